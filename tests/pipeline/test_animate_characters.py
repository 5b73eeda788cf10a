"""Tests of the script that animates characters, against a stub on this machine and, where TUFTWAVE_SERVER names it, the server.

    TUFTWAVE_SERVER=build/release/server/tuftwave-server python3 -m unittest discover -s tests/pipeline
"""

from __future__ import annotations

import contextlib
import io
import json
import os
import re
import signal
import socket
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from typing import Optional
from unittest import mock
from urllib.parse import parse_qs, urlsplit

ROOT = Path(__file__).resolve().parents[2]
PIPELINE = ROOT / "client-examples" / "pipeline"
CHARACTERS = ROOT / "tests" / "data" / "characters"
SERVER = os.environ.get("TUFTWAVE_SERVER")
sys.path[:0] = [str(PIPELINE), str(ROOT / "tests" / "contract"), str(Path(__file__).parent)]

import animate_characters as animate  # noqa: E402
from service import Service  # noqa: E402
from test_tuftwave_client import Reply, Stub, problem  # noqa: E402


def glb(children: dict[int, list[int]], moved: list[int], clip: str = "wave") -> bytes:
    """A GLB without buffers: nodes by their children, and a clip that moves some of them."""
    nodes = [{"children": children[i]} if i in children else {} for i in range(10)]
    channels = [{"sampler": 0, "target": {"node": node, "path": "rotation"}} for node in moved]
    text = json.dumps({"asset": {"version": "2.0"}, "nodes": nodes, "animations": [{"name": clip, "channels": channels}]}).encode()
    text += b" " * (-len(text) % 4)
    return b"glTF" + (2).to_bytes(4, "little") + (20 + len(text)).to_bytes(4, "little") + len(text).to_bytes(4, "little") + b"JSON" + text


MOVING = glb({0: [1]}, [0, 1])


class CharacterStub(Stub):
    def answer(self, accept: str) -> Reply:
        content = MOVING if accept == "model/gltf-binary" else accept.encode()
        return 200, {"Content-Type": accept, "Tuftwave-Frame-Rate": "24"}, content


class FakeTime:
    """Where `--watch` waits: each wait is one look, and a step of the story may happen before it."""

    def __init__(self, *steps: object) -> None:
        self.steps, self.now_s = list(steps), 0.0

    def wait(self, seconds: float) -> bool:
        self.now_s += seconds
        if not self.steps:
            return True
        step = self.steps.pop(0)
        if callable(step):
            step()
        return False

    def is_set(self) -> bool:
        return False


class AnimateTest(unittest.TestCase):
    def setUp(self) -> None:
        self.stub = CharacterStub()
        self.stub.serve_during(self)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.inbox = self.folder / "in"
        self.inbox.mkdir()
        self.out = self.folder / "out"

    def put(self, name: str, content: str = "x") -> str:
        path = self.inbox / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content)
        return str(path)

    def animate(self, *arguments: str, server: str = "", stop: Optional[FakeTime] = None) -> tuple[int, str, str]:
        out, err = io.StringIO(), io.StringIO()
        inputs = [] if any(a for a in arguments if not a.startswith("-") and os.path.exists(a)) else [str(self.inbox)]
        clock = stop or FakeTime()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err), mock.patch.object(animate.time, "monotonic", lambda: clock.now_s):
            code = animate.main([*inputs, "--out", str(self.out), "--server", server or self.stub.url, *arguments], clock)
        return code, out.getvalue(), err.getvalue()

    def outputs(self) -> list[str]:
        return sorted(str(p.relative_to(self.out)) for p in self.out.rglob("*") if p.is_file()) if self.out.exists() else []


