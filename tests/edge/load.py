"""Ordinary requests at a bounded rate, each with an answer that no other request has."""

from __future__ import annotations

import itertools
import json
import threading
import time
from typing import Any, Callable, Optional

from edge import ROOT
from wire import Answer, Broken, Connection, is_own, request, schedule

Ask = tuple[bytes, Callable[[Answer], bool]]
starts = itertools.count(0, 100_000)  # no two threads of a run ask the same


def schedules(number: int) -> Ask:
    return schedule(number), lambda answer: is_own(answer, number)


def motions(number: int) -> Ask:
    """However little it asks for, a motion needs a worker; the other two are small enough to need none."""
    name = f"chain{number}"
    body = json.loads(read_example("motions"))
    body["chains"][0]["name"] = name
    return request("POST", "/v1/motions", json.dumps(body).encode()), lambda answer: answer.status == 200 and f'"{name}"'.encode() in answer.body


def with_tufts(number: int) -> Ask:
    """Every other one a tuft, whose mesh is named as no other; a few hundred times the work of a schedule, and a larger answer."""
    if number % 2:
        return schedules(number)
    name = f"tuft{number}"
    return request("POST", "/v1/tufts", tuft_body(name)), lambda answer: answer.status == 200 and f'"{name}"'.encode() in answer.body


def read_example(operation: str) -> bytes:
    with open(f"{ROOT}/api/examples/{operation}.json", "rb") as file:
        return file.read()


def tuft_body(name: str) -> bytes:
    body = json.loads(read_example("tufts"))
    body["tufts"] = body["tufts"][:1]
    body["tufts"][0]["name"] = name
    return json.dumps(body).encode()


def percentile(values: list[float], share: float) -> float:
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))] if ordered else 0.0


class Load:
    """Use as a context manager: requests go out until the block ends, or until `enough` were answered and `wait` returns."""

    def __init__(self, address: tuple[str, int], threads: int, per_second: float, ask: Callable[[int], Ask] = schedules,
                 enough: Optional[int] = None) -> None:
        self._address, self._ask, self._enough = address, ask, enough
        self._pause_s = threads / per_second
        self._ending = threading.Event()
        self._lock = threading.Lock()
        self._threads = [threading.Thread(target=self._run, args=(next(starts),), daemon=True) for _ in range(threads)]
        self.good = 0
        self.failures: list[str] = []
        self.seconds: list[float] = []

    def __enter__(self) -> "Load":
        for thread in self._threads:
            thread.start()
        return self

    def __exit__(self, *_: Any) -> None:
        self._ending.set()
        self.wait()

    def wait(self) -> None:
        for thread in self._threads:
            thread.join()

    def _run(self, number: int) -> None:
        due = time.monotonic()
        with Connection(self._address) as connection:
            while not self._ending.is_set():
                number += 1
                data, is_right = self._ask(number)
                begun = time.monotonic()
                fault = self._fault(connection, data, is_right)
                self._note(fault, time.monotonic() - begun)
                due = max(due + self._pause_s, time.monotonic() - 1)  # catches up at most a second
                self._ending.wait(max(0.0, due - time.monotonic()))

    @staticmethod
    def _fault(connection: Connection, data: bytes, is_right: Callable[[Answer], bool]) -> str:
        try:
            answer = connection.ask(data)
            return "" if is_right(answer) else f"{answer.status} {answer.body[:120]!r}"
        except (Broken, OSError, ValueError, LookupError, TypeError) as fault:
            return repr(fault)

    def _note(self, fault: str, seconds: float) -> None:
        with self._lock:
            self.seconds.append(seconds)
            if fault:
                self.failures.append(fault)
            else:
                self.good += 1
            if self._enough and len(self.seconds) >= self._enough:
                self._ending.set()

    def figures(self) -> str:
        first = f" (first: {self.failures[0]})" if self.failures else ""
        return f"{len(self.failures)} failed of {len(self.seconds)}{first}, p99 {1000 * percentile(self.seconds, 0.99):.1f} ms"
