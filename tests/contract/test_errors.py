"""What is not a request body at all, and what HTTP says around it."""

from __future__ import annotations

import http.client
import json
import socket
from concurrent.futures import ThreadPoolExecutor

import contract
from service import Service
from support import ServiceTest

SHEET = b'{"timing": {"period": 0.45, "fps": 24, "hold": 2}}'
# Bytes, status, slug: what is wrong before anybody looks at what the body says.
BODIES = [
    ("nothing", b"", 400, "malformed"),
    ("blanks", b" \n\t ", 400, "malformed"),
    ("half a body", b'{"timing": {', 400, "malformed"),
    ("two bodies", b"{} {}", 400, "malformed"),
    ("a body and a text", b'{}""', 400, "malformed"),
    ("a closed object and a key", b'{"a":{}"b":1}', 400, "malformed"),
    ("brackets that do not match", b'{]"', 400, "malformed"),
    ("more closed than opened", b']]}}""', 400, "malformed"),
    ("an open string", b'{"timing', 400, "malformed"),
    ("a string that ends in a backslash", b'"\\', 400, "malformed"),
    ("single quotes", b"{'timing': {}}", 400, "malformed"),
    ("a comma too many", b'{"timing": {},}', 400, "malformed"),
    ("a comment", b'{} // sheet', 400, "malformed"),
    ("not a number", b'{"timing": {"period": NaN}}', 400, "malformed"),
    ("infinity", b'{"timing": {"period": Infinity}}', 400, "malformed"),
    ("minus infinity", b'{"timing": {"period": -Infinity}}', 400, "malformed"),
    ("a number that is too large", b'{"timing": {"period": 1e999}}', 400, "malformed"),
    ("a number below all numbers", b'{"timing": {"period": -1e999}}', 400, "malformed"),
    ("a hexadecimal number", b'{"timing": {"hold": 0x2}}', 400, "malformed"),
    ("a number with a leading zero", b'{"timing": {"hold": 02}}', 400, "malformed"),
    ("a number with a plus", b'{"timing": {"hold": +2}}', 400, "malformed"),
    ("broken UTF-8", b'{"name": "\xff\xfe"}', 400, "malformed"),
    ("half a surrogate", b'{"name": "\\ud800"}', 400, "malformed"),
    ("a control character", b'{"name": "a\x01b"}', 400, "malformed"),
    ("a byte of zero", b"{}\x00", 400, "malformed"),
    ("UTF-16", SHEET.decode().encode("utf-16"), 400, "malformed"),
    ("a key in disguise", b'{"timing": {}, "timin\\u0067": {}}', 400, "malformed"),
    ("a key twice", b'{"timing": {}, "timing": {}}', 400, "duplicate_key"),
    ("a key twice further in", b'{"timing": {"hold": 2, "period": 1, "hold": 2}}', 400, "duplicate_key"),
    ("33 levels", b"[" * 33 + b"]" * 33, 400, "too_deep"),
    ("33 levels of objects", b'{"a":' * 33 + b"1" + b"}" * 33, 400, "too_deep"),
    ("100,000 levels", b"[" * 100000 + b"]" * 100000, 400, "too_deep"),
    ("10,000,000 brackets", b"[" * 10000000, 400, "too_deep"),
    ("more than two million values", b"[" + b"0," * 2000001 + b"0]", 413, "too_many_values"),
    ("more than 64 keys", ("{" + ",".join(f'"k{i}":0' for i in range(65)) + "}").encode(), 413, "too_many_values"),
    ("a million empty objects", b"[" + b"{}," * 1000000 + b"{}]", 413, "too_many_values"),
    ("two million empty objects", b"[" + b"{}," * 1999999 + b"{}]", 413, "too_many_values"),
    ("more than 16 MiB", b'{"timing": {}' + b" " * (16 * 1024 * 1024) + b"}", 413, "too_large"),
]


