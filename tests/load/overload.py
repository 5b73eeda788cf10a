"""Ten times as many requests as the server can answer: what it accepts stays quick, the rest is refused at once.

    python3 tests/load/overload.py [--seconds 60] [--connections 256]

Measures what one client alone waits (p99), what the server can do (closed loop), then asks ten times as often for a minute,
at fixed times and on a bounded number of connections. Exit code 1 if a goal is missed.
"""

from __future__ import annotations

import statistics
import subprocess
import sys
import tempfile

from loading import MIB, QUIET, Goals, Program, arguments, command, count, finished, hairstyle, load, others, quantile, sampled

TIMES = 10
SLOWER, REFUSED_MS, GOODPUT, GROWTH = 5.0, 50.0, 0.8, 1.1
COPIES = 4  # of the example: 5 to 20 ms of work
WARM_S, ALONE_S, CAPACITY_S = 3, 10, 10
WARM_UP = 0.2  # share of the overload after which memory is what it costs
PATH = "/v1/hairstyles"


def capacity(generator: str, server: Program, body: str) -> float:
    """Answers per second, the best of a few closed loops: too few clients leave workers idle, too many are refused."""
    best = 0.0
    for connections in (2, 4, 8):
        figures = load(generator, server, PATH, body, 0, CAPACITY_S, connections)
        rate = count(figures, 200) / figures["seconds"]
        print(f"{connections} clients, each as fast as it can: {rate:.1f} answers/s, p99 {quantile(figures, 200):.1f} ms, refused {count(figures, 503)}", flush=True)
        best = max(best, rate)
    return best


def main() -> int:
    options = arguments(__doc__ or "", seconds={"type": float, "default": 60}, connections={"type": int, "default": 256})
    goals = Goals()
    with tempfile.NamedTemporaryFile() as file, Program(options.server, *QUIET) as server:
        file.write(hairstyle(COPIES))
        file.flush()
        load(options.generator, server, PATH, file.name, 0, WARM_S, 4)
        alone = load(options.generator, server, PATH, file.name, 0, ALONE_S, 1)
        print(f"one client alone: p50 {quantile(alone, 200, 'p50'):.1f}, p99 {quantile(alone, 200):.1f} ms", flush=True)
        can = capacity(options.generator, server, file.name)
        asked = TIMES * can
        print(f"asking {asked:.0f} times a second on {options.connections} connections for {options.seconds:.0f} s", flush=True)
        process = subprocess.Popen(command(options.generator, server, PATH, file.name, asked, options.seconds, options.connections), stdout=subprocess.PIPE)
        memory = [(at, held) for at, held in sampled(process, server.resident, 0.5)]
        over = finished(process)
        is_well = server.is_well()
    print(f"{over['due']} due, {over['asked']} asked, {count(over, 200)} accepted, {count(over, 503)} refused, {over['lost']} lost, {over['reconnected']} connections")
    goals.at_most("accepted p99", quantile(over, 200), SLOWER * quantile(alone, 200), "ms")
    goals.at_most("refused p99", quantile(over, 503), REFUSED_MS, "ms")
    goals.at_least("goodput", count(over, 200) / over["seconds"] / can, GOODPUT, "of capacity")
    goals.equal("refused without Retry-After", over["answers"].get("503", {}).get("without_retry_after", 0), 0)
    goals.equal("other answers", sum(others(over, 200, 503).values()), 0)
    goals.equal("without an answer", over["lost"], 0)
    goals.at_least("share of what was due that could be asked", over["asked"] / over["due"], 0.95)
    early = [held for at, held in memory if at < WARM_UP * options.seconds]
    late = [held for at, held in memory if at > (1 - WARM_UP) * options.seconds]
    print(f"memory {statistics.median(early) / MIB:.1f} MiB in the first fifth, {statistics.median(late) / MIB:.1f} MiB in the last, {max(held for _, held in memory) / MIB:.1f} MiB at most")
    goals.at_most("memory, last fifth over first", statistics.median(late) / statistics.median(early), GROWTH)
    goals.equal("well afterwards", is_well, True)
    return goals.exit_code


if __name__ == "__main__":
    sys.exit(main())
