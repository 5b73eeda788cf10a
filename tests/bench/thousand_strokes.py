"""Prints W1, the body that the meshing benchmarks are compared on: 1,000 strokes of 8 points, 64 rings, 12 sides, merged.

    python3 tests/bench/thousand_strokes.py > thousand.json
"""

from __future__ import annotations

import json
import math
from typing import Any

STROKES = 1000
POINTS = 8
GOLDEN_ANGLE = 2.399963


def stroke(index: int) -> list[list[float]]:
    """A lock that hangs from a head of 9 to 10 cm, bending outwards; with all digits, as programs send them."""
    reach = 0.09 + 0.0001 * (index % 97)
    points = []
    for k in range(POINTS):
        out = reach * (1 + 0.12 * k - 0.01 * k * k)
        points.append([out * math.sin(GOLDEN_ANGLE * index), 0.1 - 0.03 * k, out * math.cos(GOLDEN_ANGLE * index)])
    return points


def request() -> dict[str, Any]:
    tufts = [{"points": stroke(index)} for index in range(STROKES)]
    return {"tufts": tufts, "mesh": {"rings": 64, "sides": 12, "layout": "merged", "skin": False}}


if __name__ == "__main__":
    print(json.dumps(request()))
