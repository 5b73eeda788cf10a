"""Tests of the client, against a stub on this machine, and of the commands in its README.

    python3 -m unittest discover -s tests/pipeline
"""

from __future__ import annotations

import contextlib
import io
import json
import os
import re
import socket
import subprocess
import sys
import tempfile
import threading
import unittest
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
PIPELINE = ROOT / "client-examples" / "pipeline"
sys.path.insert(0, str(PIPELINE))

import tuftwave_client as client  # noqa: E402

Reply = tuple[int, dict[str, str], bytes]

PROBLEM = {
    "type": "urn:tuftwave:problem:out_of_range", "title": "Out of range", "status": 422, "detail": "A value is not allowed.",
    "request_id": "r-17", "errors": [
        {"code": "out_of_range", "pointer": "/motion/timing/period", "detail": "period is too long", "value": 99, "allowed": "0.01 to 60"},
        {"code": "missing", "pointer": "", "detail": "tufts is missing"},
    ]}


def problem(status: int, **headers: str) -> Reply:
    fields = {"Content-Type": "application/problem+json", **{k.replace("_", "-"): v for k, v in headers.items()}}
    return status, fields, json.dumps({**PROBLEM, "status": status}).encode()


class Stub(ThreadingHTTPServer):
    """Answers with `replies` first, then with a body that names what was asked for."""

    def __init__(self) -> None:
        super().__init__(("127.0.0.1", 0), Handler)
        self.replies: list[Reply] = []
        self.seen: list[tuple[str, str, bytes]] = []  # path, Accept, body
        self.url = f"http://127.0.0.1:{self.server_address[1]}"

    def serve_during(self, test: unittest.TestCase) -> None:
        """Answers until the test has ended."""
        threading.Thread(target=self.serve_forever, kwargs={"poll_interval": 0.01}, daemon=True).start()
        test.addCleanup(self.server_close)
        test.addCleanup(self.shutdown)

    def answer(self, accept: str) -> Reply:
        return 200, {"Content-Type": f"{accept}; charset=utf-8", "Tuftwave-Frame-Rate": "24"}, accept.encode()


class Handler(BaseHTTPRequestHandler):
    server: Stub

    def do_POST(self) -> None:
        body = self.rfile.read(int(self.headers["Content-Length"]))
        accept = self.headers["Accept"]
        self.server.seen.append((self.path, accept, body))
        status, headers, content = self.server.replies.pop(0) if self.server.replies else self.server.answer(accept)
        self.send_response(status)
        for name, value in {"Content-Length": str(len(content)), **headers}.items():
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(content)

    def log_message(self, *_: Any) -> None:
        pass


