"""Bodies that must be refused: per operation name, changes to its example (JSON pointer to value), slug and pointer of the answer.

Ranges are tried just outside; test_bad_inputs.py tries their ends, which must be allowed.
"""

from __future__ import annotations

import json

from bad_fills import FILLS, HAIR_FILLS, origin, scalp
from bad_lines import EVALUATIONS, FITS
from rows import LONGEST_CHAIN, LONGEST_STROKE, OTHER_POINT, POINT, REMOVED, SMALL_CHAIN, SMALL_TUFT, Row, outside, outside_whole, placed

HEAD = [
    Row("head is null", {"/head": None}, "wrong_type", "/head"),
    Row("head is a list", {"/head": []}, "wrong_type", "/head"),
    Row("head has a field too many", {"/head/centre": [0, 0, 0]}, "unknown_field", "/head/centre"),
    Row("center is null", {"/head/center": None}, "wrong_type", "/head/center"),
    Row("center has two numbers", {"/head/center": [0, 0]}, "wrong_type", "/head/center"),
    Row("center has four numbers", {"/head/center": [0, 0, 0, 0]}, "wrong_type", "/head/center"),
    Row("center holds a text", {"/head/center": [0, "0", 0]}, "wrong_type", "/head/center/1"),
    Row("center is too far away", {"/head/center": [0, 0, -1000000.1]}, "out_of_range", "/head/center/2"),
    Row("up has no length", {"/head/up": [0, 0, 0]}, "degenerate", "/head/up"),
    Row("up has next to no length", {"/head/up": [0, 1e-10, 0]}, "degenerate", "/head/up"),
    Row("front has no length", {"/head/front": [0, 0, 0]}, "degenerate", "/head/front"),
    Row("front is parallel to up", {"/head/up": [0, 2, 0], "/head/front": [0, -3, 0]}, "degenerate", "/head/front"),
    Row("a scalp is around something else", {"/head/scalp": {"ellipsoid": {"radii": [0.1, 0.1, 0.1], "center": [0, 1, 0]}}}, "degenerate", "/head/scalp/ellipsoid"),
    *outside("/head/root_depth", 0, 10),
    *outside("/head/diameter_at_100", 1e-6, 1000),
    *scalp("/head/scalp"),
]

TUFT = [
    Row("points are missing", {"/points": REMOVED}, "missing_field", "/points"),
    Row("points are null", {"/points": None}, "wrong_type", "/points"),
    Row("no point", {"/points": []}, "too_few", "/points"),
    Row("one point", {"/points": [POINT]}, "too_few", "/points"),
    Row("a point too many", {"/points": LONGEST_STROKE + [[0, 2, 0]]}, "too_many", "/points"),
    Row("a point is a number", {"/points/1": 0.1}, "wrong_type", "/points/1"),
    Row("a point is null", {"/points/1": None}, "wrong_type", "/points/1"),
    Row("a point has two numbers", {"/points/1": [0, 0]}, "wrong_type", "/points/1"),
    Row("a coordinate is null", {"/points/1/2": None}, "wrong_type", "/points/1/2"),
    Row("a coordinate is true", {"/points/1/2": True}, "wrong_type", "/points/1/2"),
    *outside("/points/1/2", -1e6, 1e6),
    Row("a coordinate as large as numbers get", {"/points/1/2": 1.7e308}, "out_of_range", "/points/1/2"),
    Row("a stroke on the spot", {"/points": [POINT, POINT, POINT]}, "degenerate", "/points"),
    Row("a stroke shorter than an atom", {"/points": [[0, 0.1, 0], [0, 0.1 + 1e-12, 0]]}, "degenerate", "/points"),
    Row("a root at the head's center", {"/points/0": [0, 0, 0]}, "degenerate", "/points/0"),
    Row("name is a number", {"/name": 7}, "wrong_type", "/name"),
    Row("name is null", {"/name": None}, "wrong_type", "/name"),
    Row("name is too long", {"/name": "x" * 65}, "too_many", "/name"),
    *outside("/diameter", 1, 100),
    Row("diameter is null", {"/diameter": None}, "wrong_type", "/diameter"),
    *outside("/widest_at", 1, 100),
    Row("widest_at is a text", {"/widest_at": "40"}, "wrong_type", "/widest_at"),
    *outside("/flatness", 0, 0.98),
    Row("a flat circle", {"/section": "circle", "/flatness": 0.5}, "conflict", "/flatness"),
    Row("taper is no choice", {"/taper": "cubic"}, "not_a_choice", "/taper"),
    Row("taper is null", {"/taper": None}, "not_a_choice", "/taper"),
    Row("section is no choice", {"/section": "Circle"}, "not_a_choice", "/section"),
    *outside("/twist_deg", -3600, 3600),
    *outside("/roll_deg", -360, 360),
    *outside_whole("/joints", 1, 64),
    Row("joints are null", {"/joints": None}, "wrong_type", "/joints"),
    *outside("/phase", -1000, 1000),
    *outside_whole("/cycles", 1, 11),
    Row("a tuft has a field too many", {"/length": 1}, "unknown_field", "/length"),
    Row("a field's name needs escaping", {"/a~1b~0c": 1}, "unknown_field", "/a~1b~0c"),
    *origin("/origin"),
]

