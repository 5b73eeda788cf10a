"""Attacks a server of its own and breaks what it stands on.

    python3 tests/hostile/check_hostile.py --server build/release/server/tuftwave-server
    python3 tests/hostile/check_hostile.py --server ... --full
    python3 tests/hostile/check_hostile.py --server ... --only malformed slow

Without --full what is slow is left out, so that all of it takes less than a minute. Exit code 0 if everything holds, 1 if
something does not, 77 if nothing could be looked at. Needs Linux, Debian's python3-yaml and python3-jsonschema; strace,
binutils and util-linux for what is about privileges, which is skipped without them.
"""

from __future__ import annotations

import argparse
import importlib
import os
import resource
import sys
import time
import traceback
import warnings
from typing import Optional

sys.dont_write_bytecode = True
warnings.filterwarnings("ignore", category=DeprecationWarning)
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "contract")]

from cell import MIB, cell  # noqa: E402
from report import FAILED, Report  # noqa: E402
from running import Program  # noqa: E402

# Each is a module with run(report, program, full).
NAMES = ("malformed", "legal", "slow", "slow_read", "kept_alive", "floods", "json_bombs", "expansion_bombs", "glb_bombs", "processes", "logs", "descriptors", "privileges", "system_calls", "hardening",
         "bill_of_materials")


def attack(report: Report, name: str, program: str, full: bool) -> None:
    begin, failed = time.monotonic(), report.failed
    print(f"== {name.replace('_', ' ')}", flush=True)
    try:
        importlib.import_module(name).run(report, program, full)
    except Exception:  # the server may have gone in the middle of anything
        report.check(name, False, traceback.format_exc())
    report.note(f"{time.monotonic() - begin:.1f} s{', failed' if report.failed > failed else ''}")


def main(arguments: Optional[list[str]] = None) -> int:
    parser = argparse.ArgumentParser(description="Attacks a server of its own and breaks what it stands on.")
    parser.add_argument("--server", default=os.environ.get("TUFTWAVE_SERVER"), help="the program (default: the environment's TUFTWAVE_SERVER)")
    parser.add_argument("--full", action="store_true", help="also what takes minutes")
    parser.add_argument("--only", nargs="+", choices=NAMES, metavar="NAME", help="only these of " + ", ".join(NAMES))
    parser.add_argument("--limit-mib", type=int, help="put the servers into a cgroup of so much memory, e.g. 512")
    options = parser.parse_args(arguments)
    if not options.server or not os.access(options.server, os.X_OK):
        print(f"check_hostile: {options.server!r} is no program; build the server and name it with --server", file=sys.stderr)
        return FAILED
    most = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
    resource.setrlimit(resource.RLIMIT_NOFILE, (most, most))  # for floods
    report = Report()
    Program.cell = cell(options.limit_mib)
    for name in options.only or NAMES:
        attack(report, name, os.path.abspath(options.server), options.full)
    if Program.cell:
        report.note(f"the cgroup held {Program.cell.peak() / MIB:.0f} of {options.limit_mib} MiB at most")
        report.check("nobody killed for want of memory", Program.cell.killed() == 0, Program.cell.killed())
        Program.cell.close()
    print(f"{report.passed} passed, {report.failed} failed, {report.skipped} skipped")
    return report.exit_code


if __name__ == "__main__":
    sys.exit(main())