class Bodies(ServiceTest):
    def test_what_is_no_body_is_refused_by_every_operation(self) -> None:
        for op in contract.posts():
            for name, body, status, slug in BODIES:
                if len(body) > 100000 and op.path != "/v1/schedules":
                    continue  # once is enough
                with self.subTest(f"{op.path}: {name}"):
                    self.assert_problem(self.service.post(op.path, body), status, slug)
                    self.assertTrue(self.service.is_running)

    def test_limits_are_the_served_ones(self) -> None:
        limits = self.service.get("/v1/limits").json()
        self.assertEqual((limits["body_bytes"], limits["json_depth"], limits["json_values"], limits["json_memory"]), (16 * 1024 * 1024, 32, 2000000, 80 * 1024 * 1024))
        fits = SHEET + b" " * (limits["body_bytes"] - len(SHEET))
        self.assertEqual(self.service.post("/v1/schedules", fits).status, 200)
        self.assert_problem(self.service.post("/v1/schedules", fits + b" "), 413, "too_large")
        self.assert_problem(self.service.post("/v1/schedules", b"[" * 32 + b"]" * 32), 422, "wrong_type", "")

    def test_a_byte_order_mark_is_ignored(self) -> None:
        self.assertEqual(self.service.post("/v1/schedules", b"\xef\xbb\xbf" + SHEET).body, self.service.post("/v1/schedules", SHEET).body)

    def test_every_fault_is_named_up_to_sixteen(self) -> None:
        body = {"timing": {"period": "a", "fps": "b", "hold": "c"}, "repeat": "d", "formulas": "e", "zzz": 1}
        answer = self.service.post("/v1/schedules", body)
        self.assert_problem(answer, 422, "wrong_type", "/timing/period")
        self.assertEqual([error["pointer"] for error in answer.json()["errors"]],
                         ["/timing/period", "/timing/fps", "/timing/hold", "/formulas", "/repeat", "/zzz"])
        many = {f"k{i}": 0 for i in range(30)}
        self.assertEqual(len(self.service.post("/v1/schedules", many).json()["errors"]), 16)

    def test_ranges_are_told_with_what_was_given(self) -> None:
        (error,) = self.service.post("/v1/schedules", {"timing": {"period": 61}}).json()["errors"]
        self.assertEqual((error["value"], error["minimum"], error["maximum"], error["allowed"]), (61, 0.01, 60, "0.01 to 60"))

    def test_what_a_client_sent_comes_back_as_text_only(self) -> None:
        for name in ("<script>alert(1)</script>", "\u9aea" * 100, "a" * 10000, "\u202e", "%0d%0aX-Evil: 1"):
            with self.subTest(name[:40]):
                body = json.dumps({name: 1}, ensure_ascii=False)
                answer = self.service.post("/v1/schedules", body)
                self.assert_problem(answer, 422, "unknown_field")
                self.assertLess(len(answer.body), 2000)
                self.assertNotIn("x-evil", answer.headers)
        for word in ("\r\nX-Evil: 1", "\x00", '"\\', "<b>"):
            with self.subTest(word):
                answer = self.service.post("/v1/schedules", {"timing": {"sampling": word}})
                self.assert_problem(answer, 422, "not_a_choice", "/timing/sampling")
                self.assertEqual(answer.json()["errors"][0]["value"], word)
                self.assertNotIn("x-evil", answer.headers)