TUFTS = [
    Row("tufts are missing", {"/tufts": REMOVED}, "missing_field", "/tufts"),
    Row("tufts are null", {"/tufts": None}, "wrong_type", "/tufts"),
    Row("tufts are an object", {"/tufts": {}}, "wrong_type", "/tufts"),
    Row("no tuft at all", {"/tufts": []}, "too_few", "/tufts"),
    Row("a tuft is null", {"/tufts/0": None}, "wrong_type", "/tufts/0"),
    Row("a tuft is a text", {"/tufts/0": "fringe"}, "wrong_type", "/tufts/0"),
    Row("a tuft too many", {"/tufts": [{**SMALL_TUFT, "joints": 1}] * 16385}, "too_many", "/tufts"),
    Row("too many points in all tufts", {"/tufts": [{"points": LONGEST_STROKE}] * 129}, "too_many", "/tufts"),
    Row("too many joints in all tufts", {"/tufts": [{**SMALL_TUFT, "joints": 64}] * 1025}, "too_many", "/tufts"),
    *placed("/tufts/0", TUFT),
    Row("the last of several is wrong", {"/tufts/3/diameter": 101}, "out_of_range", "/tufts/3/diameter"),
]

MESH = [
    Row("mesh is null", {"/mesh": None}, "wrong_type", "/mesh"),
    Row("mesh has a field too many", {"/mesh": {"side": 12}}, "unknown_field", "/mesh/side"),
    *[row._replace(changes={"/mesh": {}, **row.changes}) for row in (
        *outside("/mesh/tolerance", 1e-5, 1), *outside_whole("/mesh/sides", 3, 64), *outside_whole("/mesh/rings", 2, 4096),
        Row("tolerance is null", {"/mesh/tolerance": None}, "wrong_type", "/mesh/tolerance"),
        Row("sides are null", {"/mesh/sides": None}, "wrong_type", "/mesh/sides"),
        Row("layout is no choice", {"/mesh/layout": "single"}, "not_a_choice", "/mesh/layout"),
        Row("color is a word", {"/mesh/color": "brown"}, "wrong_type", "/mesh/color"),
        Row("color has three digits", {"/mesh/color": "#abc"}, "wrong_type", "/mesh/color"),
        Row("color is no hexadecimal", {"/mesh/color": "#12345g"}, "wrong_type", "/mesh/color"),
        Row("color is null", {"/mesh/color": None}, "wrong_type", "/mesh/color"))],
]

TUFT_MESHES = [
    Row("too many vertices", {"/mesh": {"rings": 4096, "sides": 64}, "/tufts": [SMALL_TUFT] * 8}, "too_many", "/mesh"),
    Row("too many rings for the tolerance", {"/mesh": {"tolerance": 1e-5}, "/head": {"diameter_at_100": 1000},
                                             "/tufts": [{"points": [[1e3 * (i % 2), 1e3 * i, 1e3] for i in range(200)], "joints": 1}]},
        "too_many", "/tufts/0"),
]


