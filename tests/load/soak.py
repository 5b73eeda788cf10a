"""Mixed load for a long time: descriptors and threads stay as many as they were, memory does not grow.

    python3 tests/load/soak.py [--minutes 30]

Every example in turn, broken requests, clients that go away and slow ones, with a quiet moment now and then in which
descriptors and threads are counted. Memory is judged from the tenth minute on, or from the last two thirds of a shorter run,
by a least-squares line. Exit code 1 if a goal is missed.
"""

from __future__ import annotations

import itertools
import math
import statistics
import sys
import threading
import time
from typing import Any

from loading import MIB, QUIET, Goals, Program, arguments, contract

SLOPE = 1.0  # MiB per hour
WARM_UP_S = 600.0
ROUND_S, QUIET_S, SAMPLE_S = 8.0, 2.0, 2.0
PAUSE_S = 0.05  # of each client between requests: the machine has other things to do
CLIENTS = 3


class Mixed:
    """Clients that ask for everything until they are told to rest."""

    def __init__(self, server: Program) -> None:
        self.server = server
        self.rests, self.ends = threading.Event(), threading.Event()
        self.count = 0
        self.wrong: list[str] = []
        self.threads = [threading.Thread(target=self.live, args=(start,), daemon=True) for start in range(CLIENTS)]
        for thread in self.threads:
            thread.start()

    def live(self, start: int) -> None:
        todo = itertools.cycle(self.tasks())
        for _ in range(start * 7):
            next(todo)
        while not self.ends.is_set():
            if self.rests.is_set():
                time.sleep(0.05)
                continue
            name, task, statuses = next(todo)
            try:
                status = task()
                if status not in (*statuses, 503):
                    self.wrong.append(f"{name}: {status}")
            except OSError as error:
                self.wrong.append(f"{name}: {error}")
            self.count += 1
            time.sleep(PAUSE_S)

    def tasks(self) -> list[Any]:
        """Name, what to do, and the statuses that it may have."""
        found: list[Any] = []
        for operation in contract.posts() + contract.uploads():
            body, headers = contract.sample(operation)
            for word in contract.formats(operation) or ["json"]:
                target = f"{operation.path}?format={word}" if contract.formats(operation) else operation.path
                found.append((target, lambda target=target, body=body, headers=headers: self.server.request("POST", target, body, headers).status, (200,)))
            found.append((f"broken {operation.path}", lambda operation=operation, headers=headers: self.server.request("POST", operation.path, b"{", headers).status, (400, 422)))
        found += [(path, lambda path=path: self.server.get(path).status, (200,)) for path in ("/", "/docs", "/v1/limits", "/openapi.yaml", "/v1/schedules?period=1")]
        found += [("nothing", lambda: self.server.get("/nothing").status, (404,)), ("no HTTP", self.no_http, (400,)), ("gone", self.gone, (200,))]
        return found

    def no_http(self) -> int:
        return int(self.server.raw(b"GET  / HTTP/1.1\r\n\r\n")[9:12] or 0)

    def gone(self) -> int:
        """Asks for much and leaves."""
        with self.server.connect() as connection:
            connection.sendall(b"GET /openapi.yaml HTTP/1.1\r\nHost: x\r\n\r\n")
            connection.recv(10)
        return 200

    def end(self) -> None:
        self.ends.set()
        for thread in self.threads:
            thread.join(30)


def slope(samples: list[tuple[float, float]]) -> tuple[float, float]:
    """MiB per hour of a line through (seconds, bytes), and its standard error."""
    hours = [at / 3600 for at, _ in samples]
    memory = [held / MIB for _, held in samples]
    middle = statistics.fmean(hours)
    spread = sum((hour - middle) ** 2 for hour in hours)
    rise = sum((hour - middle) * held for hour, held in zip(hours, memory)) / spread
    level = statistics.fmean(memory)
    rest = sum((held - level - rise * (hour - middle)) ** 2 for hour, held in zip(hours, memory))
    return rise, math.sqrt(rest / max(1, len(samples) - 2) / spread)


def main() -> int:
    options = arguments(__doc__ or "", minutes={"type": float, "default": 30})
    goals, total = Goals(), options.minutes * 60
    memory: list[tuple[float, float]] = []
    quiet: list[tuple[int, int]] = []
    with Program(options.server, *QUIET) as server:
        begin, mixed = time.monotonic(), Mixed(server)
        while (at := time.monotonic() - begin) < total:
            round_end = time.monotonic() + ROUND_S
            while time.monotonic() < round_end:
                time.sleep(SAMPLE_S)
            mixed.rests.set()
            time.sleep(QUIET_S)
            quiet.append((server.descriptors(), server.threads()))
            memory.append((at, server.resident()))  # at quiet moments, too, when nothing is being computed
            mixed.rests.clear()
            if len(quiet) % 12 == 0:
                print(f"{at / 60:5.1f} min: {mixed.count} requests, {quiet[-1][0]} descriptors, {quiet[-1][1]} threads, {memory[-1][1] / MIB:.2f} MiB", flush=True)
        mixed.end()
        is_well = server.is_well()
    late = [(when, held) for when, held in memory if when > min(WARM_UP_S, total / 3)]
    rise, error = slope(late)
    print(f"{mixed.count} requests in {total / 60:.0f} min; memory {rise:.2f} +- {error:.2f} MiB/h over {len(late)} samples, "
          f"{min(h for _, h in late) / MIB:.1f} to {max(h for _, h in late) / MIB:.1f} MiB")
    goals.equal("different numbers of descriptors at quiet moments", len({files for files, _ in quiet}), 1)
    goals.equal("different numbers of threads at quiet moments", len({threads for _, threads in quiet}), 1)
    goals.at_most("slope of memory", rise, SLOPE, "MiB/h")
    goals.equal("wrong answers", len(mixed.wrong), 0)
    if mixed.wrong:
        print(mixed.wrong[:5])
    goals.equal("well afterwards", is_well, True)
    return goals.exit_code


if __name__ == "__main__":
    sys.exit(main())
