"""The log: nobody reads it, nobody can forge it, its disk is full; and it tells no secrets."""

from __future__ import annotations

import json
import os
import re
import tempfile
import time

from cases import HOST, INNOCENT, JSON, get, head, line, sized
from report import Report
from running import Program, stop
from wire import WireError, exchange

SECRET = "s3cr3t-8d1f"
FORGED = '{"ts":"2026-01-01T00:00:00Z","level":"error","msg":"forged"}'
MANY = 20_000  # lines: more than a pipe and the queue before it hold
BATCH = 50
END_S = 10.0
LEVEL = ("--log-level", "debug", "--log-format", "json")


def hostile() -> list[bytes]:
    """Requests that carry line breaks, escapes, quotes and secrets wherever they can."""
    body = json.dumps({"tufts": [{"name": f'{SECRET}\r\n{FORGED}\x1b[31m"', "points": [[0, 0, 0], [0, 0.1, 0]]}]}).encode()
    return [
        get(target=f"/{SECRET}"),
        get(target=f"/v1/version?token={SECRET}"),
        get(target="/v1/%0d%0a" + FORGED.replace('"', "%22")),
        get(target="/v1/schedules?format=%0d%0a%1b%5b31m%22" + SECRET),
        get(target='/v1/"},{"msg":"forged"}'),
        get(f"Authorization: Bearer {SECRET}", f"Cookie: session={SECRET}", f"X-Api-Key: {SECRET}"),
        get(f"User-Agent: \x80\xff {FORGED} {SECRET}", f"Referer: http://{SECRET}/"),
        get(f"traceparent: {SECRET}", f"X-Request-Id: {SECRET}%0d%0a", f"Request-Id: {SECRET}"),
        get(f"X-Forwarded-For: {SECRET}"),
        get(f"Accept: {SECRET}/%0a", target="/v1/limits"),
        head("GET /v1/version HTTP/1.1", f"Host: {SECRET}.example"),
        line(f'"{SECRET}" / HTTP/1.1'),
        line(f"{SECRET} / HTTP/1.1"),
        line("GET /v1/version HTTP/9.9 " + SECRET),
        line(f"GET /\x1b[31m\x07{SECRET} HTTP/1.1"),
        b"GET / HTTP/1.1\r\nHost: x\nX-Forged: " + FORGED.encode() + b"\r\n\r\n",
        sized(body=body, target="/v1/tufts"),
        sized(body=body[:-1], target="/v1/tufts"),
        sized(body=b'{"' + SECRET.encode() + b'\\n":1}', target="/v1/hairstyles"),
        head("POST /v1/tufts HTTP/1.1", HOST, JSON, f"Content-Length: {SECRET}"),
        head("POST /v1/tufts HTTP/1.1", HOST, f"Content-Type: {SECRET}", "Content-Length: 2") + b"{}",
    ]


def run(report: Report, program: str, full: bool) -> None:
    injection(report, program)
    stalled_reader(report, program, MANY * (5 if full else 1))
    full_disk(report, program)


def injection(report: Report, program: str) -> None:
    with tempfile.TemporaryFile() as log:
        with Program(program, *LEVEL, log=log) as server:
            requests = hostile()
            for request in requests:
                try:
                    exchange(server.address, request, 1)
                except WireError as error:
                    report.check("an answer to a hostile request", False, error)
            report.check("well afterwards", server.is_well())
            metrics = server.request("GET", "/metrics", admin=True).body.decode()
            stop(server)
        log.seek(0)
        text = log.read()
    report.check("nothing secret in the metrics", SECRET not in metrics)
    report.check("nothing secret in the log", SECRET.encode() not in text, re.findall(rb".*" + SECRET.encode() + rb".*", text)[:1])
    lines = text.split(b"\n")
    report.equal("the log ends with a line's end", lines.pop(), b"")
    report.check("every request has its line", len(lines) >= len(requests), len(lines))
    wrong = [each for each in lines if not is_record(each)]
    report.check("every line is one object", not wrong, wrong[:1])
    report.check("no line is forged", not any(b"forged" in each for each in lines))
    report.check("no control character", not re.search(rb"[\x00-\x09\x0b-\x1f\x7f-\xff]", text), "one is there")


def is_record(text: bytes) -> bool:
    try:
        record = json.loads(text)
    except ValueError:
        return False
    return isinstance(record, dict) and {"ts", "level", "msg"} <= record.keys()


def stalled_reader(report: Report, program: str, count: int) -> None:
    """A pipe that nobody reads: the log loses lines and counts them; requests lose nothing."""
    reading, writing = os.pipe()
    try:
        with Program(program, *LEVEL, log=writing) as server:
            answered, slowest = 0, 0.0
            for _ in range(count // BATCH):
                begin = time.monotonic()
                answered += exchange(server.address, INNOCENT * BATCH, BATCH).statuses == [200] * BATCH
                slowest = max(slowest, time.monotonic() - begin)
            report.equal("answers while nobody reads the log", answered, count // BATCH)
            report.check("well while nobody reads the log", server.is_well())
            report.note(f"{answered * BATCH} answers, slowest batch of {BATCH} {slowest * 1e3:.0f} ms")
            dropped = re.search(rb"^tuftwave_log_lines_dropped_total (\d+)", server.request("GET", "/metrics", admin=True).body, re.M)
            report.check("lost lines are counted", dropped is not None and int(dropped[1]) > 0, dropped)
            begin = time.monotonic()
            report.equal("it ends all the same", stop(server), 0)
            report.check("and soon", time.monotonic() - begin < END_S, f"{time.monotonic() - begin:.1f} s")
    finally:
        os.close(reading)
        os.close(writing)


def full_disk(report: Report, program: str) -> None:
    with open("/dev/full", "wb") as full:
        with Program(program, *LEVEL, log=full) as server:
            for _ in range(20):
                exchange(server.address, INNOCENT * BATCH, BATCH)
            report.check("well with a full disk for its log", server.is_well())
            report.equal("examples with a full disk for its log", server.answers_examples(), [])
            dropped = re.search(rb"^tuftwave_log_lines_dropped_total (\d+)", server.request("GET", "/metrics", admin=True).body, re.M)
            report.check("lost lines are counted", dropped is not None and int(dropped[1]) > 0, dropped)
            report.equal("it ends in order", stop(server), 0)
