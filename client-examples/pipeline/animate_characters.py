"""Makes the hair of characters move: GLB and VRM files go to a Tuftwave service and come back with a clip.

    python3 client-examples/pipeline/animate_characters.py tests/data/characters --out moving --kinds hair,ribbon --spread 0.3 --sheet
    python3 client-examples/pipeline/animate_characters.py inbox --watch --out moving --wind 1,0,-0.5 --period 0.8

The first command is a batch; the second stays and takes every file that arrives in a folder, once it has stopped growing.
NAME.vrm and NAME.glb become NAME.hair.glb; --sheet, --csv, --poses, --vmd, --bvh and --usda add files of that name. The answer is never
called .vrm: programs that play a VRM run neither its clips nor anything over its spring bones. Play it as a GLB.

Files are written whole or not at all, an input is never written over, and an output that would not change is not touched:
the same file and settings give the same bytes. A busy service (503, 429) is asked again when it says, one that is away is
tried a few times; a watch goes on until interrupted.
Exit code: 0 all done; 1 some file failed, see the standard error stream; 2 wrong options, or there is no Tuftwave to talk to.
"""

from __future__ import annotations

import argparse
import json
import os
import signal
import sys
import threading
import time
import urllib.parse
from dataclasses import dataclass, field
from typing import Any, Iterator, Optional

from tuftwave_client import DEFAULT_SERVER, Answer, Busy, NoService, Patience, Refused, post, write_whole

INPUTS = (".glb", ".vrm")
OURS = ".hair.glb"  # in a folder, these are answers from before and not taken
SIDE_FILES = [  # option, ending, media type, help
    ("sheet", ".hair.xdts", "application/x-xdts+json", "also write the exposure sheet, .hair.xdts"),
    ("csv", ".hair.csv", "text/csv", "also write the exposure sheet, .hair.csv"),
    ("poses", ".hair.json", "application/json", "also write the poses, .hair.json"),
    ("vmd", ".hair.vmd", "application/octet-stream", "also write a MikuMikuDance motion, .hair.vmd"),
    ("bvh", ".hair.bvh", "application/x-bvh", "also write a BVH motion, .hair.bvh"),
    ("usda", ".hair.usda", "model/vnd.usda", "also write a USD skeleton, .hair.usda"),
]
SETTINGS = [  # query parameters of POST /v1/characters/motion; the service knows their defaults and checks them
    ("chains", "names or numbers of the chains to move, with * and ?, by commas"),
    ("kinds", "kinds of chains to move: hair, skirt, ribbon, unknown, by commas (hair)"),
    ("springs", "what becomes of the springs of moved chains: keep or remove (keep)"),
    ("clip_name", "of the new animation (wave)"),
    ("wind", "where the wind blows to, three numbers in the file's axes (1,0,0); with a minus first: --wind=-1,0,0"),
    ("up", "three numbers (0,1,0)"),
    ("period", "of the wave, seconds (0.45)"),
    ("fps", "frames per second, a number or a fraction (24)"),
    ("hold", "frames that a picture is held (2)"),
    ("short_holds", "where shorter holds go: last or spread (last)"),
    ("sampling", "when a picture samples the wave: uniform or by_frame (uniform)"),
    ("amplitude", "of the wave (0.8)"),
    ("spatial_period", "how long the wave is (1)"),
    ("lightness", "larger droops less (1.2)"),
    ("tip_exponent", "how much livelier the tip is than the root (1)"),
    ("mode", "relative to the rest pose, or absolute (relative)"),
    ("droop", "remove or keep the mean over the pictures"),
    ("one_sided", "true: swing away from the head only (false)"),
    ("lift", "from the rest direction, 0, to the wind, 1"),
    ("phase_step", "free, or whole pictures: picture (free)"),
    ("gust_wavelength", "metres along the wind between roots one cycle apart"),
    ("spread", "share of a cycle that chains are scattered over (0)"),
    ("seed", "for the scatter (0)"),
    ("cycles", "waves per loop (1)"),
    ("phases", "radians that each moved chain runs ahead, by commas"),
    ("formulas", "corrected or as_printed (corrected)"),
    ("interpolation", "of the clip: step, held or per_frame (step)"),
    ("repeat", "cycles in a sheet or a VMD (1)"),
]
ONLY_FOR = {  # settings that other answers refuse
    "interpolation": ("model/gltf-binary",),
    "repeat": ("application/x-xdts+json", "text/csv", "application/octet-stream"),
}

