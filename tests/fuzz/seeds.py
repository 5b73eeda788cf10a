"""What fuzzing begins with: inputs made of the contract's examples and of files that others made, and the words that matter.

    python3 tests/fuzz/seeds.py --work build/asan/tests/fuzz/work tufts glb

Writes <work>/<target>/seeds/* and <work>/<target>/words.dict. The same every time.
"""

from __future__ import annotations

import argparse
import copy
import json
import os
import random
import shutil
import struct
import sys
from typing import Any, Iterator, Optional
from urllib.parse import quote

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "contract"))

import contract  # noqa: E402
import glb_files  # noqa: E402

DATA = os.path.join(contract.ROOT, "tests", "data")
VALIDATOR_FILES = os.path.join(DATA, "gltf-validator")
LARGEST_FILE = 50_000  # bytes; larger ones are tried seldom and change slowly
RANDOM_SEEDS, RANDOM_BYTES = 48, 240


def compact(value: Any) -> bytes:
    return json.dumps(value, separators=(",", ":"), ensure_ascii=False).encode()


def target_name(op: contract.Operation) -> str:
    return op.path.removeprefix("/v1/").replace("/", "_")


def queries(op: contract.Operation) -> Iterator[str]:
    """One for each word or number that a parameter may be."""
    yield ""
    for parameter in map(contract.resolve, op.what.get("parameters", [])):
        if parameter["in"] != "query":
            continue
        for value in values_of(parameter):
            yield f"{parameter['name']}={quote(value)}"


def values_of(node: Any) -> list[str]:
    """A parameter's choices, examples, default and ends, as text."""
    schema = contract.resolve(node.get("schema", {}))
    found = [*schema.get("enum", []), *schema.get("examples", []), *([node["example"]] if "example" in node else []),
             *(schema[key] for key in ("default", "minimum", "maximum") if key in schema)]
    return [value if isinstance(value, str) else json.dumps(value) for value in found if value is not None]


def bodies(op: contract.Operation) -> Iterator[Any]:
    yield op.what["requestBody"]["content"]["application/json"]["example"]
    yield contract.example(op.what["operationId"])
    yield contract.example(op.what["operationId"], rejected=True)
    if op.path == "/v1/hairstyles":
        fill = contract.example("fills")["fill"]
        tufts = [{**fill[side], "name": side} for side in ("from", "to") if fill.get(side)]
        yield {"tufts": tufts, "fills": [{"from": "from", "to": tufts[-1]["name"], "density": {"along": 20, "crown": 10, "neck": 10}}], "motion": {}}


def characters() -> Iterator[bytes]:
    """Small ones of each kind of hair, those in tests/data, and the files that a validator is tested with."""
    document, binary = glb_files.small_character()
    yield glb_files.to_glb(document, binary)
    joints = [{"node": node} for node in (1, 2, 3)]
    spring = copy.deepcopy(document)
    spring["extensions"] = {"VRMC_springBone": {"specVersion": "1.0", "springs": [{"name": "hair", "joints": joints}]},
                            "VRMC_vrm": {"specVersion": "1.0", "humanoid": {"humanBones": {"head": {"node": 0}}}}}
    yield glb_files.to_glb(spring, binary)
    group = copy.deepcopy(document)
    group["extensions"] = {"VRM": {"humanoid": {"humanBones": [{"bone": "head", "node": 0}]},
                                   "secondaryAnimation": {"boneGroups": [{"comment": "hair", "bones": [1]}]}}}
    yield glb_files.to_glb(group, binary)
    yield skinned(document)
    for folder, _, names in sorted(os.walk(DATA)):
        for name in sorted(names):
            if not name.endswith((".glb", ".vrm", ".gltf")):
                continue
            with open(os.path.join(folder, name), "rb") as file:
                content = file.read()
            if len(content) <= LARGEST_FILE:
                yield glb_files.to_glb(content, binary) if name.endswith(".gltf") else content


