"""Whatever is wrong with a body is found and named; it is never computed and never breaks the server."""

from __future__ import annotations

import json
import math
from typing import Any, Iterator

import bad_inputs
import contract
import rows
from rows import REMOVED, changed, with_changes
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


def ends(field: Any) -> Iterator[float]:
    """The smallest and the largest number that a field may be, also where it may be something else."""
    field = contract.resolve(field)
    yield from (field[keyword] for keyword in ("minimum", "maximum") if keyword in field)
    for part in field.get("oneOf", []) + field.get("allOf", []):
        yield from ends(part)


def around(operation: str, pointer: str, body: Any) -> dict[str, Any]:
    """What must stand around a field so that it alone decides."""
    changes = rows.around(pointer)
    if operation == "evaluations" and (pointer == "/chains" or pointer.startswith("/lines/")):  # the one or the other
        changes.update({"/motion": REMOVED, "/chains": REMOVED, "/lines": [{"pictures": body["drawn"][0]["pictures"]}]})
    return changes


class BadInputs(ServiceTest):
    def test_the_table_is_long_enough(self) -> None:
        for operation, table in bad_inputs.ROWS.items():
            with self.subTest(operation):
                self.assertEqual(len({row.name for row in table}), len(table), "two rows of one name")
        self.assertGreaterEqual(sum(map(len, bad_inputs.ROWS.values())), 60)

    def test_the_table(self) -> None:
        for operation, table in bad_inputs.ROWS.items():
            for row in table:
                with self.subTest(f"{operation}: {row.name}"):
                    answer = self.service.post(f"/v1/{operation}{row.query}", json.dumps(changed(operation, row.changes)))
                    self.assert_problem(answer, 422, row.slug, row.pointer)
                    self.assertTrue(self.service.is_running)

    def test_the_schema_refuses_what_a_schema_can(self) -> None:
        """What the service refuses for its type, range, name or size is invalid by the contract too."""
        by_schema = {"wrong_type", "out_of_range", "not_a_choice", "unknown_field", "missing_field"}
        for operation, table in bad_inputs.ROWS.items():
            schema = contract.request_schema(contract.operation(operation))
            for row in table:
                if row.slug in by_schema and not row.pointer.startswith("?") and not row.beyond_schema:
                    with self.subTest(f"{operation}: {row.name}"):
                        self.assertNotEqual(contract.faults(changed(operation, row.changes), schema), [])

    def test_every_field_refuses_every_wrong_type(self) -> None:
        for operation in bad_inputs.ROWS:
            schema = contract.request_schema(contract.operation(operation))
            for at, what in objects(schema, contract.example(operation)):
                for name, field in what["properties"].items():
                    for value in (None, True, 7.25, "\u9aea", [True], {"x": 1}):
                        changes = {**around(operation, f"{at}/{name}", contract.example(operation)), f"{at}/{name}": value}
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
                    body = changed(operation, {**around(operation, f"{at}/zzz", contract.example(operation)), f"{at}/zzz": 1})
                    self.assert_problem(self.service.post(f"/v1/{operation}", body), 422, "unknown_field", f"{at}/zzz")

    def test_every_field_may_be_left_out_unless_it_is_required(self) -> None:
        for operation in bad_inputs.ROWS:
            schema = contract.request_schema(contract.operation(operation))
            for at, what in objects(schema, contract.example(operation)):
                for name in what["properties"]:
                    with self.subTest(f"{operation} {at}/{name}"):
                        body = changed(operation, {**around(operation, f"{at}/{name}", contract.example(operation)), f"{at}/{name}": REMOVED})
                        answer = self.service.post(f"/v1/{operation}", body)
                        if name in what.get("required", []):
                            self.assert_problem(answer, 422, "missing_field", f"{at}/{name}")
                        elif name == "section":  # which makes the example's flat tuft a circle
                            self.assert_problem(answer, 422, "conflict", f"{at}/flatness")
                        else:
                            self.assertEqual(answer.status, 200, answer.body[:300])

    def test_the_default_is_what_a_missing_field_means(self) -> None:
        for operation in bad_inputs.ROWS:
            schema = contract.request_schema(contract.operation(operation))
            bare = {"tufts": {"tufts": [rows.SMALL_TUFT]}, "hairstyles": {"tufts": [rows.SMALL_TUFT], "motion": {}},
                    "fills": {"fill": {"from": rows.SMALL_TUFT, "to": rows.OTHER_SMALL_TUFT}},
                    "motions": {"chains": [rows.SMALL_CHAIN]}, "schedules": {},
                    "evaluations": {"drawn": [rows.small_lines()], "chains": [rows.SMALL_LINE_CHAIN]}, "fits": {"drawn": [rows.small_lines()]}}[operation]
            for at, what in objects(schema, bare):
                for name, field in what["properties"].items():
                    if "default" in contract.resolve(field):
                        with self.subTest(f"{operation} {at}/{name}"):
                            default = contract.resolve(field)["default"]
                            if operation == "hairstyles" and name == "motion":
                                continue  # null is stillness, and the body here moves
                            changes = around(operation, f"{at}/{name}", bare)
                            without = self.service.post(f"/v1/{operation}", with_changes(bare, {**changes, f"{at}/{name}": REMOVED}))
                            self.assertEqual(without.status, 200, without.body[:300])
                            answer = self.service.post(f"/v1/{operation}", with_changes(bare, {**changes, f"{at}/{name}": default}))
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
                    for end in ends(field):
                        with self.subTest(f"{operation} {at}/{name} {end}"):
                            self.assert_allowed(operation, f"{at}/{name}", end)

    def test_the_largest_lists_are_allowed(self) -> None:
        for operation, pointer, value in (
                ("tufts", "/tufts/0/points", rows.LONGEST_STROKE), ("tufts", "/tufts/0/name", "\u9aea" * 64),
                ("fills", "/fill/from/points", rows.LONGEST_STROKE), ("fills", "/fill/name", "\u9aea" * 48),
                ("fills", "/head/scalp", {"mesh": largest_scalp()}),
                ("hairstyles", "/fills", [{"from": "ahoge", "density": {"along": 1}}] * 1024),
                ("motions", "/chains/0/nodes", rows.LONGEST_CHAIN),
                ("motions", "/chains", [rows.SMALL_CHAIN] * 16384),
                ("evaluations", "/drawn/0/name", "\u9aea" * 64),
                ("fits", "/drawn", [{"pictures": [rows.LONGEST_CHAIN] * 12 + [rows.OTHER_LONGEST_CHAIN] * 12}] * 10)):
            with self.subTest(f"{operation} {pointer}"):
                answer = self.service.post(f"/v1/{operation}", changed(operation, {pointer: value}))
                self.assertEqual(answer.status, 200, answer.body[:300])
        body = {"tufts": [{**rows.SMALL_TUFT, "joints": 1}] * 16384, "mesh": {"rings": 2, "sides": 3, "layout": "merged"}}
        self.assertEqual(self.service.post("/v1/tufts", body).status, 200)

    def assert_allowed(self, operation: str, pointer: str, value: float) -> None:
        """A value at the end of its range, among others that it gets along with."""
        changes: dict[str, Any] = {"/timing": {"period": 0.45}, "/tufts": [dict(rows.SMALL_TUFT)],
                                   **around(operation, pointer, contract.example(operation)),
                                   **FRIENDS.get(pointer.rsplit("/", 1)[1], {}).get(value, {})}
        if operation not in ("schedules", "fits"):
            changes = {pointer.replace("/timing", "/motion/timing"): v for pointer, v in changes.items()}
        known = contract.resolve(contract.request_schema(contract.operation(operation)))["properties"]
        changes = {pointer: v for pointer, v in changes.items() if pointer.split("/")[1] in known}
        answer = self.service.post(f"/v1/{operation}", changed(operation, {**changes, pointer: value}))
        if operation in ("evaluations", "fits") and answer.status == 422:  # allowed, but not as many pictures as the example has
            self.assert_problem(answer, 422, "conflict", "/motion/timing" if operation == "evaluations" else "/drawn/0/pictures")
            return
        self.assertEqual(answer.status, 200, answer.body[:300])


