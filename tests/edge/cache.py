"""deploy/nginx/nginx.conf, with other ports and in a folder of its own, in front of one replica."""

from __future__ import annotations

import os
import shutil
import socket
import subprocess
import tempfile
from collections.abc import Iterator
from typing import Any

from edge import ROOT, Replica, free_ports, wait_until
from wire import Answer, Connection, request, schedule, schedule_body

CONFIGURATION = os.path.join(ROOT, "deploy", "nginx", "nginx.conf")
NGINX = shutil.which("nginx", path=os.environ.get("PATH", "") + ":/usr/sbin:/usr/local/sbin")
LARGE = 200_000  # bytes, more than nginx keeps in memory


class Cache:
    def __init__(self, upstream_port: int) -> None:
        self.address = ("127.0.0.1", free_ports(1)[0])
        self._upstream_port = upstream_port

    def __enter__(self) -> "Cache":
        self._folder = tempfile.TemporaryDirectory()
        os.chmod(self._folder.name, 0o755)  # as root, nginx's workers are somebody else
        with open(CONFIGURATION, encoding="utf-8") as file:
            text = file.read()
        for given, own in (("server 127.0.0.1:8080;", f"server 127.0.0.1:{self._upstream_port};"),
                           ("listen 8090 ", f"listen 127.0.0.1:{self.address[1]} "), ("/dev/stdout", "access.log")):
            if given not in text:
                raise RuntimeError(f"nginx.conf has no {given!r} any more")
            text = text.replace(given, own)
        self._file = os.path.join(self._folder.name, "nginx.conf")
        with open(self._file, "w", encoding="utf-8") as file:
            file.write(text)
        return self

    def command(self, *flags: str) -> list[str]:
        if not NGINX:
            raise RuntimeError("there is no nginx; script/setup edge installs it")
        return [NGINX, "-e", "stderr", "-p", self._folder.name, "-c", self._file, *flags]

    def start(self) -> None:
        self._process = subprocess.Popen(self.command("-g", "daemon off;"), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        wait_until(self._listens, "nginx listened")

    def _listens(self) -> bool:
        if self._process.poll() is not None:
            raise RuntimeError("nginx has ended")
        with socket.socket() as probe:
            return probe.connect_ex(self.address) == 0

    def stop(self) -> None:
        self._process.terminate()
        try:
            self._process.wait(10)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()

    def __exit__(self, *_: Any) -> None:
        self._folder.cleanup()

    def ask(self, data: bytes) -> Answer:
        with Connection(self.address) as connection:
            return connection.ask(data)


def nginx_refuses() -> str:
    """What nginx -t says against the file, or nothing."""
    try:
        with Cache(1) as cache:
            done = subprocess.run(cache.command("-t"), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False, timeout=60)
    except RuntimeError as fault:
        return str(fault)
    words = done.stdout.decode()
    return words if done.returncode != 0 or "[warn]" in words else ""


def check_cache(program: str) -> Iterator[str]:
    """Faults of what the cache says it has: each row is asked once, its X-Cache and the number of computations compared."""
    if not NGINX:
        return
    replica = Replica(program)
    replica.start()
    try:
        with Cache(replica.port) as cache:
            cache.start()
            try:
                yield from faults(cache, replica)
            finally:
                cache.stop()
    finally:
        replica.kill()


def faults(cache: Cache, replica: Replica) -> Iterator[str]:
    padded = [schedule_body(number) + b" " * LARGE for number in (5, 6)]
    answers: dict[str, bytes] = {}
    for name, data, wanted in (
            ("first", schedule(1), "MISS"),
            ("again", schedule(1), "HIT"),
            ("another body", schedule(2), "MISS"),
            ("another format", request("POST", "/v1/schedules", schedule_body(1), "Accept: text/csv"), "MISS"),
            ("another query", request("POST", "/v1/schedules?format=csv", schedule_body(1)), "MISS"),
            ("another key", request("POST", "/v1/schedules", schedule_body(1), "Authorization: Bearer other"), "MISS"),
            ("a refusal", request("POST", "/v1/schedules", b"{"), "MISS"),
            ("a refusal again", request("POST", "/v1/schedules", b"{"), "MISS"),
            ("GET", request("GET", "/v1/version"), "BYPASS"),
            ("a large body", request("POST", "/v1/schedules", padded[0]), "BYPASS"),
            ("another large body", request("POST", "/v1/schedules", padded[1]), "BYPASS")):
        answer = cache.ask(data)
        answers[name] = answer.body
        got = answer.headers.get("x-cache")
        if got != wanted:
            yield f"nginx: {name} is {got} instead of {wanted} ({answer.status})"
    if answers["first"] != answers["again"] or answers["a large body"] == answers["another large body"]:
        yield "nginx: the cache mixes answers up"
    if (computed := replica.count("tuftwave_http_requests_total", 'method="POST"')) != 9:
        yield f"nginx: {computed:.0f} requests of 10 reached the replica, instead of 9"
