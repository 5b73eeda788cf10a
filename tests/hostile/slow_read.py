"""Clients that ask for much and read a few bytes a second lose their connection in time; a steady one gets everything."""

from __future__ import annotations

import json
import socket
import time

import contract
from report import Report
from running import MIB, Program, eventually

READERS = 8
BUFFER = 2_048  # bytes that such a client's system takes in ahead
ANSWER_S, BYTES_PER_S = 15.0, 64 * 1024
GRACE_S = 6.0
FIRST_S = 5.0  # in which they must be served
STEADY_BYTES_PER_S = 256 * 1024
COPIES = 12  # of the example's tufts: an answer larger than what a system buffers for a sender, which is 2.6 MB here


def big_request() -> bytes:
    body = contract.example("hairstyles")
    body["tufts"] = [{**tuft, "name": f"{tuft['name']}_{i}"} for i in range(COPIES) for tuft in body["tufts"]]
    data = json.dumps(body).encode()
    return b"POST /v1/hairstyles HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: %d\r\n\r\n" % len(data) + data


def run(report: Report, program: str, full: bool) -> None:
    if not full:
        report.skip("slow readers", "they have up to a minute and a half; --full waits for them")
        return
    request = big_request()
    with Program(program) as server:
        size = len(server.post("/v1/hairstyles", request.partition(b"\r\n\r\n")[2]).body)
        before = server.descriptors()
        readers = [slow_reader(server, request) for _ in range(READERS)]
        deadline = ANSWER_S + size / BYTES_PER_S
        report.note(f"{READERS} readers of {size / MIB:.1f} MiB, whose deadline is {deadline:.0f} s")
        time.sleep(FIRST_S)
        report.equal("they are served at first", server.descriptors() - before, READERS)
        report.check("an innocent client among them", server.is_well())
        begin = time.monotonic()
        gone = eventually(lambda: sip(readers) or server.descriptors() <= before, deadline - FIRST_S + GRACE_S)
        report.check("slow readers are cut off", gone, f"{server.descriptors() - before} of {READERS} still held after {time.monotonic() - begin + FIRST_S:.0f} s")
        report.note(f"cut off after {time.monotonic() - begin + FIRST_S:.0f} s")
        for reader in readers:
            reader.close()
        steady(report, server, request, size)
        report.check("well afterwards", server.is_well())


def steady(report: Report, server: Program, request: bytes, size: int) -> None:
    """Slower than any line that is still in use, but without a pause."""
    reader = slow_reader(server, request)
    reader.settimeout(10)
    received, begin = 0, time.monotonic()
    try:
        while received < size:
            received += len(reader.recv(STEADY_BYTES_PER_S // 20)) or size * 2  # the end would be too early
            time.sleep(max(0.0, received / STEADY_BYTES_PER_S - (time.monotonic() - begin)))
    except OSError as error:
        report.note(str(error))
    reader.close()
    report.check("a steady reader gets everything", size <= received < size * 2, f"{received} of {size} bytes after {time.monotonic() - begin:.0f} s")


def slow_reader(server: Program, request: bytes) -> socket.socket:
    reader = socket.socket()
    reader.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, BUFFER)
    reader.settimeout(10)
    reader.connect(server.address)
    reader.sendall(request)
    reader.setblocking(False)
    return reader


def sip(readers: list[socket.socket]) -> bool:
    """Each reads a byte, fifty times a second. @return  False"""
    for reader in readers:
        try:
            reader.recv(1)
        except OSError:
            pass
    return False
