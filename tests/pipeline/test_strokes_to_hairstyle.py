"""Tests of the VRoid strokes converter.

    python3 -m unittest discover -s tests/pipeline
"""

from __future__ import annotations

import contextlib
import io
import json
import math
import re
import sys
import tempfile
import unittest
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "client-examples" / "pipeline"))

import strokes_to_hairstyle as converter  # noqa: E402

STROKES = ROOT / "tests" / "data" / "strokes"
COUNTS = {"vroid_Vita": 65, "vroid_Sendagaya_Shibu": 46, "vroid_Sakurada_Fumiriya": 83}


def load(name: str) -> dict[str, Any]:
    return json.loads((STROKES / f"{name}.strokes.json").read_text(encoding="utf-8"))


def stroke(**changes: Any) -> dict[str, Any]:
    """The smallest stroke: two points, wider than thick."""
    return {"group": 1, "visible": True, "width": 0.04, "thickness": 0.01, "points": [[0, 0.2, 0], [0, 0.1, 0.1]], **changes}


def convert(*strokes: dict[str, Any], with_hidden: bool = False, **document: Any) -> tuple[dict[str, Any], list[str]]:
    return converter.to_hairstyle(converter.read_strokes({"strokes": list(strokes), **document}, with_hidden))


def run(*arguments: str) -> tuple[int, str, str]:
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = converter.main(list(arguments))
    return code, out.getvalue(), err.getvalue()


