"""Converts a VRoid strokes file to the body of POST /v1/hairstyles.

    python3 client-examples/pipeline/strokes_to_hairstyle.py tests/data/strokes/vroid_Vita.strokes.json --motion breeze --out vita.json

The larger of a stroke's width and thickness becomes the tuft's diameter, the smaller one its flatness; where the thickness
(measured away from the head) is the larger, the ellipse stands on its edge (roll_deg 90). Points are passed on unchanged.

widest_at: the file states one width and one thickness per stroke and nothing along it, so the widest place cannot be
measured. It is a constant, 40 percent, which is the service's own default; --widest-at and --taper change it for all tufts.
"""

from __future__ import annotations

import argparse
import json
import math
import sys
from dataclasses import dataclass
from typing import Any, Optional

Point = list[float]

def preset(amplitude: float, spatial_period: float, tip_exponent: float, period: float, hold: int) -> dict[str, Any]:
    return {
        "wave": {"amplitude": amplitude, "spatial_period": spatial_period, "lightness": 1.2, "tip_exponent": tip_exponent},
        "timing": {"period": period, "fps": 24, "hold": hold},
    }


MOTIONS: dict[str, Optional[dict[str, Any]]] = {
    "none": None,
    "calm": preset(0.13, 1.0, 1.5, 1.0, 3),  # 24 frames, 8 pictures
    "breeze": preset(0.38, 1.0, 1.0, 0.45, 2),  # 11 frames, 6 pictures
    "gale": preset(0.8, 0.8, 0.8, 0.33, 2),  # 8 frames, 4 pictures
}
LAID_ON_HAIR = {
    "wind": [1, 0, 0],
    "one_sided": True,
    "phase": {"step": "free", "gust_wavelength": 0.8, "spread": 0.08, "seed": 1},
}


@dataclass
class Stroke:
    name: str
    points: list[Point]  # root first, metres
    width: float  # across the outward normal, metres
    thickness: float  # along the outward normal, metres


def is_number(value: Any, above: float = -math.inf) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value) and value > above


def read_strokes(document: Any, with_hidden: bool = False) -> list[Stroke]:
    """The strokes of a parsed file, named by group and place in the group. Raises ValueError with the place of a fault."""
    if not isinstance(document, dict) or not isinstance(document.get("strokes"), list):
        raise ValueError("has no list 'strokes'")
    groups = document.get("groups") if isinstance(document.get("groups"), list) else []
    hidden = {g.get("group") for g in groups if isinstance(g, dict) and g.get("visible") is False}
    strokes: list[Stroke] = []
    count_in_group: dict[int, int] = {}
    for index, entry in enumerate(document["strokes"]):
        where = f"strokes[{index}]"
        if not isinstance(entry, dict):
            raise ValueError(f"{where} is not an object")
        points, group = entry.get("points"), entry.get("group", 0)
        if not isinstance(points, list) or len(points) < 2:
            raise ValueError(f"{where}.points has fewer than 2 points")
        if not all(isinstance(p, list) and len(p) == 3 and all(map(is_number, p)) for p in points):
            raise ValueError(f"{where}.points has a point that is not three finite numbers")
        for field in ("width", "thickness"):
            if not is_number(entry.get(field), above=0):
                raise ValueError(f"{where}.{field} is not a number above 0")
        if not isinstance(group, int) or not 0 <= group <= 9999:
            raise ValueError(f"{where}.group is not a whole number from 0 to 9999")
        count_in_group[group] = count_in_group.get(group, 0) + 1  # hidden ones count, so that --all renames nobody
        if with_hidden or (entry.get("visible", True) and group not in hidden):
            name = f"g{group:02d}_{count_in_group[group]:03d}"
            strokes.append(Stroke(name, points, entry["width"], entry["thickness"]))
    if not strokes:
        raise ValueError("has no visible strokes (--all takes hidden ones too)")
    return strokes


def solve(rows: list[list[float]]) -> Optional[list[float]]:
    """Solves a small linear system, given as rows with the right side last; None where it has no single solution."""
    size = len(rows)
    rows = [list(row) for row in rows]
    tiny = 1e-9 * max(abs(value) for row in rows for value in row)
    for column in range(size):
        pivot = max(range(column, size), key=lambda row: abs(rows[row][column]))
        if abs(rows[pivot][column]) <= tiny:
            return None
        rows[column], rows[pivot] = rows[pivot], rows[column]
        for row in range(size):
            if row != column:
                factor = rows[row][column] / rows[column][column]
                rows[row] = [a - factor * b for a, b in zip(rows[row], rows[column])]
    return [rows[i][size] / rows[i][i] for i in range(size)]


def fit_sphere(points: list[Point]) -> Optional[tuple[Point, float]]:
    """The sphere nearest to the points in least squares of |p|^2 = 2 c.p + (r^2 - |c|^2); None if they fix none."""
    mean = [math.fsum(p[i] for p in points) / len(points) for i in range(3)]
    scale = max(math.dist(p, mean) for p in points)
    if len(points) < 4 or scale == 0:
        return None
    near_one = [[(p[i] - mean[i]) / scale for i in range(3)] + [1.0] for p in points]
    squares = [math.fsum(x * x for x in row[:3]) for row in near_one]
    solution = solve([
        [math.fsum(row[i] * row[j] for row in near_one) for j in range(4)]
        + [math.fsum(row[i] * square for row, square in zip(near_one, squares))]
        for i in range(4)
    ])
    if solution is None:
        return None
    center = [x / 2 for x in solution[:3]]
    radius = math.sqrt(max(0.0, solution[3] + math.fsum(x * x for x in center)))
    return [m + scale * c for m, c in zip(mean, center)], scale * radius


