"""Whole requests over HTTP, the service beside what its library does by itself, in turns.

    python3 tests/bench/http/compare.py --server build/release/server/tuftwave-server

Prints one line of JSON for each figure: {"name", "value": [...], "unit"} or {"name", "ms": [...]}, one sample a round. Names
end in the program: tuftwave, or peer (peer.cpp). Programs serve on free ports of 127.0.0.1.
"""

from __future__ import annotations

import argparse
import json
import os
import selectors
import socket
import statistics
import subprocess
import sys
import tempfile
import time
from typing import Any, Callable, Iterator, Optional, cast

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "..", "..", ".."))
sys.dont_write_bytecode = True
sys.path[:0] = [os.path.join(ROOT, "tests", "load")]

from loading import MIB, QUIET, Figures, Program  # noqa: E402

ONE_TUFT = {"tufts": [{"points": [[0.02, 0.097, 0.02], [0.025, 0.08, 0.075], [0.03, 0.035, 0.108], [0.03, -0.01, 0.11]]}]}
PAGE = "/studio/studio.js"  # about 1 MiB, and no work to make
CLIENTS = 64
CONNECTS = 1000
SLOW_CLIENTS = 64
PATIENCE_S = 5.0  # of a client in a crowd before it counts as never answered
VERSION = b"GET /v1/version HTTP/1.1\r\nHost: localhost\r\n\r\n"

Sample = Callable[[], float]


def tell(name: str, samples: list[float], unit: str) -> None:
    row = {"name": name, "ms": samples} if unit == "ms" else {"name": name, "value": samples, "unit": unit}
    print(json.dumps(row), flush=True)


class Peer:
    """peer.cpp with its files. Use as a context manager."""

    def __init__(self, program: str, *files: str) -> None:
        self._command = [program, *files]

    def __enter__(self) -> "Peer":
        self._process = subprocess.Popen(self._command, stdout=subprocess.PIPE)
        assert self._process.stdout
        self.port = int(self._process.stdout.readline())
        return self

    def __exit__(self, *_: Any) -> None:
        self._process.kill()
        self._process.wait()

    @property
    def pid(self) -> int:
        return self._process.pid


class Bench:
    """Asks and takes samples, the programs in turns, so that a machine that drifts is slow for both."""

    def __init__(self, generator: str, rounds: int, seconds: float) -> None:
        self._generator, self._rounds, self._seconds = generator, rounds, seconds

    def ask(self, port: int, path: str, body: Optional[str], connections: int) -> Figures:
        said = subprocess.run([self._generator, str(port), path, body or "-", "0", str(self._seconds), str(connections)], stdout=subprocess.PIPE, check=True)
        figures: Figures = json.loads(said.stdout)
        if list(figures["answers"]) != ["200"] or figures["lost"]:
            raise RuntimeError(f"{path}: not every answer is 200: {figures}")
        return figures

    def rate(self, *what: Any) -> Sample:
        """Requests a second."""
        def sample() -> float:
            figures = self.ask(*what)
            return float(figures["answers"]["200"]["count"] / figures["seconds"])
        return sample

    def median(self, *what: Any) -> Sample:
        """Milliseconds from a request to the end of its answer."""
        return lambda: float(self.ask(*what)["answers"]["200"]["p50"])

    def processor(self, pid: int, *what: Any) -> Sample:
        """Milliseconds of the server's processor for each answer."""
        def sample() -> float:
            before = processor_seconds(pid)
            answers = self.ask(*what)["answers"]["200"]["count"]
            return (processor_seconds(pid) - before) * 1e3 / float(answers)
        return sample

    def compare(self, name: str, unit: str, samples: dict[str, Sample]) -> None:
        taken: dict[str, list[float]] = {program: [] for program in samples}
        for _ in range(self._rounds):
            for program, sample in samples.items():
                taken[program].append(sample())
        for program, values in taken.items():
            tell(f"{name}/{program}", values, unit)


def processor_seconds(pid: int) -> float:
    """Of all its threads, finer than the hundredths that /proc/PID/stat has."""
    total = 0
    for thread in os.listdir(f"/proc/{pid}/task"):
        with open(f"/proc/{pid}/task/{thread}/schedstat", encoding="ascii") as stat:
            total += int(stat.read().split()[0])
    return total / 1e9


