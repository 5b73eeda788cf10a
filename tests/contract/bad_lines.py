"""What can be wrong with drawn lines, and with what they are compared to."""

from __future__ import annotations

from typing import Any

import contract
from rows import LONGEST_CHAIN, POINT, REMOVED, SMALL_CHAIN, Row, outside, outside_whole, placed

PICTURES = contract.example("fits")["drawn"][0]["pictures"]  # 6 of 5 nodes; those of the other example are the same
FLAT_LINE = [[0, 0], [0, 1], [0, 2]]
ON_THE_SPOT = [[0.1, 0.2], [0.1, 0.2], [0.1, 0.2], [0.1, 0.2], [0.1, 0.2]]


def pictures(smallest: int) -> list[Row]:
    """What can be wrong with a chain's pictures, of which there must be so many."""
    return [
        Row("pictures are missing", {"/pictures": REMOVED}, "missing_field", "/pictures"),
        Row("pictures are null", {"/pictures": None}, "wrong_type", "/pictures"),
        Row("pictures are an object", {"/pictures": {}}, "wrong_type", "/pictures"),
        Row("too few pictures", {"/pictures": [PICTURES[0]] * (smallest - 1)}, "too_few", "/pictures"),
        Row("a picture too many", {"/pictures": [PICTURES[0]] * 25}, "too_many", "/pictures"),
        Row("a picture is null", {"/pictures/1": None}, "wrong_type", "/pictures/1"),
        Row("a picture is an object", {"/pictures/1": {"nodes": PICTURES[1]}}, "wrong_type", "/pictures/1"),
        Row("a picture without nodes", {"/pictures/0": []}, "too_few", "/pictures/0"),
        Row("a picture of one node", {"/pictures/0": [POINT]}, "too_few", "/pictures/0"),
        Row("a node too many", {"/pictures/1": LONGEST_CHAIN + [POINT]}, "too_many", "/pictures/1"),
        Row("a picture has a node less", {"/pictures/3": PICTURES[3][:-1]}, "conflict", "/pictures/3"),
        Row("a node is null", {"/pictures/1/2": None}, "wrong_type", "/pictures/1/2"),
        Row("a node is a number", {"/pictures/1/2": 1}, "wrong_type", "/pictures/1/2"),
        Row("a node has one number", {"/pictures/1/2": [1]}, "wrong_type", "/pictures/1/2"),
        Row("a node has four numbers", {"/pictures/1/2": [0, 0, 0, 1]}, "wrong_type", "/pictures/1/2"),
        Row("a node holds a text", {"/pictures/1/2": [0, "0"]}, "wrong_type", "/pictures/1/2/1"),
        Row("a node holds true", {"/pictures/1/2": [0, 0, True]}, "wrong_type", "/pictures/1/2/2"),
        *outside("/pictures/5/4/1", -1e6, 1e6),
        Row("a node as far as numbers go", {"/pictures/0/4/0": -1.7e308}, "out_of_range", "/pictures/0/4/0"),
        Row("name is too long", {"/name": "x" * 65}, "too_many", "/name"),
        Row("name is null", {"/name": None}, "wrong_type", "/name"),
        Row("lines have a field too many", {"/nodes": []}, "unknown_field", "/nodes"),
    ]


def lists(place: str) -> list[Row]:
    """What can be wrong with a list of chains that somebody drew."""
    return [
        Row(f"{place} is an object", {place: {}}, "wrong_type", place),
        Row(f"{place} holds nothing", {place: []}, "too_few", place),
        Row(f"{place} holds null", {f"{place}/0": None}, "wrong_type", f"{place}/0"),
        Row(f"{place} holds a line", {f"{place}/0": FLAT_LINE}, "wrong_type", f"{place}/0"),
    ]


def compared_to_lines(row: Row) -> Row:
    """A row about lines, in a body that compares lines to lines."""
    lines: dict[str, Any] = {"/chains": REMOVED, "/motion": REMOVED, "/lines": [{"pictures": PICTURES}]}
    return row._replace(name=f"lines: {row.name}", changes={**lines, **row.changes})


