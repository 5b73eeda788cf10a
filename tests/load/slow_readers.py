"""900 clients that ask for much and read a few bytes a second: what they hold of the server's memory is bounded.

    python3 tests/load/slow_readers.py [--readers 900] [--seconds 40]

Once for the largest answer that is computed and once for the largest file that is served. Who is refused asks again, as an
attacker would. Memory counts from the time on when all have their answer's beginning or a refusal, since what an answer
costs while it is computed is another goal (memory.py). Exit code 1 if a goal is missed.
"""

from __future__ import annotations

import json
import re
import socket
import subprocess
import sys
import tempfile
import time

from loading import MIB, QUIET, Goals, Program, arguments, command, contract, count, finished, hairstyle, quantile

BEYOND = 64 * MIB  # over the budget for answers
BUFFER = 2_048
SIP, TICK_S = 16, 0.25
HEAD = b"%b %b HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: %d\r\n\r\n"


def largest(limits: dict[str, int]) -> bytes:
    """As many of the largest tufts as one request may ask for."""
    rings, sides = 4_096, 64
    body = contract.example("hairstyles")
    body["tufts"] = [{**body["tufts"][0], "name": f"t{i}"} for i in range(limits["vertices"] // (rings * (sides + 1) + 2))]
    body["mesh"] = {"rings": rings, "sides": sides}
    text = json.dumps(body).encode()
    return HEAD % (b"POST", b"/v1/hairstyles", len(text)) + text


def file(_: dict[str, int]) -> bytes:
    return b"GET /docs/swagger-ui-bundle.js HTTP/1.1\r\nHost: localhost\r\n\r\n"


class Reader:
    """Asks, and asks again when it is refused."""

    def __init__(self, server: Program, request: bytes) -> None:
        self.server, self.request = server, request
        self.connection: socket.socket = socket.socket()
        self.taken = self.refused = 0
        self.begin()

    def begin(self) -> None:
        self.connection = socket.socket()
        self.connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, BUFFER)
        self.connection.settimeout(10)
        self.begun, self.first = False, b""
        try:
            self.connection.connect(self.server.address)
            self.connection.sendall(self.request)
        except OSError:
            pass  # noticed at the next sip
        self.connection.setblocking(False)

    def sip(self) -> None:
        try:
            got = self.connection.recv(SIP)
            self.first += got[:16 - len(self.first)]
            if not self.begun and len(self.first) >= 12:
                self.begun = True
                self.taken += self.first.startswith(b"HTTP/1.1 200")
                self.refused += self.first.startswith(b"HTTP/1.1 503")
            if got and not (self.begun and not self.first.startswith(b"HTTP/1.1 200")):
                return
        except BlockingIOError:
            return
        except OSError:
            pass
        self.connection.close()
        self.begin()


def budget(program: str) -> int:
    """The budget for answers in bytes, which the program says itself."""
    said = json.loads(subprocess.run([program, "--print-config"], capture_output=True, check=True).stdout)
    return int(said["answer-memory"]) * MIB


def main() -> int:
    options = arguments(__doc__ or "", readers={"type": int, "default": 900}, seconds={"type": float, "default": 40})
    goals = Goals()
    allowed = budget(options.server)
    for kind, asked in {"the largest computed answer": largest, "the largest file": file}.items():
        with tempfile.NamedTemporaryFile() as body, Program(options.server, *QUIET) as server:
            body.write(hairstyle(1))
            body.flush()
            idle, begin = server.resident(), time.monotonic()
            held: list[int] = []
            request = asked(server.get("/v1/limits").json()["counts"])
            readers = [Reader(server, request) for _ in range(options.readers)]
            healthy = subprocess.Popen(command(options.generator, server, "/v1/version", None, 20, options.seconds, 4), stdout=subprocess.PIPE)
            while healthy.poll() is None:
                if time.monotonic() - begin > options.seconds / 2:
                    held.append(server.resident())
                for reader in readers:
                    reader.sip()
                time.sleep(TICK_S)
            figures = finished(healthy)
            metrics = server.request("GET", "/metrics", admin=True).body.decode()
            taken, refused = sum(reader.taken for reader in readers), sum(reader.refused for reader in readers)
            print(f"{options.readers} readers of {kind}: {taken} answers begun, {refused} refused, healthy p99 {quantile(figures, 200):.1f} ms of {count(figures, 200)}")
            print(f"  {idle / MIB:.0f} MiB when idle, {max(held) / MIB:.0f} MiB held, {server.peak() / MIB:.0f} MiB at most, budget {allowed / MIB:.0f} MiB")
            print("  " + "; ".join(re.findall(r"^tuftwave_[a-z_]*(?:answer|connection)[a-z_]* \S+$", metrics, re.M)))
            goals.at_most(f"{kind}: memory held", max(held) / MIB, (allowed + BEYOND) / MIB, "MiB")
            goals.at_least(f"{kind}: readers that got their answer's beginning", sum(reader.taken for reader in readers), 1)
            goals.equal(f"{kind}: well meanwhile", server.request("GET", "/livez", admin=True).status, 200)
            for reader in readers:
                reader.connection.close()
            goals.equal(f"{kind}: well afterwards", server.is_well(), True)
    return goals.exit_code


if __name__ == "__main__":
    sys.exit(main())
