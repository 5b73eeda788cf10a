"""How the benchmark's figures become ratios, a table and a row of results.

    python3 -m unittest discover -s tests/bench
"""

from __future__ import annotations

import csv
import os
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True

import bench
import releases
import thousand_strokes
import workloads
from figures import Figures, Missing, combined, ratio, value, worst
from goals import GOALS, Goal, at_least, at_most
from parties import Party


def two_rounds() -> Figures:
    """The machine is twice as slow in the second round, in which the peer is measured only once."""
    figures = Figures()
    figures.add('noise\n{"name": "w1/peer", "ms": [100, 900, 110]}\n{"name": "w1/tuftwave", "ms": [10]}', 0)
    figures.add('{"name": "w1/peer", "ms": [220]}\n{"name": "w1/tuftwave", "ms": [20]}', 1)
    return figures


class FiguresTest(unittest.TestCase):
    def test_a_ratio_is_taken_within_a_round(self) -> None:
        self.assertEqual(ratio("w1/peer", "w1/tuftwave")(two_rounds()), [11, 11])

    def test_a_round_without_one_of_both_is_left_out(self) -> None:
        figures = two_rounds()
        figures.add('{"name": "w1/tuftwave", "ms": [5]}', 2)
        self.assertEqual(combined(lambda a, b: a + b, "w1/tuftwave", "w1/peer")(figures), [120, 240])

    def test_a_program_with_rounds_of_its_own_has_a_sample_for_each(self) -> None:
        figures = Figures()
        figures.add_rounds('{"name": "http/null/peer", "value": [3, 1, 2], "unit": "requests/s"}')
        self.assertEqual(value("http/null/peer")(figures), [3, 1, 2])
        self.assertEqual(worst("http/null/peer")(figures), [3])

    def test_what_nobody_printed_is_missing_by_its_name(self) -> None:
        with self.assertRaisesRegex(Missing, "w1/nobody"):
            ratio("w1/nobody", "w1/tuftwave")(two_rounds())


class TableTest(unittest.TestCase):
    fast = Goal("fast", "fast", value("x/tuftwave"), at_least(20, 60))

    def test_the_median_decides_whether_a_goal_holds(self) -> None:
        self.assertEqual(bench.row(self.fast, [1, 20, 90], ""), "| fast | >= 20 | >= 60 | 20 (1 to 90) | holds |")
        self.assertEqual(bench.row(self.fast, [19, 19, 90], ""), "| fast | >= 20 | >= 60 | 19 (19 to 90) | missed |")
        self.assertIn("missed", bench.row(self.fast._replace(bounds=at_most(5, 1)), [6], ""))

    def test_a_peer_that_is_not_installed_is_why_a_goal_was_not_measured(self) -> None:
        absent = Party(("peer",), None, (), "no Peer")
        self.assertEqual(bench.why_missing("w1/peer", [absent], []), "no Peer")
        self.assertEqual(bench.why_missing("w1/other", [absent], []), "nothing prints w1/other")
        self.assertIn("not measured (no Peer)", bench.row(self.fast, [], "no Peer"))

    def test_every_goal_has_a_column_of_its_own(self) -> None:
        self.assertEqual(len({goal.key for goal in GOALS}), len(GOALS))


class ReleasesTest(unittest.TestCase):
    def test_a_new_goal_gets_a_column_and_old_rows_stay(self) -> None:
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "results", "ratios.csv")
            releases.append("0.1.0", {"a": [1, 3, 2], "b": []}, path)
            releases.append("0.2.0", {"b": [5], "c": [7]}, path)
            with open(path, encoding="ascii", newline="") as file:
                rows = list(csv.DictReader(file))
        self.assertEqual([row["version"] for row in rows], ["0.1.0", "0.2.0"])
        self.assertEqual([(row["a"], row["b"], row["c"]) for row in rows], [("2", "", ""), ("", "5", "7")])


class WorkloadsTest(unittest.TestCase):
    def test_everybody_gets_as_much_work_as_its_definition_says(self) -> None:
        strokes, chains = thousand_strokes.request()["tufts"], workloads.chains()["chains"]
        self.assertEqual((len(strokes), {len(stroke["points"]) for stroke in strokes}), (1000, {8}))
        self.assertEqual((len(chains), {len(chain["nodes"]) for chain in chains}), (200, {16}))


if __name__ == "__main__":
    unittest.main()