# By field and value: what else must hold so that the value makes sense.
FRIENDS: dict[str, dict[float, dict[str, Any]]] = {
    "flatness": {0.98: {"/tufts": [{**rows.SMALL_TUFT, "section": "ellipse"}]}},
    "fps": {1: {"/timing": {"period": 10}}, 240: {"/timing": {"period": 0.1}}},
    "period": {0.01: {"/timing": {"fps": 60}}, 60: {"/timing": {"hold": 24, "fps": 9.6}}},
    "hold": {24: {"/timing": {"period": 1}}},
    "cycles": {11: {"/timing": {"period": 1, "hold": 1}}},
    "repeat": {1440: {"/timing": {"period": 0.4, "hold": 2}}},
    "tufts_per_meter": {1e6: {"/fill/density": {"along": 1}, "/fills/0/density": {"along": 1}}},
}


def largest_scalp() -> dict[str, Any]:
    """As many vertices and triangles as there may be: a ribbon wound around a ball from pole to pole, and its last triangle three times."""
    count = 200000
    heights = [1 - 2 * (i + 0.5) / count for i in range(count)]
    turns = [0.05 * i for i in range(count)]
    positions = [round(0.1 * c, 4) for y, turn in zip(heights, turns)
                 for c in (math.sqrt(1 - y * y) * math.cos(turn), y, math.sqrt(1 - y * y) * math.sin(turn))]
    return {"positions": positions, "triangles": [corner for i in range(count) for corner in range(min(i, count - 3), min(i, count - 3) + 3)]}
