"""Who may: keys, shares and pages elsewhere, and that nothing tells a secret. Each test starts servers of its own."""

from __future__ import annotations

import json
import os
import re
import resource
import socket
import subprocess
import tempfile
from typing import Any, Optional

import contract
from service import Answer, Service, is_sanitized
from support import ServiceTest

SHEET = {"timing": {"period": 0.45, "fps": 24, "hold": 2}}
CHALLENGE = 'Bearer realm="tuftwave"'
INVALID = CHALLENGE + ', error="invalid_token"'
STUDIO = "https://studio.example"
PATIENCE_S = 30.0  # guards against hanging; nothing here takes a second
# What may be in no answer and no line of the log, whatever was sent: secrets (added by each test), paths, versions, exceptions.
NEVER = [r"/tmp/", r"/usr/", r"/home/", r"\.cpp", r"\.hpp", r"std::", r"bad_alloc", r"exception", r"what\(\)", r"nlohmann", r"httplib", r"spdlog",
         r"openssl", r"terminate", re.escape(contract.DOCUMENT["info"]["version"])]


class AccessTest(ServiceTest):
    """A key file with alice and bob, whose share is small, and where a log goes."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.key_file = os.path.join(folder.name, "keys")
        self.log_file = os.path.join(folder.name, "log")
        self.alice, alice_line = self.new_key("alice")
        self.bob, bob_line = self.new_key("bob")
        self.hashes = [line.split()[1] for line in (alice_line, bob_line)]
        with open(os.open(self.key_file, os.O_CREAT | os.O_WRONLY, 0o600), "w", encoding="ascii") as file:
            file.write(f"# two\n{alice_line}\n{bob_line} 0.001\n")

    def new_key(self, name: str) -> tuple[str, str]:
        """A key and its line, as somebody makes them on a terminal."""
        done = subprocess.run([self.program, "new-key", name], capture_output=True, text=True, check=True, timeout=PATIENCE_S)
        lines = done.stderr.splitlines()
        self.assertEqual((len(lines), done.stdout.count("\n")), (2, 1))
        return lines[1], done.stdout.strip()

    def serve(self, *flags: str, log: Any = subprocess.DEVNULL) -> Service:
        return Service(self.program, *flags, log=log)

    def with_keys(self, *flags: str) -> Service:
        return self.serve("--key-file", self.key_file, *flags)

    def assert_unauthorized(self, answer: Answer, challenge: str) -> None:
        self.assert_problem(answer, 401, "unauthorized")
        self.assertEqual(answer.headers.get("www-authenticate"), challenge)


class Keys(AccessTest):
    def test_every_operation_needs_one_but_pages(self) -> None:
        with self.with_keys() as service:
            for op in contract.operations():
                body, headers = contract.sample(op)
                path = op.path.replace("{file}", "swagger-ui.css")
                with self.subTest(f"{op.method} {path}"):
                    without = service.request(op.method, path, body, headers)
                    if path.startswith("/v1/"):
                        self.assert_unauthorized(without, CHALLENGE)
                        answer = service.request(op.method, path, body, {**headers, "Authorization": f"Bearer {self.alice}"})
                        self.assertNotIn(answer.status, (401, 429), answer.body[:300])
                    else:
                        self.assertIn(without.status, (200, 404), without.body[:300])

    def test_whatever_is_wrong_the_answer_is_the_same(self) -> None:
        wrong = {"another key": f"Bearer {self.alice[:-4]}AAAA", "a longer key": f"Bearer {self.alice}x", "a short key": "Bearer x", "a hash": f"Bearer {self.hashes[0]}",
                 "a name": "Bearer alice", "nothing": "Bearer", "no scheme": self.alice, "another scheme": f"Basic {self.alice}", "two": f"Bearer {self.alice}, Bearer {self.alice}",
                 "201 characters": "Bearer " + "x" * 201}
        said = set()
        with self.with_keys() as service:
            for name, value in wrong.items():
                with self.subTest(name):
                    answer = service.post("/v1/schedules", SHEET, Authorization=value)
                    self.assert_unauthorized(answer, INVALID)
                    said.add(json.dumps({key: text for key, text in answer.json().items() if key != "request_id"}))
        self.assertEqual(len(said), 1, said)

    def test_two_headers_count_as_none(self) -> None:
        line = f"Authorization: Bearer {self.alice}\r\n"
        with self.with_keys() as service:
            for lines, status in ((line, b"200"), (line + line, b"401")):
                with self.subTest(lines.count("\n")):
                    answer = service.raw(f"GET /v1/limits HTTP/1.1\r\nHost: h\r\nConnection: close\r\n{lines}\r\n".encode())
                    self.assertEqual(answer[9:12], status, answer[:300])

    def test_the_answer_comes_before_the_body(self) -> None:
        """A head that announces a body, and not a byte of it: who waits for more never answers."""
        with self.with_keys() as service, socket.create_connection((service.host, service.port), timeout=PATIENCE_S) as connection:
            connection.sendall(b"POST /v1/tufts HTTP/1.1\r\nHost: h\r\nContent-Type: application/json\r\nContent-Length: 1000000\r\n\r\n")
            self.assertEqual(connection.recv(12), b"HTTP/1.1 401")

    def test_a_used_up_share_says_when_to_come_again(self) -> None:
        """Bob has a thousandth of a millisecond per second, and one to start with."""
        with self.with_keys("--burst", "1") as service:
            self.assertEqual(service.post("/v1/schedules", SHEET, Authorization=f"Bearer {self.bob}").status, 200)
            refused = service.post("/v1/schedules", SHEET, Authorization=f"Bearer {self.bob}")
            self.assert_problem(refused, 429, "over_share")
            self.assertRegex(refused.headers.get("retry-after", ""), r"^[1-9]\d*$")
            self.assertEqual(service.get("/openapi.yaml", Authorization=f"Bearer {self.bob}").status, 200)
            for _ in range(3):
                self.assertEqual(service.post("/v1/schedules", SHEET, Authorization=f"Bearer {self.alice}").status, 200)


class Start(AccessTest):
    def refusal(self, *flags: str, **environment: str) -> str:
        """What a server says that does not start; it must not."""
        clean = {name: value for name, value in os.environ.items() if not name.startswith("TUFTWAVE_")}
        command = [self.program, "--port", "0", "--admin-port", "0", *flags]
        done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE_S, env={**clean, **environment})
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        return done.stderr

    def test_an_address_for_strangers_alone_is_refused(self) -> None:
        for said in (self.refusal("--host", "0.0.0.0"), self.refusal(TUFTWAVE_HOST="0.0.0.0"), self.refusal("--host", "::", "--insecure", "no")):
            self.assertIn("--key-file", said)
            self.assertIn("--insecure yes", said)

    def test_a_bad_key_file_is_refused_and_not_shown(self) -> None:
        with open(self.key_file, "a", encoding="ascii") as file:
            file.write(f"carol {self.alice}\n")
        said = self.refusal("--key-file", self.key_file)
        self.assertIn("line 4 ", said)
        self.assertNotIn(self.alice, said)
        self.assertNotIn("carol", said)
        self.refusal("--key-file", self.key_file + ".none")

    def test_a_wildcard_is_no_origin(self) -> None:
        self.assertIn("origins", self.refusal("--origins", "*"))


class Pages(AccessTest):
    PREFLIGHT = {"Origin": STUDIO, "Access-Control-Request-Method": "POST", "Access-Control-Request-Headers": "authorization,content-type"}

    def cors(self, answer: Answer) -> dict[str, str]:
        return {name: value for name, value in answer.headers.items() if name.startswith("access-control-")}

    def test_a_listed_page_reads_answers_and_refusals(self) -> None:
        with self.with_keys("--origins", STUDIO) as service:
            asked = service.request("OPTIONS", "/v1/tufts", headers=self.PREFLIGHT)
            self.assertEqual((asked.status, asked.body), (204, b""))
            lines = "".join(f"{name}: {value}\r\n" for name, value in self.PREFLIGHT.items())
            raw = service.raw(f"OPTIONS /v1/tufts HTTP/1.1\r\nHost: h\r\nConnection: close\r\n{lines}\r\n".encode()).lower()
            self.assertEqual((raw.count(b"access-control-allow-origin:"), raw.count(b"vary:")), (1, 1))
            self.assertEqual(self.cors(asked), {"access-control-allow-origin": STUDIO, "access-control-allow-methods": "POST, OPTIONS", "access-control-max-age": "7200",
                                                "access-control-allow-headers": "Authorization, Content-Type, Accept, If-None-Match"})
            key = {"Authorization": f"Bearer {self.alice}"}
            for status, headers, target in ((200, key, "/v1/limits"), (401, {}, "/v1/limits"), (404, key, "/v1/nothing"), (405, key, "/v1/tufts")):
                with self.subTest(status):
                    answer = service.request("GET", target, headers={"Origin": STUDIO, **headers})
                    self.assertEqual(answer.status, status)
                    self.assertEqual(self.cors(answer).get("access-control-allow-origin"), STUDIO)
                    self.assertIn("Retry-After", self.cors(answer).get("access-control-expose-headers", ""))
                    self.assertIn("Origin", answer.headers.get("vary", ""))
                    stranger = service.request("GET", target, headers={"Origin": "https://evil.example", **headers})
                    self.assertEqual((stranger.status, self.cors(stranger)), (status, {}))
                    self.assertIn("Origin", stranger.headers.get("vary", ""))

    def test_without_a_list_no_answer_says_a_word(self) -> None:
        for method, target, headers in (("OPTIONS", "/v1/tufts", self.PREFLIGHT), ("GET", "/v1/limits", {"Origin": STUDIO}), ("GET", "/v1/x", {"Origin": STUDIO})):
            with self.subTest(f"{method} {target}"):
                answer = self.service.request(method, target, headers=headers)
                self.assertEqual(self.cors(answer), {})
                self.assertNotIn("Origin", answer.headers.get("vary", ""))


class Secrets(AccessTest):
    """No answer and no line of the log tells a secret, a path, a version or what an exception said."""

    ODD = "s3cr3t-of-a-client"

    def answers(self, service: Service) -> list[bytes]:
        """Heads and bodies as they came, of requests with something to hide or something wrong."""
        key = f"Authorization: Bearer {self.alice}"
        wrong = f"Authorization: Bearer {self.alice[:-4]}AAAA"
        body = b"POST /v1/tufts HTTP/1.1\r\nHost: h\r\nConnection: close\r\nContent-Type: application/json\r\n"
        got = []
        for line in (key, wrong, "Authorization: Basic " + self.ODD, "Cookie: " + self.ODD, "X-Api-Key: " + self.ODD, f"{self.ODD}: 1", "User-Agent: " + self.ODD,
                     "X-Forwarded-For: " + self.ODD, "Accept: " + self.ODD, "Referer: http://x/?" + self.ODD, "Bad Header", "Content-Length: " + self.ODD,
                     "Transfer-Encoding: " + self.ODD, "Content-Encoding: " + self.ODD, "Expect: " + self.ODD, "Host: " + self.ODD, "Range: bytes=0-" + self.ODD):
            got.append(service.raw(f"GET /v1/limits HTTP/1.1\r\nHost: h\r\nConnection: close\r\n{line}\r\n\r\n".encode()))
        for first in (f"GET /v1/{self.ODD} HTTP/1.1", f"GET /../../etc/{self.ODD} HTTP/1.1", f"{self.ODD} / HTTP/1.1", f"GET / HTTP/{self.ODD}", f"GET /v1/limits?{self.ODD} HTTP/1.1"):
            got.append(service.raw(f"{first}\r\nHost: h\r\n{key}\r\nConnection: close\r\n\r\n".encode()))
        for sent in (b"{", b"[" * 40, b'{"tufts": 1e999}', b"\xff\xfe", b"{}"):
            got.append(service.raw(body + f"{key}\r\nContent-Length: {len(sent)}\r\n\r\n".encode() + sent))
        return got

    def starve(self, service: Service) -> Optional[Answer]:
        """A sound request that cannot get the memory it needs; None where the connection was cut."""
        with open(f"/proc/{service.pid}/statm", encoding="ascii") as file:
            used = int(file.read().split()[0]) * resource.getpagesize()
        before = resource.prlimit(service.pid, resource.RLIMIT_AS, (used, resource.RLIM_INFINITY))
        tuft = {"points": [[i * 1e-3, 0.1 + i * 1e-4, 0.02] for i in range(60)], "diameter": 30}
        try:
            return service.post("/v1/tufts", {"head": {"center": [0, 0, 0]}, "tufts": [tuft] * 1500, "mesh": {"rings": 46, "sides": 12, "layout": "merged"}}, Authorization=f"Bearer {self.alice}")
        except OSError:
            return None
        finally:
            resource.prlimit(service.pid, resource.RLIMIT_AS, before)

    def test_nothing_tells_anything(self) -> None:
        never = re.compile("|".join(NEVER + [re.escape(text) for text in (self.alice, self.alice[:-4], self.bob, *self.hashes, self.ODD, self.key_file)]))
        with open(self.log_file, "wb") as log:
            with self.serve("--key-file", self.key_file, "--log-level", "debug", "--log-format", "json", log=log) as service:
                answers = self.answers(service)
                starved = None if is_sanitized(self.program) else self.starve(service)
                self.assertEqual(service.get("/v1/limits", Authorization=f"Bearer {self.alice}").status, 200)
        for answer in answers:
            self.assertTrue(answer.startswith(b"HTTP/1.1 "), answer[:100])
            if b" 200 " not in answer.split(b"\r\n")[0]:  # what /v1/limits says is the contract's
                self.assertNotRegex(answer.decode("latin-1"), never)
            self.assertNotRegex(answer.split(b"\r\n\r\n")[0].decode("latin-1").lower(), r"\nserver:|\nx-powered-by:|" + NEVER[-1])
        if starved is not None:
            self.assertIn(starved.status, (500, 503))
            self.assertNotRegex(starved.body.decode(), never)
        with open(self.log_file, encoding="ascii") as file:
            lines = file.read().splitlines()
        self.assertGreaterEqual(len(lines), len(answers))
        for line in lines:
            json.loads(line)
            self.assertNotRegex(line, never)
