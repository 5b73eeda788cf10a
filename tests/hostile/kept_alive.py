"""Connections that are kept hold nothing of what they have brought, in either direction."""

from __future__ import annotations

import socket
from typing import Optional

from cases import JSON, head
from report import Report
from running import MIB, Program, eventually
from slow_read import big_request
from wire import receive

CLIENTS = 16
MOST = 32 * MIB  # for all of them; one answer alone has 4.7 MiB, one body 8 MiB
LET_GO_S = 5.0


def run(report: Report, program: str, full: bool) -> None:
    blanks = b" " * (8 * MIB)
    body = head("POST /v1/schedules HTTP/1.1", "Host: localhost", JSON, f"Content-Length: {len(blanks)}") + blanks
    for what, request in (("answers", big_request()), ("bodies", body)):
        with Program(program, "--workers", "1") as server:
            once(server, request).close()
            before = server.resident()
            clients = [once(server, request) for _ in range(CLIENTS)]
            held = eventually(lambda: server.resident() - before < MOST, LET_GO_S)
            report.check(f"nothing of large {what} is held", held, f"{(server.resident() - before) / MIB:.0f} MiB for {CLIENTS} connections")
            statuses = {client: receive_again(client) for client in clients}
            report.equal(f"after large {what} they are kept or told to go", set(statuses.values()) - {200, None}, set())
            for client in clients:
                client.close()


def once(server: Program, request: bytes) -> socket.socket:
    """A client that has its whole answer and stays."""
    client = server.connect()
    client.sendall(request)
    receive(client, 1)
    return client


def receive_again(client: socket.socket) -> Optional[int]:
    """The status of a small second request; None if the connection was closed, as it is behind a refusal."""
    try:
        client.sendall(b"GET /v1/version HTTP/1.1\r\nHost: localhost\r\n\r\n")
        statuses = receive(client, 1).statuses
    except OSError:
        return None
    return statuses[0] if statuses else None
