"""Rows about fills and what belongs to them: the scalp, a tuft's origin, a fill by itself and those of a hairstyle."""

from __future__ import annotations

from typing import Any

from rows import LONGEST_STROKE, OTHER_SMALL_TUFT, REMOVED, SMALL_TUFT, Row, above, ellipsoid, named_tufts, outside, outside_whole, placed, tetrahedron

SCALP = [
    Row("scalp is a list", {"": []}, "wrong_type", ""),
    Row("scalp is a word", {"": "ellipsoid"}, "wrong_type", ""),
    Row("scalp has a field too many", {"": {"ellipsoid": ellipsoid(), "radii": [1, 1, 1]}}, "unknown_field", "/radii"),
    Row("scalp is neither ellipsoid nor mesh", {"": {}}, "missing_field", "", beyond_schema=True),
    Row("scalp is nothing twice", {"": {"ellipsoid": None, "mesh": None}}, "missing_field", "", beyond_schema=True),
    Row("scalp is ellipsoid and mesh", {"": {"ellipsoid": ellipsoid(), "mesh": tetrahedron()}}, "conflict", ""),
    Row("ellipsoid is a number", {"": {"ellipsoid": 0.1}}, "wrong_type", "/ellipsoid"),
    Row("scalp mesh is a list", {"": {"mesh": []}}, "wrong_type", "/mesh"),
]

ELLIPSOID = [
    Row("ellipsoid has a field too many", {"/radius": 0.1}, "unknown_field", "/radius"),
    Row("radii are missing", {"/radii": REMOVED}, "missing_field", "/radii"),
    Row("radii are null", {"/radii": None}, "wrong_type", "/radii"),
    Row("radii are one number", {"/radii": 0.1}, "wrong_type", "/radii"),
    Row("radii are two numbers", {"/radii": [0.1, 0.1]}, "wrong_type", "/radii"),
    Row("radii are four numbers", {"/radii": [0.1, 0.1, 0.1, 0.1]}, "wrong_type", "/radii"),
    Row("a radius is null", {"/radii/2": None}, "wrong_type", "/radii/2"),
    Row("a radius is zero", {"/radii/0": 0}, "out_of_range", "/radii/0"),
    Row("a radius is negative", {"/radii/1": -0.1}, "out_of_range", "/radii/1"),
    Row("a radius just below", {"/radii/2": 0.000000999}, "out_of_range", "/radii/2"),
    Row("a radius just above", {"/radii/2": above(1e6)}, "out_of_range", "/radii/2"),
    Row("the scalp's center has two numbers", {"/center": [0, 0]}, "wrong_type", "/center"),
    Row("the scalp's center holds a text", {"/center": [0, "0", 0]}, "wrong_type", "/center/1"),
    Row("the scalp's center is too far away", {"/center": [0, 0, -1000000.1]}, "out_of_range", "/center/2"),
]

SCALP_MESH = [
    Row("scalp mesh has a field too many", {"/indices": [0, 1, 2]}, "unknown_field", "/indices"),
    Row("positions are missing", {"/positions": REMOVED}, "missing_field", "/positions"),
    Row("positions are null", {"/positions": None}, "wrong_type", "/positions"),
    Row("positions are an object", {"/positions": {}}, "wrong_type", "/positions"),
    Row("positions are vectors", {"/positions": [[0, 0, 0.1], [0, 0.1, 0], [0.1, 0, 0]]}, "wrong_type", "/positions/0"),
    Row("no position", {"/positions": []}, "too_few", "/positions"),
    Row("two positions", {"/positions": [0.1] * 6}, "too_few", "/positions"),
    Row("three positions and a third", {"/positions": [0.1] * 10}, "wrong_type", "/positions", beyond_schema=True),
    Row("three positions and two thirds", {"/positions": [0.1] * 11}, "wrong_type", "/positions", beyond_schema=True),
    Row("a position too many", {"/positions": [0.1] * 600003}, "too_many", "/positions"),
    Row("a position's coordinate is null", {"/positions/11": None}, "wrong_type", "/positions/11"),
    Row("a position's coordinate is a text", {"/positions/4": "0.1"}, "wrong_type", "/positions/4"),
    *outside("/positions/4", -1e6, 1e6),
    Row("triangles are missing", {"/triangles": REMOVED}, "missing_field", "/triangles"),
    Row("triangles are null", {"/triangles": None}, "wrong_type", "/triangles"),
    Row("triangles are a number", {"/triangles": 4}, "wrong_type", "/triangles"),
    Row("triangles are triples", {"/triangles": [[0, 1, 2], [0, 3, 1], [0, 2, 3]]}, "wrong_type", "/triangles/0"),
    Row("no triangle", {"/triangles": []}, "too_few", "/triangles"),
    Row("a triangle and a third", {"/triangles": [0, 1, 2, 0]}, "wrong_type", "/triangles", beyond_schema=True),
    Row("two thirds of a triangle", {"/triangles": [0, 1]}, "wrong_type", "/triangles"),
    Row("a triangle too many", {"/triangles": [0, 1, 2] * 200001}, "too_many", "/triangles"),
    Row("a corner is null", {"/triangles/11": None}, "wrong_type", "/triangles/11"),
    *outside_whole("/triangles/5", 0, 199999),
    Row("a corner that does not exist", {"/triangles/7": 4}, "out_of_range", "/triangles/7", beyond_schema=True),
]