def find_head(roots: list[Point], sphere: Optional[tuple[Point, float]]) -> tuple[Point, float, bool]:
    """Center and radius of the head: the sphere, or where it cannot be a head's, a guess; and whether it was the sphere."""
    sides = [(min(p[i] for p in roots), max(p[i] for p in roots)) for i in range(3)]
    half = max(high - low for low, high in sides) / 2
    if sphere and max(half * 0.8, 0.05) <= sphere[1] <= half * 3 and sphere[0][1] < sides[1][1]:
        return sphere[0], sphere[1], True
    radius = max(half, 0.1)  # 10 cm, a head with some hair
    middle = [math.fsum(p[i] for p in roots) / len(roots) for i in range(3)]
    return [middle[0], sides[1][1] - radius, middle[2]], radius, False


def motion_block(name: str) -> Optional[dict[str, Any]]:
    chosen = MOTIONS[name]
    return None if chosen is None else {**chosen, **LAID_ON_HAIR}


def up_to_millimetre(diameter: float) -> float:
    return max(1, math.ceil(diameter * 1000 - 1e-6)) / 1000


def to_tuft(stroke: Stroke, diameter_at_100: float, taper: str, widest_at: float) -> dict[str, Any]:
    larger, smaller = max(stroke.width, stroke.thickness), min(stroke.width, stroke.thickness)
    tuft = {
        "name": stroke.name,
        "points": stroke.points,
        "diameter": max(1.0, round(100 * larger / diameter_at_100, 4)),
        "widest_at": widest_at,
        "taper": taper,
        "section": "circle",
        "joints": 6,
    }
    flatness = min(0.98, round(1 - smaller / larger, 4))
    if flatness > 0:
        tuft.update(section="ellipse", flatness=flatness, roll_deg=90 if stroke.thickness > stroke.width else 0)
    return tuft


def to_hairstyle(strokes: list[Stroke], motion: str = "none", taper: str = "sine", widest_at: float = 40,
                 sides: int = 12, tolerance: float = 0.0003) -> tuple[dict[str, Any], list[str]]:
    """The hairstyle, and notes for a person."""
    roots = [stroke.points[0] for stroke in strokes]
    center, radius, fitted = find_head(roots, fit_sphere(roots))
    center = [round(x, 6) for x in center]
    notes = [f"head center {center}, radius {radius:.4f} m ({'fitted to' if fitted else 'guessed from'} {len(roots)} roots)"]
    diameters = [max(stroke.width, stroke.thickness) for stroke in strokes]
    at_100 = up_to_millimetre(max(diameters))
    notes += [f"warning: {stroke.name} is thinner than 1 percent of {at_100} m and was made 1 percent"
              for stroke, diameter in zip(strokes, diameters) if 100 * diameter < at_100]
    hairstyle = {
        "head": {"center": center, "up": [0, 1, 0], "front": [0, 0, 1], "root_depth": 0.01, "diameter_at_100": at_100},
        "tufts": [to_tuft(stroke, at_100, taper, widest_at) for stroke in strokes],
        "mesh": {"tolerance": tolerance, "sides": sides},
    }
    block = motion_block(motion)
    return ({**hairstyle, "motion": block} if block else hairstyle), notes


def write_json(document: dict[str, Any], path: str) -> None:
    """One line of JSON; a path of "-" is the standard output."""
    text = json.dumps(document, allow_nan=False) + "\n"
    if path == "-":
        sys.stdout.write(text)
    else:
        with open(path, "w", encoding="ascii") as file:
            file.write(text)


def main(arguments: Optional[list[str]] = None) -> int:
    parser = argparse.ArgumentParser(description="VRoid strokes to a Tuftwave hairstyle.")
    parser.add_argument("strokes", help="a .strokes.json file")
    parser.add_argument("--out", default="-", help="where the hairstyle goes (standard output)")
    parser.add_argument("--motion", choices=list(MOTIONS), default="none")
    parser.add_argument("--taper", choices=["sine", "linear", "smooth", "round"], default="sine")
    parser.add_argument("--widest-at", type=float, default=40, help="percent of the length, for all tufts (%(default)s)")
    parser.add_argument("--sides", type=int, default=12, help="corners of a ring (%(default)s)")
    parser.add_argument("--tolerance", type=float, default=0.0003, help="of the mesh, metres (%(default)s)")
    parser.add_argument("--all", action="store_true", help="hidden strokes and groups too")
    options = parser.parse_args(arguments)
    try:
        with open(options.strokes, encoding="utf-8") as file:
            strokes = read_strokes(json.load(file), options.all)
        hairstyle, notes = to_hairstyle(strokes, options.motion, options.taper, options.widest_at, options.sides, options.tolerance)
        write_json(hairstyle, options.out)
    except (OSError, ValueError, RecursionError) as error:
        print(f"strokes_to_hairstyle: {options.strokes}: {error}", file=sys.stderr)
        return 1
    print(f"{len(strokes)} tufts", *notes, sep="\n", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