class RealFiles(unittest.TestCase):
    def test_every_stroke_becomes_a_tuft_with_its_points_unchanged(self) -> None:
        for name, count in COUNTS.items():
            with self.subTest(name):
                document = load(name)
                hairstyle, _ = converter.to_hairstyle(converter.read_strokes(document))
                self.assertEqual(len(hairstyle["tufts"]), count)
                self.assertEqual([t["points"] for t in hairstyle["tufts"]], [s["points"] for s in document["strokes"]])

    def test_every_value_is_in_the_range_of_the_service(self) -> None:
        for name in COUNTS:
            with self.subTest(name):
                hairstyle, _ = converter.to_hairstyle(converter.read_strokes(load(name)), motion="breeze")
                self.assertEqual(set(hairstyle), {"head", "tufts", "motion", "mesh"})
                for tuft in hairstyle["tufts"]:
                    self.assertTrue(1 <= tuft["diameter"] <= 100 and 1 <= tuft["widest_at"] <= 100, tuft["name"])
                    self.assertTrue(0 <= tuft.get("flatness", 0) <= 0.98, tuft["name"])
                    self.assertEqual("flatness" in tuft, tuft["section"] == "ellipse", tuft["name"])
                    self.assertTrue(all(math.isfinite(x) for p in tuft["points"] for x in p), tuft["name"])

    def test_names_are_short_unique_ascii_and_carry_the_group(self) -> None:
        for name in COUNTS:
            with self.subTest(name):
                document = load(name)
                strokes = converter.read_strokes(document)
                names = [s.name for s in strokes]
                self.assertEqual(len(set(names)), len(names))
                self.assertTrue(all(re.fullmatch(r"[A-Za-z0-9_]{1,12}", n) for n in names))
                self.assertEqual([int(n[1:3]) for n in names], [s["group"] for s in document["strokes"]])

    def test_diameter_and_flatness_give_width_and_thickness_back(self) -> None:
        for name in COUNTS:
            document = load(name)
            hairstyle, _ = converter.to_hairstyle(converter.read_strokes(document))
            for source, tuft in zip(document["strokes"], hairstyle["tufts"]):
                larger = tuft["diameter"] / 100 * hairstyle["head"]["diameter_at_100"]
                smaller = larger * (1 - tuft.get("flatness", 0))
                on_edge = tuft.get("roll_deg", 0) == 90
                width, thickness = (smaller, larger) if on_edge else (larger, smaller)
                self.assertAlmostEqual(width, source["width"], delta=2e-5, msg=tuft["name"])  # 0.02 mm: four decimals
                self.assertAlmostEqual(thickness, source["thickness"], delta=2e-5, msg=tuft["name"])

    def test_the_head_is_a_head_inside_the_hair(self) -> None:
        for name in COUNTS:
            with self.subTest(name):
                strokes = converter.read_strokes(load(name))
                roots = [s.points[0] for s in strokes]
                center, radius, fitted = converter.find_head(roots, converter.fit_sphere(roots))
                self.assertTrue(fitted)
                self.assertTrue(0.09 < radius < 0.12, radius)
                self.assertLess(abs(center[0]), 0.01)  # metres: on the middle of the face
                off = [abs(math.dist(p, center) - radius) for p in roots]
                self.assertLess(sorted(off)[len(off) // 2], 0.006)  # half the roots within 6 mm
                nearer = sum(math.dist(s.points[0], center) < math.dist(s.points[-1], center) for s in strokes)
                self.assertGreater(nearer, 0.85 * len(strokes))  # root first; some fringe tips bend back to the head

    def test_strokes_that_are_thicker_than_wide_stand_on_edge(self) -> None:
        for name, count in {"vroid_Vita": 28, "vroid_Sendagaya_Shibu": 17, "vroid_Sakurada_Fumiriya": 39}.items():
            hairstyle, _ = converter.to_hairstyle(converter.read_strokes(load(name)))
            self.assertEqual(sum(t.get("roll_deg") == 90 for t in hairstyle["tufts"]), count, name)


class Mapping(unittest.TestCase):
    def test_wider_than_thick_lies_flat(self) -> None:
        tuft = convert(stroke(width=0.04, thickness=0.01))[0]["tufts"][0]
        self.assertEqual((tuft["diameter"], tuft["section"], tuft["flatness"], tuft["roll_deg"]), (100, "ellipse", 0.75, 0))

    def test_thicker_than_wide_stands_on_edge(self) -> None:
        tuft = convert(stroke(width=0.01, thickness=0.04))[0]["tufts"][0]
        self.assertEqual((tuft["diameter"], tuft["flatness"], tuft["roll_deg"]), (100, 0.75, 90))

    def test_equal_width_and_thickness_is_a_circle(self) -> None:
        tuft = convert(stroke(width=0.02, thickness=0.02))[0]["tufts"][0]
        self.assertEqual(tuft["section"], "circle")
        self.assertNotIn("flatness", tuft)

    def test_a_sheet_thinner_than_the_service_allows_is_made_as_flat_as_it_goes(self) -> None:
        self.assertEqual(convert(stroke(width=0.04, thickness=0.0001))[0]["tufts"][0]["flatness"], 0.98)

    def test_diameter_at_100_is_the_largest_rounded_up_to_a_millimetre(self) -> None:
        self.assertEqual(convert(stroke(width=0.0401), stroke(width=0.02))[0]["head"]["diameter_at_100"], 0.041)
        self.assertEqual(convert(stroke(width=0.04))[0]["head"]["diameter_at_100"], 0.04)

    def test_below_one_percent_is_clamped_with_a_warning(self) -> None:
        hairstyle, notes = convert(stroke(width=0.1), stroke(width=0.0005, thickness=0.0005))
        self.assertEqual(hairstyle["tufts"][1]["diameter"], 1)
        self.assertTrue(any("warning" in note and "g01_002" in note for note in notes), notes)

    def test_hidden_strokes_and_groups_stay_out_and_rename_nobody(self) -> None:
        strokes = [stroke(visible=False), stroke(), stroke(group=2)]
        groups = [{"group": 1, "visible": True}, {"group": 2, "visible": False}]
        self.assertEqual([t["name"] for t in convert(*strokes, groups=groups)[0]["tufts"]], ["g01_002"])
        everything = convert(*strokes, groups=groups, with_hidden=True)[0]["tufts"]
        self.assertEqual([t["name"] for t in everything], ["g01_001", "g01_002", "g02_001"])

    def test_one_stroke_still_has_a_head_below_its_root(self) -> None:
        hairstyle, notes = convert(stroke())
        self.assertEqual(hairstyle["head"]["center"], [0, 0.1, 0])
        self.assertIn("guessed", notes[0])

    def test_motion_is_left_out_or_embedded_whole(self) -> None:
        strokes = converter.read_strokes({"strokes": [stroke()]})
        self.assertNotIn("motion", converter.to_hairstyle(strokes)[0])
        motion = converter.to_hairstyle(strokes, motion="breeze")[0]["motion"]
        self.assertEqual(motion["wave"], {"amplitude": 0.38, "spatial_period": 1.0, "lightness": 1.2, "tip_exponent": 1.0})
        self.assertEqual(motion["timing"], {"period": 0.45, "fps": 24, "hold": 2})
        self.assertEqual(motion["phase"], {"step": "free", "gust_wavelength": 0.8, "spread": 0.08, "seed": 1})
        for name in converter.MOTIONS:  # 3 to 8 pictures, the animators' range
            timing = (converter.motion_block(name) or motion)["timing"]
            frames = math.floor(timing["fps"] * timing["period"] + 0.5)
            self.assertTrue(3 <= math.ceil(frames / timing["hold"]) <= 8, name)

    def test_a_sphere_is_found_exactly_from_points_on_it(self) -> None:
        points = [[1 + 2, 2, 3], [1 - 2, 2, 3], [1, 2 + 2, 3], [1, 2, 3 + 2], [1, 2, 3 - 2]]
        center, radius = converter.fit_sphere(points) or ([], 0)
        self.assertTrue(all(math.isclose(a, b, abs_tol=1e-12) for a, b in zip(center, [1, 2, 3])), center)
        self.assertAlmostEqual(radius, 2, places=12)

    def test_points_in_a_plane_fix_no_sphere(self) -> None:
        self.assertIsNone(converter.fit_sphere([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]))


class CommandLine(unittest.TestCase):
    def test_options_reach_the_hairstyle(self) -> None:
        code, out, err = run(str(STROKES / "vroid_Vita.strokes.json"), "--sides", "8", "--tolerance", "0.001", "--taper", "round",
                             "--widest-at", "60", "--motion", "gale")
        hairstyle = json.loads(out)
        self.assertEqual(code, 0)
        self.assertEqual(hairstyle["mesh"], {"tolerance": 0.001, "sides": 8})
        self.assertEqual({(t["taper"], t["widest_at"]) for t in hairstyle["tufts"]}, {("round", 60)})
        self.assertIn("head center", err)

    def test_broken_files_give_one_line_and_code_1(self) -> None:
        cases = {
            "not_json": ("{", "Expecting"),
            "not_utf8": (b"\xff\xfe", "utf-8"),
            "not_an_object": ("[]", "strokes"),
            "without_strokes": ('{"groups": []}', "strokes"),
            "no_strokes_left": (json.dumps({"strokes": [stroke(visible=False)]}), "--all"),
            "stroke_not_an_object": ('{"strokes": [1]}', "strokes[0]"),
            "one_point": (json.dumps({"strokes": [stroke(), stroke(points=[[0, 0, 0]])]}), "strokes[1].points"),
            "two_coordinates": (json.dumps({"strokes": [stroke(points=[[0, 0], [1, 1]])]}), "strokes[0].points"),
            "not_a_number": (json.dumps({"strokes": [stroke(points=[[0, 0, math.nan], [1, 1, 1]])]}), "strokes[0].points"),
            "no_width": (json.dumps({"strokes": [stroke(width=0)]}), "strokes[0].width"),
            "thickness_is_text": (json.dumps({"strokes": [stroke(thickness="1")]}), "strokes[0].thickness"),
            "group_is_text": (json.dumps({"strokes": [stroke(group="fringe")]}), "strokes[0].group"),
            "too_deep": ("[" * 200_000, ""),
        }
        with tempfile.TemporaryDirectory() as folder:
            for name, (content, expected) in cases.items():
                with self.subTest(name):
                    path = Path(folder, name + ".json")
                    path.write_bytes(content if isinstance(content, bytes) else content.encode())
                    code, out, err = run(str(path))
                    self.assertEqual((code, out), (1, ""))
                    self.assertEqual(err.count("\n"), 1, err)
                    self.assertIn(expected, err)
            self.assertEqual(run(str(Path(folder, "missing.json")))[0], 1)


if __name__ == "__main__":
    unittest.main()
