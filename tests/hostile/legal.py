"""Odd but legal requests: refusing too much is a fault as well."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Optional, Sequence

from cases import HOST, INNOCENT, TIMING, chunk, chunked, get, head, post, sized
from report import Report
from running import Program
from wire import Exchange, WireError, exchange

TOKEN = "!#$%&'*+-.^_`|~0aZ"
N = len(TIMING)
LAST = b"0\r\n\r\n"


@dataclass(frozen=True)
class Legal:
    """Requests and the statuses of their answers.

    methods  of the requests, where one is HEAD
    holds    what else must hold of what came back
    closes   whether the server must close afterwards
    """

    name: str
    data: bytes
    statuses: Sequence[int] = (200,)
    methods: Sequence[str] = ()
    interim: Sequence[int] = ()
    closes: bool = False
    holds: Optional[Callable[[Exchange], bool]] = None


def has_length_alone(got: Exchange) -> bool:
    """An answer to HEAD says how long the body would be and has none; the next answer shows that nothing came after it."""
    return int(got.replies[0].header("content-length") or 0) > 0 and not got.replies[0].body


def is_whole_answer(got: Exchange) -> bool:
    return not got.replies[0].header("content-range") and len(got.replies[0].body) > 10


CASES = [
    Legal("bytes above ASCII in a value", get(b"X: \x80\xe9\xab\xaa\xff")),
    Legal("a tab in a value", get("X: a\tb")),
    Legal("blanks around a value", get("X: \t a \t ")),
    Legal("an empty value", get("X:", "Y: ")),
    Legal("no blank after a colon", head("GET /v1/version HTTP/1.1", "Host:localhost", "X:a")),
    Legal("a colon in a value", get("X: a:b: c")),
    Legal("a name of all token characters", get(TOKEN + ": a")),
    Legal("names in any case", head("GET /v1/version HTTP/1.1", "hOsT: localhost", "ACCEPT: application/json")),
    Legal("a Host with a port", head("GET /v1/version HTTP/1.1", "Host: localhost:8080")),
    Legal("a Host that is an IPv6 address", head("GET /v1/version HTTP/1.1", "Host: [::1]:8080")),
    Legal("64 headers", get(*(f"X-{i}: a" for i in range(63)))),
    Legal("a head of 16,000 bytes", get("X: " + "a" * (16_000 - len(get("X: "))))),
    Legal("1.0 without Host", head("GET /v1/version HTTP/1.0"), closes=True),
    Legal("1.0 with a body", post(f"Content-Length: {N}", version="1.0"), closes=True),
    Legal("1.0 that would like to stay", head("GET /v1/version HTTP/1.0", "Connection: keep-alive"), closes=True),
    Legal("a wish to close", get("Connection: close"), closes=True),
    Legal("a wish to close in a list", get("Connection: x, Close") + INNOCENT, closes=True),
    Legal("a request behind a wish to close", get("Connection: close") + INNOCENT, closes=True),
    Legal("three requests at once", INNOCENT * 3, (200,) * 3),
    Legal("fifty requests at once", INNOCENT * 50, (200,) * 50),
    Legal("bodies among them", INNOCENT + sized() + INNOCENT + chunked(chunk(TIMING)) + sized(), (200,) * 5),
    Legal("what is computed in its order", sized() + get(target="/v1/nothing"), (200, 404)),
    Legal("HEAD, then GET", head("HEAD /v1/version HTTP/1.1", HOST) + INNOCENT, (200, 200), ("HEAD", "GET"), holds=has_length_alone),
    Legal("HEAD of a large file", head("HEAD /openapi.yaml HTTP/1.1", HOST) + INNOCENT, (200, 200), ("HEAD", "GET"), holds=has_length_alone),
    Legal("GET with a length of none", get("Content-Length: 0") + INNOCENT, (200, 200)),
    Legal("zeros before a length", post(f"Content-Length: 000{N}") + INNOCENT, (200, 200)),
    Legal("blanks around a length", post(f"Content-Length: \t {N} ") + INNOCENT, (200, 200)),
    Legal("one chunk", chunked(chunk(TIMING)) + INNOCENT, (200, 200)),
    Legal("chunks of one byte", chunked(*(chunk(TIMING[i:i + 1]) for i in range(N))) + INNOCENT, (200, 200)),
    Legal("a chunk size in capitals with zeros", chunked(chunk(TIMING, f"{N:010X}")) + INNOCENT, (200, 200)),
    Legal("a chunk size of 16 digits", chunked(chunk(TIMING, f"{N:016x}")) + INNOCENT, (200, 200)),
    Legal("a last chunk of many zeros", chunked(chunk(TIMING), end=b"0000000000\r\n\r\n") + INNOCENT, (200, 200)),
    Legal("an extension", chunked(chunk(TIMING, f'{N:x};a=b;c="d e"')) + INNOCENT, (200, 200)),
    Legal("an extension of the last chunk", chunked(chunk(TIMING), end=b"0;a\r\n\r\n") + INNOCENT, (200, 200)),
    Legal("trailers", chunked(chunk(TIMING), end=b"0\r\nX: y\r\nContent-Length: 5\r\nTransfer-Encoding: chunked\r\n\r\n") + INNOCENT, (200, 200)),
    Legal("16 trailers", chunked(chunk(TIMING), end=b"0\r\n" + b"X: y\r\n" * 16 + b"\r\n") + INNOCENT, (200, 200)),
    Legal("CHUNKED", post("Transfer-Encoding: CHUNKED", body=chunk(TIMING) + LAST) + INNOCENT, (200, 200)),
    Legal("blanks around chunked", post("Transfer-Encoding: \t chunked \t", body=chunk(TIMING) + LAST) + INNOCENT, (200, 200)),
    Legal("a coding with an underscore is another header", sized("Transfer_Encoding: chunked") + INNOCENT, (200, 200)),
    Legal("packed as it is", sized("Content-Encoding: identity") + INNOCENT, (200, 200)),
    Legal("OPTIONS", head("OPTIONS /v1/tufts HTTP/1.1", HOST) + INNOCENT, (204, 200), holds=lambda got: "POST" in (got.replies[0].header("allow") or "")),
    Legal("an escaped letter in the path", get(target="/v1/%76ersion")),
    Legal("a Range", get("Range: bytes=0-1"), holds=is_whole_answer),
    Legal("a thousand ranges", get("Range: bytes=" + ",".join(["0-"] * 1_000)), holds=is_whole_answer),
    Legal("a Range of a computed answer", sized("Range: bytes=5-", "If-Range: \"x\""), holds=is_whole_answer),
    Legal("codings of the answer", get("Accept-Encoding: br;q=1, gzip, *;q=0", target="/v1/limits")),
    Legal("an upgrade", get("Connection: Upgrade, HTTP2-Settings", "Upgrade: h2c", "HTTP2-Settings: AAMAAABkAARAAAAAAAIAAAAA") + INNOCENT, (200, 200)),
    Legal("TE", get("TE: trailers, deflate;q=0.5", "Connection: TE")),
    Legal("a connection that would hide the length", sized("Connection: content-length") + INNOCENT, (200, 200)),
    Legal("addresses that others claim", get("REMOTE_ADDR: 10.0.0.1", "LOCAL_PORT: 1", "X-Forwarded-For: 10.0.0.1", "Forwarded: for=10.0.0.1")),
    Legal("Expect with the body behind it", sized("Expect: 100-continue") + INNOCENT, (200, 200), holds=lambda got: got.interim in ([], [100])),
    Legal("Expect in capitals", sized("Expect: 100-CONTINUE") + INNOCENT, (200, 200), holds=lambda got: got.interim in ([], [100])),
    Legal("Expect of 1.0 is ignored", post("Expect: 100-continue", f"Content-Length: {N}", version="1.0"), closes=True, holds=lambda got: got.interim == []),
]
_HEAD = b"POST /v1/%b HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nExpect: 100-continue\r\nContent-Length: %d\r\n\r\n"
NEVER_ASKED_FOR = {"unknown path": (_HEAD % (b"nothing", N), 404), "wrong method": (_HEAD % (b"version", N), 405), "too long": (_HEAD % (b"schedules", 2**30), 413)}


def run(report: Report, program: str, full: bool) -> None:
    with Program(program) as server:
        for case in CASES:
            attempt(report, server, case, False)
            if len(case.data) < (2_000 if full else 300):  # a longer head would take longer than it may
                attempt(report, server, case, True)
        expect(report, server)
        odd_splits(report, server, 1 if full else 7)
        report.check("well afterwards", server.is_well())


def attempt(report: Report, server: Program, case: Legal, byte_by_byte: bool) -> None:
    what = f"{case.name}, {'byte by byte' if byte_by_byte else 'at once'}"
    try:
        got = exchange(server.address, case.data, 0 if case.closes else len(case.statuses), byte_by_byte, case.methods)
    except (WireError, OSError) as error:
        report.check(what, False, error)
        return
    report.equal(what, got.statuses, list(case.statuses))
    report.check(f"{what}: closed", got.closed or not case.closes, "it stayed open")
    if case.holds and got.statuses == list(case.statuses):
        report.check(f"{what}: the answer", case.holds(got), got)


def expect(report: Report, server: Program) -> None:
    """A client that waits gets 100 and then its answer; one whose body nobody wants gets only the refusal."""
    with server.connect() as connection:
        connection.sendall(_HEAD % (b"schedules", N))
        got = b""
        while b"\r\n\r\n" not in got:
            part = connection.recv(4096)
            if not part:
                break
            got += part
        report.check("100 Continue", got.startswith(b"HTTP/1.1 100 "), got[:80])
        connection.sendall(TIMING)
        while b"\r\n\r\n" not in got.partition(b"\r\n\r\n")[2]:
            part = connection.recv(65536)
            if not part:
                break
            got += part
        report.check("the answer after it", got.partition(b"\r\n\r\n")[2].startswith(b"HTTP/1.1 200 "), got[:200])
    for what, (data, status) in NEVER_ASKED_FOR.items():
        refused = exchange(server.address, data)
        report.equal(f"no 100 for {what}", (refused.interim, refused.statuses, refused.closed), ([], [status], True))


def odd_splits(report: Report, server: Program, step: int) -> None:
    """The same two requests cut in two at every place."""
    data = chunked(chunk(TIMING[:9]), chunk(TIMING[9:])) + INNOCENT
    wrong = []
    for at in range(1, len(data), step):
        got = exchange(server.address, b"", 2, parts=[data[:at], data[at:]])
        if got.statuses != [200, 200]:
            wrong.append((at, got.statuses))
    report.equal("cut in two at every place", wrong, [])
