"""Where a body goes, and that it does not matter where it goes."""

from __future__ import annotations

import glob
import os

from edge import ROOT, Edge
from load import read_example, tuft_body
from wire import Connection, request, schedule_body

BODIES, REPEATS = 45, 4


def check_routing(edge: Edge, _: bool) -> tuple[bool, str]:
    split = [0, 0, 0]
    astray = 0
    with edge.proxy.connect() as connection:
        for number in range(BODIES):
            before = [answered(edge, index) for index in range(3)]
            for _ in range(REPEATS):
                connection.ask(request("POST", "/v1/schedules", schedule_body(number)))
            shares = [answered(edge, index) - before[index] for index in range(3)]
            astray += REPEATS - int(max(shares))
            split[shares.index(max(shares))] += 1
    is_good = astray == 0 and min(split) >= BODIES // 10
    return is_good, f"{BODIES} bodies x {REPEATS}: split {'/'.join(map(str, split))}, {astray} answered by another replica than the rest"


def answered(edge: Edge, index: int) -> float:
    return edge.replicas[index].count("tuftwave_http_requests_total", 'route="/v1/schedules"')


def check_same_answers(edge: Edge, _: bool) -> tuple[bool, str]:
    """Each example from each replica and through the proxy, and a body and an answer larger than the proxy's buffer."""
    names = [os.path.basename(path)[:-5] for path in sorted(glob.glob(f"{ROOT}/api/examples/*.json"))]
    asked = [(f"/v1/{name}", read_example(name)) for name in names]
    asked.append(("/v1/tufts", tuft_body("long") + b" " * 400_000))
    unlike = []
    for target, body in asked:
        answers = [ask(address, target, body) for address in [edge.proxy.address, *(replica.address for replica in edge.replicas)]]
        if len(set(answers)) != 1 or answers[0][0] != 200:
            unlike.append(f"{target} {sorted(status for status, _ in answers)}")
    return not unlike, f"{len(asked)} bodies from 3 replicas and through the proxy: {len(unlike)} unlike {unlike or ''}".rstrip()


def ask(address: tuple[str, int], target: str, body: bytes) -> tuple[int, bytes]:
    with Connection(address) as connection:
        answer = connection.ask(request("POST", target, body))
        return answer.status, answer.body

