"""Files that are broken, hostile or huge: each is answered or refused by name, none is followed, and the server lives."""

from __future__ import annotations

import base64
import json
import os
import random
import socket
import struct
from typing import Any, Iterator

import contract
from glb_files import small_character, to_glb
from service import Answer, Service, is_sanitized
from support import GLB, PROBLEM_TYPE, CharacterTest, glb_parts

ROUTES = ("/v1/characters/chains", "/v1/characters/motion?kinds=hair,skirt,ribbon,unknown&springs=remove")
VALIDATOR = os.path.join(contract.ROOT, "tests", "data", "gltf-validator")
INVALID_FILES = 86
# Files of the validator that say what nobody could use. Status, slug, pointer.
REFUSED = {
    "asset/1_0_version.gltf": (422, "unsupported", "/asset/version"), "asset/invalid_version.gltf": (422, "unsupported", "/asset/version"),
    "asset/min_version_invalid.gltf": (422, "unsupported", "/asset/minVersion"), "asset/min_version_valid.gltf": (422, "unsupported", "/asset/minVersion"),
    "asset/empty_array.gltf": (422, "missing_field", "/asset/version"), "glb/empty_json_object.glb": (422, "missing_field", "/asset"),
    "node/node_loop.gltf": (422, "conflict", "/nodes/0"), "node/node_loop_scene.gltf": (422, "conflict", "/nodes/5/children/0"),
    "node/node_parent_override.gltf": (422, "conflict", "/nodes/1/children/0"), "node/unresolved_child_node.gltf": (422, "out_of_range", "/nodes/0/children/0"),
    "node/unresolved_mesh.gltf": (422, "out_of_range", "/nodes/0/mesh"), "node/unresolved_skin.gltf": (422, "out_of_range", "/nodes/0/skin"),
    "skin/unresolved_joint.gltf": (422, "out_of_range", "/skins/0/joints/0"), "skin/unresolved_ibm.gltf": (422, "out_of_range", "/skins/0/inverseBindMatrices"),
    "json/invalid_object.gltf": (422, "wrong_type", ""), "json/invalid_syntax.gltf": (400, "malformed", None), "json/empty_file.gltf": (400, "malformed", None),
    "node/infinite_transform.gltf": (400, "malformed", None),
    **{f"glb/{name}.glb": (400, "malformed", None) for name in (
        "chunk_too_big", "empty_file", "empty_json_chunk", "extra_data", "invalid_json_chunk", "invalid_magic", "invalid_version", "json_and_two_buffers",
        "length_mismatch", "misplaced_bin_chunk", "no_header", "only_bin_chunk", "only_header", "truncated_chunk_data", "truncated_chunk_header",
        "two_bin_chunks", "two_empty_bin_chunks", "two_empty_json_chunks", "two_valid_json_chunks", "unaligned_chunk", "unknown_chunk", "zero_chunk_header",
        "zero_length")}}
VALUES = [None, True, -1, 0, 1, 2, 3.5, 1e300, -1e-300, 65535, 65536, 4294967295, 18446744073709551615, 5126, "", "VEC3", "\U0001f98a", [], {}, [0], [[]], [0, 0, 0],
          [0, 0, 0, 0], [1e30] * 16, {"node": 0}, {"uri": "x"}]


def validator_files() -> Iterator[tuple[str, bytes, Any]]:
    """Name, content and report of each."""
    for folder, _, names in sorted(os.walk(VALIDATOR)):
        for name in sorted(names):
            if name.endswith((".gltf", ".glb")):
                with open(os.path.join(folder, name), "rb") as file, open(os.path.join(folder, name + ".report.json"), encoding="utf-8") as report:
                    yield f"{os.path.basename(folder)}/{name}", file.read(), json.load(report)


def wrapped(text: bytes) -> bytes:
    """A .gltf as GLB; its only buffer, if that stands in the file, becomes the binary chunk."""
    binary = b""
    try:
        document = json.loads(text)
        (buffer,) = document.get("buffers", [])
        binary = base64.b64decode(buffer["uri"].partition("data:")[2].partition(",")[2])
    except (ValueError, AttributeError, KeyError):  # no JSON, no object, no or several buffers, a buffer elsewhere
        return to_glb(text)
    del buffer["uri"]
    return to_glb(document, binary)


