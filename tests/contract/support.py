"""What the contract tests share: the running service, and what every problem must look like."""

from __future__ import annotations

import json
import struct
import unittest
from typing import Any, Optional
from urllib.parse import urlencode

import contract
from service import Answer, Service

GLB = {"Content-Type": "model/gltf-binary"}
PROBLEM_TYPE = "urn:tuftwave:problem:"


class ServiceTest(unittest.TestCase):
    """A test against the service that check_contract.py has started."""

    service: Service
    program: str

    def assert_problem(self, answer: Answer, status: int, slug: str, pointer: Optional[str] = None) -> None:
        """A problem document of the contract's schema; `pointer` is that of its first error, None where there is none to name."""
        self.assertEqual((answer.status, answer.media_type), (status, "application/problem+json"), answer.body[:300])
        problem = json.loads(answer.body)
        self.assertEqual(contract.faults(problem, contract.named("Problem")), [])
        self.assertEqual(problem["type"], PROBLEM_TYPE + slug, problem["detail"])
        self.assertEqual(problem["status"], status)
        if pointer is not None:
            self.assertEqual(problem["errors"][0]["pointer"], pointer, problem["detail"])
            self.assertEqual(problem["errors"][0]["code"], slug)
        self.assertEqual(answer.headers.get("cache-control"), "no-store")
        self.assertTrue(answer.headers.get("request-id"))
        self.assertEqual(answer.headers["request-id"], problem["request_id"])

    def assert_ok(self, answer: Answer, media_type: str) -> None:
        self.assertEqual((answer.status, answer.media_type), (200, media_type), answer.body[:300])

    def has_studio(self) -> bool:
        """Whether the server was built with the studio; else / is the page of /docs."""
        return self.service.get("/").body != self.service.get("/docs").body

    def tearDown(self) -> None:
        self.assertTrue(self.service.is_running, "the server has ended")


class CharacterTest(ServiceTest):
    def chains(self, glb: bytes) -> Any:
        answer = self.service.request("POST", "/v1/characters/chains", glb, GLB)
        self.assert_ok(answer, "application/json")
        self.assertEqual(contract.faults(answer.json(), contract.named("CharacterChainsAnswer")), [])
        return answer.json()

    def motion(self, glb: bytes, **query: Any) -> Answer:
        return self.service.request("POST", "/v1/characters/motion?" + urlencode(query), glb, GLB)

    def clip(self, glb: bytes, **query: Any) -> bytes:
        answer = self.motion(glb, **query)
        self.assert_ok(answer, "model/gltf-binary")
        return answer.body

    def poses(self, glb: bytes, **query: Any) -> Any:
        answer = self.motion(glb, format="json", **query)
        self.assert_ok(answer, "application/json")
        self.assertEqual(contract.faults(answer.json(), contract.named("CharacterMotionAnswer")), [])
        return answer.json()

    def assert_same(self, one: Any, other: Any) -> None:
        """Two documents alike, the order of their keys, the kinds of their numbers and their signs of zero included."""
        self.assertEqual(json.dumps(one).split(", "), json.dumps(other).split(", "))


def glb_parts(glb: bytes) -> tuple[Any, bytes]:
    """The JSON and the buffer of a GLB. Raises ValueError."""
    magic, version, length = struct.unpack_from("<III", glb)
    if (magic, version, length) != (0x46546C67, 2, len(glb)):
        raise ValueError("is no GLB of its own length")
    chunks, at = {}, 12
    while at < length:
        size, kind = struct.unpack_from("<II", glb, at)
        chunks[kind] = glb[at + 8:at + 8 + size]
        at += 8 + size
    return json.loads(chunks[0x4E4F534A]), chunks.get(0x004E4942, b"")


def floats(gltf: Any, buffer: bytes, accessor: int) -> list[float]:
    """The float32 values of an accessor whose elements stand without gaps."""
    at = gltf["accessors"][accessor]
    width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[at["type"]]
    start = gltf["bufferViews"][at["bufferView"]].get("byteOffset", 0) + at.get("byteOffset", 0)
    return list(struct.unpack_from(f"<{at['count'] * width}f", buffer, start))
