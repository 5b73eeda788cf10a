"""Where a fill's tufts must be, worked out from the paper and from openapi.yaml alone."""

from __future__ import annotations

import math
from typing import Any

Point = list[float]
KINDS = ("along", "crown", "neck")  # their place in the order of an answer and in Philox's counter
JITTER = math.pi / 20


def philox(counter: tuple[int, int, int, int], key: tuple[int, int]) -> tuple[int, int, int, int]:
    """Philox4x32-10 (Salmon, Moraes, Dror and Shaw, 2011), written from the paper."""
    (c0, c1, c2, c3), (k0, k1) = counter, key
    for _ in range(10):
        first, second = 0xD2511F53 * c0, 0xCD9E8D57 * c2
        c0, c1, c2, c3 = second >> 32 ^ c1 ^ k0, second & 0xFFFFFFFF, first >> 32 ^ c3 ^ k1, first & 0xFFFFFFFF
        k0, k1 = k0 + 0x9E3779B9 & 0xFFFFFFFF, k1 + 0xBB67AE85 & 0xFFFFFFFF
    return c0, c1, c2, c3


def jitter(seed: int, origin: dict[str, Any]) -> tuple[float, float]:
    """How far a filled tuft is turned, in azimuth and in elevation."""
    o, y = (origin["index"], 0) if origin["kind"] == "along" else (origin["parent"], origin["index"])
    words = philox((o, y, KINDS.index(origin["kind"]), 0), (seed % 2**32, seed // 2**32))
    u, v = ((words[i] * 2**32 + words[i + 1] >> 11) * 2.0**-53 for i in (0, 2))
    return (2 * u - 1) * JITTER, (2 * v - 1) * JITTER


def cross(a: Point, b: Point) -> Point:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a: Point, b: Point) -> float:
    return sum(x * y for x, y in zip(a, b))


class Frame:
    """The paper's axes: the character's left, its back, up; azimuth counter-clockwise from its left, seen from above."""

    def __init__(self, head: dict[str, Any]) -> None:
        self._center = head.get("center", [0, 0, 0])
        up, front = head.get("up", [0, 1, 0]), head.get("front", [0, 0, 1])
        self._up = [c / math.hypot(*up) for c in up]
        left = cross(self._up, front)
        self._left = [c / math.hypot(*left) for c in left]
        self._back = cross(self._up, self._left)

    def inside(self, point: Point) -> Point:
        from_center = [c - h for c, h in zip(point, self._center)]
        return [dot(from_center, self._left), dot(from_center, self._back), dot(from_center, self._up)]

    def outside(self, point: Point) -> Point:
        return [h + x * a + y * b + z * c for h, a, b, c, (x, y, z) in zip(self._center, self._left, self._back, self._up, [point] * 3)]

    def bearing(self, point: Point) -> tuple[float, float]:
        x, y, z = self.inside(point)
        return math.atan2(y, x), math.atan2(z, math.hypot(x, y))


def towards(azimuth: float, elevation: float, radius: float) -> Point:
    """A point by its angles in degrees."""
    a, e = math.radians(azimuth), math.radians(elevation)
    return [radius * math.cos(e) * math.cos(a), radius * math.cos(e) * math.sin(a), radius * math.sin(e)]


def short_way(angle: float) -> float:
    """An angle the short way, in [-pi, pi]."""
    return math.remainder(angle, 2 * math.pi)


def is_within_hairline(azimuth: float, elevation: float) -> bool:
    is_above_face = -math.radians(150) < short_way(azimuth) < -math.radians(30)
    return elevation > (0 if is_above_face else -math.radians(60))  # eq. (8)


def copies(head: dict[str, Any], fill: dict[str, Any], report: dict[str, Any]) -> list[tuple[tuple[str, int, int], float, float]]:
    """All that equation (7) gives, as kind, parent and copy, with azimuth and elevation of their roots before jitter, hair line and scalp."""
    azimuth, elevation = Frame(head).bearing(fill["from"]["points"][0])
    count, is_printed = report["along"], fill.get("formulas") == "as_printed"
    first, last = (tuft.get("diameter", 40) for tuft in (fill["from"], fill.get("to") or fill["from"]))
    widths = [first + (last - first) * l / (count + 1) for l in range(count + 2)]
    whole = sum(widths[1:count + 1 if is_printed and count else count + 2])
    shares = [0, *(sum(widths[1:l + 1]) / whole for l in range(1, count + 1)), 1]
    if not fill.get("to") and not is_printed:
        shares.pop()
    found = []
    for kind, sign in (("crown", 1), ("neck", -1)):
        density = fill.get("density", {}).get(kind)
        step = math.radians(90 - 0.81 * density) if density else math.inf
        for o, share in enumerate(shares, 1):
            e, y = elevation + share * report["rise"], 1
            while sign * e + y * step < math.pi / 2 - 1e-9:
                found.append(((kind, o, y), azimuth + share * report["sweep"], e + sign * y * step))
                y += 1
    return found


def mesh_of(frame: Frame, radii: Point, middle: Point) -> dict[str, Any]:
    """An ellipsoid of 24 by 12 faces. @param radii, middle  along the character's left, up and front"""
    rows, columns = 12, 24
    directions = [(math.pi * i / rows, 2 * math.pi * j / columns) for i in range(rows + 1) for j in range(columns)]
    balls = [(math.sin(u) * math.cos(v), math.cos(u), math.sin(u) * math.sin(v)) for u, v in directions]
    vertices = [[m + r * c for m, r, c in zip(middle, radii, ball)] for ball in balls]
    positions = [c for left, up, front in vertices for c in frame.outside([left, -front, up])]
    triangles = []
    for i in range(rows):
        for j in range(columns):
            a, b, c, d = (row * columns + column % columns for row, column in ((i, j), (i, j + 1), (i + 1, j), (i + 1, j + 1)))
            triangles += [a, b, c, b, d, c]
    return {"positions": positions, "triangles": triangles}
