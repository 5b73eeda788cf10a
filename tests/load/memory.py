"""Memory for the worst request of at most 8 MiB, legal and illegal, of each operation: at most 128 MiB above idle.

Every request meets a server of its own that has answered an example. Its peak is the most that was resident from then on, which
Linux counts anew when asked to (proc(5), clear_refs). Exit code 1 where a row needs more or has a status that it must not have.
"""

from __future__ import annotations

import argparse
import os
import re
import sys
import time
from typing import Iterator, Optional

from loading import MIB, SERVER, Program, contract

from cell import Cell, cell
from memory_bodies import Row, rows

MOST_MIB = 128.0
PATIENCE = ("--deadline", "300")  # what is measured is no time


def forget_peak(server: Program) -> None:
    with open(f"/proc/{server.pid}/clear_refs", "w", encoding="ascii") as file:
        file.write("5")


def measured(program: str, row: Row, body: bytes, inside: Optional[Cell]) -> tuple[int, float, float, float]:
    """Status (0 for none), seconds, MiB above idle at most, MiB above idle afterwards."""
    with Program(program, *PATIENCE) as server:
        if inside:
            inside.hold(server.pid)
        for operation in contract.posts()[:1]:
            server.example(operation)
        forget_peak(server)
        idle, begin = server.resident(), time.monotonic()
        try:
            status = server.request("POST", row.path, body, {"Content-Type": row.media_type}).status
        except OSError:
            status = 0
        if not server.is_running:
            return 0, time.monotonic() - begin, float("inf"), float("inf")
        return status, time.monotonic() - begin, (server.peak() - idle) / MIB, (server.resident() - idle) / MIB


def chosen(all_rows: Iterator[Row], pattern: str) -> list[Row]:
    return [row for row in all_rows if re.search(pattern, f"{row.path} {row.what}")]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--server", default=os.environ.get("TUFTWAVE_SERVER", SERVER), help="the program")
    parser.add_argument("--limit-mib", type=int, help="put the servers into a cgroup of so much memory, e.g. 512")
    parser.add_argument("--only", default="", metavar="PATTERN", help="rows whose operation and words match this regular expression")
    options = parser.parse_args()
    with Program(options.server) as server:
        wanted = chosen(rows(server.get("/v1/limits").json()), options.only)
    inside = cell(options.limit_mib)
    missed, worst = 0, 0.0
    print("status seconds   peak  after  MiB above idle", flush=True)
    for row in wanted:
        body = row.make()
        status, seconds, peak, after = measured(options.server, row, body, inside)
        is_right = status in row.statuses and peak <= MOST_MIB and (options.limit_mib is None or peak <= options.limit_mib)
        missed, worst = missed + (not is_right), max(worst, peak)
        print(f"{status:6} {seconds:7.2f} {peak:6.1f} {after:6.1f}  {'' if is_right else 'MISSED '}{row.path}: {row.what} ({len(body) / MIB:.1f} MiB)", flush=True)
    print(f"{len(wanted)} rows, {missed} missed, at most {worst:.1f} MiB above idle (at most {MOST_MIB:.0f})")
    if inside:
        print(f"the cgroup of {options.limit_mib} MiB held {inside.peak() / MIB:.0f} MiB at most and killed {inside.killed()}")
        missed += inside.killed()
        inside.close()
    return 1 if missed or not wanted else 0


if __name__ == "__main__":
    sys.exit(main())
