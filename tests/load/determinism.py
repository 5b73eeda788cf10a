"""One SHA-256 per request: over 1,000 repeats, 1 to 16 workers, replicas started afresh, builds, and with and without FMA.

    python3 tests/load/determinism.py [--repeats 1000] [--also build/clang/server/tuftwave-server ...]

Every example of the contract in each of its formats, several at once. Exit code 1 if any request has two hashes.
"""

from __future__ import annotations

import hashlib
import http.client
import os
import sys
import threading
import time
from typing import Iterator, NamedTuple

from loading import QUIET, Goals, Program, arguments, contract

WORKERS = range(1, 17)
REPLICAS = 3
CLIENTS = 4
WITHOUT_FMA = "glibc.cpu.hwcaps=-FMA,-AVX2,-FMA_Usable,-AVX2_Usable"  # as in tests/determinism/compare.sh


class Request(NamedTuple):
    name: str
    target: str
    body: bytes
    headers: dict[str, str]


def requests() -> list[Request]:
    found = []
    for operation in contract.posts() + contract.uploads():
        body, headers = contract.sample(operation)
        for word in contract.formats(operation) or [""]:
            target = operation.path + (f"?format={word}" if word else "")
            found.append(Request(target, target, body or b"", headers))
    return found


class Hashes:
    """What each request was answered with, wherever."""

    def __init__(self) -> None:
        self.seen: dict[str, set[str]] = {}
        self.answers = 0
        self.faults: list[str] = []
        self.lock = threading.Lock()

    def add(self, name: str, status: int, body: bytes) -> None:
        digest = hashlib.sha256(body).hexdigest()
        with self.lock:
            self.answers += 1
            self.seen.setdefault(name, set()).add(digest)
            if status != 200:
                self.faults.append(f"{name}: {status}")


def ask(server: Program, turns: Iterator[Request], hashes: Hashes, lock: threading.Lock) -> None:
    """One client: takes the next request until there are none. Refused for a moment's crowd, it asks again."""
    connection = http.client.HTTPConnection(server.host, server.port, timeout=60)
    while True:
        with lock:
            request = next(turns, None)
        if request is None:
            return connection.close()
        for _ in range(1_000):
            connection.request("POST", request.target, request.body, request.headers)
            answer = connection.getresponse()
            body = answer.read()
            if answer.status != 503:
                break
            time.sleep(0.01)
        hashes.add(request.name, answer.status, body)


def round_of(program: str, repeats: int, hashes: Hashes, *flags: str) -> None:
    """One server of its own; every request so many times, in turn, so that different ones are on their way together."""
    with Program(program, *QUIET, *flags) as server:
        turns = (request for _ in range(repeats) for request in requests())
        lock = threading.Lock()
        clients = [threading.Thread(target=ask, args=(server, turns, hashes, lock)) for _ in range(CLIENTS)]
        for client in clients:
            client.start()
        for client in clients:
            client.join()


def main() -> int:
    options = arguments(__doc__ or "", repeats={"type": int, "default": 1_000}, also={"action": "append", "default": [], "metavar": "PROGRAM", "help": "another build"})
    hashes = Hashes()
    share = -(-options.repeats // (len(WORKERS) + REPLICAS))
    for workers in WORKERS:
        round_of(options.server, share, hashes, "--workers", str(workers))
    for _ in range(REPLICAS):
        round_of(options.server, share, hashes)
    print(f"{hashes.answers} answers of {len(WORKERS)} sets of workers and {REPLICAS} replicas", flush=True)
    for program in options.also:
        round_of(os.path.abspath(program), share, hashes)
        print(f"and of {program}", flush=True)
    os.environ["GLIBC_TUNABLES"] = WITHOUT_FMA
    for program in [options.server, *options.also]:
        round_of(os.path.abspath(program), share, hashes)
    print(f"and all of them without fused multiply-add: {hashes.answers} answers")
    for name, digests in sorted(hashes.seen.items()):
        print(f"{name}: {' '.join(digest[:16] for digest in sorted(digests))}")
    goals = Goals()
    goals.at_least("answers of each request", hashes.answers / len(hashes.seen), options.repeats)
    goals.equal("requests with more than one SHA-256", sum(len(digests) > 1 for digests in hashes.seen.values()), 0)
    goals.equal("other answers than 200", len(hashes.faults), 0)
    if hashes.faults:
        print(hashes.faults[:5])
    return goals.exit_code


if __name__ == "__main__":
    sys.exit(main())
