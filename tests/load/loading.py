"""What the goals under load share: the generator, a request, and a table of goals."""

from __future__ import annotations

import argparse
import json
import os
import resource
import subprocess
import sys
import time
from typing import Any, Callable, Optional

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "..", ".."))
sys.dont_write_bytecode = True
sys.path[:0] = [os.path.join(ROOT, "tests", "hostile"), os.path.join(ROOT, "tests", "contract")]

import contract  # noqa: E402
from running import MIB, Program  # noqa: E402

SERVER = os.path.join(ROOT, "build", "release", "server", "tuftwave-server")
GENERATOR = os.path.join(ROOT, "build", "release", "tests", "tuftwave_load")
QUIET = ("--log-level", "off")
Figures = dict[str, Any]


def arguments(text: str, **more: dict[str, Any]) -> argparse.Namespace:
    """--server, --generator and what else a goal needs."""
    parser = argparse.ArgumentParser(description=text)
    parser.add_argument("--server", default=os.environ.get("TUFTWAVE_SERVER", SERVER), help="the program")
    parser.add_argument("--generator", default=GENERATOR, help="tuftwave_load, which CMake builds")
    for name, options in more.items():
        parser.add_argument("--" + name, **options)
    chosen = parser.parse_args()
    for program in (chosen.server, chosen.generator):
        if not os.access(program, os.X_OK):
            parser.error(f"{program} is no program; build it first")
    most = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
    resource.setrlimit(resource.RLIMIT_NOFILE, (most, most))
    return chosen


class Goals:
    """Prints each goal with its figure; remembers whether one was missed."""

    def __init__(self) -> None:
        self.missed = 0

    def at_most(self, what: str, got: float, limit: float, unit: str = "") -> None:
        self._say(what, got <= limit, got, "at most", limit, unit)

    def at_least(self, what: str, got: float, limit: float, unit: str = "") -> None:
        self._say(what, got >= limit, got, "at least", limit, unit)

    def equal(self, what: str, got: float, wanted: float, unit: str = "") -> None:
        self._say(what, got == wanted, got, "exactly", wanted, unit)

    def _say(self, what: str, holds: bool, got: float, word: str, limit: float, unit: str) -> None:
        self.missed += not holds
        print(f"{'reached' if holds else 'MISSED '}  {what}: {got:,.4g} {unit} ({word} {limit:,.4g})".replace("  (", " ("), flush=True)

    @property
    def exit_code(self) -> int:
        return 1 if self.missed else 0


def hairstyle(copies: int) -> bytes:
    """The example with its tufts so many times: each copy is some 3 ms of work on one core and 0.4 MB of answer."""
    body = contract.example("hairstyles")
    body["tufts"] = [{**tuft, "name": f"{tuft['name']}_{i}"} for i in range(copies) for tuft in body["tufts"]]
    return json.dumps(body).encode()


def command(generator: str, server: Program, path: str, body: Optional[str], rate: float, seconds: float, connections: int) -> list[str]:
    return [generator, str(server.port), path, body or "-", str(rate), str(seconds), str(connections)]


def load(*what: Any) -> Figures:
    """Runs the generator to its end. Takes what command() takes."""
    return finished(subprocess.Popen(command(*what), stdout=subprocess.PIPE))


def finished(process: "subprocess.Popen[bytes]") -> Figures:
    said, _ = process.communicate()
    if process.returncode != 0:
        raise RuntimeError(f"the generator ended with {process.returncode}")
    figures: Figures = json.loads(said)
    return figures


def count(figures: Figures, status: int) -> int:
    return int(figures["answers"].get(str(status), {}).get("count", 0))


def quantile(figures: Figures, status: int, name: str = "p99") -> float:
    """Milliseconds; infinite where there was no such answer."""
    return float(figures["answers"].get(str(status), {}).get(name, float("inf")))


def others(figures: Figures, *statuses: int) -> dict[str, int]:
    """How many answers had another status."""
    return {status: row["count"] for status, row in figures["answers"].items() if int(status) not in statuses}


def sampled(process: "subprocess.Popen[bytes]", look: Callable[[], float], every_s: float) -> list[tuple[float, float]]:
    """Looks again and again until a process ends. @return  seconds and what was seen"""
    begin, seen = time.monotonic(), []
    while process.poll() is None:
        seen.append((time.monotonic() - begin, look()))
        try:
            process.wait(every_s)
        except subprocess.TimeoutExpired:
            pass
    return seen


__all__ = ["MIB", "QUIET", "Figures", "Goals", "Program", "arguments", "command", "contract", "count", "finished", "hairstyle", "load", "others", "quantile", "sampled"]