class Batch(AnimateTest):
    def test_every_character_of_a_folder_becomes_a_glb_with_one_line_each(self) -> None:
        for name in ("b.VRM", "a.glb", "c.txt", ".hidden.glb", "old.hair.glb"):
            self.put(name, name)
        code, out, err = self.animate()
        self.assertEqual((code, err), (0, ""))
        self.assertEqual(self.outputs(), ["a.hair.glb", "b.hair.glb"])
        self.assertEqual([(path, body) for path, _, body in self.stub.seen], [("/v1/characters/motion", b"a.glb"), ("/v1/characters/motion", b"b.VRM")])
        self.assertEqual((self.out / "a.hair.glb").read_bytes(), MOVING)
        lines = out.splitlines()
        self.assertRegex(lines[0], r"^1 of 2  .*a\.glb -> .*a\.hair\.glb: 1 chain, 24 frames per second, 0\.00 MB, \d")
        self.assertRegex(lines[1], r"^2 of 2  ")
        self.assertRegex(lines[2], r"^2 files: 2 done, 0 failed")
        self.assertNotRegex(out, "[\r\x1b]")  # not a terminal

    def test_a_terminal_sees_what_is_going_on_and_keeps_a_line_per_file(self) -> None:
        self.put("a.glb")
        terminal = io.StringIO()
        terminal.isatty = lambda: True  # type: ignore[method-assign]
        with contextlib.redirect_stdout(terminal):
            self.assertEqual(animate.main([str(self.inbox), "--out", str(self.out), "--server", self.stub.url]), 0)
        first, second, _ = terminal.getvalue().split("\n")[:3]
        self.assertRegex(first, "^\r\x1b\\[K1 of 1  .*a.glb \\.\\.\\.\r\x1b\\[K1 of 1  .* -> ")
        self.assertRegex(second, "^\r\x1b\\[K1 file: 1 done")

    def test_settings_become_the_query_and_nothing_else_is_sent(self) -> None:
        path = self.put("a.glb")
        everything = {name: f"{name} ä&=,*" for name, _ in animate.SETTINGS if name != "clip_name"}
        self.assertEqual(self.animate(path, *(f"--{name.replace('_', '-')}={value}" for name, value in everything.items()))[0], 0)
        del everything["repeat"]  # a GLB has one cycle
        self.assertEqual(self.animate(path, "--wind=-1,0,0.5")[0], 0)
        asked = [parse_qs(urlsplit(path).query, strict_parsing=True) for path, _, _ in self.stub.seen]
        self.assertEqual(asked, [{name: [value] for name, value in everything.items()}, {"wind": ["-1,0,0.5"]}])

    def test_the_settings_are_those_of_the_contract(self) -> None:
        contract = (ROOT / "api" / "openapi.yaml").read_text(encoding="utf-8")
        operation = contract[contract.index("operationId: characterMotion"):contract.index("operationId: getSchedule")]
        names = set(re.findall(r"- \{ name: (\w+), in: query", operation)) - {"format"}
        shared = {"repeat", "interpolation"}
        self.assertTrue(all(f"name: {name}\n" in contract for name in shared))
        self.assertEqual({name for name, _ in animate.SETTINGS}, names | shared)

    def test_side_files_have_the_same_name(self) -> None:
        self.put("a.vrm")
        self.assertEqual(self.animate("--sheet", "--csv", "--poses", "--vmd", "--bvh", "--usda")[0], 0)
        self.assertEqual(self.outputs(), ["a.hair." + e for e in ("bvh", "csv", "glb", "json", "usda", "vmd", "xdts")])
        self.assertEqual((self.out / "a.hair.xdts").read_text(), "application/x-xdts+json")

    def test_settings_go_where_they_are_taken(self) -> None:
        self.put("a.glb")
        self.assertEqual(self.animate("--sheet", "--poses", "--interpolation", "held", "--repeat", "3")[0], 0)
        asked = [(urlsplit(path).query, accept) for path, accept, _ in self.stub.seen]
        self.assertEqual(asked, [("interpolation=held", "model/gltf-binary"), ("repeat=3", "application/x-xdts+json"), ("", "application/json")])

    def test_folders_in_the_folder_are_taken_on_request_and_keep_their_place(self) -> None:
        for name in ("a.glb", "b/a.glb", "b/c/a.vrm", ".git/a.glb"):
            self.put(name)
        self.assertEqual(self.animate()[0], 0)
        self.assertEqual(self.outputs(), ["a.hair.glb"])
        self.assertEqual(self.animate("--recursive")[0], 0)
        self.assertEqual(self.outputs(), ["a.hair.glb", "b/a.hair.glb", "b/c/a.hair.glb"])

    def test_an_answer_that_is_there_already_is_left_alone(self) -> None:
        self.put("a.glb")
        self.assertNotIn("unchanged", self.animate()[1])
        os.utime(self.out / "a.hair.glb", ns=(1, 1))
        self.assertIn("unchanged", self.animate()[1])
        self.assertEqual((self.out / "a.hair.glb").stat().st_mtime_ns, 1)
        (self.out / "a.hair.glb").write_bytes(MOVING + b"more")
        self.assertNotIn("unchanged", self.animate()[1])
        self.assertEqual((self.out / "a.hair.glb").read_bytes(), MOVING)

    def test_two_characters_of_one_name_do_not_overwrite_each_other(self) -> None:
        for name in ("a.glb", "a.vrm"):
            self.put(name)
        code, _, err = self.animate()
        self.assertEqual((code, len(self.stub.seen), self.outputs()), (1, 1, ["a.hair.glb"]))
        self.assertRegex(err, r"a\.vrm: .*a\.hair\.glb is already made of .*a\.glb")

    def test_an_input_is_never_written_over(self) -> None:
        paths = [self.put("a.glb", "one"), self.put("a.hair.glb", "two")]
        self.out = self.inbox
        code, _, err = self.animate(*paths)
        self.assertEqual((code, Path(paths[1]).read_text()), (1, "two"))
        self.assertIn("is an input itself", err)

    def test_one_bad_file_stops_nobody_else(self) -> None:
        paths = [self.put("a.glb"), str(self.inbox / "missing.vrm"), self.put("c.glb")]
        self.stub.replies = [problem(422)]
        code, out, err = self.animate(*paths)
        self.assertEqual((code, self.outputs()), (1, ["c.hair.glb"]))
        self.assertRegex(err, r"1 of 3  .*a\.glb: 422 Out of range")
        self.assertIn("/motion/timing/period: period is too long (given 99, allowed 0.01 to 60)", err)
        self.assertRegex(err, r"2 of 3  .*missing\.vrm: ")
        self.assertIn("3 files: 1 done, 2 failed", out)

    def test_an_answer_without_the_clip_is_not_written(self) -> None:
        self.put("a.glb")
        for content in (b"", b"glTF", b"{}", glb({}, [0], clip="other"), MOVING[:40]):
            with self.subTest(content):
                self.stub.replies = [(200, {"Content-Type": "model/gltf-binary"}, content)]
                code, _, err = self.animate()
                self.assertEqual((code, self.outputs()), (1, []))
                self.assertIn("no GLB that has a clip 'wave'", err)

    def test_no_characters_is_said(self) -> None:
        code, _, err = self.animate()
        self.assertEqual(code, 1)
        self.assertIn("there is no .glb or .vrm file in", err)

    def test_names_that_no_terminal_can_show_are_shown_escaped(self) -> None:
        self.assertEqual(animate.shown("a\nb\udc80髪"), "a\\nb\\udc80髪")

    def test_wrong_options_are_refused_before_anything_is_sent(self) -> None:
        path = self.put("a.glb")
        for wrong in (["--watch", path], ["--server", "ftp://x"], ["--every", "0"], ["--retries", "-1"], ["--nonsense"]):
            with self.subTest(wrong), contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit) as stop:
                animate.main([str(self.inbox), "--out", str(self.out), *wrong])
            self.assertEqual((stop.exception.code, self.stub.seen), (2, []))


