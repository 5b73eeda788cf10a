"""Little that asks for much: packed bodies, and small JSON that describes more than a machine holds."""

from __future__ import annotations

import gzip
import json
import time
import zlib
from typing import Any, Callable
from urllib.parse import urlencode

import contract
from cases import HOST, JSON, chunk, head
from report import Report
from running import MIB, Program
from wire import exchange

UNPACKED = 128 * MIB
PEAK = 512 * MIB  # of the whole process, for the largest that it grants
LARGEST = 160 * MIB  # of an answer: 2,000,000 vertices of position, normal, texture, joints and weights, and their triangles
BILLION = 1_000_000_000
Change = Callable[[Any], Any]


def mesh(**fields: Any) -> Change:
    return lambda body: body.setdefault("mesh", {}).update(fields)


def timing(**fields: Any) -> Change:
    return lambda body: body["timing"].update(fields) if "timing" in body else body["motion"]["timing"].update(fields)


def tuft(**fields: Any) -> Change:
    return lambda body: [each.update(fields) for each in body["tufts"]]


def many(noun: str, count: int, **fields: Any) -> Change:
    return lambda body: body.update({noun: [{**body[noun][0], **fields}] * count})


# Refused with 422 (or 413, which is about how many values there are), whatever the rest of the example says.
TOO_MUCH: list[tuple[str, str, Change]] = [
    *((operation, f"{count:,} rings", mesh(rings=count)) for operation in ("tufts", "hairstyles") for count in (4_097, BILLION, 10**18)),
    *((operation, f"{count:,} sides", mesh(sides=count)) for operation in ("tufts", "hairstyles") for count in (65, BILLION)),
    ("tufts", "2,700,000 vertices", lambda body: (mesh(rings=4_096, sides=64)(body), many("tufts", 11)(body))),
    ("hairstyles", "2,700,000 vertices", lambda body: (mesh(rings=4_096, sides=64)(body), many("tufts", 11)(body))),
    ("tufts", "4,000,000,000 vertices", lambda body: (mesh(rings=4_096, sides=64)(body), many("tufts", 16_000)(body))),
    ("tufts", "17,000 tufts", many("tufts", 17_000)),
    ("tufts", "a tolerance of nothing", mesh(tolerance=1e-300)),
    ("tufts", "1,025 points", lambda body: body["tufts"][0].update(points=[[0, i * 1e-4, 0] for i in range(1_025)])),
    *((operation, "10^9 joints", tuft(joints=BILLION)) for operation in ("tufts", "hairstyles")),
    ("hairstyles", "1,048,576 joints", lambda body: (tuft(joints=64)(body), many("tufts", 16_384)(body))),
    *((operation, f"{name} {value}", timing(**{name: value})) for operation in ("schedules", "motions", "hairstyles")
      for name, value in (("period", BILLION), ("period", 1e300), ("fps", BILLION), ("fps", "1000000000/1"), ("hold", BILLION), ("period", 61), ("fps", 241))),
    ("schedules", "14,400 frames", timing(period=60, fps=240)),
    ("motions", "14,400 frames", timing(period=60, fps=240)),
    ("hairstyles", "14,400 frames", timing(period=60, fps=240)),
    ("motions", "17,000 chains", many("chains", 17_000)),
    ("fills", "10^9 tufts per meter", lambda body: body["fill"].update(tufts_per_meter=BILLION)),
    ("fills", "10^300 tufts per meter", lambda body: body["fill"].update(tufts_per_meter=1e300)),
    ("fills", "10^6 tufts per meter, all dense", lambda body: body["fill"].update(tufts_per_meter=1e6, density={"along": 100, "crown": 100, "neck": 100}, min_gap=0)),
    ("hairstyles", "1,025 fills", lambda body: body.update(fills=[{"from": "back_M"}] * 1_025)),
    ("hairstyles", "1,024 dense fills", lambda body: body.update(fills=[{"from": "back_R1", "to": "back_L1", "tufts_per_meter": 1e6,
                                                                      "density": {"along": 100, "crown": 100, "neck": 100}}] * 1_024)),
    ("hairstyles", "a scalp of 200,001 vertices", lambda body: body["head"].update(scalp={"mesh": {"positions": [0.1] * 600_003, "triangles": [0, 1, 2]}})),
    ("fits", "10^9 steps", lambda body: body.update(steps=BILLION)),
    ("fits", "10^9 cycles", lambda body: body.update(cycles=BILLION)),
    ("fits", "17,000 drawings", many("drawn", 17_000)),
    ("evaluations", "17,000 drawings", many("drawn", 17_000)),
]
QUERIES = [{"format": "xdts", "repeat": BILLION}, {"format": "csv", "repeat": 10**30}, {"format": "vmd", "repeat": -1}]


