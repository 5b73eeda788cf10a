"""Evaluations measure as openapi.yaml says; fits find waves that are known, and what they answer goes into /v1/motions."""

from __future__ import annotations

import math
import random
from typing import Any, Optional

import contract
from support import ServiceTest

Point = list[float]
Line = list[Point]
CHAIN = [[0.0, 0.3, 0.0], [0.01, 0.24, 0.02], [0.03, 0.18, 0.03], [0.06, 0.12, 0.03], [0.1, 0.07, 0.02]]
WAVE = {"amplitude": 0.9, "spatial_period": -0.8, "lightness": 1.5, "tip_exponent": 1.3}
# Poses of /v1/motions are as exact as float32 is: about 1e-7 of their size, of which a fit makes a few times more.
NEAR = 1e-4


def away(a: Point, b: Point) -> Point:
    return [x - y for x, y in zip(a, b)]


def angle_deg(a: Point, b: Point) -> float:
    cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    return math.degrees(math.atan2(math.hypot(*cross), sum(x * y for x, y in zip(a, b))))


def error_of(line: Line, drawn: Line, rest_length: float) -> dict[str, float]:
    angles = [angle_deg(away(line[i], line[i - 1]), away(drawn[i], drawn[i - 1])) for i in range(1, len(line))]
    apart = [math.dist(away(line[i], line[0]), away(drawn[i], drawn[0])) for i in range(1, len(line))]
    return {"angle_deg": sum(angles) / len(angles), "position_percent": 100 * sum(apart) / len(apart) / rest_length}


def errors_of(lines: list[Line], drawn: list[Line], rest_length: Optional[float]) -> dict[str, Any]:
    length = rest_length or sum(math.dist(a, b) for line in drawn for a, b in zip(line, line[1:])) / len(drawn)
    pictures = [error_of(a, b, length) for a, b in zip(lines, drawn)]
    return {**{name: sum(picture[name] for picture in pictures) / len(pictures) for name in pictures[0]}, "pictures": pictures}


def mean_line(drawn: list[Line]) -> Line:
    return [[sum(line[i][axis] - line[0][axis] for line in drawn) / len(drawn) for axis in range(3)] for i in range(len(drawn[0]))]


