"""Clients that send too slowly or not at all are cut off in time, and others do not notice them."""

from __future__ import annotations

import selectors
import socket
import statistics
import time
from dataclasses import dataclass, field
from typing import Optional

from cases import HOST, TIMING, head
from report import Report
from running import Program

EACH = 8  # clients of each kind
TICK_S = 0.5
GRACE_S = 4.0  # what a busy machine may add to a deadline
HEAD_S, BODY_S, IDLE_S = 5.0, 10.0, 15.0
POST_HEAD = b"POST /v1/schedules HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: %d\r\n\r\n"


@dataclass
class Client:
    """One that dribbles: `more` is sent a byte per tick after `first`."""

    kind: str
    first: bytes
    more: bytes
    deadline: float  # seconds after which the server must have cut it off
    status: Optional[int]  # of the answer that it gets before that; None for none
    connection: socket.socket = field(init=False, repr=False)
    received: bytes = field(init=False, default=b"", repr=False)
    began: float = field(init=False)
    ended: Optional[float] = field(init=False, default=None)
    sent: int = field(init=False, default=0)

    def begin(self, address: tuple[str, int]) -> None:
        self.connection = socket.create_connection(address, timeout=10)
        self.began = time.monotonic()
        if self.first:
            self.connection.sendall(self.first)
        self.connection.setblocking(False)

    def tick(self) -> None:
        """Sends one byte more. That the server has closed is noticed when that is read."""
        try:
            if self.sent < len(self.more):
                self.sent += self.connection.send(self.more[self.sent:self.sent + 1])
        except OSError:
            pass

    def read(self) -> None:
        try:
            part = self.connection.recv(65536)
            self.received += part
        except (BlockingIOError, InterruptedError):
            return
        except OSError:
            part = b""
        if not part:
            self.end()

    def end(self) -> None:
        self.ended = time.monotonic() - self.began
        self.connection.close()


def client(kind: str) -> Client:
    first, more, deadline, status = KINDS[kind]
    return Client(kind, first, more * 200, deadline, status)


_VERSION = head("GET /v1/version HTTP/1.1", HOST)
KINDS: dict[str, tuple[bytes, bytes, float, Optional[int]]] = {
    "slow request line": (b"GET /", b"a", HEAD_S, 408),
    "slow head": (b"GET /v1/version HTTP/1.1\r\nHost: localhost\r\nX: ", b"a", HEAD_S, 408),
    "stopped head": (b"GET /v1/version HTTP/1.1\r\nHost: local", b"", HEAD_S, 408),
    "slow body": (POST_HEAD % 1_000, b" ", BODY_S, 408),
    "stopped body": (POST_HEAD % len(TIMING) + TIMING[:5], b"", BODY_S, 408),
    "slow chunks": (head("POST /v1/schedules HTTP/1.1", HOST, "Transfer-Encoding: chunked"), b"1\r\n \r\n", BODY_S, 408),
    "slow second request": (_VERSION + b"GET /v1/", b"a", HEAD_S, 200),
    "idle from the start": (b"", b"", IDLE_S, None),
    "idle after an answer": (_VERSION, b"", IDLE_S, 200),
}


def run(report: Report, program: str, full: bool) -> None:
    with Program(program, "--connections", "256") as server:
        clients = [client(kind) for kind in KINDS for _ in range(EACH if full else 2)]
        for each in clients:
            each.begin(server.address)
        latencies = live(server, clients, IDLE_S + GRACE_S)
        for each in clients:
            judge(report, each)
        report.note(f"{len(latencies)} innocent requests meanwhile, median {statistics.median(latencies) * 1e3:.1f} ms, slowest {max(latencies) * 1e3:.1f} ms")
        report.check("an innocent client among them", max(latencies) < 2.0, f"{max(latencies):.1f} s")
        for each in clients:
            each.connection.close()
        report.check("well afterwards", server.is_well())


def live(server: Program, clients: list[Client], seconds: float) -> list[float]:
    """Lets all of them dribble until they are cut off or the time is over. @return  how long innocent requests took"""
    latencies: list[float] = []
    selector = selectors.DefaultSelector()
    for each in clients:
        selector.register(each.connection, selectors.EVENT_READ, each)
    end = time.monotonic() + seconds
    while time.monotonic() < end and selector.get_map():
        next_tick = time.monotonic() + TICK_S
        begin = time.monotonic()
        is_good = server.get("/v1/version").status == 200
        latencies.append(time.monotonic() - begin if is_good else float("inf"))
        while (left := next_tick - time.monotonic()) > 0:
            for key, _ in selector.select(left):
                selector.unregister(key.fileobj)  # it may close
                key.data.read()
                if key.data.ended is None:
                    selector.register(key.fileobj, selectors.EVENT_READ, key.data)
        for each in clients:
            if each.ended is None:
                each.tick()
    return latencies


def judge(report: Report, client: Client) -> None:
    took = f"{client.ended:.1f} s" if client.ended else "not at all"
    report.check(f"{client.kind} is cut off", client.ended is not None and client.ended < client.deadline + GRACE_S, f"{took}, must be {client.deadline:.0f} s")
    # Not before its time, either; except for who is idle, which is where room is made when there is little.
    if client.ended is not None and client.deadline != IDLE_S:
        report.check(f"{client.kind} has its time", client.ended > client.deadline - 1.0, f"{took}, may take {client.deadline:.0f} s")
    if client.status is None:
        report.equal(f"{client.kind} gets nothing", client.received, b"")
    else:
        report.check(f"{client.kind} is told", client.received.startswith(f"HTTP/1.1 {client.status} ".encode()), client.received[:80])