def run(report: Report, program: str, full: bool) -> None:
    with Program(program) as server:
        packed(report, server)
        for operation, what, change in TOO_MUCH:
            body = contract.example(operation)
            change(body)
            begin = time.monotonic()
            answer = server.post(f"/v1/{operation}", body)
            report.check(f"{operation}: {what}", answer.status in (413, 422), f"{answer.status} after {time.monotonic() - begin:.1f} s: {answer.body[:200]!r}")
        for query in QUERIES:
            answer = server.post("/v1/motions?" + urlencode(query), contract.example("motions"))
            report.check(f"motions?{urlencode(query)}", 400 <= answer.status < 500, f"{answer.status}, {len(answer.body)} bytes")
        if full:
            largest(report, server)
        report.note(f"peak {server.peak() / MIB:.0f} MiB")
        report.check("memory", server.peak() < PEAK, f"{server.peak() / MIB:.0f} MiB")
        report.check("well afterwards", server.is_well())
        report.equal("examples afterwards", server.answers_examples(), [])


def packed(report: Report, server: Program) -> None:
    """Packed bodies are refused by their heads; nothing in here can unpack them."""
    blanks = b" " * UNPACKED
    bodies = {"gzip": gzip.compress(blanks, 1), "deflate": zlib.compress(blanks, 1), "br": b"\x1b\x03\x00" * 1_000, "zstd": b"\x28\xb5\x2f\xfd" * 99}
    before = server.peak()
    for operation in contract.posts() + contract.uploads():
        kind = JSON if operation in contract.posts() else b"Content-Type: model/gltf-binary"
        start = f"POST {operation.path} HTTP/1.1"
        for coding, body in bodies.items():
            for way, data in {"": head(start, HOST, kind, f"Content-Encoding: {coding}", f"Content-Length: {len(body)}") + body,
                              " in chunks": head(start, HOST, kind, f"Content-Encoding: {coding}", "Transfer-Encoding: chunked") + chunk(body) + b"0\r\n\r\n"}.items():
                got = exchange(server.address, data)
                report.equal(f"{operation.path}: {coding} of {UNPACKED // MIB} MiB{way}", (got.statuses, got.closed), ([415], True))
    report.check("nothing was unpacked", server.peak() - before < UNPACKED / 2, f"{(server.peak() - before) / MIB:.0f} MiB")


def largest(report: Report, server: Program) -> None:
    """What is just allowed is granted, and no larger than can be told beforehand; or refused for its time, never for a fault."""
    for operation in ("tufts", "hairstyles"):
        body = contract.example(operation)
        many("tufts", 7)(body)
        mesh(rings=4_096, sides=64)(body)
        for index, each in enumerate(body["tufts"]):
            body["tufts"][index] = {**each, "name": f"t{index}"}
        body.pop("fills", None)
        answer = server.post(f"/v1/{operation}", json.dumps(body))
        report.check(f"{operation}: 1,900,000 vertices", answer.status in (200, 503, 504), f"{answer.status}: {answer.body[:300]!r}")
        report.check(f"{operation}: the largest answer", len(answer.body) < LARGEST, f"{len(answer.body) / MIB:.0f} MiB")
        report.note(f"{operation} of 1,900,000 vertices: {answer.status}, {len(answer.body) / MIB:.1f} MiB")