class MediaTypes(ServiceTest):
    def test_only_json_is_read(self) -> None:
        for given in ("text/plain", "application/x-www-form-urlencoded", "multipart/form-data; boundary=x", "application/jsonx", "json", "", "model/gltf-binary"):
            with self.subTest(given):
                answer = self.service.request("POST", "/v1/schedules", SHEET, {"Content-Type": given})
                self.assert_problem(answer, 415, "unsupported_media_type")
                self.assertEqual(answer.headers.get("accept"), "application/json")
        for given in ("application/json", "Application/JSON", "application/json; charset=utf-8", "application/json;charset=UTF-8"):
            with self.subTest(given):
                self.assertEqual(self.service.request("POST", "/v1/schedules", SHEET, {"Content-Type": given}).status, 200)

    def test_no_type_is_no_json(self) -> None:
        connection = http.client.HTTPConnection(self.service.host, self.service.port, timeout=30)
        connection.putrequest("POST", "/v1/schedules")
        connection.putheader("Content-Length", str(len(SHEET)))
        connection.endheaders(SHEET)
        self.assertEqual(connection.getresponse().status, 415)
        connection.close()

    def test_packed_bodies_are_not_read(self) -> None:
        for given in ("gzip", "br", "identity, gzip"):
            with self.subTest(given):
                self.assert_problem(self.service.post("/v1/schedules", SHEET, Content_Encoding=given), 415, "unsupported_media_type")
        self.assertEqual(self.service.post("/v1/schedules", SHEET, Content_Encoding="identity").status, 200)

    def test_what_nobody_can_write_is_not_acceptable(self) -> None:
        for op in [op for op in contract.operations() if contract.formats(op)]:
            for accept in ("image/png", "application/xml, text/html", "*/*;q=0", "model/gltf-binary;q=0, application/problem+json"):
                with self.subTest(f"{op.method} {op.path}", accept=accept):
                    body, headers = contract.sample(op)
                    answer = self.service.request(op.method, op.path, body, {**headers, "Accept": accept})
                    self.assert_problem(answer, 406, "not_acceptable")

    def test_accept_is_weighed(self) -> None:
        body = contract.example("hairstyles")
        for accept, expected in (
                ("*/*", "model/gltf-binary"), ("model/*", "model/gltf-binary"), ("text/*", "text/csv"), ("APPLICATION/JSON", "application/json"),
                ("application/*", "application/json"), ("text/csv;q=0.2, application/json;q=0.9", "application/json"),
                ("model/gltf-binary;q=0, */*;q=0.1", "model/gltf+json"), ("application/json;q=0.5, */*;q=0.1", "application/json")):
            with self.subTest(accept):
                self.assert_ok(self.service.post("/v1/hairstyles", body, Accept=accept), expected)


class Full(ServiceTest):
    def test_a_full_server_says_when_to_come_back(self) -> None:
        """One worker, one place to wait, and more requests at once than both: some are refused, and all others answered."""
        body = contract.example("hairstyles")
        body["tufts"] = [{**tuft, "joints": 1} for _ in range(100) for tuft in body["tufts"]]
        with Service(self.program, "--workers", "1", "--queue", "1") as service, ThreadPoolExecutor(8) as senders:
            for _ in range(10):
                answers = list(senders.map(lambda _: service.post("/v1/hairstyles", body), range(8)))
                refused = [answer for answer in answers if answer.status != 200]
                if refused:
                    break
            self.assertTrue(refused)
            self.assertLess(len(refused), 8)
            for answer in refused:
                self.assert_problem(answer, 503, "busy")
                self.assertRegex(answer.headers.get("retry-after", ""), r"^[1-9]\d*$")
            self.assertEqual(service.request("GET", "/livez", admin=True).status, 200)
            self.assertEqual(service.post("/v1/hairstyles", contract.example("hairstyles")).status, 200)

    def test_a_late_answer_is_none(self) -> None:
        body = contract.example("hairstyles")
        body["tufts"] = [{**tuft, "joints": 1} for _ in range(1066) for tuft in body["tufts"]]
        with Service(self.program, "--workers", "1", "--deadline", "0.1") as service:
            answer = service.post("/v1/hairstyles", {**body, "mesh": {"rings": 6, "sides": 8}})
            if answer.status != 200:  # unless the machine is faster than that
                self.assert_problem(answer, 504, "deadline")


