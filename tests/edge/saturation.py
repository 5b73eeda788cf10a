"""One replica with more work than it takes, given to it behind the proxy's back: the others get its share."""

from __future__ import annotations

import threading

from edge import Edge
from load import Load, motions, read_example
from wire import Broken, Connection, request

CROWD = 6  # more than one worker and one place in the queue
FLAGS = ("--workers", "1", "--queue", "1")
# No more at once than one replica takes, so that whatever fails does so because of the saturated one.
THREADS, ENOUGH = 2, 300


class Crowd:
    """Clients that keep one replica full."""

    def __init__(self, address: tuple[str, int]) -> None:
        self._address, self._ending = address, threading.Event()
        self._threads = [threading.Thread(target=self._run, daemon=True) for _ in range(CROWD)]
        self.refused = 0

    def __enter__(self) -> "Crowd":
        for thread in self._threads:
            thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ending.set()
        for thread in self._threads:
            thread.join()

    def _run(self) -> None:
        work = request("POST", "/v1/fits", read_example("fits"))
        with Connection(self._address) as connection:
            while not self._ending.is_set():
                try:
                    if connection.ask(work).status == 503:
                        self.refused += 1
                        self._ending.wait(0.002)
                except (Broken, OSError):
                    self.refused += 1


def check_saturation(program: str, _: bool) -> tuple[bool, str]:
    with Edge(program, *FLAGS) as edge, Crowd(edge.replicas[0].address) as crowd:
        before = edge.proxy.repeated()
        with Load(edge.proxy.address, THREADS, 100, motions, enough=ENOUGH) as load:
            load.wait()
        repeated = edge.proxy.repeated() - before
    is_good = not load.failures and repeated > 0 and crowd.refused > 0
    return is_good, (f"one of three full: {load.figures()}, {repeated:.0f} of its 503 repeated elsewhere, "
                     f"{crowd.refused} refusals to its own crowd")
