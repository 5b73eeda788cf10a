"""One sheet, told four times: JSON, GLB, XDTS and CSV agree on every frame."""

from __future__ import annotations

import json
from typing import Any
from urllib.parse import urlencode

import contract
from support import ServiceTest, floats, glb_parts

TIMINGS = [  # period, fps, hold, short_holds: the paper's, ties, a single picture, few pictures held long, NTSC
    (0.45, 24, 2, "last"), (0.8, 24, 3, "last"), (0.58, 25, 1, "spread"), (0.5, 12, 2, "spread"), (1.0, 60, 3, "last"),
    (0.2, 25, 4, "last"), (0.05, 24, 2, "last"), (0.45, "24000/1001", 2, "last"), (0.45, 23.976, 2, "spread"), (0.7, 30, 2, "spread"),
]


def timing(period: float, fps: Any, hold: int, short_holds: str) -> dict[str, Any]:
    return {"period": period, "fps": fps, "hold": hold, "short_holds": short_holds}


def shown(holds: list[int]) -> list[int]:
    """The picture on show at every frame, from 0."""
    return [picture for picture, hold in enumerate(holds) for _ in range(hold)]


def xdts_table(text: str) -> dict[str, Any]:
    return json.loads(text.split("\n", 1)[1])["timeTables"][0]


def xdts_names(text: str) -> list[str]:
    return xdts_table(text)["timeTableHeaders"][0]["names"]


def shown_in_xdts(text: str) -> list[int]:
    """An XDTS's frames, expanded as OpenToonz does: a cell lasts until the next one or the end."""
    table = xdts_table(text)
    header, field = table["timeTableHeaders"], table["fields"]
    assert [h["fieldId"] for h in header] == [0] == [f["fieldId"] for f in field]
    tracks = field[0]["tracks"]
    assert [track["trackNo"] for track in tracks] == list(range(len(header[0]["names"])))
    assert len(set(header[0]["names"])) == len(tracks) and all(track["frames"] == tracks[0]["frames"] for track in tracks)
    cells = {entry["frame"]: entry["data"][0]["values"][0] for entry in tracks[0]["frames"]}
    assert max(cells) == table["duration"] and cells[table["duration"]] == "SYMBOL_NULL_CELL"
    pictures: list[int] = []
    for frame in range(table["duration"]):
        pictures.append(int(cells[frame]) - 1 if frame in cells else pictures[-1])
    return pictures


def shown_in_csv(text: str) -> list[int]:
    rows = [row.split(",") for row in text.split("\r\n")[1:-1]]
    assert [int(frame) for frame, _, _ in rows] == list(range(1, len(rows) + 1))
    pictures = [int(picture) - 1 for _, picture, _ in rows]
    keys = [key == "1" for _, _, key in rows]
    assert keys == [i == 0 or pictures[i] != pictures[i - 1] or len(set(pictures)) == 1 and i % len(pictures) == 0 for i in range(len(pictures))]
    return pictures


def shown_in_clip(glb: bytes, frames: int, seconds_per_frame: float) -> list[int]:
    """What a player shows that looks exactly at each frame's time."""
    gltf, buffer = glb_parts(glb)
    (clip,) = gltf["animations"]
    (times_of_all,) = {sampler["input"] for sampler in clip["samplers"]}
    assert {sampler["interpolation"] for sampler in clip["samplers"]} == {"STEP"}
    times = floats(gltf, buffer, times_of_all)
    assert times[0] == 0 and all(a < b for a, b in zip(times, times[1:]))
    length = frames * seconds_per_frame
    assert length - 4e-6 * length < times[-1] < length, (times[-1], length)  # at most one step of float32 below
    for sampler in clip["samplers"]:
        keys = floats(gltf, buffer, sampler["output"])
        assert keys[:4] == keys[-4:], "the closing key is not the first picture"
    return [max(i for i, time in enumerate(times[:-1]) if time <= frame * seconds_per_frame) for frame in range(frames)]