def skinned_character() -> tuple[dict[str, Any], bytes]:
    """All that is read of a file: vertices, inverse bind matrices, both kinds of VRM."""
    document, _ = small_character()
    matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1.3, 0, 1]
    binary = struct.pack("<64f", *matrix * 4) + struct.pack("<6f", 0, 1.3, -0.1, 0, 1.2, -0.1) + bytes([3, 0, 0, 0] * 2) + struct.pack("<8f", *[1, 0, 0, 0] * 2)
    views = [(0, 256), (256, 24), (280, 8), (288, 32)]
    document.update(
        buffers=[{"byteLength": len(binary)}], bufferViews=[{"buffer": 0, "byteOffset": start, "byteLength": size} for start, size in views],
        accessors=[{"bufferView": 0, "componentType": 5126, "count": 4, "type": "MAT4"}, {"bufferView": 1, "componentType": 5126, "count": 2, "type": "VEC3"},
                   {"bufferView": 2, "componentType": 5121, "count": 2, "type": "VEC4"}, {"bufferView": 3, "componentType": 5126, "count": 2, "type": "VEC4"}],
        meshes=[{"primitives": [{"mode": 0, "attributes": {"POSITION": 1, "JOINTS_0": 2, "WEIGHTS_0": 3}}]}],
        skins=[{"joints": [0, 1, 2, 3], "inverseBindMatrices": 0}], animations=[{"name": "walk"}],
        extensions={"VRMC_vrm": {"humanoid": {"humanBones": {"head": {"node": 0}}}},
                    "VRMC_springBone": {"springs": [{"name": "hair", "joints": [{"node": 1}, {"node": 2}, {"node": 3}]}]},
                    "VRM": {"humanoid": {"humanBones": [{"bone": "head", "node": 0}]}, "secondaryAnimation": {"boneGroups": [{"comment": "", "bones": [1]}]}}})
    document["nodes"].append({"mesh": 0, "skin": 0, "scale": [1, 1, 1]})
    return document, binary


class UploadTest(CharacterTest):
    def send(self, route: str, body: bytes, **headers: str) -> Answer:
        return self.service.request("POST", route, body, {**GLB, **{name.replace("_", "-"): value for name, value in headers.items()}})

    def assert_handled(self, answer: Answer) -> None:
        """An answer or a refusal, whichever."""
        if answer.status != 200:
            self.assertIn(answer.status, (400, 413, 422), answer.body[:300])
            self.assert_problem(answer, answer.status, answer.json()["type"].rpartition(":")[2])
        elif answer.media_type == "model/gltf-binary":
            glb_parts(answer.body)
        else:
            self.assertEqual(contract.faults(answer.json(), contract.named("CharacterChainsAnswer")), [])

    def assert_refused(self, body: bytes, status: int, slug: str, pointer: Any = None) -> None:
        for route in ROUTES:
            answer = self.send(route, body)
            self.assert_problem(answer, status, slug, pointer)
            self.assertEqual(pointer is None, "errors" not in answer.json())