Signature = tuple[int, int, int]  # size, time of the last change, inode


@dataclass
class Job:
    source: str
    target: str  # NAME.hair.glb; side files lie beside it


@dataclass
class Report:
    """What a person sees of the work: a line per file, and on a terminal what is going on meanwhile."""
    done: int = 0
    failed: int = 0

    def now(self, text: str) -> None:
        if sys.stdout.isatty():
            print(f"\r\x1b[K{text}", end="", flush=True)

    def line(self, text: str) -> None:
        print(("\r\x1b[K" if sys.stdout.isatty() else "") + text, flush=True)

    def fault(self, text: str) -> None:
        self.now("")
        print(f"animate_characters: {text}", file=sys.stderr, flush=True)


def shown(path: str) -> str:
    """A file's name as one line of text that any terminal can take."""
    return "".join(c if c.isprintable() else ascii(c)[1:-1] for c in path)


def signature(path: str) -> Signature:
    state = os.stat(path)
    return state.st_size, state.st_mtime_ns, state.st_ino


def is_input(name: str) -> bool:
    lower = name.lower()
    return lower.endswith(INPUTS) and not lower.endswith(OURS) and not name.startswith(".")


def files_in(folder: str, recursive: bool) -> Iterator[str]:
    """The characters in a folder, in order of their names, relative to it. Raises OSError where it cannot be read."""
    entries = sorted(os.scandir(folder), key=lambda entry: entry.name)
    for entry in entries:
        if entry.is_file() and is_input(entry.name):
            yield entry.name
        elif recursive and entry.is_dir(follow_symlinks=False) and not entry.name.startswith("."):
            yield from (os.path.join(entry.name, name) for name in files_in(entry.path, recursive))


def jobs_of(inputs: list[str], out: str, recursive: bool) -> Iterator[Job]:
    """The files named and those in the folders named; what lies in folders of a folder keeps its folder."""
    for path in inputs:
        names = files_in(path, recursive) if os.path.isdir(path) else [""]
        for name in names:
            inner = name or os.path.basename(path)
            yield Job(os.path.join(path, name) if name else path, os.path.join(out, os.path.splitext(inner)[0] + OURS))


def chains_moved(glb: bytes, clip: str) -> int:
    """How many chains the clip of a GLB moves: runs of moved bones that do not branch. Raises ValueError where there is no clip."""
    try:
        gltf = json.loads(glb[20:20 + int.from_bytes(glb[12:16], "little")])
        animation = next(a for a in gltf["animations"] if a.get("name") == clip)
        moved = {channel["target"]["node"] for channel in animation["channels"]}
        parents = {child: parent for parent, node in enumerate(gltf["nodes"]) for child in node.get("children", [])}
    except (ValueError, LookupError, TypeError, AttributeError, StopIteration):
        raise ValueError(f"the service answered with no GLB that has a clip {clip!r}") from None

    def moved_above(node: Optional[int]) -> Optional[int]:
        node = parents.get(node)
        while node is not None and node not in moved:
            node = parents.get(node)
        return node

    above = [moved_above(node) for node in moved]
    return sum(node is None or above.count(node) > 1 for node in above)


