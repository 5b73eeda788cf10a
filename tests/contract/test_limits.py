"""/v1/limits and openapi.yaml tell the same numbers, and leave none out."""

from __future__ import annotations

from typing import Any

import contract
from support import ServiceTest
from test_openapi import REQUEST_SCHEMAS

# Served range: the fields of openapi.yaml that it holds for.
RANGES = {
    "coordinate": ["Coordinate"],
    "root_depth": ["Head/root_depth"],
    "diameter_at_100": ["Head/diameter_at_100"],
    "scalp_radius": ["ScalpRadius"],
    "scalp_vertex": ["ScalpVertex"],
    "diameter": ["Tuft/diameter"],
    "widest_at": ["Tuft/widest_at"],
    "flatness": ["Tuft/flatness"],
    "twist_deg": ["Tuft/twist_deg"],
    "roll_deg": ["Tuft/roll_deg"],
    "joints": ["Tuft/joints"],
    "origin": ["OriginNumber"],
    "density": ["Density/oneOf/0"],
    "tufts_per_meter": ["TuftsPerMeter"],
    "min_gap": ["MinGap"],
    "sides": ["MeshDetail/sides"],
    "rings": ["MeshDetail/rings"],
    "tolerance": ["MeshDetail/tolerance"],
    "amplitude": ["Wave/amplitude"],
    "tip_exponent": ["Wave/tip_exponent"],
    "period": ["Period"],
    "fps": ["Timing/fps/oneOf/0"],
    "hold": ["Hold"],
    "lift": ["Motion/lift"],
    "phase": ["ChainPhase"],
    "cycles": ["ChainCycles", "Phasing/cycles", "FitsRequest/cycles"],
    "gust_wavelength": ["Phasing/gust_wavelength"],
    "spread": ["Phasing/spread"],
    "seed": ["Phasing/seed", "Jitter/seed"],
    "repeat": ["Repeat"],
    "fit_steps": ["FitsRequest/steps"],
    "rest_length": ["ComparedLines/rest_length"],
}
# Of these the magnitude is served: zero and what is near it are refused on both sides.
MAGNITUDES = {"spatial_period": "Wave/spatial_period", "lightness": "Wave/lightness"}
# Served count: field and keyword of openapi.yaml.
COUNTS = {
    "tufts": [("TuftList", "maxItems")],
    "points_per_tuft": [("Tuft/points", "maxItems")],
    "fills": [("HairstyleRequest/fills", "maxItems")],
    "chains": [("MotionsRequest/chains", "maxItems"), ("FitsRequest/drawn", "maxItems"), ("EvaluationsRequest/drawn", "maxItems"),
               ("EvaluationsRequest/lines/oneOf/0", "maxItems"), ("EvaluationsRequest/chains/oneOf/0", "maxItems")],
    "nodes_per_chain": [("Chain/nodes", "maxItems"), ("Chain/rest_rotations", "maxItems"), ("Line", "maxItems")],
    "joints": [("HairstyleAnswer/totals/joints", "maximum")],
    "vertices": [("HairstyleAnswer/totals/vertices", "maximum")],
    "triangles": [("HairstyleAnswer/totals/triangles", "maximum")],
    "rings_per_tuft": [("MeshDetail/rings", "maximum")],
    "frames": [("Schedule/frames", "maximum")],
    "pictures": [("Schedule/pictures", "maximum"), ("ComparedLines/pictures", "maxItems"), ("FittedLines/pictures", "maxItems")],
}
# The same of lists that hold three numbers for each that is counted.
TRIPLES = {"scalp_vertices": "ScalpMesh/positions", "scalp_triangles": "ScalpMesh/triangles"}
# Limits of a whole request, which no keyword of a schema can state.
OF_WHOLE_REQUESTS = {"points", "node_poses", "joint_keys", "drawn_nodes", "sheet_frames", "sheet_cells"}
# The smallest sizes of lists follow from what the lists are.
SMALLEST_SIZES = {"Vec3": 3, "Rotation": 4, "TuftList": 1, "Tuft/points": 2, "Chain/nodes": 2, "Chain/rest_rotations": 2, "MotionsRequest/chains": 1,
                  "HairstyleRequest/fills": 0, "ScalpEllipsoid/radii": 3, "ScalpMesh/positions": 9, "ScalpMesh/triangles": 3,
                  "Point": 2, "Line": 2, "ComparedLines/pictures": 1, "FittedLines/pictures": 2, "FitsRequest/drawn": 1, "EvaluationsRequest/drawn": 1,
                  "EvaluationsRequest/lines/oneOf/0": 1, "EvaluationsRequest/chains/oneOf/0": 1}
