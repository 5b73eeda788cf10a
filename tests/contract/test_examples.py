"""The bodies in api/examples are what the contract says, and are answered in every format."""

from __future__ import annotations

import json
import os

import contract
from support import ServiceTest, glb_parts

STILL = ("/v1/tufts", "/v1/fills", "/v1/evaluations", "/v1/fits")


class Examples(ServiceTest):
    def test_examples_fit_their_schema(self) -> None:
        for op in contract.posts():
            with self.subTest(op.what["operationId"]):
                self.assertEqual(contract.faults(contract.example(op.what["operationId"]), contract.request_schema(op)), [])

    def test_every_example_belongs_to_an_operation(self) -> None:
        ids = {f"{op.what['operationId']}.json" for op in contract.posts()}
        self.assertEqual({name for name in os.listdir(contract.EXAMPLES) if name.endswith(".json")}, ids)
        self.assertEqual(set(os.listdir(os.path.join(contract.EXAMPLES, "rejected"))), ids | {"index.json"})

    def test_every_format_is_answered_by_accept_and_by_query_alike(self) -> None:
        for op in contract.posts():
            body = contract.example(op.what["operationId"])
            for word in contract.formats(op):
                media_type = contract.MEDIA_TYPES[word]
                with self.subTest(f"{op.path} as {word}"):
                    self.assertIn(media_type, contract.answer_content(op))
                    by_accept = self.service.post(op.path, body, Accept=media_type)
                    by_query = self.service.post(f"{op.path}?format={word}", body, Accept="image/png")
                    self.assert_ok(by_accept, media_type)
                    self.assert_ok(by_query, media_type)
                    self.assertEqual(by_accept.body, by_query.body)
                    self.assertEqual(by_accept.headers.get("vary"), "Accept")
                    self.assert_fits(by_accept.body, word, contract.answer_content(op)[media_type].get("schema"))

    def test_the_first_documented_format_is_the_default(self) -> None:
        for op in contract.posts():
            with self.subTest(op.path):
                answer = self.service.post(op.path, contract.example(op.what["operationId"]))
                self.assertEqual(answer.media_type, next(iter(contract.answer_content(op))))
                documented = next(p for p in map(contract.resolve, op.what["parameters"]) if p["name"] == "format")["schema"]["default"]
                self.assertEqual(answer.media_type, contract.MEDIA_TYPES[documented])

    def test_files_have_names_and_json_has_none(self) -> None:
        for op in contract.posts():
            for word in contract.formats(op):
                with self.subTest(f"{op.path} as {word}"):
                    answer = self.service.post(f"{op.path}?format={word}", contract.example(op.what["operationId"]))
                    rate = "30" if word == "vmd" else "24"
                    given = answer.headers.get("content-disposition", "")
                    self.assertRegex(given, r"^$" if word == "json" else rf'^attachment; filename="[a-z]+(_{rate}fps)?\.{word}"$')
                    self.assertEqual(answer.headers.get("tuftwave-frame-rate"), None if op.path in STILL else rate)

    def test_rejected_twins_are_rejected_for_their_one_fault(self) -> None:
        with open(os.path.join(contract.EXAMPLES, "rejected", "index.json"), encoding="utf-8") as file:
            index = json.load(file)
        self.assertEqual(set(index), {op.what["operationId"] for op in contract.posts()})
        for op in contract.posts():
            name = op.what["operationId"]
            with self.subTest(name):
                answer = self.service.post(op.path, contract.example(name, rejected=True))
                self.assert_problem(answer, 422, index[name]["slug"], index[name]["pointer"])
                self.assertEqual(len(answer.json()["errors"]), 1)

    def test_a_hairstyle_without_motion_is_still(self) -> None:
        body = contract.example("hairstyles")
        del body["motion"]
        for motion in ({}, {"motion": None}):
            answer = self.service.post("/v1/hairstyles?format=json", {**body, **motion})
            self.assert_ok(answer, "application/json")
            self.assertEqual(contract.faults(answer.json(), contract.named("HairstyleAnswer")), [])
            self.assertFalse({"pictures", "schedule", "quality"} & answer.json().keys())
            self.assertNotIn("tuftwave-frame-rate", answer.headers)
            self.assertNotIn("animations", glb_parts(self.service.post("/v1/hairstyles", {**body, **motion}).body)[0])

    def assert_fits(self, body: bytes, word: str, schema: object) -> None:
        if word == "glb":
            gltf, _ = glb_parts(body)
            self.assertEqual(gltf["asset"]["version"], "2.0")
        elif word in ("json", "gltf"):
            self.assertEqual(contract.faults(json.loads(body), schema), [])
        elif word == "xdts":
            first, rest = body.split(b"\n", 1)
            self.assertEqual(first, b"exchangeDigitalTimeSheet Save Data")
            self.assertEqual(json.loads(rest)["version"], 5)
        elif word == "vmd":
            self.assertTrue(body.startswith(b"Vocaloid Motion Data 0002\0"))
            self.assertEqual(len(body), 74 + 111 * int.from_bytes(body[50:54], "little"))
        elif word == "bvh":
            self.assertTrue(body.startswith(b"HIERARCHY\nROOT hair_root\n{\n"))
        elif word == "usda":
            self.assertTrue(body.startswith(b"#usda 1.0\n(\n"))
        else:
            self.assertTrue(body.startswith(b"frame,picture,key\r\n") and body.endswith(b"\r\n"))
