"""openapi.yaml says what it must, in schemas that are schemas."""

from __future__ import annotations

import os
import unittest

import jsonschema
import yaml

import contract


class OpenApi(unittest.TestCase):
    def test_version_is_one_that_knows_json_schema(self) -> None:
        self.assertRegex(contract.DOCUMENT["openapi"], r"^3\.1\.\d+$")

    def test_keys_are_unique(self) -> None:
        class Strict(yaml.SafeLoader):
            def construct_mapping(self, node, deep=False):
                keys = [self.construct_object(key, deep=deep) for key, _ in node.value]
                twice = {key for key in keys if keys.count(key) > 1}
                if twice:
                    raise yaml.constructor.ConstructorError(None, None, f"twice: {twice}", node.start_mark)
                return super().construct_mapping(node, deep)

        with open(contract.CONTRACT, encoding="utf-8") as file:
            yaml.load(file, Loader=Strict)

    def test_references_resolve(self) -> None:
        for place, node in contract.walk(contract.DOCUMENT):
            if isinstance(node, dict) and isinstance(node.get("$ref"), str):
                with self.subTest(place):
                    contract.resolve(node)

    def test_named_parts_are_used(self) -> None:
        used = {node["$ref"] for _, node in contract.walk(contract.DOCUMENT) if isinstance(node, dict) and "$ref" in node}
        schemes = {name for way in contract.DOCUMENT["security"] for name in way}  # by their bare name
        for kind, parts in contract.DOCUMENT["components"].items():
            if kind == "securitySchemes":
                self.assertEqual(schemes, set(parts))
                continue
            for name in parts:
                with self.subTest(f"{kind}/{name}"):
                    self.assertIn(f"#/components/{kind}/{name}", used)

    def test_schemas_are_schemas(self) -> None:
        for place, schema in contract.schemas():
            with self.subTest(place):
                jsonschema.Draft202012Validator.check_schema(schema)

    def test_defaults_and_examples_fit_their_own_schema(self) -> None:
        for place, schema in contract.schemas():
            for value in ([schema["default"]] if "default" in schema else []) + schema.get("examples", []):
                with self.subTest(place, value=value):
                    self.assertEqual(contract.faults(value, schema), [])

    def test_properties_are_described(self) -> None:
        for place, schema in contract.schemas():
            for name, what in schema.get("properties", {}).items():
                with self.subTest(f"{place}/properties/{name}"):
                    self.assertTrue("$ref" in what or what.get("description"), "has neither a description nor a $ref")

    def test_what_may_be_left_out_has_a_default(self) -> None:
        for place, schema in contract.schemas():
            if not self.is_of_a_request(place):
                continue
            for name, what in schema.get("properties", {}).items():
                if name not in schema.get("required", []) and contract.resolve(what).get("type") != "object":
                    with self.subTest(f"{place}/properties/{name}"):
                        self.assertIn("default", contract.resolve(what))

    def test_numbers_of_requests_have_a_range_and_lists_a_size(self) -> None:
        for place, schema in contract.schemas():
            kinds = schema.get("type", [])
            kinds = [kinds] if isinstance(kinds, str) else kinds
            if not self.is_of_a_request(place):
                continue
            with self.subTest(place):
                if "number" in kinds or "integer" in kinds:
                    self.assertLessEqual({"minimum", "maximum"}, schema.keys())
                if "array" in kinds:
                    self.assertLessEqual({"minItems", "maxItems"}, schema.keys())
                if "string" in kinds and place.startswith("#/components/schemas/"):
                    self.assertTrue({"maxLength", "pattern"} & schema.keys())
                if "object" in kinds:
                    self.assertIs(schema.get("additionalProperties"), False)

    def test_operations_say_who_they_are(self) -> None:
        ids = [op.what["operationId"] for op in contract.operations()]
        self.assertEqual(len(ids), len(set(ids)))
        for op in contract.operations():
            with self.subTest(op.what["operationId"]):
                self.assertTrue(op.what.get("summary") and op.what.get("tags"))
                self.assertIn("default", op.what["responses"])

    def test_every_key_is_optional_and_pages_need_none(self) -> None:
        """One contract with keys and without: `{}` is the way of a server that has none."""
        self.assertEqual(contract.DOCUMENT["security"], [{}, {"key": []}])
        for op in contract.operations():
            with self.subTest(op.what["operationId"]):
                self.assertEqual(op.what.get("security", "a key"), "a key" if op.path.startswith("/v1/") else [])

    def test_every_operation_with_a_body_has_an_example(self) -> None:
        for op in contract.posts():
            for name in (f"{op.what['operationId']}.json", f"rejected/{op.what['operationId']}.json"):
                with self.subTest(name):
                    self.assertTrue(os.path.exists(os.path.join(contract.EXAMPLES, name)))

    @staticmethod
    def is_of_a_request(place: str) -> bool:
        """Whether a schema is part of what is sent: reachable from a request body or a parameter."""
        return "/parameters/" in place or ("/schemas/" in place and place.split("/")[3] in REQUEST_SCHEMAS)


def reachable(node: object, found: set[str]) -> set[str]:
    for _, part in contract.walk(node):
        if isinstance(part, dict) and str(part.get("$ref", "")).startswith("#/components/schemas/"):
            name = part["$ref"].split("/")[3]
            if name not in found:
                found.add(name)
                reachable(contract.DOCUMENT["components"]["schemas"][name], found)
    return found


REQUEST_SCHEMAS = reachable([[op.what.get("requestBody"), op.what.get("parameters")] for op in contract.operations()], set())