class Lines(ServiceTest):
    def ask(self, path: str, body: dict[str, Any]) -> dict[str, Any]:
        answer = self.service.post(path, body)
        self.assert_ok(answer, "application/json")
        schema = {"/v1/evaluations": "EvaluationsAnswer", "/v1/fits": "FitsAnswer", "/v1/motions": "MotionAnswer"}[path]
        self.assertEqual(contract.faults(answer.json(), contract.named(schema)), [])
        return answer.json()

    def drawn(self, motion: dict[str, Any], **chain: Any) -> list[Line]:
        answer = self.ask("/v1/motions", {"chains": [{"nodes": CHAIN, **chain}], "motion": motion})
        return [picture["chains"][0]["positions"] for picture in answer["pictures"]]

    def assert_errors(self, got: dict[str, Any], expected: dict[str, Any]) -> None:
        for name, value in expected.items():
            if name == "pictures":
                self.assertEqual(len(got[name]), len(value))
                for a, b in zip(got[name], value):
                    self.assert_errors(a, b)
            else:
                self.assertAlmostEqual(got[name], value, 9)

    def test_errors_are_what_the_contract_says(self) -> None:
        rng = random.Random(3)
        shapes = [(2, 1, None), (5, 6, None), (5, 3, 0.7), (65, 24, 2.0)]  # nodes, pictures, rest length
        drawn, lines = ([[[[rng.uniform(-1, 1) for _ in range(3)] for _ in range(nodes)] for _ in range(pictures)]
                         for nodes, pictures, _ in shapes] for _ in range(2))
        answer = self.ask("/v1/evaluations", {
            "drawn": [{"name": str(i), "pictures": p, "rest_length": shape[2]} for i, (p, shape) in enumerate(zip(drawn, shapes))],
            "lines": [{"pictures": p} for p in lines]})
        errors = [errors_of(a, b, shape[2]) for a, b, shape in zip(lines, drawn, shapes)]
        stills = [errors_of([mean_line(b)] * len(b), b, shape[2]) for b, shape in zip(drawn, shapes)]
        weights = [(nodes - 1) * pictures for nodes, pictures, _ in shapes]
        for i, chain in enumerate(answer["chains"]):
            self.assertEqual(chain["name"], str(i))
            self.assert_errors(chain["error"], errors[i])
            self.assert_errors(chain["still"], stills[i])
        for which, chains in (("error", errors), ("still", stills)):
            for name in ("angle_deg", "position_percent"):
                whole = sum(w * chain[name] for w, chain in zip(weights, chains)) / sum(weights)
                self.assertAlmostEqual(answer[which][name], whole, 9)
        self.assertEqual([w["code"] for w in answer["warnings"]], ["no_better_than_still"])

    def test_flat_lines_lie_at_z_0(self) -> None:
        flat = [[[0, 0], [1, 0.5], [2, 0]], [[0, 0], [1, -0.5], [2, 0]]]
        deep = [[[*point, 0] for point in line] for line in flat]
        mixed = [flat[0], deep[1]]
        other = [{"pictures": [[[0, 0], [1, 0], [2, 0]]] * 2}]
        answers = [self.ask("/v1/evaluations", {"drawn": [{"pictures": p}], "lines": other}) for p in (flat, deep, mixed)]
        self.assertEqual(answers[0], answers[1])
        self.assertEqual(answers[0], answers[2])

    def test_a_motion_is_where_motions_says_it_is(self) -> None:
        for motion in ({"wave": WAVE}, {"wave": WAVE, "mode": "absolute", "wind": [0.2, 0.1, -1]}):
            drawn = self.drawn(motion, phase=0.4)
            answer = self.ask("/v1/evaluations", {"drawn": [{"pictures": drawn}], "chains": [{"nodes": CHAIN, "phase": 0.4}], "motion": motion})
            self.assertLess(answer["error"]["angle_deg"], 1e-4)  # poses go out as float32
            self.assertGreater(answer["still"]["angle_deg"], 5)
            lines = self.drawn({**motion, "wave": {**WAVE, "amplitude": 0.5}}, phase=0.4)
            by_motion = self.ask("/v1/evaluations", {"drawn": [{"pictures": drawn}], "chains": [{"nodes": CHAIN, "phase": 0.4}],
                                                     "motion": {**motion, "wave": {**WAVE, "amplitude": 0.5}}})
            by_lines = self.ask("/v1/evaluations", {"drawn": [{"pictures": drawn}], "lines": [{"pictures": lines}]})
            self.assertAlmostEqual(by_motion["error"]["angle_deg"], by_lines["error"]["angle_deg"], 4)
            self.assertGreater(by_motion["error"]["angle_deg"], 1)

    def test_fits_find_the_wave_that_was_drawn(self) -> None:
        for place in ({"mode": "relative"}, {"mode": "absolute"}, {"mode": "relative", "wind": [1, 0, -2], "up": [0.2, 1, 0]}):
            with self.subTest(place):
                drawn = self.drawn({"wave": WAVE, **place}, phase=-2.5)
                fit = self.ask("/v1/fits", {"drawn": [{"name": "lock", "pictures": drawn, "rest": CHAIN}], **place})["fits"][0]
                self.assertEqual((fit["name"], fit["cycles"], fit["complete"], fit["warnings"]), ("lock", 1, True, []))
                for name, value in WAVE.items():
                    self.assertAlmostEqual(fit["wave"][name], value, delta=NEAR)
                self.assertAlmostEqual(fit["phase"], -2.5, delta=NEAR)
                self.assertLess(fit["error"]["position_percent"], 1e-3)

    def test_a_fit_goes_into_motions_as_it_is(self) -> None:
        body = contract.example("fits")
        answer = self.ask("/v1/fits", body)
        fit = answer["fits"][0]
        moved = {"chains": [{name: fit[name] for name in ("nodes", "phase", "cycles")}],
                 "motion": {"wave": fit["wave"], **{name: body[name] for name in ("mode", "wind", "up")}}}
        drawn = {"pictures": body["drawn"][0]["pictures"], "rest_length": sum(math.dist(a, b) for a, b in zip(fit["nodes"], fit["nodes"][1:]))}
        evaluation = self.ask("/v1/evaluations", {"drawn": [drawn], **moved})
        self.assert_errors(evaluation["error"], answer["error"])
        self.assert_errors(evaluation["still"], answer["still"])
        self.assert_errors(evaluation["chains"][0]["error"], fit["error"])
        self.assertLess(10 * fit["error"]["position_percent"], fit["still"]["position_percent"])

    def test_a_fit_that_runs_out_of_steps_says_so(self) -> None:
        body = {**contract.example("fits"), "steps": 3}
        fit = self.ask("/v1/fits", body)["fits"][0]
        self.assertEqual((fit["complete"], fit["steps"]), (False, 3))
        self.assertLess(fit["error"]["position_percent"], fit["still"]["position_percent"])

    def test_what_cannot_be_told_is_warned_of(self) -> None:
        drawn = self.drawn({"wave": WAVE, "mode": "absolute"})
        for pictures, code in (([drawn[0], drawn[3]], "two_pictures"), ([drawn[0]] * 4, "nothing_moves")):
            fit = self.ask("/v1/fits", {"drawn": [{"pictures": pictures}], "mode": "absolute"})["fits"][0]
            self.assertIn(code, [warning["code"] for warning in fit["warnings"]])
        schedule = self.ask("/v1/fits", {"drawn": [{"pictures": drawn[:2]}], "timing": {"period": 0.1, "hold": 1}})
        self.assertEqual([warning["code"] for warning in schedule["warnings"]], ["unusual_picture_count"])

    def test_drawn_at_the_frames_where_pictures_start(self) -> None:
        timing = {"period": 0.45, "hold": 3, "sampling": "by_frame"}  # 11 frames as 3, 3, 3, 2
        drawn = self.drawn({"wave": WAVE, "timing": timing})
        body = {"drawn": [{"pictures": drawn, "rest": CHAIN}]}
        self.assertLess(self.ask("/v1/fits", {**body, "timing": timing})["error"]["position_percent"], 1e-3)
        self.assertGreater(self.ask("/v1/fits", body)["error"]["position_percent"], 0.1)

    def test_waves_per_loop(self) -> None:
        timing = {"period": 8 / 24, "hold": 1}
        drawn = self.drawn({"wave": WAVE, "timing": timing}, cycles=2)
        body = {"drawn": [{"pictures": drawn, "rest": CHAIN}]}
        self.assertEqual(self.ask("/v1/fits", body)["fits"][0]["cycles"], 2)
        self.assertGreater(self.ask("/v1/fits", {**body, "cycles": 1})["error"]["position_percent"], 1)
