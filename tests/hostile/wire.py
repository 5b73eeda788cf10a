"""Bytes to a server and answers out of the bytes that come back, without a library that would mend either."""

from __future__ import annotations

import re
import socket
import time
from dataclasses import dataclass, field
from typing import Optional, Sequence

STATUS_LINE = re.compile(rb"HTTP/1\.[01] (\d{3})(?: [^\r\n]*)?")
PATIENCE_S = 30.0  # guards against hanging; nothing is asserted by it
PART_PAUSE_S = 0.001  # between bytes, so that most of them travel alone


class WireError(Exception):
    """What came back is no sequence of HTTP answers."""


@dataclass
class Reply:
    status: int
    headers: list[tuple[str, str]] = field(repr=False)  # names in lower case
    body: bytes = field(repr=False)

    def header(self, name: str) -> Optional[str]:
        values = [value for key, value in self.headers if key == name]
        return values[0] if values else None


@dataclass
class Exchange:
    """What a connection gave back.

    replies   final answers in their order
    interim   the statuses of 1xx answers
    closed    whether the server closed; False if it was still open when everything expected had come
    reset     whether it closed with a reset, by which a client may lose the answer
    """

    replies: list[Reply]
    interim: list[int]
    closed: bool
    reset: bool = False

    @property
    def statuses(self) -> list[int]:
        return [reply.status for reply in self.replies]


def exchange(address: tuple[str, int], data: bytes, expected: int = 0, byte_by_byte: bool = False, methods: Sequence[str] = (),
             parts: Sequence[bytes] = (), patience: float = PATIENCE_S) -> Exchange:
    """Sends, and reads until the server closes or `expected` answers have come.

    @param expected  0 to wait for the end
    @param methods   of the requests in order, since an answer to HEAD has no body; GET where it has none
    @param parts     in place of data: what is sent one after the other with a pause between
    """
    with socket.create_connection(address, timeout=patience) as connection:
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        if byte_by_byte:
            parts = [data[i:i + 1] for i in range(len(data))]
        try:
            for part in parts or [data]:
                connection.sendall(part)
                if len(parts) > 1:
                    time.sleep(PART_PAUSE_S)
        except (BrokenPipeError, ConnectionResetError):
            pass  # refused before all of it was sent; the answer is still to be read
        return receive(connection, expected, methods, patience)


def receive(connection: socket.socket, expected: int, methods: Sequence[str] = (), patience: float = PATIENCE_S) -> Exchange:
    received, closed, reset = b"", False, False
    end = time.monotonic() + patience
    while not closed:
        if expected and len(complete(received, methods)[0]) >= expected:
            break
        connection.settimeout(max(0.001, end - time.monotonic()))
        try:
            part = connection.recv(1 << 20)
        except ConnectionResetError:
            closed = reset = True
            break
        except (TimeoutError, socket.timeout):
            break
        received += part
        closed = not part
    replies, interim, rest = complete(received, methods)
    if closed and rest:
        raise WireError(f"{len(rest)} bytes that are no whole answer: {rest[:80]!r}")
    return Exchange(replies, interim, closed, reset)


def complete(received: bytes, methods: Sequence[str] = ()) -> tuple[list[Reply], list[int], bytes]:
    """All whole answers, the interim ones' statuses, and what is left. Raises WireError."""
    replies: list[Reply] = []
    interim: list[int] = []
    while received:
        head, gap, rest = received.partition(b"\r\n\r\n")
        if not gap:
            if not b"HTTP/1.".startswith(received[:7]):
                raise WireError(f"no answer begins with {received[:60]!r}")
            break
        status, headers = parse_head(head)
        if status < 200:
            interim.append(status)
            received = rest
            continue
        method = methods[len(replies)] if len(replies) < len(methods) else "GET"
        length = 0 if method == "HEAD" or status in (204, 304) else body_length(headers)
        if len(rest) < length:
            break
        replies.append(Reply(status, headers, rest[:length]))
        received = rest[length:]
    return replies, interim, received


def parse_head(head: bytes) -> tuple[int, list[tuple[str, str]]]:
    first, *lines = head.split(b"\r\n")
    match = STATUS_LINE.fullmatch(first)
    if not match:
        raise WireError(f"no status line: {first[:80]!r}")
    headers = []
    for line in lines:
        name, colon, value = line.partition(b":")
        if not colon or not name or name != name.strip():
            raise WireError(f"no header: {line[:80]!r}")
        headers.append((name.decode("latin-1").lower(), value.strip().decode("latin-1")))
    return int(match[1]), headers


def body_length(headers: list[tuple[str, str]]) -> int:
    lengths = [value for name, value in headers if name == "content-length"]
    if len(lengths) != 1 or not lengths[0].isdigit() or any(name == "transfer-encoding" for name, _ in headers):
        raise WireError(f"an answer without exactly one Content-Length: {headers}")
    return int(lengths[0])
