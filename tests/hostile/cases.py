"""What a case of a malformed request is, and how its bytes are put together."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Union

import contract

TIMING = json.dumps(contract.example("schedules")).encode()  # the smallest body that an operation takes
INNOCENT = b"GET /v1/version HTTP/1.1\r\nHost: innocent\r\n\r\n"
HOST = b"Host: localhost"
JSON = b"Content-Type: application/json"
Bytes = Union[bytes, str]


@dataclass(frozen=True)
class Case:
    """A request that must be refused.

    status       of the only answer
    why          the section of RFC 9110, 9112 or 3986 that it breaks, or the limit of ours
    may_go_on    the request was whole and its end known, so that the connection may stay open
    is_whole     what follows these bytes on the connection does not belong to them
    """

    name: str
    data: bytes
    status: int
    why: str
    may_go_on: bool = False
    is_whole: bool = True


def to_bytes(text: Bytes) -> bytes:
    return text if isinstance(text, bytes) else text.encode("latin-1")


def head(line: Bytes, *lines: Bytes) -> bytes:
    """A head of these lines, each ended as it must be."""
    return b"".join(to_bytes(each) + b"\r\n" for each in (line, *lines)) + b"\r\n"


def get(*lines: Bytes, target: Bytes = "/v1/version") -> bytes:
    return head(b"GET " + to_bytes(target) + b" HTTP/1.1", HOST, *lines)


def line(request_line: Bytes) -> bytes:
    return head(request_line, HOST)


def post(*lines: Bytes, body: Bytes = TIMING, target: Bytes = "/v1/schedules", version: str = "1.1") -> bytes:
    """A POST whose framing is in the lines."""
    return head(b"POST " + to_bytes(target) + f" HTTP/{version}".encode(), HOST, JSON, *lines) + to_bytes(body)


def sized(*lines: Bytes, body: bytes = TIMING, target: Bytes = "/v1/schedules") -> bytes:
    """A POST with its right length."""
    return post(f"Content-Length: {len(body)}", *lines, body=body, target=target)


def chunked(*chunks: Bytes, end: Bytes = b"0\r\n\r\n", lines: tuple[Bytes, ...] = ()) -> bytes:
    """A POST of chunks that are written out, sizes and all."""
    return post("Transfer-Encoding: chunked", *lines, body=b"".join(map(to_bytes, chunks)) + to_bytes(end))


def chunk(data: bytes, size: str = "") -> bytes:
    return (size or f"{len(data):x}").encode() + b"\r\n" + data + b"\r\n"
