"""What tables of bad bodies are made of: a row, small bodies, and changes to a body."""

from __future__ import annotations

import copy
from typing import Any, Iterable, NamedTuple, Optional

import contract


class Row(NamedTuple):
    name: str
    changes: dict[str, Any]
    slug: str
    pointer: str
    query: str = ""
    beyond_schema: bool = False  # valid by the contract's schema, which cannot say everything


class Removed:
    """Takes a field away."""


REMOVED = Removed()
POINT = [0.0, 0.1, 0.05]
OTHER_POINT = [0.0, 0.05, 0.1]
LONGEST_STROKE = [[0.0, 0.1 + 0.001 * i, 0.05] for i in range(1024)]
LONGEST_CHAIN = [[0.0, -0.01 * i, 0.0] for i in range(65)]
OTHER_LONGEST_CHAIN = [[0.0001 * i * i, -0.01 * i, 0.0] for i in range(65)]
SMALL_TUFT = {"points": [POINT, OTHER_POINT]}
OTHER_SMALL_TUFT = {"points": [[0.05, 0.1, 0.0], [0.1, 0.05, 0.0]]}
SMALL_CHAIN = {"nodes": [POINT, OTHER_POINT]}
SMALL_LINE_CHAIN = {"nodes": [[0, 0, 0], [0.1, 0, 0], [0.2, 0, 0]]}  # what small_lines() are drawings of


def below(limit: float) -> float:
    return limit - max(1e-9, abs(limit) * 1e-9)


def above(limit: float) -> float:
    return limit + max(1e-9, abs(limit) * 1e-9)


def placed(place: str, rows: Iterable[Row]) -> list[Row]:
    """Rows whose pointers begin at `place`."""
    return [row._replace(changes={place + pointer: value for pointer, value in row.changes.items()}, pointer=place + row.pointer) for row in rows]


def outside(pointer: str, smallest: float, largest: float, at: Optional[str] = None) -> list[Row]:
    """A number just below and just above its range."""
    return [Row(f"{pointer} just below", {pointer: below(smallest)}, "out_of_range", at or pointer),
            Row(f"{pointer} just above", {pointer: above(largest)}, "out_of_range", at or pointer)]


def outside_whole(pointer: str, smallest: int, largest: int) -> list[Row]:
    return [Row(f"{pointer} one below", {pointer: smallest - 1}, "out_of_range", pointer),
            Row(f"{pointer} one above", {pointer: largest + 1}, "out_of_range", pointer),
            Row(f"{pointer} between two whole numbers", {pointer: smallest + 0.5}, "wrong_type", pointer),
            Row(f"{pointer} far beyond 64 bits", {pointer: 1e300}, "out_of_range", pointer)]


def ellipsoid() -> dict[str, Any]:
    return {"radii": [0.1, 0.1, 0.1]}


def tetrahedron() -> dict[str, Any]:
    """The smallest mesh that goes all around."""
    return {"positions": [0.1, 0.1, 0.1, 0.1, -0.1, -0.1, -0.1, 0.1, -0.1, -0.1, -0.1, 0.1],
            "triangles": [0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2]}


def small_lines() -> dict[str, Any]:
    """Two bones in as many pictures as the default timing has."""
    return {"pictures": [[[0, 0], [0.1, 0.01 * y], [0.19, 0.03 * y - 0.02]] for y in (0, 1, 1, 0, -1, -1)]}


def named_tufts() -> list[dict[str, Any]]:
    return [{**SMALL_TUFT, "name": "a"}, {**OTHER_SMALL_TUFT, "name": "b"}]


def changed(operation: str, changes: dict[str, Any]) -> Any:
    """An operation's example with changes made at JSON pointers."""
    return with_changes(contract.example(operation), changes)


def with_changes(body: Any, changes: dict[str, Any]) -> Any:
    """A body with changes made at JSON pointers, in their order; what is not there yet is an object."""
    whole = {"": copy.deepcopy(body)}
    for pointer, shared in changes.items():
        value = shared if shared is REMOVED else copy.deepcopy(shared)  # later changes may go into it
        *path, last = ["", *(part.replace("~1", "/").replace("~0", "~") for part in pointer.split("/")[1:])]
        node: Any = whole
        for part in path:
            node = node[int(part)] if isinstance(node, list) else node.setdefault(part, {})
        if value is REMOVED:
            node.pop(last, None)
        elif isinstance(node, list):
            node[int(last)] = value
        else:
            node[last] = value
    return whole[""]


def around(pointer: str) -> dict[str, Any]:
    """What must stand around a field that not every body has, so that the field alone decides: changes to be made first."""
    changes: dict[str, Any] = {}
    scalp, _, rest = pointer.partition("/scalp/")
    if rest:  # the one shape, unless this is about the other
        is_ellipsoid = rest.startswith("ellipsoid/") or rest == "mesh"
        changes[f"{scalp}/scalp"] = {"ellipsoid": ellipsoid()} if is_ellipsoid else {"mesh": tetrahedron()}
    if "/origin/" in pointer:
        changes[f"{pointer.partition('/origin/')[0]}/origin"] = {"kind": "neck", "index": 1}
    if pointer.startswith("/fills/0"):
        changes.update({"/tufts": named_tufts(), "/fills": [{"from": "a", "to": "b"}]})
    if "/jitter/" in pointer:
        changes[f"{pointer.partition('/jitter/')[0]}/jitter"] = {}
    return changes
