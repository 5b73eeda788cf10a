"""GLB files taken apart and put together, and where their nodes are."""

from __future__ import annotations

import json
import struct
from collections import OrderedDict
from typing import Any, Optional

import contract

CHARACTERS = ["godette.vrm0.vrm", "godette.vrm1.vrm", "pmca_sample3.glb", "vroid_Vita.chains.glb", "vroid_Sendagaya_Shibu.chains.glb",
              "vroid_Sakurada_Fumiriya.chains.glb"]
JSON_CHUNK, BINARY_CHUNK = 0x4E4F534A, 0x004E4942
Vector = tuple[float, float, float]
Columns = tuple[Vector, Vector, Vector, Vector]  # three axes and a place


def character(name: str) -> bytes:
    with open(f"{contract.ROOT}/tests/data/characters/{name}", "rb") as file:
        return file.read()


def chunk(kind: int, content: bytes, padding: bytes = b"\0") -> bytes:
    content += padding * (-len(content) % 4)
    return struct.pack("<II", len(content), kind) + content


def to_glb(document: Any, binary: bytes = b"", others: bytes = b"") -> bytes:
    """A GLB of a document, or of its text as it is. @param others  whole chunks that follow"""
    text = document if isinstance(document, bytes) else json.dumps(document, ensure_ascii=False).encode()
    chunks = chunk(JSON_CHUNK, text, b" ") + (chunk(BINARY_CHUNK, binary) if binary else b"") + others
    return struct.pack("<III", 0x46546C67, 2, 12 + len(chunks)) + chunks


def chunks(glb: bytes) -> list[tuple[int, bytes]]:
    """Types and contents, with their padding."""
    found, at = [], 12
    while at < len(glb):
        size, kind = struct.unpack_from("<II", glb, at)
        found.append((kind, glb[at + 8:at + 8 + size]))
        at += 8 + size
    return found


def in_order(glb: bytes) -> Any:
    """The JSON of a GLB; dumps() of it tells apart the order of keys, 1 and 1.0, 0.0 and -0.0."""
    return json.loads(chunks(glb)[0][1], object_pairs_hook=OrderedDict)


def without_clip(glb: bytes, before: Any) -> Any:
    """The JSON of an answer as it was before its clip came in. @param before  the JSON that was sent"""
    document = in_order(glb)
    document["animations"].pop()
    for name in ("accessors", "bufferViews", "animations"):
        document[name] = document[name][:len(before.get(name, []))]
        if name not in before:
            document.pop(name)
    document["buffers"][0]["byteLength"] = before["buffers"][0]["byteLength"]
    return document


def small_character(**members: Any) -> tuple[dict[str, Any], bytes]:
    """A head with a strand of three bones, as little as has hair. Its document, to be changed, and its buffer."""
    nodes = [{"name": "Head", "translation": [0, 1.5, 0], "children": [1]}, {"name": "hair_1", "translation": [0, 0.1, -0.1], "children": [2]},
             {"name": "hair_2", "translation": [0, -0.1, 0], "children": [3]}, {"name": "hair_3", "translation": [0, -0.1, 0]}]
    document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": nodes, "skins": [{"joints": [0, 1, 2, 3]}],
                "buffers": [{"byteLength": 8}], **members}
    return document, b"\x01\x02\x03\x04\x05\x06\x07\x08"


def times(a: Columns, b: Columns) -> Columns:
    """b, then a."""
    def turned(v: Vector) -> Vector:
        return tuple(a[0][i] * v[0] + a[1][i] * v[1] + a[2][i] * v[2] for i in range(3))
    place = turned(b[3])
    return (turned(b[0]), turned(b[1]), turned(b[2]), tuple(place[i] + a[3][i] for i in range(3)))


def moved(columns: Columns, point: Vector) -> Vector:
    return times(columns, ((1, 0, 0), (0, 1, 0), (0, 0, 1), tuple(point)))[3]


def inverse(a: Columns) -> Columns:
    def cross(u: Vector, v: Vector) -> Vector:
        return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    rows = [cross(a[1], a[2]), cross(a[2], a[0]), cross(a[0], a[1])]
    size = sum(rows[0][i] * a[0][i] for i in range(3))
    axes = [tuple(rows[row][column] / size for row in range(3)) for column in range(3)]
    turned = times((axes[0], axes[1], axes[2], (0, 0, 0)), ((1, 0, 0), (0, 1, 0), (0, 0, 1), a[3]))
    return (axes[0], axes[1], axes[2], tuple(-turned[3][i] for i in range(3)))


def local(node: Any, rotation: Optional[list[float]] = None) -> Columns:
    """What a node does to what hangs on it, perhaps turned otherwise than it is."""
    if "matrix" in node:
        return tuple(tuple(node["matrix"][4 * i:4 * i + 3]) for i in range(4))
    x, y, z, w = rotation or node.get("rotation", [0, 0, 0, 1])
    axes = ((1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)), (2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)),
            (2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)))
    scale = node.get("scale", [1, 1, 1])
    return (*(tuple(part * scale[i] for part in axes[i]) for i in range(3)), tuple(node.get("translation", [0, 0, 0])))


def placed(nodes: list[Any], rotations: dict[int, list[float]]) -> list[Columns]:
    """Every node in the model. @param rotations  of the nodes that do not rest"""
    places: list[Any] = [None] * len(nodes)
    children = {child for node in nodes for child in node.get("children", [])}
    waiting = [(root, ((1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, 0))) for root in range(len(nodes)) if root not in children]
    while waiting:
        index, above = waiting.pop()
        places[index] = times(above, local(nodes[index], rotations.get(index)))
        waiting += [(child, places[index]) for child in nodes[index].get("children", [])]
    return places
