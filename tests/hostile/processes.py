"""The process among others: a port that is taken, signals, and an end in the middle of everything."""

from __future__ import annotations

import signal
import subprocess
import time

from cases import INNOCENT
from report import Report
from running import Program, eventually
from wire import exchange, receive

END_S = 20.0  # the head of a request may take 5 s, and what computes 10 s
AT_ONCE_S = 3.0


def run(report: Report, program: str, full: bool) -> None:
    with Program(program) as server:
        two_servers_on_one_port(report, program, server)
        signals_that_end_nothing(report, server)
    ends_in_order(report, program)
    ends_at_once(report, program)
    has_a_successor(report, program)
    if full:
        ends_with_a_slow_client(report, program)


def two_servers_on_one_port(report: Report, program: str, server: Program) -> None:
    for what, flags in {"front": ("--port", str(server.port), "--admin-port", "0"), "admin": ("--port", "0", "--admin-port", str(server.admin_port))}.items():
        second = subprocess.run([program, *flags], capture_output=True, timeout=END_S)
        report.equal(f"a second server on the {what} port: exit code", second.returncode, 1)
        report.equal(f"a second server on the {what} port is not ready", second.stdout, b"")
        sentence = second.stderr.decode()
        wanted = sentence.startswith("tuftwave-server: cannot listen on ") and "in use" in sentence and flags[1 if what == "front" else 3] in sentence
        report.check(f"a second server on the {what} port says why", wanted and sentence.count("\n") == 1, sentence)
    for _ in range(20):
        if not server.is_well():
            report.check("the first goes on", False, "an answer failed")
            return
    report.check("the first goes on", True)


def signals_that_end_nothing(report: Report, server: Program) -> None:
    for number in (signal.SIGPIPE, signal.SIGWINCH, signal.SIGCONT, signal.SIGURG):
        server.signal(number)
        report.check(f"well after {number.name}", server.is_well())
    for _ in range(50):  # a client that goes away while it is written to would raise SIGPIPE
        with server.connect() as connection:
            connection.sendall(INNOCENT.replace(b"/v1/version", b"/openapi.yaml") * 20)
    report.check("well after clients that did not wait", server.is_well())


def ends_in_order(report: Report, program: str) -> None:
    """Not ready at once, serves on for a while, answers that the connection ends, closes who is idle, exit code 0."""
    for number in (signal.SIGTERM, signal.SIGINT):
        with Program(program, "--drain", "2") as server:
            idle = server.connect()
            idle.sendall(INNOCENT)
            receive(idle, 1)
            server.signal(number)
            report.check(f"{number.name}: not ready", eventually(lambda: server.request("GET", "/readyz", admin=True).status == 503, 1.5))
            report.equal(f"{number.name}: alive", server.request("GET", "/livez", admin=True).status, 200)
            last = exchange(server.address, INNOCENT)
            closes = bool(last.replies) and last.replies[0].header("connection") == "close"
            report.check(f"{number.name}: the last answers say that they are", last.statuses == [200] and closes and last.closed, last)
            report.equal(f"{number.name}: exit code", server.wait(END_S), 0)
            report.equal(f"{number.name}: who was idle is let go", receive(idle, 0).closed, True)
            idle.close()


def ends_at_once(report: Report, program: str) -> None:
    with Program(program, "--drain", "60") as server:
        server.signal(signal.SIGTERM)
        time.sleep(0.5)
        report.check("the first SIGTERM lets it serve on", server.is_running and server.get("/v1/version").status == 200)
        server.signal(signal.SIGTERM)
        code = server.wait(AT_ONCE_S)
        report.check("the second SIGTERM ends it at once", code is not None and code != 0, code)


def has_a_successor(report: Report, program: str) -> None:
    """However it ends, with connections open, the next one gets its port at once. Nobody listens to SIGHUP: it ends it."""
    for number, codes in {signal.SIGKILL: {-signal.SIGKILL}, signal.SIGHUP: {-signal.SIGHUP, 0}, signal.SIGTERM: {0}}.items():
        with Program(program) as server:
            clients = [server.connect() for _ in range(20)]
            for client in clients:
                client.sendall(INNOCENT)
                receive(client, 1)
            server.signal(number)
            code = server.wait(END_S)
            report.check(f"{number.name} ends it", code in codes, code)
            with Program(program, "--port", str(server.port), "--admin-port", str(server.admin_port)) as successor:
                report.check(f"a successor after {number.name}", successor.is_well() and successor.port == server.port)
            for client in clients:
                client.close()


def ends_with_a_slow_client(report: Report, program: str) -> None:
    """Somebody who never finishes a request holds nothing up for longer than that may take."""
    with Program(program) as server:
        with server.connect() as head, server.connect() as reader:
            head.sendall(INNOCENT[:-6])
            reader.sendall(INNOCENT.replace(b"/v1/version", b"/docs/swagger-ui-bundle.js") * 20)
            time.sleep(0.2)
            server.signal(signal.SIGTERM)
            report.equal("exit code with slow clients", server.wait(60.0), 0)