class Patience(AnimateTest):
    def test_a_busy_service_is_asked_again(self) -> None:
        self.put("a.glb")
        self.stub.replies = [problem(503, Retry_After="0")] * 2
        code, _, err = self.animate()
        self.assertEqual((code, len(self.stub.seen), self.outputs()), (0, 3, ["a.hair.glb"]))
        self.assertIn("busy (503), asking again in 0 s", err)

    def test_a_service_that_stays_busy_fails_the_file_and_the_next_one_is_tried(self) -> None:
        self.put("a.glb")
        self.put("b.glb")
        self.stub.replies = [problem(503, Retry_After="0")] * 3
        code, _, err = self.animate("--retries", "2")
        self.assertEqual((code, self.outputs()), (1, ["b.hair.glb"]))
        self.assertIn("a.glb: 503 Out of range", err)

    def test_an_absent_service_is_tried_a_few_times_and_the_rest_is_counted(self) -> None:
        self.put("a.glb")
        self.put("b.glb")
        with socket.socket() as taken:  # bound, not listening: connections are refused
            taken.bind(("127.0.0.1", 0))
            code, _, err = self.animate("--reconnects", "2", server=f"http://127.0.0.1:{taken.getsockname()[1]}")
        self.assertEqual((code, err.count("Trying again")), (2, 2))
        self.assertIn("2 of 2 files were not animated", err)

    def test_a_service_that_comes_back_is_used(self) -> None:
        self.put("a.glb")
        code, _, err = self.flaky_run()
        self.assertEqual((code, self.outputs()), (0, ["a.hair.glb"]))
        self.assertIn("reset by peer. Trying again in 0.5 s", err)

    def flaky_run(self) -> tuple[int, str, str]:
        """A run whose first connection is closed without an answer."""
        original, calls = animate.post.__globals__["open_request"], []

        def dropping(*arguments: object) -> object:
            calls.append(1)
            if len(calls) == 1:
                raise ConnectionResetError(104, "Connection reset by peer")
            return original(*arguments)

        with mock.patch.dict(animate.post.__globals__, {"open_request": dropping}):
            return self.animate()

    def test_a_slow_service_times_out_and_is_not_asked_twice(self) -> None:
        self.put("a.glb")
        with socket.socket() as silent:
            silent.bind(("127.0.0.1", 0))
            silent.listen()
            code, _, err = self.animate("--timeout", "0.05", server=f"http://127.0.0.1:{silent.getsockname()[1]}")
        self.assertEqual((code, err.count("timed out")), (2, 1))