def timing(place: str) -> list[Row]:
    """What can be wrong with a timing that stands at `place`."""
    return placed(place, [
        Row("timing is null", {"": None}, "wrong_type", ""),
        Row("timing has a field too many", {"/frames": 11}, "unknown_field", "/frames"),
        *outside("/period", 0.01, 60),
        Row("period is a text", {"/period": "0.45"}, "wrong_type", "/period"),
        Row("period is null", {"/period": None}, "wrong_type", "/period"),
        Row("period is negative", {"/period": -0.45}, "out_of_range", "/period"),
        Row("fps below 1", {"/fps": 0.999999}, "out_of_range", "/fps"),
        Row("fps above 240", {"/fps": 240.000001}, "out_of_range", "/fps"),
        Row("fps is zero", {"/fps": 0}, "out_of_range", "/fps"),
        Row("fps is negative", {"/fps": -24}, "out_of_range", "/fps"),
        Row("fps is enormous", {"/fps": 1e300}, "out_of_range", "/fps"),
        Row("fps is null", {"/fps": None}, "wrong_type", "/fps"),
        Row("fps is a list", {"/fps": [24000, 1001]}, "wrong_type", "/fps"),
        Row("fps divides by zero", {"/fps": "24/0"}, "out_of_range", "/fps", beyond_schema=True),
        Row("fps is zero over zero", {"/fps": "0/0"}, "out_of_range", "/fps", beyond_schema=True),
        Row("fps is no fraction", {"/fps": "24/1/1"}, "wrong_type", "/fps"),
        Row("fps is a word", {"/fps": "ntsc"}, "wrong_type", "/fps"),
        Row("fps has a sign", {"/fps": "-24"}, "wrong_type", "/fps"),
        Row("fps has eight digits", {"/fps": "24000000/1000000"}, "wrong_type", "/fps"),
        Row("fps as a fraction above 240", {"/fps": "240001/1000"}, "out_of_range", "/fps", beyond_schema=True),
        *outside_whole("/hold", 1, 24),
        Row("hold is null", {"/hold": None}, "wrong_type", "/hold"),
        Row("short_holds is no choice", {"/short_holds": "first"}, "not_a_choice", "/short_holds"),
        Row("sampling is no choice", {"/sampling": "random"}, "not_a_choice", "/sampling"),
        Row("less than half a frame", {"/period": 0.02, "/fps": 24}, "too_few", "/period"),
        Row("too many frames", {"/period": 60, "/fps": 25, "/hold": 24}, "too_many", "/period"),
        Row("too many pictures", {"/period": 2, "/fps": 24, "/hold": 1}, "too_many", "/period"),
    ])


def undefined_as_printed(place: str) -> Row:
    """5 frames held by 4 are 2 pictures, of which 3 would have to be short."""
    return Row("undefined as printed", {f"{place}/period": 5 / 24, f"{place}/hold": 4, "/formulas": "as_printed"}, "undefined_as_printed", f"{place}/hold")


FORMULAS = [
    Row("formulas are no choice", {"/formulas": "exact"}, "not_a_choice", "/formulas"),
    Row("formulas are null", {"/formulas": None}, "not_a_choice", "/formulas"),
]