class Containers(UploadTest):
    def test_media_types(self) -> None:
        glb = to_glb(*small_character())
        for route in ROUTES:
            for given in ("application/json", "model/gltf+json", "text/plain", "multipart/form-data; boundary=x", ""):
                with self.subTest(route, given=given):
                    answer = self.send(route, glb, Content_Type=given)
                    self.assert_problem(answer, 415, "unsupported_media_type")
                    self.assertIn("model/gltf-binary", answer.headers["accept"])
            for given in ("model/gltf-binary", "model/vrm", "application/octet-stream", "Model/VRM; x=y"):
                self.assertEqual(self.send(route, glb, Content_Type=given).status, 200)
            self.assert_problem(self.send(route, glb, Content_Encoding="gzip"), 415, "unsupported_media_type")

    def test_what_is_no_glb(self) -> None:
        document, binary = small_character()
        for name, body in (("nothing", b""), ("glTF", json.dumps(document).encode()), ("indented glTF", json.dumps(document, indent=1).encode()), ("zeros", bytes(100)), ("a PNG", b"\x89PNG\r\n\x1a\n" + bytes(99)),
                           ("more than it says", to_glb(document, binary) + b"\0\0\0\0")):
            with self.subTest(name):
                self.assert_refused(body, 400, "malformed")

    def test_every_truncation(self) -> None:
        glb = to_glb(*small_character())
        for cut in range(len(glb)):
            with self.subTest(cut):
                self.assert_problem(self.send(ROUTES[0], glb[:cut]), 400, "malformed")
                honest = glb[:8] + struct.pack("<I", cut) + glb[12:cut] if cut >= 12 else glb[:cut]
                answer = self.send(ROUTES[0], honest)  # a header that knows of it may end before the binary chunk
                self.assertEqual(answer.status, 200 if cut == 20 + struct.unpack_from("<I", glb, 12)[0] else 400)

    def test_the_validators_files(self) -> None:
        invalid, names = set(), set()
        for name, content, report in validator_files():
            names.add(name)
            if any(message["severity"] == 0 for message in report["issues"]["messages"]):
                invalid.add(name)
            if name.endswith(".gltf"):
                self.assert_refused(content, 400, "malformed")
                content = wrapped(content)
            with self.subTest(name):
                if name in REFUSED:
                    self.assert_refused(content, *REFUSED[name])
                else:
                    self.assertEqual(self.send(ROUTES[0], content).status, 200)
                    self.assert_handled(self.send(ROUTES[1], content))
        self.assertEqual(len(invalid), INVALID_FILES)
        self.assertLessEqual(set(REFUSED), names)