def crowd(port: int, count: int, seconds: float) -> tuple[list[float], int]:
    """That many clients connect at once and ask; each asks again as soon as it is answered, for so many seconds.

    @return  seconds until the first answer of each that had one, and how many had none
    """
    selector, begin = selectors.DefaultSelector(), time.monotonic()
    clients = [socket.socket() for _ in range(count)]
    for client in clients:
        client.setblocking(False)
        client.connect_ex(("127.0.0.1", port))
        selector.register(client, selectors.EVENT_WRITE)
    first: dict[socket.socket, float] = {}
    failed = 0

    def is_over(now: float) -> bool:
        return now >= begin + (seconds if len(first) + failed == count else PATIENCE_S)

    while not is_over(time.monotonic()):
        for key, events in selector.select(0.05):
            client = cast(socket.socket, key.fileobj)
            try:
                if events & selectors.EVENT_READ:
                    if not client.recv(65536).startswith(b"HTTP/1.1 200"):
                        raise ConnectionError("refused")
                    first.setdefault(client, time.monotonic() - begin)
                if events & selectors.EVENT_WRITE or time.monotonic() < begin + seconds:
                    client.send(VERSION)
                selector.modify(client, selectors.EVENT_READ)
            except OSError:
                failed += client not in first
                selector.unregister(client)
    for client in clients:
        client.close()
    return list(first.values()), count - len(first)


def beside_slow_clients(port: int, body: str, drip_body: bool) -> float:
    """Milliseconds that a good client waits while others send their heads, or their bodies, a byte at a time."""
    begun = b"POST /v1/tufts HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: 60000\r\n"
    slow = [socket.create_connection(("127.0.0.1", port)) for _ in range(SLOW_CLIENTS)]
    for client in slow:
        client.sendall(begun + (b"\r\n" if drip_body else b"x-slow: "))
    for _ in range(3):
        time.sleep(0.05)
        for client in slow:
            client.sendall(b" " if drip_body else b"x")
    with open(body, "rb") as file:
        bytes_of_body = file.read()
    begin = time.monotonic()
    with socket.create_connection(("127.0.0.1", port)) as good:
        good.sendall(b"POST /v1/tufts HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: %d\r\n\r\n" % len(bytes_of_body) + bytes_of_body)
        if not good.recv(65536).startswith(b"HTTP/1.1 200"):
            raise RuntimeError("the good client was refused")
    took = (time.monotonic() - begin) * 1e3
    for client in slow:
        client.close()
    return took


def starts(server: str, rounds: int) -> Iterator[tuple[float, float]]:
    """Milliseconds from the start to the ready line, and MiB that it then holds."""
    for _ in range(rounds):
        begin = time.monotonic()
        with Program(server, *QUIET) as program:
            ready = (time.monotonic() - begin) * 1e3
            program.is_well()
            yield ready, program.resident() / MIB


def made(program: Program, path: str, body: bytes, to: str) -> str:
    """Keeps an answer for the peer to give."""
    answer = program.request("POST", path, body, {"Content-Type": "application/json"})
    if answer.status != 200:
        raise RuntimeError(f"{path}: {answer.status} {answer.body[:200]!r}")
    with open(to, "wb") as file:
        file.write(answer.body)
    return to


def written(path: str, content: bytes) -> str:
    with open(path, "wb") as file:
        file.write(content)
    return path


def head_of_65(work: str) -> Optional[str]:
    """The moving hairstyle of a VRoid head, if the tool that makes it runs."""
    to = os.path.join(work, "head.json")
    tool = os.path.join(ROOT, "client-examples", "pipeline", "strokes_to_hairstyle.py")
    strokes = os.path.join(ROOT, "tests", "data", "strokes", "vroid_Vita.strokes.json")
    done = subprocess.run([sys.executable, tool, strokes, "--motion", "breeze", "--out", to], stdout=subprocess.DEVNULL, check=False)
    return to if done.returncode == 0 else None