MOTION = [
    Row("motion is a list", {"/motion": []}, "wrong_type", "/motion"),
    Row("motion has a field too many", {"/motion/amplitude": 1}, "unknown_field", "/motion/amplitude"),
    Row("wave is null", {"/motion/wave": None}, "wrong_type", "/motion/wave"),
    Row("wave has a field too many", {"/motion/wave/k": 1}, "unknown_field", "/motion/wave/k"),
    *outside("/motion/wave/amplitude", -100, 100),
    *[row for name in ("spatial_period", "lightness") for row in (
        *outside(f"/motion/wave/{name}", -100, 100),
        *[Row(f"{name} is {value}", {f"/motion/wave/{name}": value}, "out_of_range", f"/motion/wave/{name}") for value in (0, 0.0499, -0.0499)])],
    *outside("/motion/wave/tip_exponent", 0.05, 8),
    Row("amplitude is null", {"/motion/wave/amplitude": None}, "wrong_type", "/motion/wave/amplitude"),
    *timing("/motion/timing"),
    undefined_as_printed("/motion/timing"),
    Row("mode is no choice", {"/motion/mode": "free"}, "not_a_choice", "/motion/mode"),
    Row("mode is null", {"/motion/mode": None}, "not_a_choice", "/motion/mode"),
    Row("wind is null", {"/motion/wind": None}, "wrong_type", "/motion/wind"),
    Row("wind has no length", {"/motion/wind": [0, 0, 0]}, "degenerate", "/motion/wind"),
    Row("wind is parallel to up", {"/motion/wind": [0, 0, 2], "/motion/up": [0, 0, -1]}, "degenerate", "/motion/wind"),
    Row("wind is parallel to the head's up", {"/motion/wind": [0, 1, 0]}, "degenerate", "/motion/wind"),
    Row("the motion's up has no length", {"/motion/up": [0, 0, 0]}, "degenerate", "/motion/up"),
    Row("up is a word", {"/motion/up": "y"}, "wrong_type", "/motion/up"),
    Row("wind is a hurricane", {"/motion/wind": [1000001, 0, 0]}, "out_of_range", "/motion/wind/0"),
    Row("droop is no choice", {"/motion/droop": "half"}, "not_a_choice", "/motion/droop"),
    Row("one_sided is a number", {"/motion/one_sided": 1}, "wrong_type", "/motion/one_sided"),
    Row("one_sided is null", {"/motion/one_sided": None}, "wrong_type", "/motion/one_sided"),
    Row("one_sided in absolute mode", {"/motion/one_sided": True, "/motion/mode": "absolute"}, "conflict", "/motion/one_sided"),
    *outside("/motion/lift", 0, 1),
    Row("phase is null", {"/motion/phase": None}, "wrong_type", "/motion/phase"),
    *[row._replace(changes={"/motion/phase": {}, **row.changes}) for row in (
        Row("phase has a field too many", {"/motion/phase/offset": 1}, "unknown_field", "/motion/phase/offset"),
        Row("step is no choice", {"/motion/phase/step": "whole"}, "not_a_choice", "/motion/phase/step"),
        *outside("/motion/phase/gust_wavelength", 0.001, 1e6), *outside("/motion/phase/spread", 0, 1),
        *outside_whole("/motion/phase/seed", 0, 9007199254740991)[0:1],
        Row("seed beyond what readers keep", {"/motion/phase/seed": 9007199254740992}, "out_of_range", "/motion/phase/seed"),
        Row("seed between two whole numbers", {"/motion/phase/seed": 0.5}, "wrong_type", "/motion/phase/seed"),
        *outside_whole("/motion/phase/cycles", 1, 11),
        Row("half as many cycles as pictures", {"/motion/phase/cycles": 3}, "conflict", "/motion/phase/cycles"))],
]