def scalp(place: str) -> list[Row]:
    """What can be wrong with a scalp that stands at `place`; one that is sound comes first."""
    return [*placed(place, SCALP),
            *[row._replace(changes={place: {"ellipsoid": ellipsoid()}, **row.changes}) for row in placed(f"{place}/ellipsoid", ELLIPSOID)],
            *[row._replace(changes={place: {"mesh": tetrahedron()}, **row.changes}) for row in placed(f"{place}/mesh", SCALP_MESH)]]


ORIGIN = [
    Row("origin is a text", {"": "along"}, "wrong_type", ""),
    Row("origin has a field too many", {"/fill": 1}, "unknown_field", "/fill"),
    Row("origin's kind is missing", {"/kind": REMOVED}, "missing_field", "/kind"),
    Row("origin's kind is no choice", {"/kind": "front"}, "not_a_choice", "/kind"),
    Row("origin's kind is null", {"/kind": None}, "not_a_choice", "/kind"),
    Row("origin's index is missing", {"/index": REMOVED}, "missing_field", "/index"),
    Row("origin's index is null", {"/index": None}, "wrong_type", "/index"),
    *outside_whole("/index", 1, 16386),
    Row("origin's parent is a text", {"/parent": "1"}, "wrong_type", "/parent"),
    *outside_whole("/parent", 1, 16386),
]


def origin(place: str) -> list[Row]:
    """What can be wrong with a tuft's origin that stands at `place`; one that is sound comes first."""
    return [row._replace(changes={place: {"kind": "neck", "index": 1}, **row.changes}) for row in placed(place, ORIGIN)]


FILL = [
    Row("a fill has a field too many", {"/seed": 1}, "unknown_field", "/seed"),
    Row("from is missing", {"/from": REMOVED}, "missing_field", "/from"),
    Row("from is null", {"/from": None}, "wrong_type", "/from"),
    Row("from is a list", {"/from": []}, "wrong_type", "/from"),
    Row("to is a list", {"/to": []}, "wrong_type", "/to"),
    Row("a fill's name is a number", {"/name": 7}, "wrong_type", "/name"),
    Row("a fill's name is too long", {"/name": "x" * 49}, "too_many", "/name"),
    *outside("/tufts_per_meter", 0.001, 1e6),
    Row("tufts_per_meter is zero", {"/tufts_per_meter": 0}, "out_of_range", "/tufts_per_meter"),
    Row("tufts_per_meter is a text", {"/tufts_per_meter": "32"}, "wrong_type", "/tufts_per_meter"),
    Row("density is null", {"/density": None}, "wrong_type", "/density"),
    Row("density is a number", {"/density": 50}, "wrong_type", "/density"),
    Row("density has a field too many", {"/density": {"up": 50}}, "unknown_field", "/density/up"),
    *[row for direction in ("along", "crown", "neck") for row in (
        *outside(f"/density/{direction}", 1, 100),
        Row(f"{direction} is next to nothing", {f"/density/{direction}": 1e-9}, "out_of_range", f"/density/{direction}"),
        Row(f"{direction} is negative", {f"/density/{direction}": -1}, "out_of_range", f"/density/{direction}"),
        Row(f"{direction} is false", {f"/density/{direction}": False}, "wrong_type", f"/density/{direction}"),
        Row(f"{direction} is a text", {f"/density/{direction}": "50"}, "wrong_type", f"/density/{direction}"))],
    Row("jitter is a number", {"/jitter": 7}, "wrong_type", "/jitter"),
    Row("jitter is true", {"/jitter": True}, "wrong_type", "/jitter"),
    Row("jitter has a field too many", {"/jitter": {"degrees": 9}}, "unknown_field", "/jitter/degrees"),
    Row("jitter's seed is null", {"/jitter": {"seed": None}}, "wrong_type", "/jitter/seed"),
    Row("jitter's seed is negative", {"/jitter": {"seed": -1}}, "out_of_range", "/jitter/seed"),
    Row("jitter's seed is beyond what readers keep", {"/jitter": {"seed": 9007199254740992}}, "out_of_range", "/jitter/seed"),
    Row("jitter's seed is between two whole numbers", {"/jitter": {"seed": 0.5}}, "wrong_type", "/jitter/seed"),
    Row("a fill's formulas are no choice", {"/formulas": "exact"}, "not_a_choice", "/formulas"),
    Row("a fill's formulas are a number", {"/formulas": 1}, "not_a_choice", "/formulas"),
    Row("spacing is no choice", {"/spacing": "even"}, "not_a_choice", "/spacing"),
    Row("spacing is a number", {"/spacing": 1}, "not_a_choice", "/spacing"),
    Row("arc is no choice", {"/arc": "straight"}, "not_a_choice", "/arc"),
    Row("arc is null", {"/arc": None}, "not_a_choice", "/arc"),
    Row("direction is no choice", {"/direction": "left"}, "not_a_choice", "/direction"),
    Row("direction is null", {"/direction": None}, "not_a_choice", "/direction"),
    Row("resample is a number", {"/resample": 1}, "wrong_type", "/resample"),
    Row("resample is a text", {"/resample": "true"}, "wrong_type", "/resample"),
    *outside("/min_gap", 0, 10),
    Row("min_gap is null", {"/min_gap": None}, "wrong_type", "/min_gap"),
    Row("too many tufts along", {"/tufts_per_meter": 1e6, "/density": {"along": 100}}, "too_many", "/density/along"),
]