FIXED_SIZES = {"Vec3": 3, "Point": 3, "Rotation": 4, "ScalpEllipsoid/radii": 3}


def field(place: str) -> dict[str, Any]:
    """A schema by the short names of the tables above: Schema/property, Schema/property/keyword/index."""
    name, *rest = place.split("/")
    schema: Any = contract.DOCUMENT["components"]["schemas"][name]
    for part in rest:
        if isinstance(schema, dict) and part in schema.get("properties", {}):
            schema = schema["properties"][part]
        else:
            schema = schema[int(part)] if isinstance(schema, list) else schema[part]
    return schema


def short(place: str) -> str:
    return place.removeprefix("#/components/schemas/").replace("/properties/", "/")


def request_parts() -> list[tuple[str, dict[str, Any]]]:
    return [(short(place), schema) for place, schema in contract.schemas()
            if place.startswith("#/components/schemas/") and place.split("/")[3] in REQUEST_SCHEMAS and "/not" not in place]


class Limits(ServiceTest):
    def setUp(self) -> None:
        self.limits = self.service.get("/v1/limits").json()

    def test_served_ranges_are_the_documented_ones(self) -> None:
        for name, places in RANGES.items():
            for place in places:
                with self.subTest(name, place=place):
                    documented = field(place)
                    self.assertEqual(self.limits["ranges"][name], {"minimum": documented["minimum"], "maximum": documented["maximum"]})

    def test_served_magnitudes_are_the_documented_ones(self) -> None:
        for name, place in MAGNITUDES.items():
            with self.subTest(name):
                served, documented = self.limits["ranges"][name], field(place)
                self.assertEqual((documented["minimum"], documented["maximum"]), (-served["maximum"], served["maximum"]))
                self.assertEqual(documented["not"], {"exclusiveMinimum": -served["minimum"], "exclusiveMaximum": served["minimum"]})

    def test_served_counts_are_the_documented_ones(self) -> None:
        for name, places in COUNTS.items():
            for place, keyword in places:
                with self.subTest(name, place=place):
                    self.assertEqual(self.limits["counts"][name], field(place)[keyword])

    def test_served_counts_are_a_third_of_flat_lists(self) -> None:
        for name, place in TRIPLES.items():
            with self.subTest(name):
                self.assertEqual(3 * self.limits["counts"][name], field(place)["maxItems"])

    def test_nothing_is_served_that_is_not_documented(self) -> None:
        self.assertEqual(set(self.limits["ranges"]), RANGES.keys() | MAGNITUDES.keys())
        self.assertEqual(set(self.limits["counts"]), COUNTS.keys() | TRIPLES.keys() | OF_WHOLE_REQUESTS)

    def test_nothing_is_documented_that_is_not_served(self) -> None:
        ranges = {place for places in RANGES.values() for place in places} | set(MAGNITUDES.values())
        sizes = {place for places in COUNTS.values() for place, keyword in places if keyword == "maxItems"} | set(TRIPLES.values()) | FIXED_SIZES.keys()
        for place, schema in request_parts():
            with self.subTest(place):
                if "minimum" in schema or "maximum" in schema:
                    self.assertIn(place, ranges)
                if "maxItems" in schema:
                    self.assertIn(place, sizes)
                if "minItems" in schema:
                    self.assertEqual(schema["minItems"], SMALLEST_SIZES[place])

    def test_sums_are_larger_than_their_parts(self) -> None:
        counts = self.limits["counts"]
        self.assertGreaterEqual(counts["points"], counts["points_per_tuft"])
        self.assertGreaterEqual(counts["sheet_frames"], counts["frames"])
        self.assertEqual(self.limits["ranges"]["scalp_vertex"]["maximum"], counts["scalp_vertices"] - 1)
        self.assertEqual(self.limits["ranges"]["origin"]["maximum"], counts["tufts"] + 2)  # the two of the fill count, too
        self.assertGreaterEqual(self.limits["json_values"], 3 * (counts["scalp_vertices"] + counts["scalp_triangles"]) + 4 * counts["points"])
        self.assertGreaterEqual(counts["node_poses"], counts["nodes_per_chain"] * counts["pictures"])
        self.assertGreaterEqual(counts["drawn_nodes"], counts["nodes_per_chain"] * counts["pictures"])