CHAINS = [
    Row("chains are missing", {"/chains": REMOVED}, "missing_field", "/chains"),
    Row("chains are null", {"/chains": None}, "wrong_type", "/chains"),
    Row("no chain at all", {"/chains": []}, "too_few", "/chains"),
    Row("a chain is null", {"/chains/1": None}, "wrong_type", "/chains/1"),
    Row("a chain too many", {"/chains": [SMALL_CHAIN] * 16385}, "too_many", "/chains"),
    Row("too many bones in all chains", {"/chains": [{"nodes": LONGEST_CHAIN}] * 1025}, "too_many", "/chains"),
    Row("too many poses", {"/chains": [{"nodes": LONGEST_CHAIN}] * 700, "/motion/timing": {"period": 1, "hold": 1}}, "too_many", "/chains"),
    Row("a chain has a field too many", {"/chains/0/points": []}, "unknown_field", "/chains/0/points"),
    Row("nodes are missing", {"/chains/0/nodes": REMOVED}, "missing_field", "/chains/0/nodes"),
    Row("one node", {"/chains/0/nodes": [POINT]}, "too_few", "/chains/0/nodes"),
    Row("a node too many", {"/chains/0/nodes": LONGEST_CHAIN + [[0, -1, 0]]}, "too_many", "/chains/0/nodes"),
    Row("all nodes in one place", {"/chains/0/nodes": [POINT, POINT]}, "degenerate", "/chains/0/nodes"),
    Row("a node is an object", {"/chains/0/nodes/1": {"x": 0, "y": 0, "z": 0}}, "wrong_type", "/chains/0/nodes/1"),
    *outside("/chains/0/nodes/1/0", -1e6, 1e6),
    Row("fewer rotations than nodes", {"/chains/0/rest_rotations": [[0, 0, 0, 1]] * 6}, "conflict", "/chains/0/rest_rotations"),
    Row("no rotation at all", {"/chains/0/rest_rotations": []}, "conflict", "/chains/0/rest_rotations"),
    Row("rotations are an object", {"/chains/0/rest_rotations": {}}, "wrong_type", "/chains/0/rest_rotations"),
    Row("a rotation has three numbers", {"/chains/0/rest_rotations": [[0, 0, 1]] * 7}, "wrong_type", "/chains/0/rest_rotations/0"),
    Row("a rotation has no length", {"/chains/0/rest_rotations": [[0, 0, 0, 1]] + [[0, 0, 0, 0]] * 6}, "degenerate", "/chains/0/rest_rotations/1"),
    Row("a rotation out of range", {"/chains/0/rest_rotations": [[0, 0, 0, 1]] * 6 + [[0, 0, 2e6, 1]]}, "out_of_range", "/chains/0/rest_rotations/6/2"),
    Row("parent_rotation has no length", {"/chains/0/parent_rotation": [0, 0, 0, 0]}, "degenerate", "/chains/0/parent_rotation"),
    Row("parent_rotation is null", {"/chains/0/parent_rotation": None}, "wrong_type", "/chains/0/parent_rotation"),
    Row("outward has no length", {"/chains/0/outward": [0, 0, 0]}, "degenerate", "/chains/0/outward"),
    Row("outward is a number", {"/chains/0/outward": 1}, "wrong_type", "/chains/0/outward"),
    Row("one_sided without outward", {"/motion/one_sided": True}, "degenerate", "/chains/0/outward"),
    Row("name is too long", {"/chains/0/name": "x" * 65}, "too_many", "/chains/0/name"),
    Row("block is too long", {"/chains/0/block": "x" * 65}, "too_many", "/chains/0/block"),
    Row("block is null", {"/chains/0/block": None}, "wrong_type", "/chains/0/block"),
    *outside("/chains/0/phase", -1000, 1000),
    *outside_whole("/chains/0/cycles", 1, 11),
    Row("half as many cycles of a chain as pictures", {"/chains/1/cycles": 3}, "conflict", "/chains/1/cycles"),
    Row("motion is null", {"/motion": None}, "wrong_type", "/motion"),
    *[row._replace(changes={"/head": {}, **row.changes}) for row in HEAD],
]

# What the query says about a file of motion, wherever the motion comes from.
FILE_QUERIES = [
    *[Row(f"repeat is {value}", {}, slug, "?repeat", f"?format=xdts&repeat={value}") for value, slug in (
        ("0", "out_of_range"), ("1441", "out_of_range"), ("1440", "too_many"), ("-1", "out_of_range"), ("1.5", "wrong_type"), ("two", "wrong_type"),
        ("", "wrong_type"), ("nan", "wrong_type"), ("1e300", "out_of_range"))],
    Row("an unknown interpolation", {}, "not_a_choice", "?interpolation", "?format=glb&interpolation=linear"),
    Row("an interpolation in figures", {}, "not_a_choice", "?interpolation", "?format=glb&interpolation=1"),
    Row("an interpolation of no word", {}, "not_a_choice", "?interpolation", "?format=glb&interpolation="),
    *[Row(f"{word} has no clip", {}, "conflict", "?interpolation", f"?format={word}&interpolation=held") for word in ("json", "xdts", "csv", "vmd", "bvh", "usda")],
    *[Row(f"{word} has one cycle", {}, "conflict", "?repeat", f"?format={word}&repeat=2") for word in ("glb", "gltf", "json", "bvh", "usda")],
]

