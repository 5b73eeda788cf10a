"""Tests of the TressFX strands converter.

    python3 -m unittest discover -s tests/pipeline
"""

from __future__ import annotations

import contextlib
import io
import json
import math
import re
import struct
import sys
import tempfile
import unittest
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "client-examples" / "pipeline"))

import strands_to_hairstyle as converter  # noqa: E402

FILES = {name: ROOT / "tests" / "data" / "strands" / f"tressfx_ponytail_{name}.tfx" for name in ("back", "front_top", "tail")}
COUNTS = {"back": 517, "front_top": 876, "tail": 255}


def tfx(strands: int = 1, points: int = 2, version: float = 3.0, offset: int = 296, positions: bytes = b"") -> bytes:
    """The smallest file: one strand of two points."""
    header = struct.pack("<fII", version, strands, points).ljust(144, b"\0") + struct.pack("<I", offset)
    return header.ljust(296, b"\0") + (positions or struct.pack("<6f", 0, 0, 0, 0, -1, 0))


def run(*arguments: str) -> tuple[int, str, str]:
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = converter.main(list(arguments))
    return code, out.getvalue(), err.getvalue()


class RealFiles(unittest.TestCase):
    hairstyle: dict[str, Any]

    @classmethod
    def setUpClass(cls) -> None:
        cls.files = [converter.read_tfx(path.read_bytes()) for path in FILES.values()]
        cls.hairstyle, cls.notes = converter.to_hairstyle(cls.files, motion="breeze")

    def test_every_strand_becomes_a_tuft_of_16_points(self) -> None:
        self.assertEqual([len(strands) for strands in self.files], list(COUNTS.values()))
        self.assertEqual(len(self.hairstyle["tufts"]), 1648)
        self.assertEqual({len(t["points"]) for t in self.hairstyle["tufts"]}, {16})

    def test_every_value_is_in_the_range_of_the_service(self) -> None:
        self.assertEqual(set(self.hairstyle), {"head", "tufts", "motion", "mesh"})
        self.assertEqual(self.hairstyle["mesh"], {"tolerance": 0.0005, "sides": 6, "layout": "merged"})
        for tuft in self.hairstyle["tufts"]:
            self.assertTrue(1 <= tuft["diameter"] <= 100 and tuft["joints"] == 4, tuft["name"])
            self.assertTrue(all(math.isfinite(x) and abs(x) < 0.5 for p in tuft["points"] for x in p), tuft["name"])
            self.assertTrue(all(a != b for a, b in zip(tuft["points"], tuft["points"][1:])), tuft["name"])

    def test_names_are_short_unique_ascii(self) -> None:
        names = [t["name"] for t in self.hairstyle["tufts"]]
        self.assertEqual(len(set(names)), 1648)
        self.assertTrue(all(re.fullmatch(r"[A-Za-z0-9_]{1,12}", n) for n in names))

    def test_roots_lie_on_a_life_size_head_around_the_center(self) -> None:
        distances = [math.dist(t["points"][0], [0, 0, 0]) for t in self.hairstyle["tufts"] if t["name"][:2] != "f3"]
        self.assertLess(max(abs(d - 0.09) for d in distances), 0.02)  # metres
        self.assertLess(sorted(abs(d - 0.09) for d in distances)[len(distances) // 2], 0.002)

    def test_root_first_whichever_way_a_file_is_drawn(self) -> None:
        for name, strands in zip(COUNTS, self.files):
            with self.subTest(name):
                self.assertIs(converter.root_first(strands), strands)
                self.assertTrue(converter.root_first([strand[::-1] for strand in strands]) == strands)

    def test_roots_are_nearer_to_the_scalp_than_tips(self) -> None:
        tufts = self.hairstyle["tufts"]
        nearer = sum(abs(math.hypot(*t["points"][0]) - 0.09) < abs(math.hypot(*t["points"][-1]) - 0.09) for t in tufts)
        self.assertGreater(nearer, 0.85 * len(tufts))  # a few fringe tips lie on the scalp as well

    def test_the_face_looks_to_plus_z_and_the_tail_hangs_behind(self) -> None:
        tail = [t for t in self.hairstyle["tufts"] if t["name"].startswith("f3")]
        self.assertTrue(all(t["points"][0][2] < -0.1 and t["points"][-1][1] < t["points"][0][1] for t in tail))
        fringe = max(p[2] for t in self.hairstyle["tufts"] for p in t["points"])
        self.assertGreater(fringe, 0.08)

    def test_strands_are_as_thick_as_hair_is_drawn(self) -> None:
        head = self.hairstyle["head"]
        diameter = self.hairstyle["tufts"][0]["diameter"] / 100 * head["diameter_at_100"]
        self.assertTrue(0.004 <= diameter <= 0.008, diameter)

    def test_the_shape_is_only_turned_moved_and_scaled(self) -> None:
        hairstyle, _ = converter.to_hairstyle(self.files, unit=0.01, center=[1, 2, 3])
        source, tuft = self.files[0][7], hairstyle["tufts"][7]["points"]
        for a, b in zip(source, tuft):
            moved = [0.01 * (y - x) for x, y in zip(source[0], a)]
            for got, wanted in zip([y - x for x, y in zip(tuft[0], b)], [-moved[0], moved[1], -moved[2]]):
                self.assertAlmostEqual(got, wanted, delta=2e-6)  # metres: six decimals
        self.assertEqual(hairstyle["head"]["center"], [1, 2, 3])


class CommandLine(unittest.TestCase):
    def test_one_small_file_is_converted(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "small.tfx")
            path.write_bytes(tfx())
            code, out, err = run(str(path), "--unit", "0.01", "--diameter", "0.004")
        hairstyle = json.loads(out)
        self.assertEqual(code, 0)
        self.assertEqual(len(hairstyle["tufts"]), 1)
        self.assertEqual((hairstyle["tufts"][0]["diameter"], hairstyle["head"]["diameter_at_100"]), (100, 0.004))
        self.assertIn("guessed", err)

    def test_broken_files_give_one_line_and_code_1(self) -> None:
        cases = {
            "empty": (b"", "truncated"),
            "header_cut": (tfx()[:200], "truncated"),
            "positions_cut": (tfx()[:-4], "truncated"),
            "real_file_cut": (FILES["tail"].read_bytes()[:40_000], "truncated"),
            "longer": (tfx() + b"\0" * 8, "more than positions"),
            "version_4": (tfx(version=4.0), "version reads 4"),
            "version_nan": (tfx(version=math.nan), "version"),
            "no_strands": (tfx(strands=0), "0 strands"),
            "one_point": (tfx(points=1), "1 points"),
            "four_billion_strands": (tfx(strands=0xFFFFFFFF, points=64), "truncated"),
            "other_offset": (tfx(offset=300), "byte 300"),
            "not_finite": (tfx(positions=struct.pack("<6f", 0, 0, math.inf, 0, 1, 0)), "not finite"),
        }
        with tempfile.TemporaryDirectory() as folder:
            for name, (content, expected) in cases.items():
                with self.subTest(name):
                    path = Path(folder, name + ".tfx")
                    path.write_bytes(content)
                    code, out, err = run(str(FILES["tail"]), str(path))
                    self.assertEqual((code, out), (1, ""))
                    self.assertEqual(err.count("\n"), 1, err)
                    self.assertIn(expected, err)
                    self.assertIn(name, err)  # which of the files
            self.assertEqual(run(str(Path(folder, "missing.tfx")))[0], 1)


if __name__ == "__main__":
    unittest.main()
