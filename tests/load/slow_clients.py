"""900 clients that send a byte a second, for as long as they are let: others do not notice, and none of them is let for long.

    python3 tests/load/slow_clients.py [--clients 900] [--seconds 30]

Once with slow heads and once with slow bodies, on the bare server with its limits as they are by default. Who is cut off comes
back with the next tick, so that there are never more of them. Exit code 1 if a goal is missed.
"""

from __future__ import annotations

import selectors
import socket
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass

from loading import QUIET, Goals, Program, arguments, command, count, finished, hairstyle, load, others, quantile

HEALTHY_MS, CUT_S = 50.0, 15.0
RATE, CONNECTIONS = 50, 8  # of the healthy
TICK_S = 1.0
KINDS = {"slow heads": (b"POST /v1/hairstyles HTTP/1.1\r\nHost: localhost\r\nX: ", b"a"),
         "slow bodies": (b"POST /v1/hairstyles HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: 100000\r\n\r\n", b" ")}


@dataclass(eq=False)
class Slow:
    connection: socket.socket
    began: float


class Crowd:
    """All slow clients of one kind, in one thread."""

    def __init__(self, server: Program, clients: int, first: bytes, more: bytes) -> None:
        self.server, self.first, self.more = server, first, more
        self.selector = selectors.DefaultSelector()
        self.lives: list[float] = []
        self.gone: list[Slow] = []
        self.clients = [self.begin() for _ in range(clients)]

    def begin(self) -> Slow:
        slow = Slow(self.server.connect(), time.monotonic())
        slow.connection.sendall(self.first)
        slow.connection.setblocking(False)
        self.selector.register(slow.connection, selectors.EVENT_READ, slow)
        return slow

    def live(self, process: "subprocess.Popen[bytes]") -> None:
        """A byte of each now and then, until the process ends."""
        while process.poll() is None:
            next_tick = time.monotonic() + TICK_S
            gone, self.gone = self.gone, []
            for slow in gone:
                self.clients.remove(slow)
                self.clients.append(self.begin())
            for slow in self.clients:
                try:
                    slow.connection.send(self.more)
                except OSError:
                    pass  # cut off: noticed when it is read
            while (left := next_tick - time.monotonic()) > 0 and process.poll() is None:
                for key, _ in self.selector.select(min(left, 0.1)):
                    self.hear(key.data)

    def hear(self, slow: Slow) -> None:
        try:
            if slow.connection.recv(65536):
                return  # why it is cut off; the end comes next
        except BlockingIOError:
            return
        except OSError:
            pass
        self.lives.append(time.monotonic() - slow.began)
        self.selector.unregister(slow.connection)
        slow.connection.close()
        self.gone.append(slow)

    def longest(self) -> float:
        """Of those that were cut off and those that still live."""
        return max([*self.lives, *(time.monotonic() - slow.began for slow in self.clients if slow not in self.gone)])

    def close(self) -> None:
        for slow in self.clients:
            slow.connection.close()


def main() -> int:
    options = arguments(__doc__ or "", clients={"type": int, "default": 900}, seconds={"type": float, "default": 30})
    goals = Goals()
    with tempfile.NamedTemporaryFile() as file, Program(options.server, *QUIET) as server:
        file.write(hairstyle(1))
        file.flush()
        before = load(options.generator, server, "/v1/hairstyles", file.name, RATE, 5, CONNECTIONS)
        print(f"{RATE} healthy requests a second alone: p50 {quantile(before, 200, 'p50'):.1f}, p99 {quantile(before, 200):.1f} ms", flush=True)
        for kind, (first, more) in KINDS.items():
            crowd = Crowd(server, options.clients, first, more)
            process = subprocess.Popen(command(options.generator, server, "/v1/hairstyles", file.name, RATE, options.seconds, CONNECTIONS), stdout=subprocess.PIPE)
            crowd.live(process)
            healthy = finished(process)
            print(f"{options.clients} {kind}: {count(healthy, 200)} healthy answers, p50 {quantile(healthy, 200, 'p50'):.1f} ms, "
                  f"{len(crowd.lives)} cut off, memory {server.resident() >> 20} MiB, others {others(healthy, 200)}")
            goals.at_most(f"{kind}: healthy p99", quantile(healthy, 200), HEALTHY_MS, "ms")
            goals.equal(f"{kind}: healthy ones not answered", sum(others(healthy, 200).values()) + healthy["lost"], 0)
            goals.at_most(f"{kind}: longest life", crowd.longest(), CUT_S, "s")
            goals.at_least(f"{kind}: cut off", len(crowd.lives), options.clients)
            crowd.close()
        goals.equal("well afterwards", server.is_well(), True)
    return goals.exit_code


if __name__ == "__main__":
    sys.exit(main())