@dataclass
class Animator:
    options: argparse.Namespace
    report: Report
    patience: Patience
    owners: dict[str, str] = field(default_factory=dict)  # outputs of this run, and the inputs that they came from

    def refuse_target(self, job: Job, inputs: set[str]) -> Optional[str]:
        """Why the output's place is taken; None where it is free."""
        target, source = os.path.realpath(job.target), os.path.realpath(job.source)
        if target in inputs or target == source:
            return f"{shown(job.target)} is an input itself and is not written over"
        owner = self.owners.setdefault(target, source)
        return None if owner == source else f"{shown(job.target)} is already made of {shown(owner)}"

    def take(self, job: Job, place: str, inputs: set[str]) -> None:
        """Animates a file unless its output's place is taken, which is reported. Raises what animate() does."""
        taken = self.refuse_target(job, inputs)
        if taken:
            self.fail(job, place, taken)
        else:
            self.animate(job, place)

    def ask(self, body: bytes, media_type: str) -> Answer:
        settings = {name: getattr(self.options, name) for name, _ in SETTINGS
                    if getattr(self.options, name) is not None and media_type in ONLY_FOR.get(name, (media_type,))}
        path = "/v1/characters/motion" + ("?" + urllib.parse.urlencode(settings) if settings else "")
        return post(self.options.server, path, body, media_type, self.patience, "model/gltf-binary")

    def animate(self, job: Job, place: str) -> None:
        """Asks for everything, then writes it. Raises OSError, ValueError, Refused or NoService."""
        begun = time.monotonic()
        self.report.now(f"{place}{shown(job.source)} ...")
        with open(job.source, "rb") as file:
            body = file.read()
        glb = self.ask(body, "model/gltf-binary")
        chains = chains_moved(glb.data, self.options.clip_name or "wave")
        outputs = [(job.target, glb)]
        stem = job.target[:-len(OURS)]
        for option, ending, media_type, _ in SIDE_FILES:
            if getattr(self.options, option):
                outputs.append((stem + ending, self.ask(body, media_type)))
        os.makedirs(os.path.dirname(os.path.abspath(job.target)), exist_ok=True)
        written = [write_changed(path, answer.data) for path, answer in outputs]
        facts = [f"{chains} chain{'s' * (chains != 1)}", f"{glb.frame_rate} frames per second", f"{len(glb.data) / 1e6:.2f} MB",
                 f"{time.monotonic() - begun:.2f} s", *([] if any(written) else ["unchanged"])]
        self.report.line(f"{place}{shown(job.source)} -> {shown(job.target)}: {', '.join(facts)}")
        self.report.done += 1

    def fail(self, job: Job, place: str, why: Any) -> None:
        self.report.failed += 1
        self.report.fault(f"{place}{shown(job.source)}: {why}")


def write_changed(path: str, data: bytes) -> bool:
    """Writes a file unless it holds these bytes already, so that whoever watches the output sees changes only."""
    try:
        with open(path, "rb") as file:
            if file.read(len(data) + 1) == data:
                return False
    except OSError:
        pass
    write_whole(path, data)
    return True


def batch(animator: Animator) -> int:
    options, report = animator.options, animator.report
    begun = time.monotonic()
    jobs = list(jobs_of(options.inputs, options.out, options.recursive))
    if not jobs:
        report.fault("there is no .glb or .vrm file in " + ", ".join(map(shown, options.inputs)))
        return 1
    inputs = {os.path.realpath(job.source) for job in jobs}
    for number, job in enumerate(jobs, 1):
        place = f"{number} of {len(jobs)}  "
        try:
            animator.take(job, place, inputs)
        except (Refused, OSError, ValueError) as error:
            animator.fail(job, place, error)
        except NoService as error:
            report.fault(f"{place}{shown(job.source)}: {error}")
            report.fault(f"{len(jobs) - number + 1} of {len(jobs)} files were not animated")
            return 2
    report.line(f"{len(jobs)} file{'s' * (len(jobs) != 1)}: {report.done} done, {report.failed} failed, {time.monotonic() - begun:.2f} s")
    return 1 if report.failed else 0


@dataclass
class Watch:
    """Which files of the folders are ready: those that have not changed for a while and were not taken as they are now."""
    settle_s: float
    seen: dict[str, tuple[Signature, float]] = field(default_factory=dict)  # by path: how it looked, and since when
    taken: dict[str, Signature] = field(default_factory=dict)

    def ready(self, jobs: list[Job], now_s: float) -> list[Job]:
        there: dict[str, tuple[Signature, float]] = {}
        settled = []
        for job in jobs:
            try:
                looks = signature(job.source)
            except OSError:  # gone again
                continue
            before, since_s = self.seen.get(job.source, (None, now_s))
            there[job.source] = (looks, since_s if looks == before else now_s)
            if looks != self.taken.get(job.source) and looks == before and now_s - since_s >= self.settle_s:
                settled.append(job)
        self.seen = there
        self.taken = {path: looks for path, looks in self.taken.items() if path in there}
        return settled

    def take(self, job: Job) -> None:
        """Marks a file as done with; if it has changed meanwhile, it does not look like this and is taken again."""
        self.taken[job.source] = self.seen[job.source][0]


def watched_jobs(animator: Animator) -> list[Job]:
    options = animator.options
    try:
        return list(jobs_of(options.inputs, options.out, options.recursive))
    except OSError as error:  # a share that went away may come back
        animator.report.now(f"waiting: {error}")
        return []


