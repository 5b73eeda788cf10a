"""No file descriptors left: nobody new comes in, nothing spins, and afterwards everything is as before."""

from __future__ import annotations

import socket
import time

from cases import INNOCENT
from report import Report
from running import Program, eventually
from wire import receive

MOST = 64
CLIENTS = 200
LOOK_S = 2.0
RETURN_S = 20.0


def run(report: Report, program: str, full: bool) -> None:
    with Program(program, prefix=["prlimit", f"--nofile={MOST}:{MOST}"]) as server:
        before = server.descriptors()
        report.check("well with few descriptors", server.is_well())
        for _ in range(5 if full else 1):
            exhaust(report, server)
        report.check("every descriptor comes back", eventually(lambda: server.descriptors() <= before, RETURN_S), f"{server.descriptors()}, {before} before")
        report.equal("examples afterwards", server.answers_examples(), [])


def exhaust(report: Report, server: Program) -> None:
    clients = [server.connect() for _ in range(CLIENTS)]  # the system takes them in, the program cannot
    for client in clients:
        send(client, INNOCENT[:-2])
    time.sleep(0.3)
    report.check("none is left", server.descriptors() >= MOST - 2, server.descriptors())
    begin = server.processor_seconds()
    time.sleep(LOOK_S)
    used = server.processor_seconds() - begin
    report.check("it does not spin", used < 0.5 * LOOK_S, f"{used:.1f} s of processor time in {LOOK_S} s")
    report.check("it runs", server.is_running)
    served = 0
    for client in clients[:10]:
        send(client, INNOCENT[-2:])
        served += receive(client, 1, patience=5).statuses == [200]
    report.equal("who was in is served", served, 10)
    for client in clients:
        client.close()
    report.check("well again", eventually(server.is_well, RETURN_S))


def send(client: socket.socket, data: bytes) -> None:
    try:
        client.sendall(data)
    except OSError:
        pass  # sent away already
