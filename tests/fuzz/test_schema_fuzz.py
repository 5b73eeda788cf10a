"""The tools of the schema fuzz themselves: a check that cannot fail is none."""

from __future__ import annotations

import json
import os
import random
import sys
import unittest
from typing import Any

sys.dont_write_bytecode = True
sys.path[:0] = [os.path.dirname(os.path.abspath(__file__)), os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "contract")]

import broken_values  # noqa: E402
import contract  # noqa: E402
import schema_fuzz  # noqa: E402
from quick_schema import compiled  # noqa: E402
from service import Answer  # noqa: E402
from valid_values import Values  # noqa: E402

PROBLEM = {"type": "urn:tuftwave:problem:busy", "title": "t", "status": 503, "detail": "d", "request_id": "1"}


def answer(status: int, media_type: str, body: Any) -> Answer:
    return Answer(status, {"content-type": media_type, "request-id": "1"}, body if isinstance(body, bytes) else json.dumps(body).encode())


class QuickSchema(unittest.TestCase):
    def test_agrees_with_jsonschema_on_good_and_bad_bodies(self) -> None:
        source = random.Random(1)
        for op in contract.posts():
            schema = contract.request_schema(op)
            for _ in range(40):
                body = Values(source).body(op)
                self.assertEqual((compiled(schema)(body), contract.faults(body, schema)), (None, []))
                broken = broken_values.Mutations(source, op, body)
                broken.broken()
                if not isinstance(broken.holder[0], bytes):
                    self.assertTrue(compiled(schema)(broken.holder[0]))
                    self.assertNotEqual(contract.faults(broken.holder[0], schema), [])

    def test_every_schema_of_the_contract_compiles(self) -> None:
        for name in contract.DOCUMENT["components"]["schemas"]:
            compiled(contract.named(name))

    def test_refuses_keywords_it_does_not_know(self) -> None:
        with self.assertRaises(ValueError):
            compiled({"type": "string", "format": "date"})


class Faults(unittest.TestCase):
    def setUp(self) -> None:
        self.op = contract.operation("schedules")

    def test_a_sound_problem_has_none(self) -> None:
        self.assertIsNone(schema_fuzz.fault_of(self.op, answer(503, "application/problem+json", PROBLEM), True))

    def test_what_the_contract_has_not_is_found(self) -> None:
        for name, wrong in {
            "another media type": answer(422, "application/json", PROBLEM),
            "another status": answer(422, "application/problem+json", PROBLEM),
            "a field too many": answer(503, "application/problem+json", {**PROBLEM, "trace": "at line 3"}),
            "a file that is none": answer(200, "model/gltf-binary", b"glTF"),
            "an empty sheet": answer(200, "text/csv", b""),
            "an answer without a schedule": answer(200, "application/json", {"warnings": []}),
        }.items():
            with self.subTest(name):
                op = contract.operation("tufts") if wrong.media_type == "model/gltf-binary" else self.op
                self.assertTrue(schema_fuzz.fault_of(op, wrong, False))

    def test_a_pointer_is_about_a_place_if_one_holds_the_other(self) -> None:
        for pointer, place, is_about in (("/a/b", "/a/b", True), ("/a", "/a/b", True), ("/a/b/0", "/a/b", True), ("/a/bc", "/a/b", False), ("?x", "?x", True),
                                         ("?xy", "?x", False)):
            self.assertEqual(schema_fuzz.is_about(pointer, place), is_about, (pointer, place))


if __name__ == "__main__":
    unittest.main()