def watch(animator: Animator, stop: threading.Event) -> int:
    """Goes on until `stop`. What the service has no time for stays where it is and is tried again."""
    options, report, files = animator.options, animator.report, Watch(animator.options.settle)
    report.line(f"watching {', '.join(map(shown, options.inputs))} for .glb and .vrm files")
    told = ""
    while not stop.wait(options.every):
        jobs = watched_jobs(animator)
        inputs = {os.path.realpath(job.source) for job in jobs}
        for job in files.ready(jobs, time.monotonic()):
            if stop.is_set():
                break
            place = f"{report.done + report.failed + 1}  "
            try:
                animator.take(job, place, inputs)
                told = ""
            except (NoService, Busy) as error:
                if str(error) != told:
                    report.fault(f"{shown(job.source)} waits: {error}")
                told = str(error)
                break
            except (Refused, OSError, ValueError) as error:
                animator.fail(job, place, error)
            files.take(job)
    report.line(f"stopped: {report.done} done, {report.failed} failed")
    return 1 if report.failed else 0


def parse_arguments(arguments: Optional[list[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        description="Makes the hair of GLB and VRM characters move. NAME.vrm becomes NAME.hair.glb, never a .vrm: programs that "
                    "play a VRM run neither its clips nor anything over its spring bones.")
    parser.add_argument("inputs", nargs="+", help="files and folders; with --watch only folders")
    parser.add_argument("--out", required=True, metavar="FOLDER", help="where the results go; made if it is not there")
    parser.add_argument("--recursive", action="store_true", help="also take folders in the folders, and keep them in --out")
    for option, _, _, text in SIDE_FILES:
        parser.add_argument(f"--{option}", action="store_true", help=text)
    parser.add_argument("--watch", action="store_true", help="stay, and take each file that arrives or changes")
    parser.add_argument("--every", type=float, default=1.0, metavar="S", help="seconds between two looks at the folders (%(default)s)")
    parser.add_argument("--settle", type=float, default=1.0, metavar="S", help="seconds a file must not have changed for (%(default)s)")
    parser.add_argument("--server", default=os.environ.get("TUFTWAVE_URL") or DEFAULT_SERVER, help="address (%(default)s)")
    parser.add_argument("--retries", type=int, default=5, help="how often a busy service is asked again (%(default)s)")
    parser.add_argument("--reconnects", type=int, default=3, help="how often one that is away is tried again (%(default)s)")
    parser.add_argument("--timeout", type=float, default=60, help="seconds without a byte before giving up (%(default)s)")
    settings = parser.add_argument_group("settings", "as in the contract, POST /v1/characters/motion; the service checks them")
    for name, text in SETTINGS:
        settings.add_argument(f"--{name.replace('_', '-')}", dest=name, metavar="VALUE", help=text)
    options = parser.parse_intermixed_args(arguments)
    if not options.server.startswith(("http://", "https://")):
        parser.error(f"--server must begin with http:// or https://, not {options.server!r}")
    if min(options.retries, options.reconnects, options.settle) < 0 or not (options.timeout > 0 and options.every > 0):
        parser.error("--retries, --reconnects and --settle must be at least 0, --timeout and --every above 0")
    for path in options.inputs if options.watch else []:
        if not os.path.isdir(path):
            parser.error(f"--watch needs folders, and {path!r} is none")
    return options


def stop_on_signals() -> threading.Event:
    """An event that interrupting or ending the program sets: the file at hand is finished first."""
    stop = threading.Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: stop.set())
    return stop


def main(arguments: Optional[list[str]] = None, stop: Optional[threading.Event] = None) -> int:
    """@param stop  ends a watch and every wait"""
    options = parse_arguments(arguments)
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")
    report = Report()
    patience = Patience(options.retries, options.timeout, options.reconnects, say=report.fault)
    try:
        if options.watch:
            stop = stop or stop_on_signals()
        if stop:
            patience.wait = stop.wait
        if options.watch:
            return watch(Animator(options, report, patience), stop)
        return batch(Animator(options, report, patience))
    except OSError as error:
        report.fault(str(error))
        return 1
    except KeyboardInterrupt:
        report.fault("interrupted")
        return 1


if __name__ == "__main__":
    sys.exit(main())
