"""HTTP/1.1 on a plain socket: light enough to put load on a proxy, strict enough to notice what does not belong.

A `Connection` keeps alive and counts nothing; whoever asks judges the answer.
"""

from __future__ import annotations

import json
import socket
from dataclasses import dataclass, field
from typing import Any, Optional

PATIENCE_S = 30.0  # guards against hanging; no answer is expected to take this long


class Broken(Exception):
    """The peer closed, or what it sent is no HTTP answer."""


@dataclass
class Answer:
    status: int
    headers: dict[str, str] = field(repr=False)  # names in lower case
    body: bytes = field(repr=False)

    def json(self) -> Any:
        return json.loads(self.body)


class Connection:
    """One connection that is opened when needed and kept as long as the peer keeps it."""

    def __init__(self, address: tuple[str, int], timeout_s: float = PATIENCE_S) -> None:
        self._address, self._timeout_s = address, timeout_s
        self._socket: Optional[socket.socket] = None
        self._received = b""

    def __enter__(self) -> "Connection":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def close(self) -> None:
        if self._socket:
            self._socket.close()
        self._socket, self._received = None, b""

    def send(self, data: bytes) -> None:
        if not self._socket:
            self._socket = socket.create_connection(self._address, timeout=self._timeout_s)
            self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._socket.sendall(data)

    def answer(self, has_body: bool = True) -> Answer:
        """The next answer but 100 Continue. Raises Broken, OSError."""
        while True:
            status, headers = self._head()
            if status >= 200:
                break
        if "transfer-encoding" in headers:
            raise Broken("a chunked answer, which nothing here sends")
        size = int(headers.get("content-length", "0")) if has_body and status not in (204, 304) else 0
        while len(self._received) < size:
            self._more()
        body, self._received = self._received[:size], self._received[size:]
        if headers.get("connection", "").lower() == "close":
            self.close()
        return Answer(status, headers, body)

    def ask(self, data: bytes) -> Answer:
        """One request, one answer; opened anew if the peer has closed meanwhile. Raises Broken, OSError."""
        try:
            self.send(data)
            return self.answer()
        except (Broken, OSError):
            self.close()
            raise

    def rest(self) -> bytes:
        """All that comes until the peer closes or says nothing for the connection's time."""
        received, self._received = self._received, b""
        try:
            while self._socket and (part := self._socket.recv(65536)):
                received += part
        except OSError:
            pass
        return received

    def _head(self) -> tuple[int, dict[str, str]]:
        while b"\r\n\r\n" not in self._received:
            self._more()
        head, self._received = self._received.split(b"\r\n\r\n", 1)
        first, *lines = head.decode("latin-1").split("\r\n")
        words = first.split(" ", 2)
        if not words[0].startswith("HTTP/1.") or len(words) < 2 or not words[1].isdigit():
            raise Broken(f"no status line: {first[:80]!r}")
        return int(words[1]), {name.strip().lower(): value.strip() for name, _, value in (line.partition(":") for line in lines)}

    def _more(self) -> None:
        part = self._socket.recv(65536) if self._socket else b""
        if not part:
            raise Broken("closed before the answer was whole")
        self._received += part


def request(method: str, target: str, body: Optional[bytes] = None, *lines: str) -> bytes:
    """The bytes of a request; `lines` are further header lines."""
    head = [f"{method} {target} HTTP/1.1", "Host: tuftwave.test", *lines]
    if body is not None:
        head += ["Content-Type: application/json", f"Content-Length: {len(body)}"]
    return "\r\n".join(head).encode() + b"\r\n\r\n" + (body or b"")


def schedule_body(number: int) -> bytes:
    """The cheapest computation there is, unlike that of any other number below 10^7."""
    return json.dumps({"timing": {"period": own_period(number), "fps": 24, "hold": 2}}).encode()


def schedule(number: int) -> bytes:
    return request("POST", "/v1/schedules", schedule_body(number))


def own_period(number: int) -> float:
    """Seconds, 0.4 to 0.5."""
    return 0.4 + (number % 10_000_000) / 1e8


def is_own(answer: Answer, number: int) -> bool:
    """Whether this is the answer to schedule(number) and to no other."""
    return answer.status == 200 and answer.json()["schedule"]["requested_period"] == own_period(number)
