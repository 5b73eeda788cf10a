"""As nobody, without capabilities, on a root that cannot be written: all examples are answered."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile

from report import Report
from running import Program, eventually, status_field

NOBODY = 65_534
DROP = ["setpriv", f"--reuid={NOBODY}", f"--regid={NOBODY}", "--clear-groups", "--no-new-privs", "--inh-caps=-all", "--bounding-set=-all"]
# Every file system of this process's own name space read-only, a look that it is, then the program.
READ_ONLY = ["unshare", "--mount", "--propagation", "private", "sh", "-c",
             'mount -o remount,bind,ro / && for at in /tmp /var /run /home; do mount --bind "$at" "$at" && mount -o remount,bind,ro "$at" || exit 97; done; '
             'if touch /probe "$1/probe" 2>/dev/null; then exit 98; fi; shift; exec "$@"', "sh"]


def run(report: Report, program: str, full: bool) -> None:
    if os.geteuid() != 0:
        report.skip("least privilege", "only root can give privileges away")
        return
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o755)
        copied = shutil.copy(program, folder)
        os.chmod(copied, 0o755)
        as_nobody(report, copied, [*DROP], "as nobody")
        if subprocess.run([*READ_ONLY, folder, "true"], capture_output=True).returncode != 0:
            report.skip("a read-only root", "this machine does not let us make name spaces")
            return
        as_nobody(report, copied, [*READ_ONLY, folder, *DROP], "on a read-only root")


def as_nobody(report: Report, program: str, prefix: list[str], what: str) -> None:
    with Program(program, prefix=prefix) as server:
        pid = server.pid
        report.equal(f"{what}: user", status_field(pid, "Uid"), NOBODY)
        report.equal(f"{what}: group", status_field(pid, "Gid"), NOBODY)
        report.equal(f"{what}: no new privileges", status_field(pid, "NoNewPrivs"), 1)
        for kind in ("CapInh", "CapPrm", "CapEff", "CapBnd", "CapAmb"):
            report.equal(f"{what}: {kind}", capabilities(pid, kind), 0)
        report.equal(f"{what}: all examples", server.answers_examples(), [])
        for path in ("/", "/docs", "/openapi.yaml", "/v1/limits"):
            report.equal(f"{what}: {path}", server.get(path).status, 200)
        report.equal(f"{what}: listens twice and nowhere else", sockets(pid), 2)
        report.check(f"{what}: well", server.is_well())
        server.signal(15)
        report.check(f"{what}: ends in order", eventually(lambda: server.wait(0.1) == 0, 15))


def capabilities(pid: int, kind: str) -> int:
    with open(f"/proc/{pid}/status", encoding="ascii") as status:
        return int(next(line for line in status if line.startswith(kind + ":")).split()[1], 16)


def sockets(pid: int) -> int:
    """How many sockets it listens on."""
    own = {os.readlink(f"/proc/{pid}/fd/{number}") for number in os.listdir(f"/proc/{pid}/fd")}
    listening = 0
    for family in ("tcp", "tcp6", "udp", "udp6"):
        with open(f"/proc/{pid}/net/{family}", encoding="ascii") as table:
            rows = [line.split() for line in table][1:]
        listening += sum(1 for row in rows if f"socket:[{row[9]}]" in own and (row[3] == "0A" or family.startswith("udp")))
    return listening