def measure(options: argparse.Namespace, program: Program, work: str, only: Callable[[str], bool]) -> None:
    one = written(os.path.join(work, "one.json"), json.dumps(ONE_TUFT).encode())
    thousand = os.path.join(work, "thousand.json")
    with open(thousand, "wb") as file:
        subprocess.run([sys.executable, os.path.join(ROOT, "tests", "bench", "thousand_strokes.py")], stdout=file, check=True)
    with open(thousand, "rb") as file:
        thousand_answer = made(program, "/v1/tufts", file.read(), os.path.join(work, "thousand.glb"))
    one_answer = made(program, "/v1/tufts", json.dumps(ONE_TUFT).encode(), os.path.join(work, "one.glb"))
    page = program.get(PAGE)
    if page.status != 200:
        print(f"{PAGE} was not built in: no figure for 1 MiB", file=sys.stderr)
    page_file = written(os.path.join(work, "page"), page.body)

    bench = Bench(options.generator, options.rounds, options.seconds)
    with Peer(options.peer, one_answer, thousand_answer, page_file) as peer:
        ours, theirs, admin = program.port, peer.port, program.admin_port
        if only("null"):
            bench.compare("http/null", "requests/s", {"health": bench.rate(admin, "/livez", None, 8), "tuftwave": bench.rate(ours, "/v1/version", None, 8), "peer": bench.rate(theirs, "/null", None, 8)})
        if only("round_trip"):
            bench.compare("http/round_trip", "ms", {"tuftwave": bench.median(ours, "/v1/version", None, 1), "peer": bench.median(theirs, "/null", None, 1)})
        if only("one_tuft"):
            bench.compare("http/one_tuft", "requests/s", {"tuftwave": bench.rate(ours, "/v1/tufts", one, 8), "peer": bench.rate(theirs, "/same/0", one, 8)})
        if only("thousand_strokes"):
            bench.compare("http/thousand_strokes", "ms", {"tuftwave": bench.median(ours, "/v1/tufts", thousand, 1), "peer": bench.median(theirs, "/same/1", thousand, 1)})
        if only("mebibyte") and page.status == 200:
            bench.compare("http/mebibyte_processor", "ms", {"tuftwave": bench.processor(program.pid, ours, PAGE, None, 1), "peer": bench.processor(peer.pid, theirs, "/same/2", None, 1)})
    head = head_of_65(work) if only("head") else None
    if head:
        bench.compare("http/head_of_65_tufts", "ms", {"tuftwave": bench.median(ours, "/v1/hairstyles", head, 1)})
    if only("crowd"):
        crowds(options, program, one)


def crowds(options: argparse.Namespace, program: Program, one: str) -> None:
    for name, count, go_on in (("keep_alive_64", CLIENTS, 1.0), ("connects_1000", CONNECTS, 0.0)):
        waits = [crowd(program.port, count, go_on) for _ in range(options.rounds)]
        tell(f"http/{name}_never/tuftwave", [float(never) for _, never in waits], "clients")
        tell(f"http/{name}_slowest/tuftwave", [max(first) * 1e3 for first, _ in waits], "ms")
    for name, drip_body in (("slow_heads", False), ("slow_bodies", True)):
        tell(f"http/{name}/tuftwave", [beside_slow_clients(program.port, one, drip_body) for _ in range(options.rounds)], "ms")


def main() -> None:
    built = os.path.join(ROOT, "build", "bench")
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--server", default=os.path.join(built, "server", "tuftwave-server"))
    parser.add_argument("--generator", default=os.path.join(built, "tests", "tuftwave_load"))
    parser.add_argument("--peer", default=os.path.join(built, "tests", "tuftwave_http_peer"))
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--seconds", type=float, default=1.0, help="of each sample")
    parser.add_argument("--only", nargs="*", default=[], help="null round_trip one_tuft thousand_strokes mebibyte head crowd start")
    parser.add_argument("--medians", action="store_true", help="one line of text for each figure instead, to read")
    options = parser.parse_args()
    if options.medians:
        globals()["tell"] = lambda name, samples, unit: print(f"{name:40} {statistics.median(samples):12,.4g} {unit}", flush=True)

    def only(name: str) -> bool:
        return not options.only or name in options.only

    with tempfile.TemporaryDirectory() as work, Program(options.server, *QUIET) as program:
        measure(options, program, work, only)
    if only("start"):
        seen = list(starts(options.server, max(10, options.rounds)))
        tell("http/start_to_ready/tuftwave", [ready for ready, _ in seen], "ms")
        tell("http/idle_memory/tuftwave", [held for _, held in seen], "MiB")


if __name__ == "__main__":
    main()
