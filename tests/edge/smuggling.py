"""Attackers and victims share the proxy's connections to the replicas: does a victim ever get what is not its own?"""

from __future__ import annotations

import itertools
import threading
import time
from typing import Any

from attacks import attacks
from broken_backend import BrokenBackend
from edge import Edge, Proxy, Replica
from load import Load
from wire import Connection

ATTACKERS, VICTIMS, PER_SECOND = 4, 4, 4000
LISTEN_S = 0.02  # how long an attacker waits for an answer before it leaves


class Attackers:
    """Send one attack after the other, each on a connection of its own, until the block ends."""

    def __init__(self, address: tuple[str, int]) -> None:
        self._address, self._ending = address, threading.Event()
        self._next = itertools.cycle(attacks())
        self._lock = threading.Lock()
        self._threads = [threading.Thread(target=self._run, daemon=True) for _ in range(ATTACKERS)]
        self.sent = 0

    def __enter__(self) -> "Attackers":
        for thread in self._threads:
            thread.start()
        return self

    def __exit__(self, *_: Any) -> None:
        self._ending.set()
        for thread in self._threads:
            thread.join()

    def _run(self) -> None:
        while not self._ending.is_set():
            with self._lock:
                _, data = next(self._next)
                self.sent += 1
            with Connection(self._address, LISTEN_S) as connection:
                try:
                    connection.send(data)
                except OSError:
                    continue
                connection.rest()
            time.sleep(0.001)


def attacked(address: tuple[str, int], enough: int) -> tuple[Load, int]:
    """Victims' answers, at least `enough` and as many as it takes to send every attack once; and how many attacks were sent."""
    every = len(attacks())
    with Attackers(address) as attackers, Load(address, VICTIMS, PER_SECOND) as load:
        while len(load.seconds) < enough or attackers.sent < every:
            time.sleep(0.02)
    return load, attackers.sent


def check_smuggling(edge: Edge, is_full: bool) -> tuple[bool, str]:
    load, sent = attacked(edge.proxy.address, 50_000 if is_full else 2_000)
    alive = all(replica.is_running for replica in edge.replicas)
    return not load.failures and alive, f"{sent} attacks of {len(attacks())} kinds, http-reuse always: {load.figures()}"


def check_smuggling_works(_: Replica, __: bool) -> tuple[bool, str]:
    """The same attacks where a backend loses the frame: if no victim suffers there, they prove nothing."""
    with BrokenBackend() as backend, Proxy([(backend.port, backend.port)]) as proxy:
        load, sent = attacked(proxy.address, 500)
    return len(load.failures) > 0, f"{sent} attacks on a backend that loses the frame: {load.figures()} (must not be 0)"