class Contents(UploadTest):
    def test_required_extensions_are_refused_by_name(self) -> None:
        for name in ("KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression", "ACME_made_up", "", "KHR_materialsX", "\U0001f98a"):
            document, binary = small_character(extensionsUsed=[name], extensionsRequired=["KHR_materials_unlit", name])
            self.assert_refused(to_glb(document, binary), 422, "unsupported", "/extensionsRequired/1")
            document["extensionsRequired"] = [name]
            for route in ROUTES:
                answer = self.send(route, to_glb(document, binary))
                self.assert_problem(answer, 422, "unsupported", "/extensionsRequired/0")
                self.assertEqual(answer.json()["errors"][0]["value"], name)

    def test_nesting_keys_and_names_have_limits(self) -> None:
        def nested(levels: int) -> Any:
            return [nested(levels - 1)] if levels > 1 else []
        limits = self.service.get("/v1/limits").json()["files"]
        self.assertEqual([limits[name] for name in ("json_depth", "keys_per_object", "json_values", "json_memory", "nodes", "name_bytes")], [64, 256, 2000000, 64 * 2**20, 65536, 1024])
        keys = {f"k{i}": 0 for i in range(256)}
        for extras, status, slug in ((nested(63), 200, ""), (nested(64), 400, "too_deep"), (keys, 200, ""), ({**keys, "one": 1}, 413, "too_many_values"),
                                     ([0] * 1999000, 200, ""), ([0] * 2000000, 413, "too_many_values")):
            body = to_glb(*small_character(extras=extras))
            for route in ROUTES:
                answer = self.send(route, body)
                self.assertEqual((answer.status, slug and answer.json()["type"]), (status, slug and PROBLEM_TYPE + slug))
        for text, slug in ((b'"a":1,"a":2', "duplicate_key"), (b'"a":1,"\\u0061":2', "duplicate_key"), (b'"\\ud800":1', "malformed"), (b'"\\x":1', "malformed"),
                           (b'"a":1e999', "malformed"), (b'"a":"\xff"', "malformed")):
            self.assert_refused(to_glb(b'{"asset":{"version":"2.0"},"extras":{' + text + b"}}"), 400, slug)
        document, binary = small_character()
        document["nodes"][1]["name"] = "髪" * 341  # 1,023 bytes
        self.assertEqual(self.send(ROUTES[1], to_glb(document, binary)).status, 200)
        document["nodes"][1]["name"] += "ab"
        self.assert_refused(to_glb(document, binary), 422, "out_of_range", "/nodes/1/name")
        self.assert_refused(to_glb({"asset": {"version": "2.0"}, "nodes": [{}] * 65537}), 422, "too_many", "/nodes")

    def test_nothing_is_opened(self) -> None:
        with socket.create_server(("127.0.0.1", 0)) as listener:
            listener.setblocking(False)
            for uri in (f"http://127.0.0.1:{listener.getsockname()[1]}/x", "file:///etc/passwd", "/etc/passwd", "../../../../etc/passwd", "data:,x", ""):
                document, binary = skinned_character()
                document["images"] = [{"uri": uri}]
                document["buffers"].append({"byteLength": 8, "uri": uri})
                document["bufferViews"].append({"buffer": 1, "byteLength": 8})
                document["accessors"][0]["bufferView"] = 4
                with self.subTest(uri):
                    answer = self.send(ROUTES[1], to_glb(document, binary))
                    self.assert_ok(answer, "model/gltf-binary")
                    after, after_binary = glb_parts(answer.body)
                    self.assertEqual((after["images"], after["buffers"][1]), (document["images"], document["buffers"][1]))
                    self.assertNotIn(b"root:", after_binary)
                    document["buffers"][0]["uri"] = uri
                    self.assertEqual(self.send(ROUTES[0], to_glb(document, binary)).status, 200)
                    self.assert_problem(self.send(ROUTES[1], to_glb(document, binary)), 422, "unsupported", "/buffers/0/uri")
            with self.assertRaises(BlockingIOError):
                listener.accept()

    def test_repeated_work_is_bounded(self) -> None:
        """A thousand skins wear a mesh of three thousand primitives; a list of patterns meets megabytes of names."""
        document, binary = skinned_character()
        document["nodes"] += [{"mesh": 0, "skin": skin} for skin in range(1000)]
        document["skins"] *= 1000
        document["accessors"] += [document["accessors"][1]] * 3000
        document["meshes"][0]["primitives"] = [{"attributes": {"POSITION": 4 + i, "JOINTS_0": 2, "WEIGHTS_0": 3}} for i in range(3000)]
        self.assert_refused(to_glb(document, binary), 422, "too_many", "/meshes/0")
        document, binary = small_character()
        document["nodes"] = [part for i in range(0, 4000, 2) for part in ({"name": "a" * 1000, "children": [i + 1]}, {"translation": [0, 1, 0]})]
        document["skins"] = [{"joints": list(range(4000))}]
        glb = to_glb(document, binary)
        self.assert_problem(self.send("/v1/characters/motion?format=csv&chains=" + "*a" * 500, glb), 422, "too_many", "?chains")
        self.assert_ok(self.send("/v1/characters/motion?format=csv&chains=" + "*a" * 200, glb), "text/csv")


class Mutations(UploadTest):
    def places(self, node: Any) -> Iterator[tuple[Any, Any]]:
        for key in (list(node) if isinstance(node, dict) else range(len(node)) if isinstance(node, list) else ()):
            yield node, key
            yield from self.places(node[key])

    def test_flipped_bytes(self) -> None:
        chance = random.Random(20261126)
        whole = to_glb(*skinned_character())
        for _ in range(1000):
            glb = bytearray(whole)
            for _ in range(chance.randint(1, 4)):
                glb[chance.randrange(len(glb))] ^= 1 << chance.randrange(8)
            self.assert_handled(self.send(chance.choice(ROUTES), bytes(glb)))

    def test_replaced_values(self) -> None:
        chance = random.Random(3)
        text = json.dumps(skinned_character()[0])
        for _ in range(1000):
            document = json.loads(text)
            if chance.random() < 0.5:
                del document["extensions"]["VRMC_vrm"], document["extensions"]["VRMC_springBone"]
            for _ in range(chance.randint(1, 3)):
                owner, key = chance.choice(list(self.places(document)))
                if chance.random() < 0.2:
                    del owner[key]
                else:
                    owner[key] = json.loads(json.dumps(chance.choice(VALUES)))
            self.assert_handled(self.send(chance.choice(ROUTES), to_glb(document, skinned_character()[1])))