class Schedules(ServiceTest):
    def test_the_papers_example_is_eleven_frames_of_six_pictures_everywhere(self) -> None:
        asked = {"period": 0.45, "fps": 24, "hold": 2}
        holds, starts = [2, 2, 2, 2, 2, 1], [0, 2, 4, 6, 8, 10]
        sheet = self.service.post("/v1/schedules", {"timing": asked}).json()
        self.assertEqual(sheet, {"schedule": {"frames": 11, "pictures": 6, "holds": holds, "starts": starts, "fps": 24,
                                              "requested_period": 0.45, "period": 11 / 24}, "warnings": []})
        for operation in ("hairstyles", "motions"):
            with self.subTest(operation):
                body = contract.example(operation)
                self.assertEqual({name: body["motion"]["timing"][name] for name in asked}, asked)
                report = self.service.post(f"/v1/{operation}?format=json", body).json()
                self.assertEqual(report["schedule"], sheet["schedule"])
                self.assertEqual(len(report["pictures"]), 6)
                self.assertEqual(report["quality"]["hold_counts"], {"1": 1, "2": 5})
                glb = self.service.post(f"/v1/{operation}?format=glb", body).body
                gltf, _ = glb_parts(glb)
                self.assertEqual(gltf["asset"]["extras"]["tuftwave"]["schedule"], sheet["schedule"])
                self.assertEqual(gltf["animations"][0]["extras"], sheet["schedule"])
                self.assertEqual(shown_in_clip(glb, 11, 1 / 24), shown(holds))
                self.assertEqual(shown_in_xdts(self.service.post(f"/v1/{operation}?format=xdts", body).body.decode()), shown(holds))
                self.assertEqual(shown_in_csv(self.service.post(f"/v1/{operation}?format=csv", body).body.decode()), shown(holds))

    def test_all_formats_agree_for_other_timings(self) -> None:
        chains = contract.example("motions")["chains"]
        for case in TIMINGS:
            with self.subTest(case):
                asked = timing(*case)
                body = {"chains": chains, "motion": {"timing": asked}}
                answer = self.service.post("/v1/motions", body).json()
                schedule = answer["schedule"]
                self.assertEqual(schedule, self.service.post("/v1/schedules", {"timing": asked}).json()["schedule"])
                self.assertEqual(sum(schedule["holds"]), schedule["frames"])
                self.assertEqual(schedule["starts"], [sum(schedule["holds"][:n]) for n in range(schedule["pictures"])])
                self.assertLessEqual(max(schedule["holds"]), case[2])
                self.assertGreaterEqual(min(schedule["holds"]), 1)
                seconds_per_frame = schedule["period"] / schedule["frames"]
                expected = shown(schedule["holds"])
                self.assertEqual(shown_in_clip(self.service.post("/v1/motions?format=glb", body).body, schedule["frames"], seconds_per_frame), expected)
                self.assertEqual(shown_in_xdts(self.service.post("/v1/motions?format=xdts", body).body.decode()), expected)
                self.assertEqual(shown_in_csv(self.service.post("/v1/motions?format=csv", body).body.decode()), expected)

    def test_clips_for_importers_without_steps_tell_the_same(self) -> None:
        chains = contract.example("motions")["chains"]
        for case in TIMINGS:
            body = {"chains": chains, "motion": {"timing": timing(*case)}}
            schedule = self.service.post("/v1/motions", body).json()["schedule"]
            for word, kind, count in (("step", "STEP", schedule["pictures"] + 1), ("held", "LINEAR", 2 * schedule["pictures"] + 1),
                                      ("per_frame", "STEP", schedule["frames"] + 1)):
                with self.subTest(case, interpolation=word):
                    gltf, buffer = glb_parts(self.service.post(f"/v1/motions?format=glb&interpolation={word}", body).body)
                    (clip,) = gltf["animations"]
                    self.assertEqual({sampler["interpolation"] for sampler in clip["samplers"]}, {kind})
                    times = floats(gltf, buffer, clip["samplers"][0]["input"])
                    self.assertEqual(len(times), count)
                    self.assertTrue(all(a < b for a, b in zip(times, times[1:])))
                    keys = floats(gltf, buffer, clip["samplers"][0]["output"])
                    self.assertEqual(keys[:4], keys[-4:])
                    if word == "held":
                        self.assertTrue(all(keys[8 * n:8 * n + 4] == keys[8 * n + 4:8 * n + 8] for n in range(schedule["pictures"])))
            default = self.service.post("/v1/motions?format=glb", body).body
            self.assertEqual(self.service.post("/v1/motions?format=glb&interpolation=step", body).body, default)

    def test_get_is_post(self) -> None:
        for case in TIMINGS:
            for word in ("json", "xdts", "csv"):
                with self.subTest(case, format=word):
                    asked = timing(*case)
                    query = urlencode({**asked, "repeat": 3, "sampling": "by_frame", "format": word})
                    got = self.service.get(f"/v1/schedules?{query}")
                    posted = self.service.post(f"/v1/schedules?format={word}", {"timing": {**asked, "sampling": "by_frame"}, "repeat": 3})
                    self.assert_ok(got, contract.MEDIA_TYPES[word])
                    self.assertEqual(got.body, posted.body)
                    self.assertEqual(got.headers.get("tuftwave-frame-rate"), posted.headers.get("tuftwave-frame-rate"))

    def test_a_repeated_sheet_repeats(self) -> None:
        body = {"timing": {"period": 0.45, "fps": 24, "hold": 2}, "repeat": 4}
        self.assertEqual(shown_in_xdts(self.service.post("/v1/schedules?format=xdts", body).body.decode()), shown([2, 2, 2, 2, 2, 1]) * 4)
        rows = self.service.post("/v1/schedules?format=csv", body).body.decode().split("\r\n")
        self.assertEqual(len(rows), 1 + 4 * 11 + 1)

    def test_sheets_of_motion_repeat_as_bare_ones_do(self) -> None:
        for operation in ("hairstyles", "motions"):
            body = contract.example(operation)
            for word in ("xdts", "csv"):
                with self.subTest(operation, format=word):
                    asked = {"timing": body["motion"]["timing"], "repeat": 4}
                    answer = self.service.post(f"/v1/{operation}?format={word}&repeat=4", body)
                    self.assertEqual(answer.body, self.service.post(f"/v1/schedules?format={word}", asked).body)

    def test_a_sheet_has_a_track_for_each_block(self) -> None:
        body = contract.example("motions")
        lock = body["chains"][0]
        given = ["bangs", "\u524d\u9aea", " bangs\t", None, "", "\u3000", "hair", "ponytail\n", "ponytail", "pony tail"]
        body["chains"] = [lock if block is None else {**lock, "block": block} for block in given]
        sheet = self.service.post("/v1/motions?format=xdts&repeat=2", body).body.decode()
        self.assertEqual(xdts_names(sheet), ["bangs", "\u524d\u9aea", "hair", "ponytail", "pony tail"])
        self.assertEqual(shown_in_xdts(sheet), shown([2, 2, 2, 2, 2, 1]) * 2)

    def test_a_hairstyles_blocks_are_the_drawn_tufts_and_each_fill(self) -> None:
        body = contract.example("hairstyles")
        body["fills"] = [{"from": "back_R1", "to": "back_L1"}, {"from": "ahoge", "density": {"along": 0}}, {"from": "side_R", "to": "side_L", "name": "\u9aea"},
                         {"from": "fringe_L2", "to": "fringe_R2", "name": "hair", "direction": "shorter"}]
        report = self.service.post("/v1/hairstyles?format=json", body).json()
        self.assertEqual([sum(fill["tufts"].values()) > 0 for fill in report["fills"]], [True, False, True, True])
        sheet = self.service.post("/v1/hairstyles?format=xdts", body).body.decode()
        self.assertEqual(xdts_names(sheet), ["hair", "fill1", "\u9aea"])
        self.assertEqual(shown_in_xdts(sheet), shown([2, 2, 2, 2, 2, 1]))

    def test_whoever_has_a_sheet_gets_it_only_once(self) -> None:
        path = "/v1/schedules?period=0.45&fps=24&hold=2"
        first = self.service.get(path)
        tag = first.headers["etag"]
        self.assertRegex(tag, r'^"[0-9a-f]+"$')
        self.assertIn("max-age=", first.headers["cache-control"])
        for given in (tag, f'"other", {tag}', f"W/{tag}", "*"):
            for method in ("GET", "HEAD"):
                with self.subTest(given, method=method):
                    again = self.service.request(method, path, headers={"If-None-Match": given})
                    self.assertEqual((again.status, again.body, again.headers.get("etag")), (304, b"", tag))
        for given in ('"other"', tag.strip('"'), ""):
            with self.subTest(given):
                self.assertEqual(self.service.get(path, If_None_Match=given).status, 200)
        self.assertNotEqual(self.service.get(path + "&format=csv").headers["etag"], tag)
        self.assertNotEqual(self.service.get("/v1/schedules?period=0.46&fps=24&hold=3").headers["etag"], tag)

    def test_the_frame_rate_is_told(self) -> None:
        for given, told in (("24", "24"), ("24000/1001", "24000/1001"), ("48/2", "24"), ("29.97", "2997/100")):
            with self.subTest(given):
                self.assertEqual(self.service.get(f"/v1/schedules?fps={given}").headers["tuftwave-frame-rate"], told)
