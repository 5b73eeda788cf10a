"""A Tuftwave server of the tests' own, on a free port, and requests to it."""

from __future__ import annotations

import http.client
import json
import os
import re
import socket
import subprocess
import threading
from dataclasses import dataclass, field
from typing import Any, Optional, Union

READY = re.compile(r"^tuftwave-server \S+ listening on http://([^:/]+):(\d+), admin on http://([^:/]+):(\d+)$")
START_S = 20.0  # sanitizers are slow
PATIENCE_S = "300"  # the largest request takes long under a sanitizer, and no test asserts a time
ANSWER_S = 300.0
Body = Union[bytes, str, dict, list, None]


@dataclass
class Answer:
    status: int
    headers: dict[str, str] = field(repr=False)  # names in lower case
    body: bytes = field(repr=False)

    @property
    def media_type(self) -> str:
        return self.headers.get("content-type", "").split(";")[0].strip()

    def json(self) -> Any:
        return json.loads(self.body)


def to_bytes(body: Body) -> Optional[bytes]:
    if body is None or isinstance(body, bytes):
        return body
    return (body if isinstance(body, str) else json.dumps(body)).encode()


class Service:
    """Use as a context manager. Its log goes nowhere unless `log` is a file."""

    def __init__(self, program: str, *flags: str, log: Any = subprocess.DEVNULL) -> None:
        self._command = [os.path.abspath(program), "--host", "127.0.0.1", "--port", "0", "--admin-host", "127.0.0.1", "--admin-port", "0",
                         "--deadline", PATIENCE_S, *flags]
        self._log = log

    def __enter__(self) -> "Service":
        environment = {name: value for name, value in os.environ.items() if not name.startswith("TUFTWAVE_") and name != "PORT"}
        self._process = subprocess.Popen(self._command, stdout=subprocess.PIPE, stderr=self._log, env=environment)
        giving_up = threading.Timer(START_S, self._process.kill)
        giving_up.start()
        line = self._process.stdout.readline().decode().rstrip("\n")
        giving_up.cancel()
        match = READY.match(line)
        if not match:
            self._process.kill()
            self._process.wait()
            raise RuntimeError(f"{self._command[0]} did not say that it is ready, but {line!r}")
        # What comes after the first line is read and dropped, so that the server never waits for us.
        self._drain = threading.Thread(target=self._process.stdout.read, daemon=True)
        self._drain.start()
        self.host, self.port, self.admin_port = match[1], int(match[2]), int(match[4])
        return self

    def __exit__(self, *_: Any) -> None:
        self._process.terminate()
        try:
            self._process.wait(timeout=15)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._drain.join()
        self._process.stdout.close()

    @property
    def is_running(self) -> bool:
        return self._process.poll() is None

    @property
    def pid(self) -> int:
        return self._process.pid

    @property
    def url(self) -> str:
        return f"http://{self.host}:{self.port}"

    def request(self, method: str, target: str, body: Body = None, headers: Optional[dict[str, str]] = None, admin: bool = False) -> Answer:
        """One request on a connection of its own."""
        connection = http.client.HTTPConnection(self.host, self.admin_port if admin else self.port, timeout=ANSWER_S)
        try:
            connection.request(method, target, body=to_bytes(body), headers=headers or {})
            got = connection.getresponse()
            return Answer(got.status, {name.lower(): value for name, value in got.getheaders()}, got.read())
        finally:
            connection.close()

    def get(self, target: str, **headers: str) -> Answer:
        return self.request("GET", target, headers=with_dashes(headers))

    def post(self, target: str, body: Body, **headers: str) -> Answer:
        return self.request("POST", target, body, {"Content-Type": "application/json", **with_dashes(headers)})

    def raw(self, data: bytes) -> bytes:
        """Bytes sent as they are, and all that comes back until the server closes."""
        with socket.create_connection((self.host, self.port), timeout=ANSWER_S) as connection:
            connection.sendall(data)
            received = b""
            while part := connection.recv(65536):
                received += part
            return received


def is_sanitized(program: str) -> bool:
    """Whether a sanitizer is in it, which needs memory of its own and ends where there is none."""
    with open(program, "rb") as file:
        return re.search(rb"__[at]san_init", file.read()) is not None


def with_dashes(headers: dict[str, str]) -> dict[str, str]:
    """Keyword arguments as header names: If_None_Match is If-None-Match."""
    return {name.replace("_", "-"): value for name, value in headers.items()}