# What the query says about how a file is packed.
COMPRESSION = [
    Row("an unknown compression", {}, "not_a_choice", "?compression", "?format=glb&compression=draco"),
    Row("a compression in figures", {}, "not_a_choice", "?compression", "?format=glb&compression=1"),
    Row("a compression of no word", {}, "not_a_choice", "?compression", "?format=glb&compression="),
    Row("a packed gltf", {}, "conflict", "?compression", "?format=gltf&compression=meshopt"),
]

BODY = [Row(f"the body is {json.dumps(body)}", {"": body}, "wrong_type", "") for body in (None, True, 7, "tufts", [])]

ROWS: dict[str, list[Row]] = {
    "tufts": [*BODY, *HEAD, *TUFTS, *MESH, *TUFT_MESHES, *COMPRESSION,
              Row("motion is not for still hair", {"/motion": {}}, "unknown_field", "/motion"),
              Row("fills are not for still hair", {"/fills": []}, "unknown_field", "/fills"),
              Row("a format of other operations", {}, "not_a_choice", "?format", "?format=json"),
              Row("an unknown query", {}, "unknown_field", "?sides", "?sides=12")],
    "fills": [*BODY, *HEAD, *FILLS, *COMPRESSION,
              Row("packed JSON", {}, "conflict", "?compression", "?compression=meshopt"),
              *[row._replace(query="?format=glb") for row in MESH],
              *[row._replace(name=f"from: {row.name}") for row in placed("/fill/from", TUFT)],
              *[row._replace(name=f"to: {row.name}") for row in placed("/fill/to", TUFT)]],
    "hairstyles": [*BODY, *HEAD, *TUFTS, *MESH, *TUFT_MESHES, *MOTION, *FORMULAS, *HAIR_FILLS,
                   Row("half as many cycles of a tuft as pictures", {"/tufts/1/cycles": 3}, "conflict", "/tufts/1/cycles"),
                   Row("an XDTS of still hair", {"/motion": REMOVED}, "missing_field", "/motion", "?format=xdts", beyond_schema=True),
                   Row("a CSV of still hair", {"/motion": None}, "missing_field", "/motion", "?format=csv", beyond_schema=True),
                   Row("a VMD of still hair", {"/motion": REMOVED}, "missing_field", "/motion", "?format=vmd", beyond_schema=True),
                   Row("a BVH of still hair", {"/motion": None}, "missing_field", "/motion", "?format=bvh", beyond_schema=True),
                   Row("a flip book of still hair", {"/motion": None}, "missing_field", "/motion", "?clip=flip_book", beyond_schema=True),
                   Row("an unknown clip", {}, "not_a_choice", "?clip", "?clip=morphs"),
                   *[Row(f"{word} is no flip book", {}, "conflict", "?clip", f"?format={word}&clip=flip_book") for word in ("json", "xdts", "csv", "vmd", "bvh", "usda")],
                   Row("too many vertices in all pictures", {"/mesh": {"rings": 4096, "sides": 64}, "/tufts": [SMALL_TUFT] * 2}, "too_many", "/mesh", "?clip=flip_book"),
                   Row("a held clip of still hair", {"/motion": None}, "missing_field", "/motion", "?interpolation=held", beyond_schema=True),
                   *FILE_QUERIES, *COMPRESSION,
                   *[Row(f"{word} is not packed", {}, "conflict", "?compression", f"?format={word}&compression=meshopt") for word in ("json", "xdts", "csv", "vmd", "bvh", "usda")],
                   Row("a packed flip book", {}, "conflict", "?compression", "?clip=flip_book&compression=meshopt"),
                   Row("chains belong elsewhere", {"/chains": []}, "unknown_field", "/chains"),
                   Row("an unknown format", {}, "not_a_choice", "?format", "?format=fbx")],
    "motions": [*BODY, *MOTION, *CHAINS, *FORMULAS,
                *FILE_QUERIES,
                Row("more than 24 pictures at a VMD's rate", {"/motion/timing": {"period": 1, "hold": 1}}, "too_many", "/motion/timing/period", "?format=vmd"),
                Row("a VMD of no frame rate", {"/motion/timing/fps": 0}, "out_of_range", "/motion/timing/fps", "?format=vmd"),
                *[Row(f"too many keys in a {word}", {"/chains": [{"nodes": LONGEST_CHAIN}] * 500, "/motion/timing": {"period": 2, "fps": 30, "hold": 3}},
                      "too_many", "/chains", f"?format={word}") for word in ("vmd", "bvh")],
                Row("bare chains have nothing to pack", {}, "unknown_field", "?compression", "?format=glb&compression=meshopt"),
                Row("bare chains have no flip book", {}, "unknown_field", "?clip", "?format=glb&clip=flip_book"),
                Row("too many cells in a sheet", {"/chains": [{**SMALL_CHAIN, "block": str(i)} for i in range(1000)]}, "too_many", "?repeat",
                    "?format=xdts&repeat=1000"),
                *[Row(f"too many keys in a {word} clip", {"/chains": [{"nodes": LONGEST_CHAIN}] * 500, "/motion/timing": {"period": 2, "fps": 30, "hold": 3}},
                      "too_many", "/chains", f"?format=glb&interpolation={word}") for word in ("held", "per_frame")],
                Row("too many keys in a usda", {"/chains": [{"nodes": LONGEST_CHAIN}] * 500, "/motion/timing": {"period": 0.8, "hold": 1}},
                    "too_many", "/chains", "?format=usda"),
                Row("tufts belong elsewhere", {"/tufts": []}, "unknown_field", "/tufts"),
                Row("an empty format", {}, "not_a_choice", "?format", "?format=")],
    "schedules": [*BODY, *timing("/timing"), *FORMULAS, undefined_as_printed("/timing"),
                  *outside_whole("/repeat", 1, 1440),
                  Row("repeat is null", {"/repeat": None}, "wrong_type", "/repeat"),
                  Row("a sheet of more than ten minutes", {"/repeat": 1440}, "too_many", "/repeat"),
                  Row("period stands in timing", {"/period": 0.45}, "unknown_field", "/period"),
                  Row("no glTF of a sheet", {}, "not_a_choice", "?format", "?format=glb")],
    "evaluations": [*BODY, *EVALUATIONS, *FORMULAS],
    "fits": [*BODY, *FITS, *FORMULAS, *[row for row in timing("/timing") if row.changes != {"/timing": None}], undefined_as_printed("/timing")],
}

