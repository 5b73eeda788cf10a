"""W1 and W2, the requests that every party gets: 1,000 strokes, and 200 chains for a second at 24 frames.

    python3 tests/bench/workloads.py FOLDER      writes w1.json and w2.json
"""

from __future__ import annotations

import json
import math
import os
import sys
from typing import Any

STROKES, POINTS = 1000, 8
CHAINS, NODES = 200, 16
GOLDEN_ANGLE = 2.399963


def stroke(index: int) -> list[list[float]]:
    """A lock that hangs from a head of 9 to 10 cm, bending outwards."""
    reach = 0.09 + 0.0001 * (index % 97)
    points = []
    for k in range(POINTS):
        out = reach * (1 + 0.12 * k - 0.01 * k * k)
        points.append([out * math.sin(GOLDEN_ANGLE * index), 0.1 - 0.03 * k, out * math.cos(GOLDEN_ANGLE * index)])
    return points  # with all of their digits, as programs send them


def chain(index: int) -> list[list[float]]:
    """Long hair around a head: nodes 2 cm apart, straight down."""
    angle = 2 * math.pi * index / CHAINS
    x, z = round(0.1 * math.sin(angle), 6), round(0.1 * math.cos(angle), 6)
    return [[x, round(0.05 - 0.02 * i, 6), z] for i in range(NODES)]


def w1() -> dict[str, Any]:
    """1,000 strokes of 8 points, 64 rings, 12 sides, merged."""
    tufts = [{"points": stroke(index)} for index in range(STROKES)]
    return {"tufts": tufts, "mesh": {"rings": 64, "sides": 12, "layout": "merged"}}


def w2() -> dict[str, Any]:
    """200 chains of 16 nodes, a second at 24 frames per second on twos: 12 pictures."""
    chains = [{"name": f"lock_{index}", "nodes": chain(index)} for index in range(CHAINS)]
    return {"chains": chains, "motion": {"timing": {"period": 1, "fps": 24, "hold": 2}}}


def write(folder: str) -> None:
    for name, body in (("w1", w1()), ("w2", w2())):
        with open(os.path.join(folder, name + ".json"), "w", encoding="ascii") as file:
            json.dump(body, file)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python3 tests/bench/workloads.py FOLDER")
    write(sys.argv[1])
