"""Fills: the row between two tufts is where the paper says, its jitter is what openapi.yaml says, and its tufts are like drawn ones."""

from __future__ import annotations

import math
from collections import Counter
from typing import Any, NamedTuple, Optional

import contract
import rows
from fill_math import KINDS, Frame, Point, copies, cross, dot, is_within_hairline, jitter, mesh_of, philox, short_way, towards
from service import Answer
from support import ServiceTest, glb_parts

SEEDS = (0, 7, 2**32, 2**53 - 1)  # both words of the key
NEAR = 9  # decimals of an angle or of metres
# Heads and how they lie: as most do, and on one side, far off.
HEADS: dict[str, dict[str, Any]] = {"upright": {}, "lying": {"center": [1.5, -0.25, 3], "up": [2, 0.5, 0.1], "front": [0.3, 0, -5]}}


def lock(head: dict[str, Any], azimuth: float, elevation: float, **shape: Any) -> dict[str, Any]:
    """A tuft that comes out of the head and hangs down."""
    points = [towards(azimuth, elevation, 0.1), towards(azimuth + 8, elevation - 25, 0.115), towards(azimuth - 5, elevation - 60, 0.14)]
    return {"points": [Frame(head).outside(point) for point in points], **shape}


class Case(NamedTuple):
    head: dict[str, Any]
    fill: dict[str, Any]

    @property
    def body(self) -> dict[str, Any]:
        return {"head": self.head, "fill": self.fill}

    def but(self, **fields: Any) -> "Case":
        return Case(self.head, {**self.fill, **fields})


def case(head: Optional[dict[str, Any]] = None, **fields: Any) -> Case:
    """A fill around the back without jitter and scalp, which leaves every tuft where its formula puts it."""
    where = head if head is not None else {}
    tufts = {"from": lock(where, 10, 35, name="left", diameter=20, widest_at=30),
             "to": lock(where, 200, 20, name="right", diameter=60, widest_at=80, joints=4)}
    return Case(where, {**tufts, "density": {"along": 60}, **fields})


# A pyramid behind the head, open towards the face.
HALF = {"positions": [0.2, 0.2, 0, 0.2, -0.2, 0, -0.2, -0.2, 0, -0.2, 0.2, 0, 0, 0, -0.2], "triangles": [0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4]}
ALL = {"along": 70, "crown": 75, "neck": 80}


def without_origin(tuft: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in tuft.items() if name != "origin"}


