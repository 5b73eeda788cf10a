"""Replicas of the server behind HAProxy with deploy/haproxy/haproxy.cfg, all on free ports of the loopback.

    with Edge("build/release/server/tuftwave-server") as edge:
        edge.replicas[0].kill(); edge.replicas[0].start()      # on the ports that it had

Everything is ended by its process id when the block ends. Needs Debian's haproxy.
"""

from __future__ import annotations

import os
import random
import re
import shutil
import signal
import socket
import subprocess
import tempfile
import threading
import time
from typing import Any, Callable, Optional

from wire import Broken, Connection, request

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
CONFIGURATION = os.path.join(ROOT, "deploy", "haproxy", "haproxy.cfg")
HAPROXY = shutil.which("haproxy", path=os.environ.get("PATH", "") + ":/usr/sbin:/usr/local/sbin")
START_S = 20.0
SAMPLE = re.compile(r'^(\w+)(?:\{(.*)\})? (\S+)$', re.MULTILINE)
# Every client of a test has one address, so the limits per source are out of the way unless they are what is tested.
UNLIMITED = {"TUFTWAVE_SOURCE_CONNECTIONS": "1000000", "TUFTWAVE_SOURCE_REQUESTS": "100000000"}


def free_ports(count: int) -> list[int]:
    """Ports nobody listens on, below those that outgoing connections are given: a replica that comes back needs its own again."""
    with open("/proc/sys/net/ipv4/ip_local_port_range", encoding="ascii") as file:
        first = int(file.read().split()[0])
    found: list[int] = []
    while len(found) < count:
        port = random.randrange(10_000, max(first, 20_000))
        with socket.socket() as probe:
            try:
                probe.bind(("127.0.0.1", port))
            except OSError:
                continue
        if port not in found:
            found.append(port)
    return found


def without_settings() -> dict[str, str]:
    return {name: value for name, value in os.environ.items() if not name.startswith("TUFTWAVE_") and name != "PORT"}


def wait_until(holds: Callable[[], bool], what: str, timeout_s: float = START_S) -> None:
    end = time.monotonic() + timeout_s
    while not holds():
        if time.monotonic() > end:
            raise RuntimeError(f"waited {timeout_s:g} s in vain until {what}")
        time.sleep(0.02)


def samples(address: tuple[str, int]) -> dict[tuple[str, str], float]:
    """What /metrics there says: (name, labels) to value. Raises Broken, OSError."""
    # HTTP/1.0, since HAProxy's own exporter would answer in chunks.
    with Connection(address, 5) as connection:
        connection.send(b"GET /metrics HTTP/1.0\r\n\r\n")
        text = connection.rest().decode()
    return {(name, labels): float(value) for name, labels, value in SAMPLE.findall(text)}


class Replica:
    """A server that can end and begin again on the ports it had."""

    def __init__(self, program: str, *flags: str) -> None:
        self.port, self.admin_port = free_ports(2)
        self._command = [os.path.abspath(program), "--host", "127.0.0.1", "--port", str(self.port), "--admin-host", "127.0.0.1",
                         "--admin-port", str(self.admin_port), *flags]
        self._process: Optional[subprocess.Popen[bytes]] = None

    def start(self) -> None:
        self._process = subprocess.Popen(self._command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, env=without_settings())
        giving_up = threading.Timer(START_S, self._process.kill)
        giving_up.start()
        line = self._process.stdout.readline().decode()
        giving_up.cancel()
        if " listening on " not in line:
            self.kill()
            raise RuntimeError(f"{self._command[0]} did not say that it is ready, but {line!r}")
        threading.Thread(target=self._process.stdout.read, daemon=True).start()

    def stop(self, timeout_s: float = 20.0) -> int:
        """SIGTERM, and the exit code; what has not ended in time is killed and raises RuntimeError."""
        self._process.send_signal(signal.SIGTERM)
        try:
            return self._process.wait(timeout_s)
        except subprocess.TimeoutExpired:
            self.kill()
            raise RuntimeError(f"a replica did not end within {timeout_s:g} s after SIGTERM") from None

    def kill(self) -> None:
        if self._process and self._process.poll() is None:
            self._process.kill()
        if self._process:
            self._process.wait()

    @property
    def address(self) -> tuple[str, int]:
        return ("127.0.0.1", self.port)

    @property
    def is_running(self) -> bool:
        return self._process is not None and self._process.poll() is None

    def count(self, name: str, labels: str = "") -> float:
        """A metric, summed over those of its samples whose labels contain `labels`; 0 if there is none."""
        found = samples(("127.0.0.1", self.admin_port))
        return sum(value for (sample, with_labels), value in found.items() if sample == name and labels in with_labels)

    def answered(self) -> float:
        return self.count("tuftwave_http_requests_total")