class Http(ServiceTest):
    def status_line(self, request: bytes) -> str:
        return self.service.raw(request).split(b"\r\n", 1)[0].decode()

    def test_every_answer_carries_its_id_and_no_other_does(self) -> None:
        ids = {self.service.get("/v1/version").headers["request-id"] for _ in range(20)}
        self.assertEqual(len(ids), 20)

    def test_connections_are_kept(self) -> None:
        connection = http.client.HTTPConnection(self.service.host, self.service.port, timeout=30)
        sockets = set()
        for i in range(50):
            body = SHEET if i % 2 else b'{"timing": 1}'
            connection.request("POST", "/v1/schedules", body, {"Content-Type": "application/json"})
            answer = connection.getresponse()
            self.assertEqual(answer.status, 200 if i % 2 else 422)
            answer.read()
            sockets.add(connection.sock)
        self.assertEqual(len(sockets), 1)
        connection.close()

    def test_bodies_need_a_length(self) -> None:
        self.assertIn(" 411 ", self.status_line(b"POST /v1/schedules HTTP/1.1\r\nHost: x\r\nContent-Type: application/json\r\nConnection: close\r\n\r\n"))

    def test_what_is_no_http_is_refused(self) -> None:
        for request, status in ((b"hello\r\n\r\n", 400), (b"GET\r\n\r\n", 400), (b"GET / HTTP/9.9\r\nHost: x\r\n\r\n", 505),
                                (b"GET /v1/version HTTP/1.1\r\nbroken header\r\n\r\n", 400),
                                (b"POST /v1/schedules HTTP/1.1\r\nHost: x\r\nContent-Length: -1\r\n\r\n", 400),
                                (b"POST /v1/schedules HTTP/1.1\r\nHost: x\r\nContent-Length: 2\r\nContent-Length: 3\r\n\r\n{}", 400)):
            with self.subTest(request):
                self.assertTrue(self.status_line(request).startswith(f"HTTP/1.1 {status} "))
        self.assertEqual(self.service.get("/v1/version").status, 200)

    def test_heads_have_limits(self) -> None:
        long_target = b"GET /" + b"a" * 100000 + b" HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n"
        many_headers = b"GET /v1/version HTTP/1.1\r\nHost: x\r\nConnection: close\r\n" + b"X-A: b\r\n" * 100000 + b"\r\n"
        for request, status in ((long_target, "414"), (many_headers, "431")):
            with self.subTest(status):
                try:
                    self.assertIn(f" {status} ", self.status_line(request))
                except (ConnectionResetError, BrokenPipeError):
                    pass  # refused while we were still sending
        self.assertEqual(self.service.get("/v1/version").status, 200)

    def test_a_declared_giant_is_refused_before_it_is_sent(self) -> None:
        with socket.create_connection((self.service.host, self.service.port), timeout=10) as connection:
            connection.sendall(b"POST /v1/schedules HTTP/1.1\r\nHost: x\r\nContent-Type: application/json\r\nContent-Length: 99999999999\r\n\r\n")
            head = b""
            while b"\r\n\r\n" not in head:
                part = connection.recv(65536)
                self.assertTrue(part)
                head += part
        self.assertIn(b" 413 ", head.split(b"\r\n")[0])
        self.assertIn(b"application/problem+json", head)

    def test_ranges_are_not_served(self) -> None:
        answer = self.service.get("/openapi.yaml", Range="bytes=0-9")
        self.assertEqual(answer.status, 200)
        self.assertGreater(len(answer.body), 1000)

    def test_error_bodies_of_the_http_layer_are_problems(self) -> None:
        received = self.service.raw(b"POST /v1/schedules HTTP/1.1\r\nHost: x\r\nContent-Type: application/json\r\nConnection: close\r\n\r\n")
        head, body = received.split(b"\r\n\r\n", 1)
        self.assertIn(b"application/problem+json", head)
        self.assertEqual(contract.faults(json.loads(body), contract.named("Problem")), [])
