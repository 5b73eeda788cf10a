"""More connections than there is room for, and connections that come to nothing."""

from __future__ import annotations

import selectors
import socket
import struct
import time

from cases import INNOCENT, TIMING, get, sized
from report import Report
from running import Program, eventually
from wire import exchange, receive

ROOM = 64
AT_ONCE = 1_000
RESET = struct.pack("ii", 1, 0)  # SO_LINGER: close with a reset
PATIENCE_S = 30.0


def run(report: Report, program: str, full: bool) -> None:
    with Program(program, "--connections", str(ROOM)) as server:
        full_house(report, server)
    with Program(program, "--connections", "1024") as server:
        before = server.descriptors()
        for _ in range(5 if full else 1):
            at_once(report, server, AT_ONCE)
        storms = 2_000 if full else 300
        for name, storm in STORMS.items():
            for _ in range(storms):
                storm(server)
            report.check(f"well after {storms} times {name}", server.is_well())
        closed = eventually(lambda: server.descriptors() <= before + 1, PATIENCE_S)
        report.check("every connection closed in the end", closed, f"{server.descriptors()} descriptors, {before} before")
        report.equal("examples afterwards", server.answers_examples(), [])


def full_house(report: Report, server: Program) -> None:
    """Every place taken by who has begun to ask, so that none of them is idle: the next is told so and sent away."""
    guests = [server.connect() for _ in range(ROOM)]
    for guest in guests:
        guest.sendall(INNOCENT[:-4])
    report.check("the admin listener has room of its own", server.request("GET", "/livez", admin=True).status == 200)
    time.sleep(0.2)  # all of them are in
    for _ in range(3):
        turned_away = exchange(server.address, INNOCENT, patience=PATIENCE_S)
        report.equal("one too many", (turned_away.statuses, turned_away.closed), ([503], True))
        if turned_away.statuses == [503]:
            reply = turned_away.replies[0]
            report.check("one too many is told when to come again", (reply.header("retry-after") or "").isdigit(), reply.headers)
            report.equal("one too many gets a problem", reply.header("content-type"), "application/problem+json")
    for guest in guests[:10]:
        guest.close()
    report.check("room again when some leave", eventually(lambda: exchange(server.address, INNOCENT, 1).statuses == [200], 5))
    served = 0
    for guest in guests[10:]:
        guest.sendall(INNOCENT[-4:])
        served += receive(guest, 1).statuses == [200]
        guest.close()
    report.equal("those who were in are served", served, ROOM - 10)
    report.check("well after a full house", server.is_well())


def at_once(report: Report, server: Program, count: int) -> None:
    """So many clients connect in the same moment, ask once and leave: all of them get their answer."""
    selector = selectors.DefaultSelector()
    for _ in range(count):
        connection = socket.socket()
        connection.setblocking(False)
        connection.connect_ex(server.address)
        selector.register(connection, selectors.EVENT_WRITE, bytearray())
    good = bad = 0
    begin = time.monotonic()
    while good + bad < count and time.monotonic() < begin + PATIENCE_S:
        for key, events in selector.select(1.0):
            connection, received = key.fileobj, key.data
            try:
                if events & selectors.EVENT_WRITE:
                    connection.send(INNOCENT)  # type: ignore[union-attr]
                    selector.modify(connection, selectors.EVENT_READ, received)
                    continue
                part = connection.recv(65536)  # type: ignore[union-attr]
                received += part
                if part and not is_complete(received):
                    continue
                good, bad = (good + 1, bad) if received.startswith(b"HTTP/1.1 200 ") else (good, bad + 1)
            except OSError:
                bad += 1
            selector.unregister(connection)
            connection.close()  # type: ignore[union-attr]
    report.equal(f"{count} connections at once", (good, bad), (count, 0))
    report.note(f"{count} connections at once took {time.monotonic() - begin:.2f} s")
    for key in list(selector.get_map().values()):
        key.fileobj.close()  # type: ignore[union-attr]


def is_complete(received: bytearray) -> bool:
    head, gap, body = bytes(received).partition(b"\r\n\r\n")
    length = next((line.split(b":")[1] for line in head.lower().split(b"\r\n") if line.startswith(b"content-length:")), b"0")
    return bool(gap) and len(body) >= int(length)


def connect_and_close(server: Program) -> None:
    server.connect().close()


def reset_at_once(server: Program) -> None:
    with server.connect() as connection:
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, RESET)


def reset_in_a_head(server: Program) -> None:
    with server.connect() as connection:
        connection.sendall(INNOCENT[:20])
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, RESET)


def reset_in_a_body(server: Program) -> None:
    with server.connect() as connection:
        connection.sendall(sized()[:-5])
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, RESET)


def reset_while_it_computes(server: Program) -> None:
    with server.connect() as connection:
        connection.sendall(sized())
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, RESET)


def reset_in_an_answer(server: Program) -> None:
    with server.connect() as connection:
        connection.sendall(get(target="/openapi.yaml"))
        connection.recv(1)
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, RESET)


def half_closed_before_a_request_ends(server: Program) -> None:
    with server.connect() as connection:
        connection.sendall(sized(body=TIMING)[:-1])
        connection.shutdown(socket.SHUT_WR)
        connection.settimeout(PATIENCE_S)
        while connection.recv(65536):
            pass


def half_closed_after_a_request(server: Program) -> None:
    with server.connect() as connection:
        connection.sendall(INNOCENT)
        connection.shutdown(socket.SHUT_WR)
        connection.settimeout(PATIENCE_S)
        while connection.recv(65536):
            pass


STORMS = {"connecting and closing": connect_and_close, "a reset at once": reset_at_once, "a reset in a head": reset_in_a_head, "a reset in a body": reset_in_a_body,
          "a reset while it computes": reset_while_it_computes, "a reset in an answer": reset_in_an_answer, "half closed within a request": half_closed_before_a_request_ends,
          "half closed after a request": half_closed_after_a_request}
