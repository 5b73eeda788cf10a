"""Malformed and ambiguous requests: exactly the expected status, never more answers than requests, and the connection closed.

Each is sent at once, followed by an innocent request on the same connection, and some of them byte by byte.
"""

from __future__ import annotations

import json

import cases_framing
import cases_header
import cases_line
import contract
from cases import INNOCENT, Case
from report import Report
from running import Program
from wire import Exchange, Reply, WireError, exchange

CASES: list[Case] = cases_line.CASES + cases_header.CASES + cases_framing.CASES
FEWEST = 120  # of which issue 6 speaks
SHORT = 400  # bytes; longer ones would take long byte by byte
EVERY = 6  # of the short ones byte by byte in the quick form
FORBIDDEN = ("server", "exception_what", "x-powered-by")


def run(report: Report, program: str, full: bool) -> None:
    report.check("number of cases", len(CASES) >= FEWEST, len(CASES))
    report.equal("names used once", len({case.name for case in CASES}), len(CASES))
    with Program(program) as server:
        short = [case for case in CASES if len(case.data) <= SHORT]
        for case in CASES:
            attempt(report, server, case, "at once")
            if case.is_whole:
                attempt(report, server, case, "before an innocent one")
        for case in short if full else short[::EVERY]:
            attempt(report, server, case, "byte by byte")
        report.check("well afterwards", server.is_well())
        report.equal("examples afterwards", server.answers_examples(), [])
    report.note(f"{len(CASES)} cases")


def attempt(report: Report, server: Program, case: Case, way: str) -> None:
    """One case in one way."""
    is_followed = way == "before an innocent one"
    data = case.data + INNOCENT if is_followed else case.data
    method = case.data.split(b" ")[0].decode("latin-1")
    what = f"{case.name}, {way}"
    try:
        got = exchange(server.address, data, (2 if is_followed else 1) if case.may_go_on else 0, way == "byte by byte", [method])
    except (WireError, OSError) as error:
        report.check(what, False, f"{error} ({case.why})")
        return
    fault = judge(case, got, is_followed)
    report.check(what, not fault, f"{fault} ({case.why})")


def judge(case: Case, got: Exchange, is_followed: bool) -> str:
    """What is wrong with the answers; empty if nothing is."""
    wanted = [[case.status]] + ([[case.status, 200]] if is_followed and case.may_go_on else [])
    if got.statuses not in wanted:
        return f"{got.statuses} in place of {wanted[0]}"
    if got.interim:
        return f"{got.interim} before it"
    if got.reset:
        return "the connection was reset"
    if not case.may_go_on and not got.closed:
        return "the connection stayed open"
    return is_problem(got.replies[0], case)


def is_problem(reply: Reply, case: Case) -> str:
    if reply.header("content-type") != "application/problem+json":
        return f"of type {reply.header('content-type')}"
    if not case.may_go_on and reply.header("connection") != "close":
        return f"Connection: {reply.header('connection')}"
    if case.status == 405 and not reply.header("allow"):
        return "without Allow"
    if any(reply.header(name) for name in FORBIDDEN):
        return f"says too much: {reply.headers}"
    if case.data.startswith(b"HEAD "):
        return "" if not reply.body else "a body for HEAD"
    try:
        problem = json.loads(reply.body)
    except ValueError:
        return f"no JSON: {reply.body[:80]!r}"
    faults = contract.faults(problem, contract.named("Problem"))
    return faults[0] if faults else "" if problem["status"] == case.status else f"status {problem['status']} in its body"
