"""Fuzzes targets one after the other, or runs their inputs again.

    python3 tests/fuzz/run.py --program build/asan/tests/fuzz/tuftwave_fuzz --work build/asan/tests/fuzz/work --seconds 60 tufts
    python3 tests/fuzz/run.py --replay build/release/tests/fuzz/tuftwave_replay --work build/release/tests/fuzz/work tufts glb

First come the inputs in tests/fuzz/regressions/<target>/, each of which once found something. What is found lands in
<work>/<target>/found/; once it is mended, it goes there under a name that says what it was. Exit code 0 if nothing is
found, else 1.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import subprocess
import sys
from typing import Optional

sys.dont_write_bytecode = True

import seeds  # noqa: E402

REGRESSIONS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "regressions")
LIMITS = ["-timeout=10", "-rss_limit_mb=2048"]
STARTS_S = 60  # what may go by before and after the time that is given
MINIMIZES_S = 30  # for each input that was found
MOST_BYTES = {"request": 20_000, "json": 4_096, "query": 2_048, "poses": 512, "sheets": 512, "glb": 60_000, "characters_chains": 60_000,
              "characters_motion": 60_000}



def files_in(folder: str) -> list[str]:
    return sorted(os.path.join(folder, name) for name in os.listdir(folder)) if os.path.isdir(folder) else []


def replay(command: list[str], target: str, inputs: list[str]) -> bool:
    """Whether all inputs pass."""
    if not inputs:
        return True
    done = subprocess.run([*command, *inputs], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0:
        print(done.stdout.decode(errors="replace")[-6_000:])
    print(f"{target}: {len(inputs)} known inputs {'pass' if done.returncode == 0 else 'FAIL'}", flush=True)
    return done.returncode == 0


def merge(program: str, target: str, folder: str) -> None:
    """Leaves of the corpus the fewest inputs that reach the same code."""
    corpus, least = os.path.join(folder, "corpus"), os.path.join(folder, "least")
    os.makedirs(least, exist_ok=True)
    subprocess.run([program, f"--target={target}", "-merge=1", *LIMITS, least, corpus], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
    for name in files_in(corpus):
        os.remove(name)
    for name in files_in(least):
        os.replace(name, os.path.join(corpus, os.path.basename(name)))
    os.rmdir(least)


def minimize(program: str, target: str, folder: str) -> None:
    for name in files_in(os.path.join(folder, "found")):
        if os.path.basename(name).startswith(("crash-", "leak-")) and not name.endswith(".small"):
            with contextlib.suppress(subprocess.TimeoutExpired):  # it starts itself again and again, for that long each time
                subprocess.run([program, f"--target={target}", "-minimize_crash=1", f"-max_total_time={MINIMIZES_S}", *LIMITS,
                                f"-exact_artifact_path={name}.small", name],
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=MINIMIZES_S, check=False)


def fuzz(program: str, target: str, work: str, seconds: int, is_long: bool) -> bool:
    """Whether nothing was found."""
    folder, dictionary = seeds.write(target, work)
    place = os.path.join(work, target)
    corpus, found = os.path.join(place, "corpus"), os.path.join(place, "found")
    for needed in (corpus, found):
        os.makedirs(needed, exist_ok=True)
    command = [program, f"--target={target}", *LIMITS]
    if not replay(command, target, files_in(os.path.join(REGRESSIONS, target))):
        return False
    done = subprocess.run([*command, f"-max_total_time={seconds}", f"-max_len={MOST_BYTES.get(target, 6_000)}", f"-artifact_prefix={found}/",
                           *([f"-dict={dictionary}"] if os.path.getsize(dictionary) else []), "-print_final_stats=1", "-reload=0", corpus, folder], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=seconds + STARTS_S, check=False)
    text = done.stdout.decode(errors="replace")
    print("\n".join(line for line in text.splitlines() if "INITED" in line or "DONE" in line or line.startswith("stat::")))
    if done.returncode != 0:
        print(text[-8_000:])
        minimize(program, target, place)
        print(f"{target}: FOUND something; see {found}")
    elif is_long:
        merge(program, target, place)
    print(f"{target}: ended with {done.returncode}", flush=True)
    return done.returncode == 0


def main(arguments: Optional[list[str]] = None) -> int:
    parser = argparse.ArgumentParser(description="Fuzzes what strangers' bytes go into.")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--program", help="tuftwave_fuzz: fuzz")
    what.add_argument("--replay", help="tuftwave_replay: only run seeds and regressions again")
    parser.add_argument("--work", required=True, help="a folder for seeds, corpora and findings")
    parser.add_argument("--seconds", type=int, default=60, help="for each target")
    parser.add_argument("--long", action="store_true", help="make the corpus small again at the end")
    parser.add_argument("targets", nargs="+")
    options = parser.parse_args(arguments)
    passed = []
    for target in options.targets:
        if options.replay:
            folder, _ = seeds.write(target, options.work)
            passed.append(replay([options.replay, target], target, files_in(os.path.join(REGRESSIONS, target)) + files_in(folder)))
        else:
            passed.append(fuzz(options.program, target, options.work, options.seconds, options.long))
    return 0 if all(passed) else 1


if __name__ == "__main__":
    sys.exit(main())