FILLS = [
    Row("fill is missing", {"/fill": REMOVED}, "missing_field", "/fill"),
    Row("fill is null", {"/fill": None}, "wrong_type", "/fill"),
    Row("fill is a list", {"/fill": []}, "wrong_type", "/fill"),
    *placed("/fill", FILL),
    Row("from is a name", {"/fill/from": "side_L"}, "wrong_type", "/fill/from"),
    Row("to is a name", {"/fill/to": "side_R"}, "wrong_type", "/fill/to"),
    Row("a fill's formulas are null", {"/fill/formulas": None}, "not_a_choice", "/fill/formulas"),
    Row("too many tufts with all copies", {"/fill/tufts_per_meter": 50000, "/fill/density": {"along": 100, "crown": 100}}, "too_many", "/fill/density"),
    Row("too many points in all tufts", {"/fill/from/points": LONGEST_STROKE, "/fill/tufts_per_meter": 1000}, "too_many", "/fill/density"),
    Row("unequal strokes must not be resampled", {"/fill/to": SMALL_TUFT, "/fill/resample": False}, "conflict", "/fill/to/points"),
    Row("unequal strokes as printed", {"/fill/to": SMALL_TUFT, "/fill/formulas": "as_printed"}, "undefined_as_printed", "/fill/to/points"),
    Row("unequal strokes must not be resampled as printed either", {"/fill/to": SMALL_TUFT, "/fill/formulas": "as_printed", "/fill/resample": False},
        "conflict", "/fill/to/points"),
    Row("the head's center is outside of the ellipsoid", {"/head/scalp": {"ellipsoid": {"radii": [0.1, 0.1, 0.1], "center": [0, 0.11, 0]}}},
        "degenerate", "/head/scalp/ellipsoid"),
    Row("the head's center is on the ellipsoid", {"/head/scalp": {"ellipsoid": {"radii": [0.5, 1, 2], "center": [0, 0, 2]}}},
        "degenerate", "/head/scalp/ellipsoid"),
    Row("no tuft to make a mesh of", {"/fill/density": {"along": 0}}, "too_few", "/fill/density", "?format=glb"),
    Row("no tuft to make a glTF of", {"/fill/density": {"along": None, "crown": 0}}, "too_few", "/fill/density", "?format=gltf"),
    Row("fills belong elsewhere", {"/fills": []}, "unknown_field", "/fills"),
    Row("tufts belong elsewhere", {"/tufts": []}, "unknown_field", "/tufts"),
    Row("motion is not for still hair", {"/motion": {}}, "unknown_field", "/motion"),
    Row("formulas stand in fill", {"/formulas": "as_printed"}, "unknown_field", "/formulas"),
    Row("no sheet of still hair", {}, "not_a_choice", "?format", "?format=xdts"),
    Row("an unknown query", {}, "unknown_field", "?seed", "?seed=1"),
    Row("more joints than a file may have", {"/fill": {"from": {**SMALL_TUFT, "joints": 64}, "tufts_per_meter": 5000}}, "too_many", "/fill", "?format=glb"),
]


