"""W1 and W2 as files, which every party gets: 1,000 strokes, and 200 chains for a second at 24 frames on twos.

    python3 tests/bench/workloads.py FOLDER      writes w1.json and w2.json, requests to /v1/tufts and /v1/motions
"""

from __future__ import annotations

import json
import math
import os
import sys
from typing import Any

import thousand_strokes

CHAINS, NODES = 200, 16


def chain(index: int) -> list[list[float]]:
    """Long hair around a head: nodes 2 cm apart, straight down."""
    angle = 2 * math.pi * index / CHAINS
    x, z = round(0.1 * math.sin(angle), 6), round(0.1 * math.cos(angle), 6)
    return [[x, round(0.05 - 0.02 * i, 6), z] for i in range(NODES)]


def chains() -> dict[str, Any]:
    lines = [{"name": f"lock_{index}", "nodes": chain(index)} for index in range(CHAINS)]
    return {"chains": lines, "motion": {"timing": {"period": 1, "fps": 24, "hold": 2}}}


def write(folder: str) -> None:
    for name, body in (("w1", thousand_strokes.request()), ("w2", chains())):
        with open(os.path.join(folder, name + ".json"), "w", encoding="ascii") as file:
            json.dump(body, file)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python3 tests/bench/workloads.py FOLDER")
    write(sys.argv[1])