# GET /v1/schedules: query, slug, pointer.
QUERIES = [
    ("period=0", "out_of_range", "?period"), ("period=", "wrong_type", "?period"), ("period=abc", "wrong_type", "?period"),
    ("period=nan", "wrong_type", "?period"), ("period=inf", "wrong_type", "?period"), ("period=1e999", "wrong_type", "?period"),
    ("period=0x1p-1", "wrong_type", "?period"), ("period=0.45s", "wrong_type", "?period"), ("period=60.1", "out_of_range", "?period"),
    ("fps=0", "out_of_range", "?fps"), ("fps=24/0", "out_of_range", "?fps"), ("fps=1/2/3", "wrong_type", "?fps"), ("fps=inf", "wrong_type", "?fps"),
    ("hold=0", "out_of_range", "?hold"), ("hold=1.5", "wrong_type", "?hold"), ("hold=two", "wrong_type", "?hold"), ("hold=25", "out_of_range", "?hold"),
    ("hold=nan", "wrong_type", "?hold"),
    ("short_holds=first", "not_a_choice", "?short_holds"), ("short_holds=1", "not_a_choice", "?short_holds"), ("sampling=", "not_a_choice", "?sampling"),
    ("formulas=exact", "not_a_choice", "?formulas"), ("repeat=0", "out_of_range", "?repeat"), ("repeat=1440", "too_many", "?repeat"),
    ("format=glb", "not_a_choice", "?format"), ("timing=1", "unknown_field", "?timing"), ("Period=1", "unknown_field", "?Period"),
    ("=1", "unknown_field", "?"), ("hold=2&hold=2", "duplicate_key", "?hold"), ("format=csv&format=csv", "duplicate_key", "?format"),
    ("period=60&fps=25&hold=24", "too_many", "?period"), ("period=0.2083333333&hold=4&formulas=as_printed", "undefined_as_printed", "?hold"),
]
