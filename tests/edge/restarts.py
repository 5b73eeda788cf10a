"""Replicas that end while requests are on their way: no client notices."""

from __future__ import annotations

import time

from edge import Edge, Replica, wait_until
from load import Load, with_tufts

THREADS, PER_SECOND = 6, 200


def check_rolling_restart(edge: Edge, is_full: bool) -> tuple[bool, str]:
    """SIGTERM to each in turn, the next when the last one has requests again."""
    rounds, codes = (10 if is_full else 1), []
    with Load(edge.proxy.address, THREADS, PER_SECOND, with_tufts) as load:
        for _ in range(rounds):
            for number, replica in enumerate(edge.replicas, 1):
                codes.append(replica.stop())
                come_back(edge, number, replica)
    return not load.failures and not any(codes), f"{rounds} rounds of 3 SIGTERMs: {load.figures()}, exit codes {sorted(set(codes))}"


def check_kill(edge: Edge, is_full: bool) -> tuple[bool, str]:
    """kill -9, and back some time after the proxy has noticed. The requests fit its buffer."""
    kills = 10 if is_full else 1
    with Load(edge.proxy.address, THREADS, PER_SECOND, with_tufts) as load:
        before = edge.proxy.repeated()
        for turn in range(kills):
            number = turn % 3 + 1
            replica = edge.replicas[number - 1]
            time.sleep(0.3)
            replica.kill()
            wait_until(lambda: number not in edge.proxy.up(), "the proxy had noticed a killed replica")
            come_back(edge, number, replica)
        repeated = edge.proxy.repeated() - before
    return not load.failures and repeated > 0, (f"{kills} kill -9 of one of three: {load.figures()}, {repeated:.0f} repeated elsewhere, "
                                                "each came back and was used")


def come_back(edge: Edge, number: int, replica: Replica) -> None:
    replica.start()
    wait_until(lambda: number in edge.proxy.up() and replica.answered() > 0, f"replica {number} was used again")