class ClientTest(unittest.TestCase):
    def setUp(self) -> None:
        self.stub = Stub()
        self.stub.serve_during(self)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.body = self.folder / "hairstyle.json"
        self.body.write_text('{"tufts": []}')

    def run_client(self, *arguments: str, server: str = "") -> tuple[int, str, str]:
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = client.main([str(self.body), "--server", server or self.stub.url, *arguments])
        return code, out.getvalue(), err.getvalue()

    def file(self, name: str) -> str:
        return str(self.folder / name)

    def names(self) -> list[str]:
        return sorted(path.name for path in self.folder.iterdir())

    def test_every_answer_is_asked_for_by_its_media_type_and_written(self) -> None:
        code, out, err = self.run_client("--out", self.file("h.glb"), "--sheet", self.file("h.xdts"), "--csv", self.file("h.csv"),
                                         "--json", self.file("h.json"))
        self.assertEqual((code, err), (0, ""))
        types = ["model/gltf-binary", "application/x-xdts+json", "text/csv", "application/json"]
        self.assertEqual(self.stub.seen, [("/v1/hairstyles", t, b'{"tufts": []}') for t in types])
        self.assertEqual([(self.folder / n).read_text() for n in ("h.glb", "h.xdts", "h.csv", "h.json")], types)
        self.assertIn("24 frames per second", out)
        self.assertEqual(self.names(), ["h.csv", "h.glb", "h.json", "h.xdts", "hairstyle.json"])  # no temporary file left

    def test_files_are_replaced_whole(self) -> None:
        old = self.folder / "h.glb"
        old.write_bytes(b"old")
        reader = old.open("rb")
        self.addCleanup(reader.close)
        self.assertEqual(self.run_client("--out", str(old))[0], 0)
        self.assertEqual(reader.read(), b"old")  # whoever had it open still sees the whole old file
        self.assertEqual(old.read_bytes(), b"model/gltf-binary")

    def test_nothing_is_written_when_a_later_answer_is_refused(self) -> None:
        self.stub.replies = [(200, {"Content-Type": "model/gltf-binary"}, b"glb"), problem(422)]
        code, _, _ = self.run_client("--out", self.file("h.glb"), "--sheet", self.file("h.xdts"))
        self.assertEqual((code, self.names()), (1, ["hairstyle.json"]))

    def test_a_file_that_cannot_be_replaced_leaves_no_temporary_file(self) -> None:
        (self.folder / "h.glb").mkdir()
        code, _, err = self.run_client("--out", self.file("h.glb"))
        self.assertEqual((code, err.count("\n")), (1, 1))
        self.assertEqual(self.names(), ["h.glb", "hairstyle.json"])

    def test_a_busy_service_is_asked_again(self) -> None:
        self.stub.replies = [problem(503, Retry_After="0"), problem(429, Retry_After="0")]
        code, _, err = self.run_client("--out", self.file("h.glb"))
        self.assertEqual((code, len(self.stub.seen)), (0, 3))
        self.assertIn("busy (503), asking again in 0 s", err)

    def test_a_service_that_stays_busy_is_given_up_on(self) -> None:
        self.stub.replies = [problem(503, Retry_After="0")] * 3
        code, _, err = self.run_client("--out", self.file("h.glb"), "--retries", "2")
        self.assertEqual((code, len(self.stub.seen)), (1, 3))
        self.assertIn("503 Out of range", err)

    def test_a_service_that_asks_for_an_hour_is_not_waited_for(self) -> None:
        self.stub.replies = [problem(503, Retry_After="3600")]
        code, _, err = self.run_client("--out", self.file("h.glb"))
        self.assertEqual((code, len(self.stub.seen)), (1, 1))
        self.assertIn("come back in 3600 s", err)

    def test_backoff_is_bounded_and_retry_after_wins(self) -> None:
        self.assertEqual([client.seconds_to_wait(None, n) for n in (0, 1, 2, 10)], [0.5, 1, 2, 8])
        self.assertEqual(client.seconds_to_wait("7", 0), 7)
        self.assertEqual(client.seconds_to_wait("Wed, 21 Oct 2026 07:28:00 GMT", 1), 1)

    def test_a_problem_is_printed_for_people(self) -> None:
        self.stub.replies = [problem(422)]
        code, out, err = self.run_client("--out", self.file("h.glb"))
        self.assertEqual((code, out), (1, ""))
        self.assertEqual(err, "tuftwave_client: 422 Out of range: A value is not allowed. (request r-17)\n"
                              "  /motion/timing/period: period is too long (given 99, allowed 0.01 to 60)\n"
                              "  /: tufts is missing\n")

    def test_an_error_that_is_no_problem_json_is_still_shown(self) -> None:
        for content, shown in ((b"<h1>Bad gateway</h1>", "502: <h1>Bad gateway</h1>"), (b"", "502: no text"), (b"[" * 100_000, "502: [[")):
            with self.subTest(shown):
                self.stub.replies = [(502, {}, content)]
                code, _, err = self.run_client("--out", self.file("h.glb"))
                self.assertEqual(code, 1)
                self.assertIn(shown, err)

    def test_a_redirect_does_not_become_a_get(self) -> None:
        self.stub.replies = [(302, {"Location": self.stub.url + "/elsewhere"}, b"moved")]
        code, _, err = self.run_client("--out", self.file("h.glb"))
        self.assertEqual((code, len(self.stub.seen)), (1, 1))
        self.assertIn("302: moved", err)

    def test_another_service_is_recognised(self) -> None:
        self.stub.replies = [(200, {"Content-Type": "text/html"}, b"<html>")]
        code, _, err = self.run_client("--out", self.file("h.glb"))
        self.assertEqual((code, self.names()), (2, ["hairstyle.json"]))
        self.assertIn("text/html instead of model/gltf-binary", err)

    def test_an_answer_cut_short_writes_nothing(self) -> None:
        self.stub.replies = [(200, {"Content-Type": "model/gltf-binary", "Content-Length": "100"}, b"glb")]
        code, _, err = self.run_client("--out", self.file("h.glb"))
        self.assertEqual((code, self.names()), (2, ["hairstyle.json"]))
        self.assertIn("No answer from", err)

    def test_nobody_listening_is_one_sentence_and_code_2(self) -> None:
        with socket.socket() as taken:  # bound, not listening: connections are refused
            taken.bind(("127.0.0.1", 0))
            url = f"http://127.0.0.1:{taken.getsockname()[1]}"
            code, _, err = self.run_client("--out", self.file("h.glb"), server=url)
        self.assertEqual((code, err.count("\n")), (2, 1))
        self.assertIn(f"No answer from {url}", err)
        self.assertIn("Is the service running there?", err)

    def test_a_silent_service_times_out(self) -> None:
        with socket.socket() as silent:
            silent.bind(("127.0.0.1", 0))
            silent.listen()
            url = f"http://127.0.0.1:{silent.getsockname()[1]}"
            code, _, err = self.run_client("--out", self.file("h.glb"), "--timeout", "0.05", server=url)
        self.assertEqual(code, 2)
        self.assertIn("timed out", err)

    def test_proxy_variables_are_ignored_and_the_server_comes_from_the_environment(self) -> None:
        surprises = {"http_proxy": "http://127.0.0.1:9", "HTTP_PROXY": "http://127.0.0.1:9", "no_proxy": "", "TUFTWAVE_URL": self.stub.url}
        with mock.patch.dict(os.environ, surprises), contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual(client.main([str(self.body), "--out", self.file("h.glb")]), 0)

    def test_wrong_options_are_refused_before_anything_is_sent(self) -> None:
        for arguments in ([], ["--out", "h.glb", "--server", "file:///etc"], ["--out", "h.glb", "--timeout", "0"]):
            with self.subTest(arguments), contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit) as stop:
                client.main([str(self.body), *arguments])
            self.assertEqual(stop.exception.code, 2)

    def test_a_missing_hairstyle_is_one_line(self) -> None:
        self.body.unlink()
        code, _, err = self.run_client("--out", self.file("h.glb"))
        self.assertEqual((code, err.count("\n")), (1, 1))

    def test_the_commands_of_the_readme_and_the_docstrings_run(self) -> None:
        for name in ("client-examples", "tests"):
            (self.folder / name).symlink_to(ROOT / name)
        block = re.search(r"```sh\n(.*?)```", (PIPELINE / "README.md").read_text(), re.S)
        commands = block.group(1).splitlines() if block else []
        self.assertEqual(len(commands), 3)
        for script in ("strokes_to_hairstyle", "strands_to_hairstyle", "tuftwave_client"):
            text = (PIPELINE / f"{script}.py").read_text()
            commands += [line.strip() for line in text.splitlines() if line.startswith("    python3 client-examples")]
        self.assertEqual(len(commands), 6)
        for command in commands:
            done = subprocess.run(["sh", "-c", command], cwd=self.folder, env={**os.environ, "TUFTWAVE_URL": self.stub.url},
                                  capture_output=True, text=True, timeout=60)
            self.assertEqual(done.returncode, 0, f"{command}\n{done.stderr}")
        self.assertEqual(len(json.loads(self.stub.seen[0][2])["tufts"]), 65)
        self.assertTrue(all((self.folder / n).exists() for n in ("vita.glb", "vita.xdts", "vita.csv", "vita_report.json", "ponytail.json")))


if __name__ == "__main__":
    unittest.main()
