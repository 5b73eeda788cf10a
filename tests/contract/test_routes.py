"""What is documented is served, and nothing else."""

from __future__ import annotations

import contract
from support import ServiceTest

SERVED_METHODS = ("GET", "HEAD", "POST", "OPTIONS")
OTHER_METHODS = ("PUT", "DELETE", "PATCH")  # the server's HTTP knows none of them
NOWHERE = ("/v1", "/v1/", "/v1/tuft", "/v1/tufts/", "/V1/tufts", "/v2/tufts", "/docs/", "/docs/../openapi.yaml", "//v1/tufts",
           "/v1/tufts/0", "/openapi.json", "/%2e%2e/etc/passwd", "/docs/..%2f..%2fetc%2fpasswd", "/livez", "/metrics",
           "/studio", "/studio/", "/studio/../openapi.yaml", "/studio/..%2fopenapi.yaml")
FILES = {"/docs/{file}": "/docs/start.js", "/studio/{file}": "/studio/studio.js"}


def methods(path: str) -> set[str]:
    documented = {op.method for op in contract.operations() if op.path == path}
    return documented | {"OPTIONS"} | ({"HEAD"} if "GET" in documented else set())


def target(path: str) -> str:
    """A documented path with something in place of its variable."""
    return FILES.get(path, path)


def words(header: str) -> set[str]:
    return {word.strip() for word in header.split(",")}


class Routes(ServiceTest):
    def operations(self) -> list[contract.Operation]:
        """Those that this server has something for: it may have been built without the studio, see test_studio.py."""
        return [op for op in contract.operations() if op.path != "/studio/{file}" or self.has_studio()]

    def test_documented_methods_are_served(self) -> None:
        for op in self.operations():
            with self.subTest(f"{op.method} {op.path}"):
                body, headers = contract.sample(op)
                answer = self.service.request(op.method, target(op.path), body, headers)
                self.assert_ok(answer, next(iter(contract.answer_content(op))))

    def test_documented_headers_are_sent(self) -> None:
        for op in self.operations():
            for name in op.what["responses"]["200"].get("headers", {}):
                with self.subTest(f"{op.method} {op.path} {name}"):
                    body, headers = contract.sample(op)
                    answer = self.service.request(op.method, target(op.path), body, headers)
                    self.assertTrue(answer.headers.get(name.lower()))

    def test_undocumented_methods_are_not_allowed(self) -> None:
        for path in contract.DOCUMENT["paths"]:
            allowed = methods(path)
            for method in SERVED_METHODS:
                if method not in allowed:
                    with self.subTest(f"{method} {path}"):
                        answer = self.service.request(method, target(path), "{}" if method == "POST" else None)
                        self.assertEqual(words(answer.headers.get("allow", "")), allowed)
                        if method != "HEAD":
                            self.assert_problem(answer, 405, "method_not_allowed")
                        else:
                            self.assertEqual((answer.status, answer.body), (405, b""))

    def test_methods_nobody_serves_are_not_implemented(self) -> None:
        for path in contract.DOCUMENT["paths"]:
            for method in OTHER_METHODS:
                with self.subTest(f"{method} {path}"):
                    self.assert_problem(self.service.request(method, target(path), "{}"), 501, "not_implemented")

    def test_options_names_the_methods(self) -> None:
        for path in contract.DOCUMENT["paths"]:
            with self.subTest(path):
                answer = self.service.request("OPTIONS", target(path))
                self.assertEqual((answer.status, answer.body), (204, b""))
                self.assertEqual(words(answer.headers.get("allow", "")), methods(path))

    def test_head_is_get_without_the_body(self) -> None:
        for op in self.operations():
            if op.method == "GET":
                with self.subTest(op.path):
                    got, head = self.service.get(target(op.path)), self.service.request("HEAD", target(op.path))
                    self.assertEqual((head.status, head.body), (200, b""))
                    for name in ("content-type", "content-length", "etag", "cache-control", "tuftwave-frame-rate"):
                        self.assertEqual(head.headers.get(name), got.headers.get(name), name)

    def test_nothing_is_served_elsewhere(self) -> None:
        for path in NOWHERE:
            for method in ("GET", "POST"):
                with self.subTest(f"{method} {path}"):
                    self.assert_problem(self.service.request(method, path, "{}" if method == "POST" else None), 404, "not_found")

    def test_the_contract_is_served_byte_for_byte(self) -> None:
        with open(contract.CONTRACT, "rb") as file:
            self.assertEqual(self.service.get("/openapi.yaml").body, file.read())

    def test_the_docs_need_nothing_from_outside(self) -> None:
        page = self.service.get("/docs").body.decode()
        self.assert_problem(self.service.get("/docs/nothing"), 404, "not_found")
        self.assertNotIn("http://", page)
        self.assertNotIn("https://", page)
        for quoted in page.split('"')[1::2]:
            if quoted.startswith("/"):
                with self.subTest(quoted):
                    self.assertEqual(self.service.get(quoted).status, 200)

    def test_the_version_is_the_contracts(self) -> None:
        version = self.service.get("/v1/version").json()
        self.assertEqual(version, {"name": "tuftwave", "version": contract.DOCUMENT["info"]["version"], "api": "v1"})

    def test_admin_paths_are_on_the_second_listener_only(self) -> None:
        for path in ("/livez", "/readyz", "/metrics"):
            with self.subTest(path):
                self.assertEqual(self.service.request("GET", path, admin=True).status, 200)
                self.assertEqual(self.service.get(path).status, 404)
        self.assertEqual(self.service.request("GET", "/v1/version", admin=True).status, 404)