class Fills(ServiceTest):
    def fill(self, asked: Case) -> dict[str, Any]:
        answer = self.service.post("/v1/fills", asked.body)
        self.assert_ok(answer, "application/json")
        return answer.json()

    def hair(self, word: str, body: dict[str, Any]) -> Answer:
        answer = self.service.post(f"/v1/hairstyles?format={word}", body)
        self.assert_ok(answer, contract.MEDIA_TYPES[word])
        return answer

    def test_philox_gives_the_published_answers(self) -> None:
        ones = 2**32 - 1
        for counter, key, words in (
                ((0, 0, 0, 0), (0, 0), (0x6627E8D5, 0xE169C58D, 0xBC57AC4C, 0x9B00DBD8)),
                ((ones,) * 4, (ones,) * 2, (0x408F276D, 0x41C83B0E, 0xA20BC7C6, 0x6D5451FD)),
                ((0x243F6A88, 0x85A308D3, 0x13198A2E, 0x03707344), (0xA4093822, 0x299F31D0), (0xD16CFE09, 0x94FDCCEB, 0x5001E420, 0x24126EA1))):
            self.assertEqual(philox(counter, key), words)

    def test_answers_fit_the_contract_in_the_promised_order(self) -> None:
        for name, asked in CASES.items():
            with self.subTest(name):
                answer = self.fill(asked)
                self.assertEqual(contract.faults(answer, contract.named("FillsAnswer")), [])
                origins = [tuft["origin"] for tuft in answer["tufts"]]
                places = [(KINDS.index(o["kind"]), o.get("parent", 0), o["index"]) for o in origins]
                self.assertEqual(places, sorted(set(places)))
                self.assertTrue(all(("parent" in o) == (o["kind"] != "along") for o in origins))
                called = asked.fill.get("name") or "fill"
                self.assertEqual([tuft["name"] for tuft in answer["tufts"]], [f"{called}_{i + 1}" for i in range(len(origins))])

    def test_the_counts_of_a_report_add_up(self) -> None:
        for name, asked in CASES.items():
            with self.subTest(name):
                answer = self.fill(asked)
                report, kinds = answer["report"], Counter(tuft["origin"]["kind"] for tuft in answer["tufts"])
                self.assertEqual(report["tufts"], {kind: kinds[kind] for kind in KINDS})
                removed = report["removed"]
                self.assertEqual(sum(kinds.values()) + sum(removed.values()), report["along"] + len(copies(asked.head, asked.fill, report)))
                self.assertLessEqual(report["moved_out"], len(answer["tufts"]))
                self.assertEqual(bool(answer["warnings"]), not answer["tufts"])

    def test_the_row_along_is_where_the_paper_says(self) -> None:
        for where, head in HEADS.items():
            for spacing in ("diameter", "half_gap", "as_printed"):
                for direction, sweep in (("counter_clockwise", 190), ("clockwise", -170), ("shorter", -170)):
                    with self.subTest(where, spacing=spacing, direction=direction):
                        asked = case(head, spacing=spacing, direction=direction)
                        answer = self.fill(asked)
                        report, count = answer["report"], len(answer["tufts"])
                        alpha, beta = math.radians(abs(sweep)), math.radians(-15)
                        gamma = math.acos(math.cos(alpha) * math.cos(beta))
                        gamma = 2 * math.pi - gamma if alpha > math.pi else gamma  # eq. (2)
                        for term, value in {"sweep": math.radians(sweep), "rise": beta, "gamma": gamma, "distance": 0.1 * gamma,
                                            "tufts_per_meter": 32 / (2 * math.pi * 0.1)}.items():
                            self.assertAlmostEqual(report[term], value, NEAR, term)
                        self.assertEqual(count, math.floor(0.6 * report["tufts_per_meter"] * report["distance"]))  # eq. (3)
                        widths = [20 + 40 * l / (count + 1) for l in range(count + 2)]  # eq. (4)
                        room = [(a + b) / 2 if spacing == "half_gap" else b for a, b in zip(widths, widths[1:])]
                        whole = sum(room[:-1] if spacing == "as_printed" else room)
                        for l, tuft in enumerate(answer["tufts"], 1):
                            share = sum(room[:l]) / whole  # eq. (5)
                            azimuth, elevation = Frame(head).bearing(tuft["points"][0])
                            self.assertAlmostEqual(short_way(azimuth - math.radians(10) - share * math.radians(sweep)), 0, NEAR)
                            self.assertAlmostEqual(elevation, math.radians(35 - 15 * share), NEAR)
                            self.assertAlmostEqual(tuft["diameter"], widths[l], NEAR)
                            self.assertAlmostEqual(tuft["widest_at"], 30 + 50 * l / (count + 1), NEAR)  # eq. (4)
                            self.assertEqual(tuft["joints"], math.floor(6 - 2 * l / (count + 1) + 0.5))
                            lengths, first, last = (steps_of(t) for t in (tuft, asked.fill["from"], asked.fill["to"]))
                            for length, a, b in zip(lengths, first, last):
                                self.assertAlmostEqual(length, a + (b - a) * l / (count + 1), NEAR)  # eq. (6)

    def test_a_gap_by_path_is_as_long_as_the_way_of_its_roots(self) -> None:
        for direction, sweep in (("counter_clockwise", 190), ("clockwise", -170)):
            with self.subTest(direction):
                report, steps = self.fill(case(arc="path", direction=direction))["report"], 10000
                way = [towards(10 + sweep * i / steps, 35 - 15 * i / steps, 1) for i in range(steps + 1)]
                self.assertAlmostEqual(report["gamma"], sum(math.dist(a, b) for a, b in zip(way, way[1:])), 6)
                self.assertAlmostEqual(report["distance"], 0.1 * report["gamma"], NEAR)

    def test_copies_are_their_parents_turned_up_and_down(self) -> None:
        for where, head in HEADS.items():
            with self.subTest(where):
                asked = case(head, density=ALL)
                answer, frame = self.fill(asked), Frame(head)
                row = [tuft for tuft in answer["tufts"] if tuft["origin"]["kind"] == "along"]
                parents = [asked.fill["from"], *row, asked.fill["to"]]
                found = set()
                for tuft in answer["tufts"][len(row):]:
                    kind, y, parent = tuft["origin"]["kind"], tuft["origin"]["index"], parents[tuft["origin"]["parent"] - 1]
                    found.add((kind, tuft["origin"]["parent"], y))
                    rise = y * math.radians(90 - 0.81 * ALL[kind]) * (1 if kind == "crown" else -1)  # eq. (7)
                    (azimuth, elevation), (a, e) = frame.bearing(tuft["points"][0]), frame.bearing(parent["points"][0])
                    self.assertAlmostEqual(short_way(azimuth - a), 0, NEAR)
                    self.assertAlmostEqual(elevation, e + rise, NEAR)
                    self.assertEqual((tuft["diameter"], tuft["widest_at"]), (parent["diameter"], parent["widest_at"]))
                    self.assert_turned(frame, parent, tuft)
                self.assertEqual(found, {place for place, azimuth, elevation in copies(asked.head, asked.fill, answer["report"])
                                         if place[0] == "crown" or is_within_hairline(azimuth, elevation)})

    def assert_turned(self, frame: Frame, a: dict[str, Any], b: dict[str, Any]) -> None:
        """Both strokes are the same, seen from the head's center."""
        before, after = ([frame.inside(point) for point in tuft["points"]] for tuft in (a, b))
        for i, (p, q) in enumerate(zip(before, after)):
            self.assertAlmostEqual(math.hypot(*p), math.hypot(*q), NEAR)
            self.assertAlmostEqual(math.dist(before[0], p), math.dist(after[0], q), NEAR)
            self.assertAlmostEqual(dot(cross(before[0], p), before[-1]), dot(cross(after[0], q), after[-1]), NEAR, f"point {i} is mirrored")

    def test_jitter_is_the_documented_one(self) -> None:
        for where, head in HEADS.items():
            clean = case(head, density=ALL)
            stills = {place_of(tuft): tuft for tuft in self.fill(clean)["tufts"]}
            for seed in SEEDS:
                with self.subTest(where, seed=seed):
                    answer, frame = self.fill(clean.but(jitter={"seed": seed})), Frame(head)
                    compared = 0
                    for tuft in answer["tufts"]:
                        still = stills.get(place_of(tuft))
                        if still is None:
                            continue  # a copy that only its jitter brings back from beyond the hair line
                        compared += 1
                        (azimuth, elevation), (a, e) = frame.bearing(tuft["points"][0]), frame.bearing(still["points"][0])
                        turn, rise = jitter(seed, tuft["origin"])
                        self.assertAlmostEqual(elevation, min(max(e + rise, -math.pi / 2), math.pi / 2), 7)
                        if abs(e + rise) < math.pi / 2 - 1e-6:  # right above the head there is no azimuth
                            self.assertAlmostEqual(short_way(azimuth - a - turn), 0, NEAR)
                        self.assert_turned(frame, still, tuft)
                    self.assertGreaterEqual(compared, 0.8 * len(stills))

    def test_the_hair_line_is_drawn_after_the_jitter(self) -> None:
        for seed in SEEDS:
            with self.subTest(seed=seed):
                asked = case(density=ALL, jitter={"seed": seed}, direction="clockwise")  # over the face
                answer = self.fill(asked)
                expected, beyond = set(), 0
                for (kind, parent, y), azimuth, elevation in copies(asked.head, asked.fill, answer["report"]):
                    turn, rise = jitter(seed, {"kind": kind, "parent": parent, "index": y})
                    is_within = is_within_hairline(azimuth + turn, max(elevation + rise, -math.pi / 2))
                    if kind == "crown" or is_within:
                        expected.add((kind, parent, y))
                    else:
                        beyond += 1
                self.assertEqual({place_of(tuft) for tuft in answer["tufts"] if tuft["origin"]["kind"] != "along"}, expected)
                removed = answer["report"]["removed"]
                self.assertEqual((removed["hairline"], sum(removed.values())), (beyond, beyond))

    def test_the_same_seed_is_the_same_hair_and_another_is_not(self) -> None:
        asked = case(density=ALL)
        seen = {self.service.post("/v1/fills", asked.but(jitter=given).body).body for given in (None, {}, *({"seed": seed} for seed in range(1, 20)))}
        self.assertEqual(len(seen), 21)
        self.assertEqual(self.fill(asked.but(jitter={})), self.fill(asked.but(jitter={"seed": 0})))

    def test_along_crown_and_neck_are_on_and_off_by_themselves(self) -> None:
        whole = self.fill(case(density=ALL, jitter={"seed": 5}))["tufts"]
        for crown in (ALL["crown"], 0, None):
            for neck in (ALL["neck"], 0, None):
                with self.subTest(crown=crown, neck=neck):
                    wanted = {"along"} | {kind for kind, density in (("crown", crown), ("neck", neck)) if density}
                    answer = self.fill(case(density={**ALL, "crown": crown, "neck": neck}, jitter={"seed": 5}))
                    self.assertEqual([{**tuft, "name": ""} for tuft in answer["tufts"]],
                                     [{**tuft, "name": ""} for tuft in whole if tuft["origin"]["kind"] in wanted])
        for along in (0, None):
            with self.subTest(along=along):
                answer = self.fill(case(density={**ALL, "along": along}))
                self.assertEqual(answer["report"]["along"], 0)
                self.assertEqual({tuft["origin"]["parent"] for tuft in answer["tufts"]}, {1, 2})

    def test_a_filled_tuft_is_accepted_as_it_came_and_keeps_its_origin(self) -> None:
        filled = self.fill(case(density=ALL, jitter={"seed": 3}))["tufts"]
        for path, more in (("/v1/tufts", {}), ("/v1/hairstyles", {}), ("/v1/hairstyles", {"motion": {}})):
            with self.subTest(path, **more):
                answer = self.service.post(path, {"tufts": filled, **more})
                self.assert_ok(answer, "model/gltf-binary")
                self.assertEqual(glb_parts(answer.body)[0]["asset"]["extras"]["tuftwave"]["hairstyle"]["tufts"], filled)
                without = self.service.post(path, {"tufts": [without_origin(tuft) for tuft in filled], **more})
                self.assertEqual(glb_parts(without.body)[1], glb_parts(answer.body)[1])
        again = self.fill(Case({}, {"from": filled[0], "to": filled[2]}))
        self.assertEqual([tuft["origin"] for tuft in again["tufts"]], [{"kind": "along", "index": i + 1} for i in range(len(again["tufts"]))])

    def test_a_fill_as_a_file_is_its_tufts_as_a_file(self) -> None:
        for name, asked in {**CASES, "the example": Case(*(contract.example("fills")[part] for part in ("head", "fill")))}.items():
            filled = self.fill(asked)["tufts"]
            for word in ("glb", "gltf"):
                with self.subTest(name, format=word):
                    answer = self.service.post(f"/v1/fills?format={word}", asked.body)
                    if filled:
                        self.assertEqual(answer.body, self.service.post(f"/v1/tufts?format={word}", {"head": asked.head, "tufts": filled}).body)
                    else:
                        self.assert_problem(answer, 422, "too_few", "/fill/density")

    def test_a_hairstyle_is_filled_with_the_same_tufts(self) -> None:
        for name, asked in CASES.items():
            for more in ({}, {"motion": {"phase": {"spread": 1, "seed": 4}}}):
                with self.subTest(name, **more):
                    alone = self.fill(asked)
                    drawn = drawn_tufts(asked)
                    whole = {"head": asked.head, "tufts": drawn, "fills": [hairstyle_fill(asked)], **more}
                    report = self.hair("json", whole).json()
                    self.assertEqual(contract.faults(report, contract.named("HairstyleAnswer")), [])
                    self.assertEqual(report["fills"], [alone["report"]])
                    called = asked.fill.get("name") or "fill1"  # the first of the hairstyle's
                    filled = [{**tuft, "name": f"{called}_{i + 1}"} for i, tuft in enumerate(alone["tufts"])]
                    by_hand = {"head": asked.head, "tufts": drawn + filled, **more}
                    self.assertEqual({**report, "fills": [], "warnings": []}, {**self.hair("json", by_hand).json(), "warnings": []})
                    (gltf, buffer), (expected, expected_buffer) = (glb_parts(self.hair("glb", body).body) for body in (whole, by_hand))
                    self.assertEqual(buffer, expected_buffer)
                    self.assertEqual(gltf["asset"]["extras"]["tuftwave"].pop("hairstyle")["tufts"],
                                     expected["asset"]["extras"]["tuftwave"].pop("hairstyle")["tufts"][:len(drawn)])
                    for parts in (gltf, expected):
                        parts["asset"]["extras"]["tuftwave"].pop("warnings", None)
                    self.assertEqual(gltf, expected)

    def test_several_fills_follow_in_their_order_and_are_numbered(self) -> None:
        tufts = drawn_tufts(case())
        way = {"from": "left", "to": "right"}
        fills = [way, {"from": "right"}, {**way, "name": "back"}, {**way, "density": {"along": 0}}]
        report = self.hair("json", {"tufts": tufts, "fills": fills}).json()
        counts = [sum(fill["tufts"].values()) for fill in report["fills"]]
        names = [f"{called}_{i + 1}" for called, count in zip(("fill1", "fill2", "back", "fill4"), counts) for i in range(count)]
        self.assertEqual([tuft["name"] for tuft in report["tufts"]], ["left", "right", *names])
        self.assertEqual(report["totals"]["tufts"], 2 + sum(counts))
        self.assertEqual([(warning["code"], "Fill 4" in warning["detail"]) for warning in report["warnings"]], [("empty_fill", True)])

    def test_a_ring_is_a_fill_without_to(self) -> None:
        for direction, sweep in (("counter_clockwise", 2 * math.pi), ("clockwise", -2 * math.pi), ("shorter", 2 * math.pi)):
            with self.subTest(direction):
                ring = case(direction=direction, density=ALL)
                ring.fill.pop("to")
                answer = self.fill(ring)
                self.assertEqual(answer, self.fill(ring.but(to=None)))
                self.assertEqual((answer["report"]["sweep"], answer["report"]["rise"]), (sweep, 0))
                self.assertEqual(answer["report"]["along"], 22)  # 70 percent of 32
                azimuths = [Frame({}).bearing(tuft["points"][0])[0] for tuft in answer["tufts"][:22]]
                for l, azimuth in enumerate(azimuths, 1):
                    self.assertAlmostEqual(short_way(azimuth - math.radians(10) - l * sweep / 23), 0, NEAR)
                parents = {tuft["origin"].get("parent", 1) for tuft in answer["tufts"]}
                self.assertEqual(parents, set(range(1, 24)))  # without the ring's end, which is its beginning
                filled = [{"from": "left", "direction": direction, "density": ALL, "name": "fill", **to} for to in ({}, {"to": None}, {"to": "left"})]
                bodies = [{"tufts": drawn_tufts(case()), "fills": [fill]} for fill in filled]
                self.assertEqual([self.hair("json", body).json()["fills"] for body in bodies], [[answer["report"]]] * 3)
                self.assertEqual(len({glb_parts(self.hair("glb", body).body)[1] for body in bodies}), 1)

    def test_a_second_tuft_in_the_same_place_is_no_ring(self) -> None:
        asked = case()
        answer = self.fill(asked.but(to=asked.fill["from"]))
        self.assertEqual((answer["report"]["sweep"], answer["report"]["distance"], answer["report"]["along"], answer["tufts"]), (0, 0, 0, []))

    def test_a_fill_that_adds_nothing_says_so(self) -> None:
        for fields in ({"density": {"along": 0}}, {"density": {"along": None}}, {"tufts_per_meter": 0.001}, {"density": {"along": 1}}):
            with self.subTest(**fields):
                asked = case(**fields)
                answer = self.fill(asked)
                self.assertEqual((answer["tufts"], answer["report"]["along"]), ([], 0))
                self.assertEqual([warning["code"] for warning in answer["warnings"]], ["empty_fill"])
                for word in ("glb", "gltf"):
                    self.assert_problem(self.service.post(f"/v1/fills?format={word}", asked.body), 422, "too_few", "/fill/density")
                body = {"tufts": drawn_tufts(asked), "fills": [hairstyle_fill(asked)], "motion": {}}
                report = self.hair("json", body).json()
                self.assertEqual((report["totals"]["tufts"], [warning["code"] for warning in report["warnings"]]), (2, ["empty_fill"]))
                for moving in (body, {**body, "motion": None}):
                    self.assertEqual(glb_parts(self.hair("glb", moving).body)[0]["asset"]["extras"]["tuftwave"]["warnings"], report["warnings"])

    def test_a_fill_whose_tufts_are_all_left_out_says_that_and_not_to_fill_more(self) -> None:
        answer = self.fill(case(head={"scalp": {"mesh": {"positions": [0.1] * 9, "triangles": [0, 1, 2]}}}))
        self.assertEqual((answer["tufts"], answer["report"]["removed"]["off_scalp"]), ([], answer["report"]["along"]))
        self.assertEqual(answer["warnings"], [{"code": "empty_fill", "detail": "Fill 1 adds no tuft: all of them were left out, see removed."}])

    def test_half_gaps_are_the_same_from_both_sides(self) -> None:
        asked = case(spacing="half_gap")
        back = asked.but(**{"from": asked.fill["to"], "to": asked.fill["from"], "direction": "clockwise"})
        ours, theirs = self.fill(asked)["tufts"], self.fill(back)["tufts"]
        self.assertEqual(len(ours), len(theirs))
        for a, b in zip(ours, reversed(theirs)):
            self.assertAlmostEqual(a["diameter"], b["diameter"], NEAR)
            for p, q in zip(a["points"], b["points"]):
                self.assertLess(math.dist(p, q), 1e-12)

    def test_as_printed_the_last_tuft_lands_on_the_second(self) -> None:
        for fields in ({"formulas": "as_printed"}, {"spacing": "as_printed"}):
            with self.subTest(**fields):
                asked = case(**fields)
                last = self.fill(asked)["tufts"][-1]
                self.assertLess(math.dist(last["points"][0], asked.fill["to"]["points"][0]), 1e-12)
        self.assertEqual(self.fill(case(formulas="as_printed", spacing="half_gap"))["tufts"], self.fill(case(spacing="half_gap"))["tufts"])

    def test_unequal_strokes_are_given_equal_points(self) -> None:
        short = [[0.1, 0, 0], [0.1, -0.2, 0]]
        for fields in ({}, {"resample": True}, {"resample": True, "formulas": "as_printed"}):
            for end, other in (("from", "to"), ("to", "from")):
                with self.subTest(end, **fields):
                    asked = case(**fields)
                    answer = self.fill(asked.but(**{end: {"points": short}}))
                    self.assertEqual({len(tuft["points"]) for tuft in answer["tufts"]}, {len(asked.fill[other]["points"])})
                    self.assertEqual(answer["report"]["resampled"], ["from", "to"])
        self.assertEqual(self.fill(case())["report"]["resampled"], [])

    def test_too_many_tufts_are_told_their_number(self) -> None:
        ring = {"points": [[0.1, 0, 0], [0.1, -0.1, 0]]}

        def along(per_meter: float) -> int:
            return math.floor(0.5 * per_meter * 2 * math.pi * 0.1)

        # Copies of density 100 are 9 degrees apart, and nine of them go between a root at 0 degrees and the pole.
        for per_meter, crown, pointer, value in ((60000, None, "/fill/density/along", along(60000)),
                                                 (10000, 100, "/fill/density", along(10000) + 9 * (along(10000) + 1))):
            with self.subTest(pointer):
                answer = self.service.post("/v1/fills", Case({}, {"from": ring, "tufts_per_meter": per_meter, "density": {"crown": crown}}).body)
                self.assert_problem(answer, 422, "too_many", pointer)
                self.assertEqual((answer.json()["errors"][0]["value"], answer.json()["errors"][0]["maximum"]), (value, 16384))
        drawn = [{**ring, "name": "a"}, *[{**ring, "joints": 1}] * 15000]
        answer = self.service.post("/v1/hairstyles", {"tufts": drawn, "fills": [{"from": "a", "tufts_per_meter": 6000}]})
        self.assert_problem(answer, 422, "too_many", "/fills/0")
        self.assertEqual(answer.json()["errors"][0]["value"], 15001 + along(6000))
        long = {"points": rows.LONGEST_STROKE}
        answer = self.service.post("/v1/fills", {"fill": {"from": long, "tufts_per_meter": 1000}})
        self.assert_problem(answer, 422, "too_many", "/fill/density")
        self.assertEqual(answer.json()["errors"][0]["value"], 1024 * along(1000 * math.hypot(*rows.POINT) / 0.1))

    def test_filled_roots_are_on_the_scalp(self) -> None:
        radii, middle = [0.085, 0.11, 0.095], [0.004, -0.01, 0.006]  # along the character's left, up and front
        for where, head in HEADS.items():
            frame = Frame(head)
            center = frame.outside([middle[0], -middle[2], middle[1]])
            scalps = {"ellipsoid": {"ellipsoid": {"radii": radii, "center": center}}, "mesh": {"mesh": mesh_of(frame, radii, middle)}}
            for shape, scalp in scalps.items():
                with self.subTest(where, scalp=shape):
                    bare = case(head, density=ALL, jitter={"seed": 2})
                    asked = Case({**head, "scalp": scalp}, bare.fill)
                    answer = self.fill(asked)
                    self.assertEqual(answer["report"]["removed"]["off_scalp"], 0)
                    self.assertEqual([tuft["origin"] for tuft in answer["tufts"]], [tuft["origin"] for tuft in self.fill(bare)["tufts"]])
                    for tuft, free in zip(answer["tufts"], self.fill(bare)["tufts"]):
                        x, y, z = frame.inside(tuft["points"][0])
                        at = math.hypot((x - middle[0]) / radii[0], (z - middle[1]) / radii[1], (-y - middle[2]) / radii[2])
                        self.assertAlmostEqual(at, 1, 9 if shape == "ellipsoid" else 1)
                        ours, theirs = (frame.inside(root) for root in (tuft["points"][0], free["points"][0]))
                        self.assertAlmostEqual(dot(ours, theirs), math.hypot(*ours) * math.hypot(*theirs), 12)  # on the same ray

    def test_filled_tufts_stay_out_of_the_scalp_and_near_it(self) -> None:
        """On scalps that are as large as the head that was drawn on, and smaller."""
        for radius in (0.1, 0.098, 0.09, 0.07):
            for shape in ("ellipsoid", "mesh"):
                radii = [radius] * 3
                scalp = {"ellipsoid": {"radii": radii}} if shape == "ellipsoid" else {"mesh": mesh_of(Frame({}), radii, [0, 0, 0])}
                with self.subTest(shape, radius=radius):
                    bare = case(density={"along": 80, "crown": 60, "neck": 50})
                    free = {place_of(tuft): tuft for tuft in self.fill(bare)["tufts"]}
                    answer = self.fill(Case({"scalp": scalp}, bare.fill))
                    self.assertGreaterEqual(len(answer["tufts"]), 0.9 * len(free))
                    for tuft in answer["tufts"]:
                        for point, unmoved in zip(tuft["points"], free[place_of(tuft)]["points"]):
                            self.assertGreater(math.hypot(*point), 0.98 * radius)  # a mesh of few faces is flatter than a ball
                            self.assertLess(math.dist(point, unmoved), 0.1 - radius + 0.01)

    def test_what_would_run_through_the_head_is_brought_out_or_left_out(self) -> None:
        # One lies around the front to the right, the other around the front to the left: between them they go straight on.
        turns = {"from": range(0, -180, -15), "to": range(180, 360, 15)}
        bands = {end: {"points": [Frame({}).outside(towards(azimuth, 0, 0.105)) for azimuth in turns[end]]} for end in turns}
        answer = self.fill(Case({"scalp": {"ellipsoid": {"radii": [0.1, 0.1, 0.1]}}}, bands))
        self.assertGreater(answer["report"]["moved_out"] + answer["report"]["removed"]["inside"], 0)
        self.assertEqual(answer["report"]["removed"]["inside"] + len(answer["tufts"]), answer["report"]["along"])

    def test_where_a_scalp_mesh_has_no_surface_no_hair_grows(self) -> None:
        ring = Case({"scalp": {"mesh": HALF}}, {"from": {"points": [[0, 0.01, -0.1], [0, -0.1, -0.1]]}, "density": {"along": 100}})
        answer = self.fill(ring)
        self.assertEqual((answer["report"]["along"], answer["report"]["removed"]["off_scalp"]), (32, 32 - len(answer["tufts"])))
        self.assertEqual(len(answer["tufts"]), 16)
        self.assertTrue(all(tuft["points"][0][2] < 0 for tuft in answer["tufts"]))

    def test_a_scalp_leaves_drawn_tufts_alone(self) -> None:
        body = {"tufts": drawn_tufts(case()), "motion": {}}
        bald = glb_parts(self.hair("glb", body).body)[1]
        for scalp in ({"ellipsoid": {"radii": [1, 1, 1]}}, {"mesh": rows.tetrahedron()}):
            self.assertEqual(glb_parts(self.hair("glb", {**body, "head": {"scalp": scalp}}).body)[1], bald)

    def test_copies_keep_the_gap_that_is_asked_for(self) -> None:
        free = self.fill(case(density=ALL, jitter={"seed": 9}))["tufts"]
        for gap in (0.1, 0.5, 2, 10):
            with self.subTest(gap):
                asked = case(density=ALL, jitter={"seed": 9}, min_gap=gap)
                answer = self.fill(asked)
                self.assertEqual(len(free) - len(answer["tufts"]), answer["report"]["removed"]["crowded"])
                row = [tuft["points"][0] for tuft in answer["tufts"] if tuft["origin"]["kind"] == "along"]
                kept: dict[str, list[Point]] = {kind: [asked.fill["from"]["points"][0], asked.fill["to"]["points"][0], *row] for kind in KINDS[1:]}
                expected = [tuft for tuft in free if tuft["origin"]["kind"] == "along"]
                for tuft in free[len(row):]:
                    roots, least = kept[tuft["origin"]["kind"]], gap * 0.1 * tuft["diameter"] / 100
                    if all(math.dist(root, tuft["points"][0]) >= least for root in roots):
                        roots.append(tuft["points"][0])
                        expected.append(tuft)
                self.assertEqual([without_name(tuft) for tuft in answer["tufts"]], [without_name(tuft) for tuft in expected])


