"""Whatever is wrong with a body is found and named; it is never computed and never breaks the server."""

from __future__ import annotations

import json
from typing import Any, Iterator

import bad_inputs
import contract
from bad_inputs import REMOVED, changed
from support import ServiceTest


def objects(schema: Any, body: Any, pointer: str = "") -> Iterator[tuple[str, dict[str, Any]]]:
    """Every object that a schema knows, with a pointer to where it stands; lists by their first item."""
    schema = contract.resolve(schema)
    for part in schema.get("oneOf", []) + schema.get("allOf", []):
        if contract.resolve(part).get("type") in ("object", "array"):
            schema = contract.resolve(part)
    if schema.get("type") == "object":
        yield pointer, schema
        for name, what in schema.get("properties", {}).items():
            yield from objects(what, body, f"{pointer}/{name}")
    elif "items" in schema and contract.resolve(schema["items"]).get("type") == "object":
        yield from objects(schema["items"], body, f"{pointer}/0")


def allows_null(what: dict[str, Any]) -> bool:
    return not contract.faults(None, what)


class BadInputs(ServiceTest):
    def test_the_table_is_long_enough(self) -> None:
        for operation, rows in bad_inputs.ROWS.items():
            with self.subTest(operation):
                self.assertEqual(len({row.name for row in rows}), len(rows), "two rows of one name")
        self.assertGreaterEqual(sum(map(len, bad_inputs.ROWS.values())), 60)

    def test_the_table(self) -> None:
        for operation, rows in bad_inputs.ROWS.items():
            for row in rows:
                with self.subTest(f"{operation}: {row.name}"):
                    answer = self.service.post(f"/v1/{operation}{row.query}", json.dumps(changed(operation, row.changes)))
                    self.assert_problem(answer, 422, row.slug, row.pointer)
                    self.assertTrue(self.service.is_running)

    def test_the_schema_refuses_what_a_schema_can(self) -> None:
        """What the service refuses for its type, range, name or size is invalid by the contract too."""
        by_schema = {"wrong_type", "out_of_range", "not_a_choice", "unknown_field", "missing_field"}
        for operation, rows in bad_inputs.ROWS.items():
            schema = contract.request_schema(contract.operation(operation))
            for row in rows:
                fps = row.pointer.endswith("/fps") and row.slug == "out_of_range" and isinstance(list(row.changes.values())[0], str)
                if row.slug in by_schema and not row.query and not fps:
                    with self.subTest(f"{operation}: {row.name}"):
                        self.assertNotEqual(contract.faults(changed(operation, row.changes), schema), [])

    def test_every_field_refuses_every_wrong_type(self) -> None:
        for operation in bad_inputs.ROWS:
            schema = contract.request_schema(contract.operation(operation))
            for at, what in objects(schema, contract.example(operation)):
                for name, field in what["properties"].items():
                    for value in (None, True, 7.25, "\u9aea", [True], {"x": 1}):
                        changes = {f"{at}/{name}": value}
                        if at == "/head":
                            changes = {"/head": {}, **changes}
                        body = changed(operation, changes)
                        if contract.faults(value, field):
                            with self.subTest(f"{operation} {at}/{name}", value=value):
                                answer = self.service.post(f"/v1/{operation}", body)
                                self.assertEqual(answer.status, 422, answer.body[:300])
                                self.assertTrue(answer.json()["errors"][0]["pointer"].startswith(f"{at}/{name}"), answer.body[:300])

    def test_every_object_refuses_unknown_fields(self) -> None:
        for operation in bad_inputs.ROWS:
            schema = contract.request_schema(contract.operation(operation))
            for at, _ in objects(schema, contract.example(operation)):
                with self.subTest(f"{operation} {at}"):
                    self.assert_problem(self.service.post(f"/v1/{operation}", changed(operation, {f"{at}/zzz": 1})), 422, "unknown_field", f"{at}/zzz")

    def test_every_field_may_be_left_out_unless_it_is_required(self) -> None:
        for operation in bad_inputs.ROWS:
            schema = contract.request_schema(contract.operation(operation))
            for at, what in objects(schema, contract.example(operation)):
                for name in what["properties"]:
                    with self.subTest(f"{operation} {at}/{name}"):
                        answer = self.service.post(f"/v1/{operation}", changed(operation, {f"{at}/{name}": REMOVED}))
                        if name in what.get("required", []):
                            self.assert_problem(answer, 422, "missing_field", f"{at}/{name}")
                        elif name == "section":  # which makes the example's flat tuft a circle
                            self.assert_problem(answer, 422, "conflict", f"{at}/flatness")
                        else:
                            self.assertEqual(answer.status, 200, answer.body[:300])

    def test_the_default_is_what_a_missing_field_means(self) -> None:
        for operation in bad_inputs.ROWS:
            schema = contract.request_schema(contract.operation(operation))
            bare = {"tufts": {"tufts": [bad_inputs.SMALL_TUFT]}, "hairstyles": {"tufts": [bad_inputs.SMALL_TUFT], "motion": {}},
                    "motions": {"chains": [bad_inputs.SMALL_CHAIN]}, "schedules": {}}[operation]
            without = self.service.post(f"/v1/{operation}", bare)
            self.assertEqual(without.status, 200, without.body[:300])
            for at, what in objects(schema, bare):
                for name, field in what["properties"].items():
                    if "default" in contract.resolve(field):
                        with self.subTest(f"{operation} {at}/{name}"):
                            default = contract.resolve(field)["default"]
                            if operation == "hairstyles" and name == "motion":
                                continue  # null is stillness, and the body here moves
                            answer = self.service.post(f"/v1/{operation}", put(bare, f"{at}/{name}", default))
                            self.assertEqual(answer.status, 200, answer.body[:300])
                            self.assertEqual(answer.body, without.body)

    def test_queries(self) -> None:
        for query, slug, pointer in bad_inputs.QUERIES:
            with self.subTest(query):
                answer = self.service.get(f"/v1/schedules?{query}")
                self.assert_problem(answer, 400 if slug == "duplicate_key" else 422, slug, pointer)

    def test_the_ends_of_every_range_are_allowed(self) -> None:
        for operation in bad_inputs.ROWS:
            schema = contract.request_schema(contract.operation(operation))
            for at, what in objects(schema, contract.example(operation)):
                for name, field in what["properties"].items():
                    field = contract.resolve(field)
                    for keyword in ("minimum", "maximum"):
                        if keyword in field:
                            with self.subTest(f"{operation} {at}/{name} {keyword}"):
                                self.assert_allowed(operation, f"{at}/{name}", field[keyword])

    def test_the_largest_lists_are_allowed(self) -> None:
        for operation, pointer, value in (
                ("tufts", "/tufts/0/points", bad_inputs.LONGEST_STROKE), ("tufts", "/tufts/0/name", "\u9aea" * 64),
                ("motions", "/chains/0/nodes", bad_inputs.LONGEST_CHAIN),
                ("motions", "/chains", [bad_inputs.SMALL_CHAIN] * 16384)):
            with self.subTest(f"{operation} {pointer}"):
                answer = self.service.post(f"/v1/{operation}", changed(operation, {pointer: value}))
                self.assertEqual(answer.status, 200, answer.body[:300])
        body = {"tufts": [{**bad_inputs.SMALL_TUFT, "joints": 1}] * 16384, "mesh": {"rings": 2, "sides": 3, "layout": "merged"}}
        self.assertEqual(self.service.post("/v1/tufts", body).status, 200)

    def assert_allowed(self, operation: str, pointer: str, value: float) -> None:
        """A value at the end of its range, among others that it gets along with."""
        changes: dict[str, Any] = {"/timing": {"period": 0.45}, **FRIENDS.get(pointer.rsplit("/", 1)[1], {}).get(value, {})}
        if operation != "schedules":
            changes = {pointer.replace("/timing", "/motion/timing"): v for pointer, v in changes.items() if operation != "tufts" or "timing" not in pointer}
            if operation in ("tufts", "hairstyles"):
                changes = {"/tufts": [dict(bad_inputs.SMALL_TUFT)], **changes}
        answer = self.service.post(f"/v1/{operation}", changed(operation, {**changes, pointer: value}))
        self.assertEqual(answer.status, 200, answer.body[:300])


# By field and value: what else must hold so that the value makes sense.
FRIENDS: dict[str, dict[float, dict[str, Any]]] = {
    "flatness": {0.98: {"/tufts": [{**bad_inputs.SMALL_TUFT, "section": "ellipse"}]}},
    "period": {0.01: {"/timing": {"fps": 60}}, 60: {"/timing": {"hold": 24, "fps": 9.6}}},
    "hold": {24: {"/timing": {"period": 1}}},
    "cycles": {11: {"/timing": {"period": 1, "hold": 1}}},
    "repeat": {1440: {"/timing": {"period": 0.4, "hold": 2}}},
}


def put(body: Any, pointer: str, value: Any) -> Any:
    """A copy of a body with one value put in."""
    first, _, rest = pointer[1:].partition("/")
    if isinstance(body, list):
        return [put(item, "/" + rest, value) if i == int(first) else item for i, item in enumerate(body)] if rest else body
    return {**body, first: put(body.get(first, {}), "/" + rest, value) if rest else value}