def skinned(document: Any) -> bytes:
    """With two vertices that follow the last bone, and a clip."""
    document = copy.deepcopy(document)
    binary = struct.pack("<6f", 0, 0, 0, 0, -0.1, 0) + bytes([3, 0, 0, 0] * 2) + struct.pack("<8f", *[1, 0, 0, 0] * 2) + struct.pack("<f", 0)
    views = ((0, 24, 5126, "VEC3", 2), (24, 8, 5121, "VEC4", 2), (32, 32, 5126, "VEC4", 2), (64, 4, 5126, "SCALAR", 1))
    document["buffers"] = [{"byteLength": len(binary)}]
    document["bufferViews"] = [{"buffer": 0, "byteOffset": at, "byteLength": size} for at, size, *_ in views]
    document["accessors"] = [{"bufferView": index, "componentType": kind, "type": shape, "count": count, "min": [0], "max": [0]}
                             for index, (_, _, kind, shape, count) in enumerate(views)]
    document["meshes"] = [{"primitives": [{"attributes": {"POSITION": 0, "JOINTS_0": 1, "WEIGHTS_0": 2}}]}]
    document["nodes"].append({"mesh": 0, "skin": 0})
    document["nodes"][3] = {"name": "hair_3", "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -0.1, 0, 1]}
    document["animations"] = [{"name": "old", "samplers": [{"input": 3, "output": 3}], "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}]
    return glb_files.to_glb(document, binary)


def requests() -> Iterator[bytes]:
    """Connections' bytes, with the byte before them that says how they are split."""
    body = compact(contract.example("schedules"))
    lines = {
        "get": b"GET /v1/schedules?period=0.45&fps=24000/1001 HTTP/1.1\r\nHost: localhost:8080\r\nAccept: text/csv;q=0.5, */*\r\n\r\n",
        "post": b"POST /v1/schedules HTTP/1.1\r\nhost: [::1]\r\ncontent-type: application/json\r\ncontent-length: %d\r\n\r\n%s" % (len(body), body),
        "chunks": b"POST /v1/tufts HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: chunked\r\nExpect: 100-continue\r\n\r\n3;a=b\r\n{  \r\n1\r\n}\r\n0\r\nx: y\r\n\r\n",
        "old": b"HEAD /docs/swagger-ui.css HTTP/1.0\r\nConnection: keep-alive, close\r\n\r\n",
        "options": b"OPTIONS /v1/tufts HTTP/1.1\r\nHost: a\r\nContent-Length: 0\r\nContent-Encoding: identity\r\n\r\n",
    }
    for split, request in enumerate(lines.values()):
        yield bytes([split]) + request
    yield b"\x07" + b"".join(lines.values())
    yield b"\x09" + b"GET / HTTP/1.1\r\nHost: a\r\n" + b"".join(b"x%d: y\r\n" % i for i in range(63)) + b"\r\n"


def targets_text() -> Iterator[bytes]:
    for op in contract.operations():
        for query in queries(op):
            yield f"{op.path.replace('{file}', 'a')}{'?' if query else ''}{query}".encode()
    yield b"/application/json;q=0.5,text/%2A?format=csv&fps=24000%2F1001&period=1e-1&repeat=3&a=%E9%AB%AA&b=+&"


def noise(name: str) -> Iterator[bytes]:
    source = random.Random(name)
    for _ in range(RANDOM_SEEDS):
        yield source.randbytes(RANDOM_BYTES)


def seeds(name: str) -> Iterator[bytes]:
    """Raises KeyError where there is no such target."""
    operations = {target_name(op): op for op in contract.posts() + contract.uploads()}
    if name in operations:
        op = operations[name]
        for query in queries(op):
            for body in map(compact, bodies(op)) if op in contract.posts() else characters():
                yield query.encode() + b"\n" + body
                if query and op in contract.uploads():
                    break  # every setting once is enough
        return
    if name == "json":
        for op in contract.posts():
            yield from map(compact, bodies(op))
        yield from (b'{"a":[[[[[{"b":1e5}]]]]],"c":"\\u00e9\\ud83d\\ude00"}', b'[1,-0.5e-7,true,false,null,"",{},[]]', b'{"a\\u0062":0,"ab":1}')
    elif name in ("poses", "sheets"):
        yield from noise(name)
    else:
        yield from {"glb": characters, "request": requests, "query": targets_text}[name]()


def words(name: str) -> list[str]:
    """Names and choices of the contract that a target could want, and its numbers' ends."""
    if name == "request":
        return ["HTTP/1.1", "HTTP/1.0", "\r\n", "Content-Length: ", "Transfer-Encoding: chunked", "Host: ", "Connection: close", "Expect: 100-continue",
                "Content-Encoding: gzip", "GET ", "HEAD ", "POST ", "OPTIONS ", "%00", "0\r\n\r\n"]
    if name in ("poses", "sheets"):
        return []
    found: dict[str, None] = {}
    for _, node in contract.walk(contract.DOCUMENT["components"]["schemas"] | contract.DOCUMENT["components"]["parameters"]):
        if isinstance(node, dict):
            found |= {key: None for key in node.get("properties", {}) if isinstance(key, str)}
            found |= {word: None for word in node.get("enum", []) if isinstance(word, str)}
            found |= {json.dumps(node[key]): None for key in ("minimum", "maximum", "minItems", "maxItems") if isinstance(node.get(key), (int, float))}
    texts = [f'"{word}"' if word[0].isalpha() and name != "query" else word for word in found]
    if name in ("glb", "characters_chains", "characters_motion"):
        texts += [f'"{word}"' for word in (
            "asset", "version", "nodes", "children", "translation", "rotation", "scale", "matrix", "mesh", "skin", "skins", "joints", "inverseBindMatrices",
            "meshes", "primitives", "attributes", "POSITION", "JOINTS_0", "WEIGHTS_0", "accessors", "bufferView", "byteOffset", "componentType", "count", "type",
            "VEC3", "VEC4", "MAT4", "sparse", "bufferViews", "buffers", "byteLength", "byteStride", "uri", "animations", "samplers", "channels", "extensions",
            "extensionsRequired", "VRM", "VRMC_vrm", "VRMC_springBone", "springs", "boneGroups", "bones", "humanoid", "humanBones", "node", "head", "normalized")]
    return texts + ["1e308", "-1e-308", "null", "\\u0000", "[[]]", "%2C"]


def escaped(text: str) -> str:
    return "".join(chr(byte) if 32 <= byte < 127 and byte not in b'"\\' else f"\\x{byte:02x}" for byte in text.encode())


def write(name: str, work: str) -> tuple[str, str]:
    """@return  the folder of the seeds and the file of the words"""
    folder, dictionary = os.path.join(work, name, "seeds"), os.path.join(work, name, "words.dict")
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    for index, content in enumerate(dict.fromkeys(seeds(name))):
        with open(os.path.join(folder, f"{index:04}"), "wb") as file:
            file.write(content)
    with open(dictionary, "w", encoding="ascii") as file:
        file.writelines(f'"{escaped(word)}"\n' for word in words(name))
    return folder, dictionary


def main(arguments: Optional[list[str]] = None) -> int:
    parser = argparse.ArgumentParser(description="Writes what fuzzing begins with.")
    parser.add_argument("--work", required=True, help="the folder to write to")
    parser.add_argument("targets", nargs="+")
    options = parser.parse_args(arguments)
    for name in options.targets:
        folder, _ = write(name, options.work)
        print(f"{name}: {len(os.listdir(folder))} seeds")
    return 0


if __name__ == "__main__":
    sys.exit(main())
