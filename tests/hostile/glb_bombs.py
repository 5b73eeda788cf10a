"""Files whose lengths lie, whose counts do not fit them, or that cost far more than they weigh."""

from __future__ import annotations

import copy
import json
import struct
from typing import Any, Callable, Iterator

import contract
from report import Report
from running import MIB, Program
from support import glb_parts

GLTF, JSON_CHUNK, BIN_CHUNK = 0x46546C67, 0x4E4F534A, 0x004E4942
MILLION = 1_000_000
MOST = 2**32 - 1
PATHS = ("/v1/characters/chains", "/v1/characters/motion")
PEAK = 256 * MIB  # published: reading a file takes at most 128 MiB besides three times its size, and what was free before comes to it


def glb(text: bytes, data: bytes = b"") -> bytes:
    """A sound file around any JSON."""
    text += b" " * (-len(text) % 4)
    data += b"\0" * (-len(data) % 4)
    chunks = struct.pack("<II", len(text), JSON_CHUNK) + text + (struct.pack("<II", len(data), BIN_CHUNK) + data if data else b"")
    return struct.pack("<III", GLTF, 2, 12 + len(chunks)) + chunks


def lies(sound: bytes) -> Iterator[tuple[str, bytes]]:
    """A file whose bytes are not what they say. All of them are refused."""
    def patched(at: int, value: int) -> bytes:
        return sound[:at] + struct.pack("<I", value & MOST) + sound[at + 4:]
    text = struct.unpack_from("<I", sound, 12)[0]
    for size in (0, 1, 4, 11, 12, 19, 20, 21, 20 + text - 1, len(sound) - 1, len(sound) - 4):
        yield f"cut off after {size} bytes", sound[:size]
    for value in (0, 11, 12, 20, len(sound) - 4, len(sound) + 4, 2**31, MOST):
        yield f"length {value}", patched(8, value)
    for value in (0, 1, text - 4, text + 1, text + 4, len(sound), 2**31 - 1, 2**31, MOST, MOST - 19, -12):
        yield f"JSON of {value} bytes", patched(12, value)
    for value in (1, 2**31 - 1, MOST, MOST - 7, len(sound)):
        yield f"buffer of {value} bytes", patched(20 + text, value)
    yield "another magic", patched(0, 0x46546C68)
    for version in (0, 1, 3, MOST):
        yield f"version {version}", patched(4, version)
    yield "the buffer first", sound[:12] + sound[20 + text:] + sound[12:20 + text]
    yield "a buffer for JSON", patched(16, BIN_CHUNK)
    yield "16 MiB and one byte of JSON", glb(b" " * (16 * MIB + 4))
    yield "no glTF at all", b"\x89PNG\r\n\x1a\n" * 100
    yield "a text", json.dumps(contract.example("tufts")).encode()


def costly() -> Iterator[tuple[str, bytes]]:
    """JSON that is far larger in memory than on the wire, or deep."""
    empty = b"[" + b"{}," * MILLION + b"{}]"
    for noun in ("nodes", "materials", "accessors", "meshes", "animations", "scenes", "skins", "bufferViews", "textures", "images", "cameras"):
        yield f"10^6 empty {noun}", glb(b'{"asset":{"version":"2.0"},"' + noun.encode() + b'":' + empty + b"}")
    yield "10^6 empty extras", glb(b'{"asset":{"version":"2.0"},"extras":' + empty + b"}")
    yield "2,100,000 values", glb(b'{"asset":{"version":"2.0"},"extras":[' + b"0," * 2_100_000 + b"0]}")
    yield "deep extras", glb(b'{"asset":{"version":"2.0"},"extras":' + b"[" * 100_000 + b"]" * 100_000 + b"}")
    yield "deep objects", glb(b'{"asset":{"version":"2.0"},"extras":' + b'{"a":' * 50_000 + b"0" + b"}" * 50_000 + b"}")
    yield "a key twice", glb(b'{"asset":{"version":"2.0"},"nodes":[],"nodes":[{}]}')
    yield "bad UTF-8", glb(b'{"asset":{"version":"2.0","generator":"\xff"}}')
    yield "NaN", glb(b'{"asset":{"version":"2.0"},"extras":NaN}')
    yield "1e999", glb(b'{"asset":{"version":"2.0"},"extras":1e999}')


def circle(gltf: Any) -> None:
    gltf["nodes"][0]["children"] = [0]


def ring(gltf: Any) -> None:
    gltf["nodes"][0]["children"], gltf["nodes"][1]["children"] = [1], [0]


def for_all(noun: str, **fields: Any) -> Callable[[Any], None]:
    return lambda gltf: [each.update(fields) for each in gltf[noun]]


def skins(**fields: Any) -> Callable[[Any], None]:
    return lambda gltf: [each.update(fields) for each in gltf.get("skins", [])]


