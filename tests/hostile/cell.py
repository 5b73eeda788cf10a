"""A cgroup with a limit of memory, and the servers under test in it."""

from __future__ import annotations

import os
import re
from typing import Optional

MIB = 1024 * 1024
CGROUPS = "/sys/fs/cgroup"


class Cell:
    """A cgroup with a limit, for as long as this program runs; what it starts is in it as well."""

    def __init__(self, limit_mib: int) -> None:
        self.is_new = os.path.exists(f"{CGROUPS}/cgroup.controllers")
        base = CGROUPS if self.is_new else f"{CGROUPS}/memory"
        self.home, self.folder = base, f"{base}/tuftwave_memory_{os.getpid()}"
        os.mkdir(self.folder)
        self._write(self.folder, "memory.max" if self.is_new else "memory.limit_in_bytes", str(limit_mib * MIB))

    def hold(self, pid: int) -> None:
        self._write(self.folder, "cgroup.procs", str(pid))

    def peak(self) -> int:
        """Bytes, the pages of files among them."""
        with open(f"{self.folder}/{'memory.peak' if self.is_new else 'memory.max_usage_in_bytes'}", encoding="ascii") as file:
            return int(file.read())

    def killed(self) -> int:
        name = "memory.events" if self.is_new else "memory.oom_control"
        with open(f"{self.folder}/{name}", encoding="ascii") as file:
            return int((re.search(r"^oom_kill (\d+)", file.read(), re.MULTILINE) or [0, 0])[1])

    def close(self) -> None:
        os.rmdir(self.folder)

    def _write(self, folder: str, name: str, value: str) -> None:
        with open(f"{folder}/{name}", "w", encoding="ascii") as file:
            file.write(value)


def cell(limit_mib: Optional[int]) -> Optional[Cell]:
    if limit_mib is None:
        return None
    try:
        return Cell(limit_mib)
    except OSError as error:
        print(f"no cgroup can be made ({error.strerror}); the peak of each server is compared with {limit_mib} MiB instead", flush=True)
        return None
