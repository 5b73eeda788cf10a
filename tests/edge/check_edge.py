"""Checks three replicas behind HAProxy with deploy/haproxy/haproxy.cfg, one line with figures for each goal.

    python3 tests/edge/check_edge.py --server build/release/server/tuftwave-server          a minute at the most
    python3 tests/edge/check_edge.py --server ... --full                                    the goals' own numbers, about six
    python3 tests/edge/check_edge.py --server ... --only smuggling slow_clients

Needs Debian's haproxy; script/setup edge installs it. Exit code 0 if every goal is met, else 1.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from typing import Callable, Optional

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from edge import Edge, HAPROXY  # noqa: E402
from restarts import check_kill, check_rolling_restart  # noqa: E402
from routing import check_routing, check_same_answers  # noqa: E402
from rules import check_rules  # noqa: E402
from saturation import check_saturation  # noqa: E402
from slow import SETTINGS, check_slow_clients  # noqa: E402
from smuggling import check_smuggling, check_smuggling_works  # noqa: E402

DRAIN = ("--drain", "2")
Check = Callable[[str, bool], tuple[bool, str]]


def on_edge(check: Callable[[Edge, bool], tuple[bool, str]], **settings: str) -> Check:
    """A check on three fresh replicas of its own."""
    def run(program: str, is_full: bool) -> tuple[bool, str]:
        with Edge(program, *DRAIN, **settings) as edge:
            return check(edge, is_full)
    return run


CHECKS: dict[str, Check] = {
    "routing": on_edge(check_routing),
    "same_answers": on_edge(check_same_answers),
    "rolling_restart": on_edge(check_rolling_restart),
    "kill": on_edge(check_kill),
    "smuggling_works": check_smuggling_works,
    "smuggling": on_edge(check_smuggling),
    "slow_clients": on_edge(check_slow_clients, **SETTINGS),
    "saturation": check_saturation,
    "rules": on_edge(check_rules),
}


def run(name: str, program: str, is_full: bool) -> bool:
    begun = time.monotonic()
    try:
        is_good, figures = CHECKS[name](program, is_full)
    except (RuntimeError, OSError) as fault:
        is_good, figures = False, repr(fault)
    print(f"{'ok  ' if is_good else 'FAIL'} {name}: {figures} [{time.monotonic() - begun:.1f} s]", flush=True)
    return is_good


def main(arguments: Optional[list[str]] = None) -> int:
    parser = argparse.ArgumentParser(description="Checks replicas behind HAProxy.")
    parser.add_argument("--server", default=os.environ.get("TUFTWAVE_SERVER"), help="the program (default: the environment's TUFTWAVE_SERVER)")
    parser.add_argument("--full", action="store_true", help="with the goals' own numbers")
    parser.add_argument("--only", nargs="+", choices=sorted(CHECKS), metavar="CHECK", help="run only these: " + ", ".join(CHECKS))
    options = parser.parse_args(arguments)
    if not options.server or not os.access(options.server, os.X_OK):
        print(f"check_edge: {options.server!r} is no program; build the server and name it with --server", file=sys.stderr)
        return 1
    if not HAPROXY:
        print("check_edge: there is no haproxy; script/setup edge installs it", file=sys.stderr)
        return 1
    failed = [name for name in options.only or CHECKS if not run(name, options.server, options.full)]
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
