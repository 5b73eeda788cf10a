"""Thousands of clients that send a byte a second, and ordinary ones among them."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time

from edge import Edge
from load import Load, percentile

HERE = os.path.dirname(os.path.abspath(__file__))
CLIENTS_FULL, CLIENTS_QUICK = 4000, 200
SECONDS_FULL, SECONDS_QUICK = 30, 1
CUT_S, HEALTHY_P99_MS = 15.0, 50.0
SETTINGS = {"TUFTWAVE_MAXCONN": "5000"}


def check_slow_clients(edge: Edge, is_full: bool) -> tuple[bool, str]:
    """The time that healthy requests take is a goal of the full form only: the quick one runs beside other tests."""
    clients, seconds = (CLIENTS_FULL, SECONDS_FULL) if is_full else (CLIENTS_QUICK, SECONDS_QUICK)
    command = [sys.executable, os.path.join(HERE, "slow_clients.py"), "--port", str(edge.proxy.port), "--clients", str(clients),
               "--seconds", str(seconds)]
    slow = subprocess.Popen(command, stdout=subprocess.PIPE)
    memory = 0.0
    with Load(edge.proxy.address, 2, 100) as load:
        while slow.poll() is None:
            memory = max(memory, edge.proxy.memory_mib())
            time.sleep(0.2)
    crowd = json.loads(slow.stdout.read())
    p99_ms = 1000 * percentile(load.seconds, 0.99)
    is_good = (not load.failures and crowd["survived"] == 0 and crowd["longest_s"] <= CUT_S and crowd["most_open"] >= 0.9 * clients
               and (p99_ms <= HEALTHY_P99_MS or not is_full))
    return is_good, (f"{crowd['most_open']} slow clients at once, {crowd['opened']} in all, {crowd['cut']} cut, the last after "
                     f"{crowd['longest_s']} s; healthy: {load.figures()}; HAProxy {memory:.0f} MiB")