class Watching(AnimateTest):
    def watch(self, *steps: object, arguments: tuple[str, ...] = ()) -> tuple[int, str, str]:
        return self.animate("--watch", *arguments, stop=FakeTime(*steps))

    def test_a_file_is_taken_once_it_has_stopped_growing(self) -> None:
        grow = [lambda n=n: self.put("a.glb", "x" * n) for n in (1, 2, 3)]
        code, out, err = self.watch(*grow, None, None, None, None)
        self.assertEqual((code, err), (0, ""))
        self.assertEqual([body for _, _, body in self.stub.seen], [b"xxx"])
        self.assertIn("stopped: 1 done, 0 failed", out)

    def test_settling_is_counted_in_seconds(self) -> None:
        self.put("a.glb")
        self.watch(None, None, None, arguments=("--settle", "2.5"))
        self.assertEqual(len(self.stub.seen), 0)
        self.watch(None, None, None, None, arguments=("--settle", "2.5"))
        self.assertEqual(len(self.stub.seen), 1)

    def test_a_file_that_changes_is_animated_again(self) -> None:
        self.put("a.glb", "one")
        self.watch(None, None, None, lambda: self.put("a.glb", "three"), None, None)
        self.assertEqual([body for _, _, body in self.stub.seen], [b"one", b"three"])

    def test_a_file_that_goes_and_comes_back_is_animated_again(self) -> None:
        self.put("a.glb", "one")
        self.watch(None, None, lambda: os.unlink(self.inbox / "a.glb"), lambda: self.put("a.glb", "one"), None, None)
        self.assertEqual(len(self.stub.seen), 2)

    def test_a_bad_file_is_reported_once_and_does_not_stop_the_watch(self) -> None:
        self.put("a.glb")
        self.put("b.glb")
        self.stub.replies = [problem(422)]
        code, _, err = self.watch(None, None, None, None)
        self.assertEqual((code, self.outputs(), err.count("a.glb")), (1, ["b.hair.glb"], 1))

    def test_what_the_service_has_no_time_for_waits(self) -> None:
        self.put("a.glb")
        self.stub.replies = [problem(503, Retry_After="0")] * 2
        code, _, err = self.watch(None, None, None, None, arguments=("--retries", "0"))
        self.assertEqual((code, self.outputs()), (0, ["a.hair.glb"]))
        self.assertEqual(err.count("waits: 503"), 1)  # said once, not at every look

    def test_results_in_the_watched_folder_are_not_taken_for_characters(self) -> None:
        self.out = self.inbox
        self.put("a.glb")
        self.watch(*[None] * 6)
        self.assertEqual(len(self.stub.seen), 1)

    def test_a_folder_that_goes_away_is_waited_for(self) -> None:
        moved = self.folder / "elsewhere"
        self.put("a.glb")
        code, _, err = self.watch(lambda: self.inbox.rename(moved), None, lambda: moved.rename(self.inbox), None, None)
        self.assertEqual((code, err, len(self.stub.seen)), (0, "", 1))

    def test_ending_the_program_finishes_the_file_at_hand(self) -> None:
        self.put("a.glb")
        command = [sys.executable, "-B", str(PIPELINE / "animate_characters.py"), str(self.inbox), "--watch", "--every", "0.01", "--settle", "0",
                   "--out", str(self.out), "--server", self.stub.url]
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number), subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as running:
                while not running.stdout.readline().startswith("1 "):
                    self.assertIsNone(running.poll())
                running.send_signal(number)
                self.assertIn("stopped: 1 done, 0 failed", running.stdout.read())
                self.assertEqual(running.wait(), 0)


