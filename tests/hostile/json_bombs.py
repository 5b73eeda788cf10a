"""JSON made to overflow a stack, a number, a memory or a reader, on every operation that takes JSON."""

from __future__ import annotations

import copy
import json
from typing import Any, Iterator, Optional

import contract
from report import Report
from running import MIB, Program

MALFORMED, REFUSED, TOO_LARGE = {400}, {400, 422}, {413}
EIGHT = 8 * MIB
HUGE = ["1e308", "-1e308", "1e-320", "9" * 300, "-" + "9" * 300, "9007199254740993", "18446744073709551616", "-9223372036854775809", "0." + "3" * 5_000, "1" + "0" * 5_000]
LEAVES = 5  # numbers of each example that are replaced in the quick form

# name: (body, statuses). None of them can be answered with 200, whichever operation it is.
BOMBS: dict[str, tuple[bytes, set[int]]] = {
    "nothing": (b"", MALFORMED),
    "blanks": (b" \t\r\n" * 1_000, MALFORMED),
    "100,000 open brackets": (b"[" * 100_000, MALFORMED),
    "100,000 nested lists": (b"[" * 100_000 + b"]" * 100_000, MALFORMED),
    "100,000 open objects": (b'{"a":' * 100_000, MALFORMED),
    "100,000 nested objects": (b'{"a":' * 100_000 + b"0" + b"}" * 100_000, MALFORMED),
    "8 MiB of open brackets": (b"[" * EIGHT, MALFORMED),
    "33 nested lists": (b"[" * 33 + b"]" * 33, MALFORMED),
    "nested in a known field": (b'{"tufts":' + b"[" * 50_000 + b"]" * 50_000 + b"}", MALFORMED),
    "too many numbers": (b"[" + b"0," * 2_000_001 + b"0]", TOO_LARGE),
    "too many objects": (b"[" + b"{}," * 2_000_001 + b"{}]", TOO_LARGE),
    "too many lists": (b"[" + b"[]," * 2_000_001 + b"[]]", TOO_LARGE),
    "too many texts": (b"[" + b'"",' * 2_000_001 + b'""]', TOO_LARGE),
    "too many keys": (b"{" + b",".join(b'"k%d":0' % i for i in range(200)) + b"}", TOO_LARGE),
    "100,000 keys": (b"{" + b",".join(b'"k%d":0' % i for i in range(100_000)) + b"}", TOO_LARGE),
    "a key twice": (b'{"a":0,"a":0}', MALFORMED),
    "a known key twice": (b'{"timing":{"period":1},"timing":{"period":2}}', MALFORMED),
    "a key twice, once escaped": (b'{"a":0,"\\u0061":0}', MALFORMED),
    "10,000 times a key": (b"{" + b'"a":0,' * 10_000 + b'"a":0}', MALFORMED),
    "1e999": (b'{"x":1e999}', MALFORMED),
    "-1e999": (b'{"x":-1e999}', MALFORMED),
    "an exponent of 400 digits": (b'{"x":1e' + b"9" * 400 + b"}", MALFORMED),
    "a number of 400 digits": (b'{"x":' + b"9" * 400 + b"}", REFUSED),
    "a number of 8 MiB": (b'{"x":' + b"1" * EIGHT + b"}", REFUSED),
    "NaN": (b'{"x":NaN}', MALFORMED),
    "Infinity": (b'{"x":Infinity}', MALFORMED),
    "zeros before a number": (b'{"x":007}', MALFORMED),
    "a plus before a number": (b'{"x":+1}', MALFORMED),
    "a hexadecimal number": (b'{"x":0x10}', MALFORMED),
    "a number without its end": (b'{"x":1.}', MALFORMED),
    "single quotes": (b"{'x':1}", MALFORMED),
    "a comma too many": (b'{"x":1,}', MALFORMED),
    "a comment": (b'{"x":1/*y*/}', MALFORMED),
    "two documents": (b"{} {}", MALFORMED),
    "text behind it": (b"{}x", MALFORMED),
    "bad UTF-8 in a value": (b'{"x":"\xff"}', MALFORMED),
    "bad UTF-8 in a key": (b'{"\xff":1}', MALFORMED),
    "bad UTF-8 between": (b'{"x":\xff1}', MALFORMED),
    "UTF-8 that is too long": (b'{"x":"\xc0\xaf"}', MALFORMED),
    "UTF-8 that is cut off": (b'{"x":"\xe9\xab"}', MALFORMED),
    "UTF-8 beyond Unicode": (b'{"x":"\xf4\x90\x80\x80"}', MALFORMED),
    "a surrogate in UTF-8": (b'{"x":"\xed\xa0\x80"}', MALFORMED),
    "half a surrogate": (b'{"x":"\\ud800"}', MALFORMED),
    "the other half": (b'{"x":"\\udc00"}', MALFORMED),
    "halves in the wrong order": (b'{"x":"\\udc00\\ud800"}', MALFORMED),
    "an escape that is none": (b'{"x":"\\x41"}', MALFORMED),
    "an escape cut off": (b'{"x":"\\u00"}', MALFORMED),
    "a mark of byte order, which may be skipped (RFC 8259 8.1)": (b"\xef\xbb\xbf{\"x\":1}", REFUSED),
    "UTF-16": ('{"x":1}'.encode("utf-16"), MALFORMED),
    "NUL": (b"\0", MALFORMED),
    "NUL behind it": (b"{}\0", MALFORMED),
    "NUL in a value": (b'{"x":"a\0b"}', MALFORMED),
    "NUL in a key": (b'{"a\0b":1}', MALFORMED),
    "a line break in a value": (b'{"x":"a\nb"}', MALFORMED),
    "a value of 8 MiB": (b'{"x":"' + b"a" * EIGHT + b'"}', REFUSED),
    "a key of 8 MiB": (b'{"' + b"a" * EIGHT + b'":1}', REFUSED),
    "a value of 8 MiB of escapes": (b'{"x":"' + b"\\u9aea" * (EIGHT // 6) + b'"}', REFUSED),
    "a value that never ends": (b'{"x":"' + b"a" * EIGHT, MALFORMED),
    "8 MiB of backslashes": (b'{"x":"' + b"\\" * (EIGHT + 1), MALFORMED),
    "8 MiB of blanks": (b" " * EIGHT + b"[]", REFUSED),
    "a list": (b"[]", REFUSED),
    "null": (b"null", REFUSED),
    "a number": (b"0", REFUSED),
    "a text": (b'"x"', REFUSED),
}


def run(report: Report, program: str, full: bool) -> None:
    with Program(program, "--queue", "1000") as server:
        idle = server.resident()
        for operation in contract.posts():
            for name, (body, statuses) in BOMBS.items():
                if len(body) > MIB and not full and operation.path != "/v1/schedules":
                    continue
                refuse(report, server, f"{operation.path}: {name}", operation.path, body, statuses)
            for name, body in numbers(contract.example(operation.what["operationId"]), None if full else LEAVES):
                refuse(report, server, f"{operation.path}: {name}", operation.path, body, {200, 400, 422})
        report.note(f"peak {(server.peak() - idle) / MIB:.0f} MiB above idle")
        report.check("well afterwards", server.is_well())
        report.equal("examples afterwards", server.answers_examples(), [])


def refuse(report: Report, server: Program, what: str, path: str, body: bytes, statuses: set[int]) -> None:
    answer = server.post(path, body)
    report.check(what, answer.status in statuses, f"{answer.status} in place of {sorted(statuses)}: {answer.body[:200]!r}")
    if answer.status != 200:
        faults = contract.faults(answer.json(), contract.named("Problem"))
        report.check(f"{what}: its problem", not faults and len(answer.body) < 4_096, faults or f"{len(answer.body)} bytes")


def numbers(body: Any, most: Optional[int]) -> Iterator[tuple[str, bytes]]:
    """The example with one of its numbers replaced by one that is hard to hold."""
    for place in list(leaves(body))[:most]:
        for text in HUGE:
            changed = copy.deepcopy(body)
            node = changed
            for part in place[:-1]:
                node = node[part]
            node[place[-1]] = "@"
            yield f"{'/'.join(map(str, place))} = {text[:24]}", json.dumps(changed).replace('"@"', text).encode()


def leaves(node: Any, place: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """The places of all numbers, of a list only the first."""
    if isinstance(node, dict):
        for key, value in node.items():
            yield from leaves(value, (*place, key))
    elif isinstance(node, list):
        if node:
            yield from leaves(node[0], (*place, 0))
    elif isinstance(node, (int, float)) and not isinstance(node, bool):
        yield place