def hair_fill(name: str, changes: dict[str, Any], slug: str, pointer: str, beyond_schema: bool = False) -> Row:
    """Wrong is a hairstyle of two small tufts and a fill between them, except for the changes."""
    return Row(name, {"/tufts": named_tufts(), "/fills": [{"from": "a", "to": "b"}], **changes}, slug, pointer, beyond_schema=beyond_schema)


HAIR_FILLS = [
    *[hair_fill(row.name, row.changes, row.slug, row.pointer, row.beyond_schema) for row in placed("/fills/0", FILL)],
    hair_fill("fills are null", {"/fills": None}, "wrong_type", "/fills"),
    hair_fill("fills are an object", {"/fills": {}}, "wrong_type", "/fills"),
    hair_fill("a fill is null", {"/fills/0": None}, "wrong_type", "/fills/0"),
    hair_fill("a fill is a name", {"/fills/0": "a"}, "wrong_type", "/fills/0"),
    hair_fill("a fill too many", {"/fills": [{"from": "a", "density": {"along": 0}}] * 1025}, "too_many", "/fills"),
    hair_fill("from is a tuft", {"/fills/0/from": SMALL_TUFT}, "wrong_type", "/fills/0/from"),
    hair_fill("to is a tuft", {"/fills/0/to": SMALL_TUFT}, "wrong_type", "/fills/0/to"),
    hair_fill("from is nobody's name", {"/fills/0/from": "A"}, "not_a_choice", "/fills/0/from", beyond_schema=True),
    hair_fill("to is nobody's name", {"/fills/0/to": ""}, "not_a_choice", "/fills/0/to", beyond_schema=True),
    hair_fill("from is the name of a filled tuft", {"/fills": [{"from": "a", "to": "b"}, {"from": "fill1_1"}]}, "not_a_choice", "/fills/1/from", beyond_schema=True),
    hair_fill("from is the name of two", {"/tufts": [*named_tufts(), {**SMALL_TUFT, "name": "a"}]}, "conflict", "/fills/0/from"),
    hair_fill("to is the name of two", {"/tufts": [*named_tufts(), {**SMALL_TUFT, "name": "b"}]}, "conflict", "/fills/0/to"),
    hair_fill("both tufts have no name", {"/tufts": [dict(SMALL_TUFT), dict(SMALL_TUFT)], "/fills": [{"from": ""}]}, "conflict", "/fills/0/from"),
    hair_fill("from is longer than names are", {"/fills/0/from": "x" * 65}, "too_many", "/fills/0/from"),
    hair_fill("to is longer than names are", {"/fills/0/to": "x" * 65}, "too_many", "/fills/0/to"),
    hair_fill("too many tufts, drawn and filled", {"/tufts": [*named_tufts(), *[{**SMALL_TUFT, "joints": 1}] * 16382]}, "too_many", "/fills/0"),
    hair_fill("too many tufts in two fills", {"/fills": [{"from": "a", "tufts_per_meter": 30000}] * 2}, "too_many", "/fills/1"),
    hair_fill("too many points, drawn and filled", {"/tufts": [*named_tufts(), *[{"points": LONGEST_STROKE}] * 127], "/fills/0/tufts_per_meter": 20000},
              "too_many", "/fills/0"),
    hair_fill("too many joints, drawn and filled", {"/tufts/0/joints": 64, "/tufts/1/joints": 64, "/fills/0/tufts_per_meter": 50000, "/mesh": {"rings": 2}},
              "too_many", "/tufts"),
    hair_fill("too many vertices, drawn and filled", {"/fills/0/tufts_per_meter": 5000, "/mesh": {"rings": 4096, "sides": 64}}, "too_many", "/mesh"),
    hair_fill("a drawn tuft of a fill is wrong", {"/tufts/1/diameter": 101}, "out_of_range", "/tufts/1/diameter"),
    hair_fill("a tuft that no fill names is wrong", {"/tufts": [*named_tufts(), {**SMALL_TUFT, "diameter": 101}]}, "out_of_range", "/tufts/2/diameter"),
    hair_fill("unequal drawn strokes must not be resampled", {"/tufts/1/points": [[0, 0.1, 0], [0, 0, 0.1], [0, -0.1, 0]], "/fills/0/resample": False},
              "conflict", "/tufts/1/points"),
    hair_fill("unequal drawn strokes as printed", {"/tufts/1/points": [[0, 0.1, 0], [0, 0, 0.1], [0, -0.1, 0]], "/formulas": "as_printed"},
              "undefined_as_printed", "/tufts/1/points"),
    hair_fill("the head's center is outside of the ellipsoid", {"/head/scalp": {"ellipsoid": {"radii": [0.1, 0.1, 0.1], "center": [0, 0.11, 0]}}},
              "degenerate", "/head/scalp/ellipsoid"),
]