class Proxy:
    """HAProxy in front of (host:port, admin port) pairs. `settings` are variables of its configuration file."""

    def __init__(self, backends: list[tuple[int, int]], **settings: str) -> None:
        self.port, self.admin_port = free_ports(2)
        self._environment = {**without_settings(), **UNLIMITED, "TUFTWAVE_BIND": f"127.0.0.1:{self.port}",
                             "TUFTWAVE_EDGE_ADMIN": f"127.0.0.1:{self.admin_port}", "TUFTWAVE_MAXCONN": "1000",
                             "TUFTWAVE_REUSE": "always", **settings}
        for number, (port, admin_port) in enumerate(backends, 1):
            self._environment[f"TUFTWAVE_REPLICA_{number}"] = f"127.0.0.1:{port}"
            self._environment[f"TUFTWAVE_ADMIN_PORT_{number}"] = str(admin_port)
        self._count = len(backends)
        self._log = tempfile.TemporaryFile()

    def __enter__(self) -> "Proxy":
        if not HAPROXY:
            raise RuntimeError("there is no haproxy; script/setup edge installs it")
        self._process = subprocess.Popen([HAPROXY, "-db", "-f", CONFIGURATION], stdout=self._log, stderr=subprocess.STDOUT,
                                         env=self._environment)
        try:
            wait_until(self._has_all, "HAProxy had found every replica")
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_: Any) -> None:
        if self._process.poll() is None:
            self._process.kill()
        self._process.wait()
        self._log.close()

    def _has_all(self) -> bool:
        if self._process.poll() is not None:
            self._log.seek(0)
            raise RuntimeError("HAProxy has ended: " + self._log.read().decode()[-2000:])
        return self.up() == set(range(1, self._count + 1)) and self._has_checked()

    def _has_checked(self) -> bool:
        # A server counts as up before its first check.
        return sum(self._servers("haproxy_server_check_status", 'state="L7OK"').values()) == self._count

    def _servers(self, name: str, labels: str = "") -> dict[int, float]:
        try:
            found = samples(("127.0.0.1", self.admin_port))
        except (Broken, OSError):
            return {}
        return {int(match[1]): value for (sample, with_labels), value in found.items()
                if sample == name and labels in with_labels and (match := re.search(r'server="replica(\d+)"', with_labels))}

    def up(self) -> set[int]:
        """Numbers of the replicas that are given requests."""
        return {number for number, value in self._servers("haproxy_server_status", 'state="UP"').items() if value}

    def repeated(self) -> float:
        """Requests that were sent once more: after a failed connection, or after a failed answer."""
        return sum(sum(self._servers(f"haproxy_server_{kind}_warnings_total").values()) for kind in ("redispatch", "retry"))

    def memory_mib(self) -> float:
        with open(f"/proc/{self._process.pid}/status", encoding="ascii") as file:
            return int(re.search(r"VmRSS:\s+(\d+)", file.read())[1]) / 1024

    @property
    def address(self) -> tuple[str, int]:
        return ("127.0.0.1", self.port)

    def connect(self, timeout_s: float = 30.0) -> Connection:
        return Connection(self.address, timeout_s)

    def get(self, target: str) -> Any:
        with self.connect() as connection:
            return connection.ask(request("GET", target))


class Edge:
    """Three replicas and the proxy. `flags` go to each replica, `settings` to the proxy."""

    def __init__(self, program: str, *flags: str, **settings: str) -> None:
        self.replicas = [Replica(program, *flags) for _ in range(3)]
        self.proxy = Proxy([(replica.port, replica.admin_port) for replica in self.replicas], **settings)

    def __enter__(self) -> "Edge":
        try:
            for replica in self.replicas:
                replica.start()
            self.proxy.__enter__()
        except BaseException:
            self._end_replicas()
            raise
        return self

    def __exit__(self, *_: Any) -> None:
        self.proxy.__exit__()
        self._end_replicas()

    def _end_replicas(self) -> None:
        for replica in self.replicas:
            replica.kill()
