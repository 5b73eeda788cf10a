"""The server under attack: started in any way a test needs, and looked at from outside through /proc."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import time
from typing import Any, Callable, Optional, Sequence

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "contract"))

import contract  # noqa: E402
from cell import Cell  # noqa: E402
from service import Answer, Service  # noqa: E402

DEADLINE = ("--deadline", "10")  # as by default; the contract tests' own is for sanitizers
KIB = 1024
MIB = 1024 * 1024


class Program(Service):
    """A server with limits as they are by default. Its standard error goes nowhere unless `log` is a file.

    @param prefix  a command that starts it, e.g. setpriv with its flags
    """

    def __init__(self, program: str, *flags: str, prefix: Sequence[str] = (), log: Any = subprocess.DEVNULL) -> None:
        super().__init__(program, *DEADLINE, *flags, log=log)
        self._command[:0] = prefix

    cell: Optional[Cell] = None  # where all of them live, if there is one

    def __enter__(self) -> "Program":
        super().__enter__()
        if self.cell:
            self.cell.hold(self.pid)
        return self

    @property
    def address(self) -> tuple[str, int]:
        return self.host, self.port

    def connect(self, timeout: float = 30.0) -> socket.socket:
        connection = socket.create_connection(self.address, timeout=timeout)
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        return connection

    def signal(self, number: int) -> None:
        os.kill(self.pid, number)

    def wait(self, timeout: float) -> Optional[int]:
        """The exit code, negative for a signal; None if it has not ended in time."""
        try:
            return self._process.wait(timeout=timeout)
        except subprocess.TimeoutExpired:
            return None

    def resident(self) -> int:
        """Bytes of memory that it holds now."""
        return status_field(self.pid, "VmRSS") * KIB

    def peak(self) -> int:
        """Bytes of memory that it has ever held."""
        return status_field(self.pid, "VmHWM") * KIB

    def threads(self) -> int:
        return status_field(self.pid, "Threads")

    def descriptors(self) -> int:
        return len(os.listdir(f"/proc/{self.pid}/fd"))

    def processor_seconds(self) -> float:
        with open(f"/proc/{self.pid}/stat", encoding="ascii", errors="replace") as stat:
            fields = stat.read().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def is_well(self) -> bool:
        """Whether it runs and gives the right answer to an innocent request."""
        if not self.is_running:
            return False
        try:
            version = self.get("/v1/version")
            alive = self.request("GET", "/livez", admin=True)
            return version.status == 200 and "version" in version.json() and alive.status == 200
        except (OSError, ValueError):
            return False

    def answers_examples(self) -> list[str]:
        """What goes wrong with the contract's own examples; empty if nothing does."""
        faults = []
        for operation in contract.posts() + contract.uploads():
            answer = self.example(operation)
            if answer.status != 200 or not answer.body:
                faults.append(f"{operation.path}: {answer.status} {answer.body[:200]!r}")
        return faults

    def example(self, operation: contract.Operation) -> Answer:
        body, headers = contract.sample(operation)
        return self.request(operation.method, operation.path, body, headers)


def status_field(pid: int, name: str) -> int:
    with open(f"/proc/{pid}/status", encoding="ascii", errors="replace") as status:
        for line in status:
            if line.startswith(name + ":"):
                return int(line.split()[1])
    raise KeyError(name)


def eventually(holds: Callable[[], bool], seconds: float) -> bool:
    """Whether it holds within that time; asked again and again, since what others see of a program comes late."""
    end = time.monotonic() + seconds
    while not holds():
        if time.monotonic() > end:
            return False
        time.sleep(0.02)
    return True


def stop(process: Program) -> Optional[int]:
    process.signal(signal.SIGTERM)
    return process.wait(15)