EVALUATIONS = [
    Row("drawn is missing", {"/drawn": REMOVED}, "missing_field", "/drawn"),
    Row("drawn is null", {"/drawn": None}, "wrong_type", "/drawn"),
    *lists("/drawn"),
    *placed("/drawn/0", pictures(1)),
    *outside("/drawn/0/rest_length", 1e-9, 1e9),
    Row("rest_length is a text", {"/drawn/0/rest_length": "1"}, "wrong_type", "/drawn/0/rest_length"),
    Row("drawn lines have no length", {"/drawn/0/pictures": [ON_THE_SPOT] * 6}, "degenerate", "/drawn/0/pictures"),
    Row("a rest pose is for fits", {"/drawn/0/rest": PICTURES[0]}, "unknown_field", "/drawn/0/rest"),
    Row("a drawn chain too many", {"/drawn": [{"pictures": [[[0, 0], [0, 1]]]}] * 16385}, "too_many", "/drawn"),
    Row("neither lines nor chains", {"/chains": REMOVED}, "missing_field", "/lines", beyond_schema=True),
    Row("lines and chains are null", {"/chains": None, "/lines": None}, "missing_field", "/lines", beyond_schema=True),
    Row("lines and chains", {"/lines": [{"pictures": PICTURES}]}, "conflict", "/lines"),
    Row("lines and a motion", {"/chains": REMOVED, "/lines": [{"pictures": PICTURES}]}, "conflict", "/motion"),
    Row("a chain that nobody drew", {"/chains": [SMALL_CHAIN] * 2}, "conflict", "/chains"),
    Row("a chain of fewer nodes than were drawn", {"/chains": [SMALL_CHAIN]}, "conflict", "/chains/0/nodes"),
    Row("fewer pictures than were drawn", {"/motion/timing": {"period": 0.2}}, "conflict", "/motion/timing"),
    Row("chains are an object", {"/chains": {}}, "wrong_type", "/chains"),
    Row("no chain", {"/chains": []}, "too_few", "/chains"),
    Row("a chain of one node", {"/chains": [{"nodes": [POINT]}]}, "too_few", "/chains/0/nodes"),
    Row("a wave out of range", {"/motion/wave/lightness": 0}, "out_of_range", "/motion/wave/lightness"),
    Row("motion is null", {"/motion": None}, "wrong_type", "/motion"),
    Row("a cycle of no length", {"/motion/timing/period": 0}, "out_of_range", "/motion/timing/period"),
    Row("the wind blows up", {"/motion/wind": [0, 1, 0]}, "degenerate", "/motion/wind"),
    *[compared_to_lines(row) for row in (
        *lists("/lines"), *placed("/lines/0", pictures(1)),
        Row("a chain more than was drawn", {"/lines": [{"pictures": PICTURES}] * 2}, "conflict", "/lines"),
        Row("fewer pictures than were drawn", {"/lines/0/pictures": PICTURES[:5]}, "conflict", "/lines/0/pictures"),
        Row("fewer nodes than were drawn", {"/lines/0/pictures": [line[:4] for line in PICTURES]}, "conflict", "/lines/0/pictures/0"))],
    Row("head is for tufts", {"/head": {}}, "unknown_field", "/head"),
    Row("no CSV of errors", {}, "not_a_choice", "?format", "?format=csv"),
    Row("an unknown query", {}, "unknown_field", "?still", "?still=1"),
]

FITS = [
    Row("drawn is missing", {"/drawn": REMOVED}, "missing_field", "/drawn"),
    Row("drawn is null", {"/drawn": None}, "wrong_type", "/drawn"),
    *lists("/drawn"),
    *placed("/drawn/0", pictures(2)),
    Row("a single bone", {"/drawn": [{"pictures": [line[:2] for line in PICTURES]}]}, "too_few", "/drawn/0/pictures/0"),
    Row("drawn lines have no length", {"/drawn": [{"pictures": [ON_THE_SPOT] * 6}]}, "degenerate", "/drawn/0/pictures"),
    Row("rest is a number", {"/drawn/0/rest": 1}, "wrong_type", "/drawn/0/rest"),
    Row("rest has fewer nodes than the pictures", {"/drawn/0/rest": FLAT_LINE}, "conflict", "/drawn/0/rest"),
    Row("rest has no length", {"/drawn/0/rest": ON_THE_SPOT}, "degenerate", "/drawn/0/rest"),
    Row("rest holds a node of one number", {"/drawn/0/rest/1": [1]}, "wrong_type", "/drawn/0/rest/1"),
    *outside("/drawn/0/rest/1/1", -1e6, 1e6),
    Row("a length is for evaluations", {"/drawn/0/rest_length": 1}, "unknown_field", "/drawn/0/rest_length"),
    Row("a drawn chain too many", {"/drawn": [{"pictures": [FLAT_LINE] * 2}] * 16385}, "too_many", "/drawn"),
    Row("too many drawn nodes", {"/drawn": [{"pictures": [FLAT_LINE] * 2}] * 2731}, "too_many", "/drawn"),
    Row("mode is no choice", {"/mode": "free"}, "not_a_choice", "/mode"),
    Row("mode is null", {"/mode": None}, "not_a_choice", "/mode"),
    Row("wind has no length", {"/wind": [0, 0, 0]}, "degenerate", "/wind"),
    Row("wind is parallel to up", {"/wind": [0, -3, 0]}, "degenerate", "/wind"),
    Row("wind has two numbers", {"/wind": [1, 0]}, "wrong_type", "/wind"),
    Row("wind is null", {"/wind": None}, "wrong_type", "/wind"),
    Row("up has no length", {"/up": [0, 0, 0]}, "degenerate", "/up"),
    Row("up is far away", {"/up": [0, 1000001, 0]}, "out_of_range", "/up/1"),
    *outside_whole("/cycles", 1, 11),
    Row("half as many cycles as pictures", {"/cycles": 3}, "conflict", "/cycles"),
    *outside_whole("/steps", 1, 1000),
    Row("steps are null", {"/steps": None}, "wrong_type", "/steps"),
    Row("as many pictures as the timing has not", {"/timing": {"period": 0.2}}, "conflict", "/drawn/0/pictures"),
    Row("a wave belongs into the answer", {"/wave": {}}, "unknown_field", "/wave"),
    Row("no GLB of a fit", {}, "not_a_choice", "?format", "?format=glb"),
    Row("an unknown query", {}, "unknown_field", "?steps", "?steps=1"),
]