# Changes of a sound character. The service may find that it needs nothing of what is wrong, and then 200 is right.
DAMAGES: dict[str, Callable[[Any], None]] = {
    "a node that is its own child": circle,
    "two nodes that are each other's children": ring,
    "children that are not there": lambda gltf: gltf["nodes"][0].update(children=[MILLION]),
    "children of a negative number": lambda gltf: gltf["nodes"][0].update(children=[-1]),
    "children of 10^18": lambda gltf: gltf["nodes"][0].update(children=[10**18]),
    "a child twice": lambda gltf: gltf["nodes"][0].update(children=[1, 1]),
    "100,000 nodes in one chain": lambda gltf: gltf.update(nodes=[{"children": [i + 1]} for i in range(60_000)] + [{}]),
    "accessors of 2^32 - 1": for_all("accessors", count=MOST),
    "accessors of 2^53": for_all("accessors", count=2**53),
    "accessors of -1": for_all("accessors", count=-1),
    "accessors of half a number": for_all("accessors", count=1.5),
    "accessors far behind": for_all("accessors", byteOffset=2**40),
    "accessors before the start": for_all("accessors", byteOffset=-8),
    "accessors of no view": for_all("accessors", bufferView=MILLION),
    "accessors of another type": for_all("accessors", componentType=5_130),
    "accessors of no known shape": for_all("accessors", type="VEC99"),
    "sparse accessors of 2^32 - 1": for_all("accessors", sparse={"count": MOST, "indices": {"bufferView": 0, "componentType": 5125}, "values": {"bufferView": 0}}),
    "views beyond the buffer": for_all("bufferViews", byteLength=MOST),
    "views far behind": for_all("bufferViews", byteOffset=2**53),
    "views that wrap around": for_all("bufferViews", byteOffset=2**64 - 16, byteLength=32),
    "views of no buffer": for_all("bufferViews", buffer=7),
    "views without a step": for_all("bufferViews", byteStride=0),
    "views of giant steps": for_all("bufferViews", byteStride=2**31),
    "a buffer larger than its bytes": for_all("buffers", byteLength=MOST),
    "a buffer of nothing": for_all("buffers", byteLength=0),
    "a buffer from a file": for_all("buffers", uri="/etc/passwd"),
    "a buffer from a file, as a URL": for_all("buffers", uri="file:///etc/passwd"),
    "a buffer from elsewhere": for_all("buffers", uri="http://127.0.0.1:1/x.bin"),
    "a buffer in itself": for_all("buffers", uri="data:application/octet-stream;base64," + "A" * 1_000_000),
    "an image from a file": lambda gltf: gltf.update(images=[{"uri": "../../../../etc/passwd"}]),
    "joints that are not there": skins(joints=[MILLION]),
    "joints of a negative number": skins(joints=[-1]),
    "300,000 joints": skins(joints=[0] * 300_000),
    "a skeleton that is not there": skins(skeleton=MILLION),
    "matrices of no accessor": skins(inverseBindMatrices=MILLION),
    "a node that goes nowhere": for_all("nodes", translation=[1e308, -1e308, 1e308]),
    "a node without a size": for_all("nodes", scale=[0, 0, 0]),
    "a node turned by nothing": for_all("nodes", rotation=[0, 0, 0, 0]),
    "names of 100,000 bytes": lambda gltf: gltf["nodes"][0].update(name="x" * 100_000),
    "names of control characters": for_all("nodes", name="\x1b[31m\r\n\0"),
    "an extension that nobody knows": lambda gltf: gltf.update(extensionsRequired=["EVIL_everything"]),
    "scenes of nodes that are not there": lambda gltf: gltf.update(scenes=[{"nodes": [MILLION]}]),
    "another version": lambda gltf: gltf["asset"].update(version="999.0"),
    "no version": lambda gltf: gltf.pop("asset"),
}


def run(report: Report, program: str, full: bool) -> None:
    with open(contract.CHARACTER, "rb") as file:
        sound = file.read()
    gltf, data = glb_parts(sound)
    with Program(program) as server:
        for path in PATHS:
            for name, body in lies(sound):
                send(report, server, path, name, body, {400, 413, 422})
            for name, body in costly():
                send(report, server, path, name, body, {400, 413, 422})
            for name, damage in DAMAGES.items():
                changed = copy.deepcopy(gltf)
                damage(changed)
                send(report, server, path, name, glb(json.dumps(changed).encode(), data), {200, 400, 413, 422})
        report.note(f"peak {server.peak() / MIB:.0f} MiB")
        report.check("memory", server.peak() < PEAK, f"{server.peak() / MIB:.0f} MiB")
        report.check("well afterwards", server.is_well())
        report.equal("examples afterwards", server.answers_examples(), [])


def send(report: Report, server: Program, path: str, name: str, body: bytes, statuses: set[int]) -> None:
    answer = server.request("POST", path, body, {"Content-Type": "model/gltf-binary"})
    report.check(f"{path}: {name}", answer.status in statuses, f"{answer.status} in place of {sorted(statuses)}: {answer.body[:200]!r}")
    if answer.status != 200:
        faults = contract.faults(answer.json(), contract.named("Problem"))
        report.check(f"{path}: {name}: its problem", not faults and b"root:" not in answer.body, faults or answer.body[:300])
