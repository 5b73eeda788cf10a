"""The studio at /: whole, of its own, and never stale. A server that was built without it has the page of /docs there."""

from __future__ import annotations

import re

import contract
from support import ServiceTest

ENDINGS = {"html": "text/html", "js": "text/javascript", "css": "text/css", "json": "application/json", "glb": "model/gltf-binary",
           "svg": "image/svg+xml", "png": "image/png", "woff2": "font/woff2", "txt": "text/plain"}


class Studio(ServiceTest):
    def files(self) -> list[str]:
        """What there must be: the page as a file, and all that it names."""
        page = self.service.get("/").body.decode()
        return ["/studio/index.html", *re.findall(r'"(/studio/[^"]+)"', page)] if self.has_studio() else []

    def test_it_is_whole_or_not_there(self) -> None:
        files = self.files()
        if files:
            self.assertIn("/studio/studio.js", files)
        else:
            self.assert_problem(self.service.get("/studio/index.html"), 404, "not_found")
            self.assert_problem(self.service.get("/studio/studio.js"), 404, "not_found")
        for path in files:
            with self.subTest(path):
                answer = self.service.get(path)
                self.assert_ok(answer, ENDINGS[path.rsplit(".", 1)[1]])
                self.assertIn(answer.media_type, contract.answer_content(contract.operation("studioFile")))
                self.assertTrue(answer.body)
                self.assertEqual(answer.headers.get("x-content-type-options"), "nosniff")

    def test_what_is_not_of_it_is_not_there(self) -> None:
        for name in ("nothing.js", "openapi.yaml", "swagger-ui.css", "INDEX.HTML", "index", "%01", "..", "..%5cindex.html"):
            with self.subTest(name):
                self.assert_problem(self.service.get(f"/studio/{name}"), 404, "not_found")

    def test_it_is_kept_and_asked_for_again(self) -> None:
        for path in ["/", *self.files()]:
            with self.subTest(path):
                answer = self.service.get(path)
                self.assertEqual(answer.headers["cache-control"], "no-cache")
                self.assertRegex(answer.headers["etag"], r'^"[0-9a-f]+"$')
                again = self.service.request("GET", path, headers={"If-None-Match": answer.headers["etag"]})
                self.assertEqual((again.status, again.body, again.headers["etag"]), (304, b"", answer.headers["etag"]))
                other = self.service.request("GET", path, headers={"If-None-Match": '"0"'})
                self.assertEqual((other.status, other.body), (200, answer.body))

    def test_the_first_page_needs_nothing_from_outside(self) -> None:
        page = self.service.get("/")
        self.assertNotRegex(page.body.decode(), r'(src|href)="(?!/|data:)')
        policies = [self.service.get(path).headers.get("content-security-policy", "") for path in ("/", "/studio/index.html")]
        if self.has_studio():
            for policy in policies:
                self.assertIn("default-src 'self';", policy)
                self.assertIn("script-src 'self';", policy)
                self.assertNotRegex(policy, r"https?:|\*|'unsafe-eval'")
        else:
            self.assertEqual(policies, ["", ""])