def steps_of(tuft: dict[str, Any]) -> Point:
    """Lengths between the points of a stroke."""
    return [math.dist(p, q) for p, q in zip(tuft["points"], tuft["points"][1:])]


def without_name(tuft: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in tuft.items() if name != "name"}


def place_of(tuft: dict[str, Any]) -> tuple[str, int, int]:
    origin = tuft["origin"]
    return origin["kind"], origin.get("parent", 0), origin["index"]


def drawn_tufts(asked: Case) -> list[dict[str, Any]]:
    return [asked.fill[end] for end in ("from", "to") if asked.fill.get(end)]


def hairstyle_fill(asked: Case) -> dict[str, Any]:
    """The same fill between tufts of a hairstyle."""
    return {**asked.fill, **{end: asked.fill[end]["name"] for end in ("from", "to") if asked.fill.get(end)}}


def ring_case(**fields: Any) -> Case:
    ring = case(**fields)
    ring.fill.pop("to")
    return ring


CASES = {
    "along": case(),
    "all": case(density=ALL),
    "on its side": case(HEADS["lying"], density=ALL, jitter={"seed": 1}),
    "jittered and thinned": case(density=ALL, jitter={"seed": 2**53 - 1}, min_gap=0.8, name="back"),
    "a ring": ring_case(density=ALL),
    "a ring as printed": ring_case(density=ALL, formulas="as_printed"),
    "as printed": case(density=ALL, formulas="as_printed"),
    "by path, the shorter way": case(density=ALL, arc="path", direction="shorter"),
    "on an ellipsoid": case({"scalp": {"ellipsoid": {"radii": [0.1, 0.1, 0.1]}}}, density=ALL),
    "on half a scalp": case({"scalp": {"mesh": HALF}}, density=ALL),
    "unequal strokes": case(**{"to": {**lock({}, 150, 0, name="right"), "points": [[-0.1, 0, 0], [-0.1, -0.1, 0]]}, "density": ALL}),
    "nothing": case(density={"along": 0}),
    "copies only": case(density={"along": 0, "crown": 30, "neck": 30}),
}
