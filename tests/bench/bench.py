"""Measures everybody in turns, so that a machine that drifts is slow for all, and says which goals hold.

    python3 tests/bench/bench.py --build build/bench [--quick] [--release VERSION]

A round runs every program once (parties.py); what they print is read by figures.py, and compared by goals.py. A ratio is taken
within a round; the table has the median over the rounds, the least and the most. No goal that is missed fails the run.
"""

from __future__ import annotations

import argparse
import os
import signal
import statistics
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True

import releases
import workloads
from figures import Figures, Missing, Values
from goals import GOALS, Goal
from parties import HERE, Party, parties

ROUNDS, SLOW_ROUNDS = 5, 2  # the slow ones are left out of the later rounds
QUICK_ROUNDS, QUICK_SLOW_ROUNDS = 3, 1
QUIET = 0.5  # of the load, above which somebody else must be at work
# What compares whole requests: a program, and the arguments besides --rounds and --seconds.
HTTP = ((os.path.join(HERE, "http", "compare.py"), ()), (os.path.join(HERE, "whole_requests.py"), ("--server", "--generator")))


def say(text: str) -> None:
    print(text, file=sys.stderr, flush=True)


def play_rounds(present: list[Party], rounds: int, slow_rounds: int, figures: Figures) -> None:
    for number in range(rounds):
        begin = time.monotonic()
        for party in present:
            if party.is_slow and number >= slow_rounds:
                continue
            figures.add(party.run() or "", number)
        say(f"script/bench: round {number + 1} of {rounds} took {time.monotonic() - begin:.0f} s")


def whole_requests(build: str, rounds: int, figures: Figures) -> None:
    programs = {"--server": os.path.join(build, "server", "tuftwave-server"), "--generator": os.path.join(build, "tests", "tuftwave_load")}
    for script, wanted in HTTP:
        begin = time.monotonic()
        arguments = [word for name in wanted for word in (name, programs[name])]
        done = subprocess.run([sys.executable, script, *arguments, "--rounds", str(rounds), "--seconds", "1"], stdout=subprocess.PIPE, text=True, check=False)
        if done.returncode != 0:
            say(f"script/bench: {os.path.relpath(script, HERE)} ended with {done.returncode}")
        figures.add_rounds(done.stdout)
        say(f"script/bench: {os.path.relpath(script, HERE)} took {time.monotonic() - begin:.0f} s")


def why_missing(name: str, everybody: list[Party], present: list[Party]) -> str:
    """@param name  of a figure that nobody has measured"""
    party = next((party for party in everybody if name.rpartition("/")[2] in party.names), None)
    if party is None or party in present:
        return f"nothing prints {name}"
    return party.without if not party.is_there else "left out"


def number(figure: float) -> str:
    return f"{figure:,.3g}" if abs(figure) < 1000 else f"{figure:,.0f}"


def row(goal: Goal, values: Values, missing: str) -> str:
    must, aim = (goal.bounds.text(goal.bounds.must), goal.bounds.text(goal.bounds.aim)) if goal.bounds else ("", "")
    if not values:
        return f"| {goal.what} | {must} | {aim} | | not measured ({missing}) |"
    median = statistics.median(values)
    said = "" if not goal.bounds else "holds" if goal.bounds.holds(median) else "missed"
    return f"| {goal.what} | {must} | {aim} | {number(median)} ({number(min(values))} to {number(max(values))}) | {said} |"


def print_table(figures: Figures, everybody: list[Party], present: list[Party]) -> dict[str, Values]:
    """@return  what each goal's figures are, nothing where it was not measured"""
    measured: dict[str, Values] = {}
    print("\n| goal | must | aim | median (least to most) | |\n|---|---|---|---|---|")
    for goal in GOALS:
        missing = ""
        try:
            measured[goal.key] = goal.measure(figures)
        except Missing as error:
            measured[goal.key], missing = [], why_missing(str(error), everybody, present)
        print(row(goal, measured[goal.key], missing))
    return measured


def print_figures(figures: Figures) -> None:
    print("\nMedians over the rounds:\n")
    for name, median, unit in figures.medians():
        print(f"- {name}: {median:,.4g} {unit}".rstrip())


def load() -> float:
    """Programs that want to run, on average over the last minute."""
    return os.getloadavg()[0]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, help="where CMake has built")
    parser.add_argument("--quick", action="store_true", help="fewer rounds, without Blender and Bullet")
    parser.add_argument("--release", metavar="VERSION", help="appends the medians to tests/bench/results/ratios.csv")
    options = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # by which programs are stopped and files removed

    rounds, slow_rounds = (QUICK_ROUNDS, QUICK_SLOW_ROUNDS) if options.quick else (ROUNDS, SLOW_ROUNDS)
    figures, before = Figures(), load()
    if before > QUIET:
        say(f"script/bench: others are at work here (load {before:.1f}); ratios will be off by as much")
    with tempfile.TemporaryDirectory() as work:
        workloads.write(work)
        everybody = parties(os.path.abspath(options.build), work)
        present = [party for party in everybody if party.is_there and (party.is_quick or not options.quick)]
        play_rounds(present, rounds, slow_rounds, figures)
    whole_requests(os.path.abspath(options.build), rounds, figures)
    print_figures(figures)
    measured = print_table(figures, everybody, present)
    print(f"\n{releases.machine()}, {os.cpu_count()} cores, load {before:.1f} before and {load():.1f} after {rounds} rounds")
    if options.release:
        releases.append(options.release, measured)


if __name__ == "__main__":
    main()