class ChainsMoved(unittest.TestCase):
    def test_chains_are_runs_that_do_not_branch(self) -> None:
        cases = {
            "none": ({}, [], 0),
            "one_bone": ({0: [1]}, [1], 1),
            "one_chain": ({0: [1], 1: [2]}, [0, 1, 2], 1),
            "two_chains_of_a_still_head": ({0: [1, 2], 1: [3], 2: [4]}, [1, 2, 3, 4], 2),
            "a_still_bone_between": ({0: [1], 1: [2]}, [0, 2], 1),
            "a_branching": ({0: [1], 1: [2, 3]}, [0, 1, 2, 3], 3),
        }
        for name, (children, moved, chains) in cases.items():
            with self.subTest(name):
                self.assertEqual(animate.chains_moved(glb(children, moved), "wave"), chains)


@unittest.skipUnless(SERVER, "TUFTWAVE_SERVER names no server")
class RealServer(unittest.TestCase):
    def test_the_command_of_the_readme_runs_and_counts_the_chains(self) -> None:
        text = (PIPELINE / "README.md").read_text(encoding="utf-8")
        command = next(line for line in text.splitlines() if "animate_characters.py tests/data" in line)
        self.assertIn(f"    {command}\n", (PIPELINE / "animate_characters.py").read_text(encoding="utf-8"))
        with Service(SERVER) as service, tempfile.TemporaryDirectory() as folder:
            for name in ("client-examples", "tests"):
                Path(folder, name).symlink_to(ROOT / name)
            done = subprocess.run(["sh", "-c", command], cwd=folder, env={**os.environ, "TUFTWAVE_URL": service.url}, capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            out = Path(folder, "moving")
            names = sorted(path.name for path in CHARACTERS.iterdir())
            self.assertEqual(sorted(path.name for path in out.glob("*.glb")), [os.path.splitext(name)[0] + ".hair.glb" for name in names])
            for name in names:
                poses = json.loads(service.post("/v1/characters/motion?format=json&kinds=hair,ribbon&spread=0.3", (CHARACTERS / name).read_bytes(),
                                                Content_Type="model/gltf-binary").body)
                moved = animate.chains_moved((out / (os.path.splitext(name)[0] + ".hair.glb")).read_bytes(), "wave")
                self.assertEqual(moved, len(poses["chains"]), name)
            self.assertEqual(len(list(out.glob("*.xdts"))), len(names))

    def test_the_service_takes_every_kind_of_answer_and_its_settings(self) -> None:
        with Service(SERVER) as service, tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
            arguments = [str(CHARACTERS / "pmca_sample3.glb"), "--out", folder, "--server", service.url, "--interpolation", "held", "--repeat", "3"]
            self.assertEqual(animate.main([*arguments, *(f"--{option}" for option, _, _, _ in animate.SIDE_FILES)]), 0)
            self.assertEqual(len(os.listdir(folder)), 1 + len(animate.SIDE_FILES))
            self.assertEqual(len(Path(folder, "pmca_sample3.hair.csv").read_text().split()), 1 + 3 * 11)

    def test_the_services_own_problems_name_the_setting(self) -> None:
        with Service(SERVER) as service, tempfile.TemporaryDirectory() as folder:
            err = io.StringIO()
            with contextlib.redirect_stderr(err), contextlib.redirect_stdout(io.StringIO()):
                code = animate.main([str(CHARACTERS / "pmca_sample3.glb"), "--out", folder, "--server", service.url, "--period", "99"])
            self.assertEqual((code, os.listdir(folder)), (1, []))
            self.assertIn("?period", err.getvalue())


if __name__ == "__main__":
    unittest.main()