class Sizes(UploadTest):
    def status_of(self, path: str, media_type: str, size: int, more: str = "") -> str:
        """The status line that answers a head, before any of its body is sent."""
        with socket.create_connection((self.service.host, self.service.port), timeout=30) as connection:
            connection.sendall(f"POST {path} HTTP/1.1\r\nHost: x\r\nContent-Type: {media_type}\r\nContent-Length: {size}\r\n{more}\r\n".encode())
            return connection.recv(65536).split(b"\r\n")[0].decode()

    def test_too_large_is_refused_before_it_is_sent(self) -> None:
        limits, asking = self.service.get("/v1/limits").json(), "Expect: 100-continue\r\n"
        for path, media_type, most in (*((route, "model/gltf-binary", limits["files"]["bytes"]) for route in ROUTES),
                                       ("/v1/schedules", "application/json", limits["body_bytes"])):
            self.assertIn(" 100 ", self.status_of(path, media_type, most, asking))
            for more in (asking, ""):
                self.assertIn(" 413 ", self.status_of(path, media_type, most + 1, more))
        self.assertIn(" 404 ", self.status_of("/v1/nowhere", "model/gltf-binary", 4, asking))
        self.assert_problem(self.send(ROUTES[0], bytes(limits["files"]["bytes"] + 1)), 413, "too_large")

    def test_the_largest_file(self) -> None:
        limits = self.service.get("/v1/limits").json()
        document = {"asset": {"version": "2.0"}}
        glb = to_glb(document, bytes(limits["files"]["bytes"] - len(to_glb(document)) - 8))
        self.assertEqual(len(glb), limits["files"]["bytes"])
        self.assertEqual(self.send(ROUTES[0], glb).status, 200)
        text = json.dumps(document).encode()
        self.assert_refused(to_glb(text + b" " * (limits["body_bytes"] + 4 - len(text))), 413, "too_large")

    def test_memory_is_bounded(self) -> None:
        if is_sanitized(self.program):
            self.skipTest("a sanitizer needs memory of its own")
        nodes, two_mb = 65536, 2000000
        joints = ",".join(map(str, range(nodes)))
        pairs = ",".join('{"children":[%d]},{"translation":[0,1,0]}' % (i + 1) for i in range(0, nodes, 2))
        bodies = {
            "empty nodes": '"nodes":[' + ",".join(["{}"] * nodes) + "]", "empty joints": '"nodes":[' + ",".join(["{}"] * nodes) + f'],"skins":[{{"joints":[{joints}]}}]',
            "pairs": f'"nodes":[{pairs}],"skins":[{{"joints":[{joints}]}}]', "lists": '"extras":[' + ",".join(["[]"] * (two_mb // 3)) + "]",
            "short texts": '"extras":[' + ",".join(['""'] * (two_mb // 3)) + "]", "keys": '"extras":[' + ",".join(['{"":0}'] * (two_mb // 7)) + "]",
            "springs": '"extensions":{"VRMC_springBone":{"springs":[' + ",".join(["{}"] * (two_mb // 3)) + "]}}",
            "one long name": f'"nodes":[{{"name":"Head{"x" * 1000}","children":[{",".join(map(str, range(1, 65535, 2)))}]}},{pairs[pairs.index("},") + 2:]}]'}
        for name, text in bodies.items():
            with self.subTest(name), Service(self.program) as service:
                body = to_glb(('{"asset":{"version":"2.0"},' + text + "}").encode())
                service.request("POST", ROUTES[0], b"", GLB)
                before = self.most_memory(service)
                self.assertLess(service.request("POST", ROUTES[0], body, GLB).status, 500)
                self.assertLess(self.most_memory(service), before + 128 * 2**20 + 3 * len(body))  # as openapi.yaml says

    def most_memory(self, service: Service) -> int:
        with open(f"/proc/{service.pid}/status", encoding="utf-8") as status:
            return next(int(line.split()[1]) * 1024 for line in status if line.startswith("VmHWM"))
