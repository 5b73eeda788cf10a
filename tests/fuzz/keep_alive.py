"""A connection that is used again and again, and little code between a request and its answer."""

from __future__ import annotations

import socket
from typing import Optional

from service import ANSWER_S, Answer

PIECE = 1 << 18


class Connection:
    """Opened when needed, and again when the server has closed it. Raises OSError where nothing comes back."""

    def __init__(self, host: str, port: int) -> None:
        self._address = (host, port)
        self._socket: Optional[socket.socket] = None
        self._received = b""

    def ask(self, method: str, target: str, headers: dict[str, str], body: Optional[bytes]) -> Answer:
        lines = [f"{method} {target} HTTP/1.1", f"Host: {self._address[0]}:{self._address[1]}", *(f"{name}: {value}" for name, value in headers.items())]
        if body is not None:
            lines.append(f"Content-Length: {len(body)}")
        request = "\r\n".join(lines).encode() + b"\r\n\r\n" + (body or b"")
        if self._socket is not None:
            try:
                return self._exchange(request)
            except (ConnectionError, BrokenPipeError):  # closed while idle
                self._close()
        return self._exchange(request)

    def _exchange(self, request: bytes) -> Answer:
        if self._socket is None:
            self._socket = socket.create_connection(self._address, timeout=ANSWER_S)
            self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        try:
            self._socket.sendall(request)
        except (ConnectionError, BrokenPipeError):
            pass  # refused before all of it was sent: the answer is there
        answer = self._read()
        if answer.headers.get("connection", "").lower() == "close":
            self._close()
        return answer

    def _read(self) -> Answer:
        while b"\r\n\r\n" not in self._received:
            self._receive()
        head, self._received = self._received.split(b"\r\n\r\n", 1)
        first, *lines = head.decode("latin-1").split("\r\n")
        headers = {name.lower(): value.strip() for name, value in (line.split(":", 1) for line in lines)}
        length = int(headers.get("content-length", "0"))
        while len(self._received) < length:
            self._receive()
        body, self._received = self._received[:length], self._received[length:]
        return Answer(int(first.split(" ")[1]), headers, body)

    def _receive(self) -> None:
        part = self._socket.recv(PIECE)
        if not part:
            raise ConnectionResetError("the server closed the connection before its answer")
        self._received += part

    def _close(self) -> None:
        self._socket.close()
        self._socket, self._received = None, b""
