"""Converts TressFX strands (.tfx, version 3.0; one or more files) to the body of POST /v1/hairstyles, one tuft per strand.

    python3 client-examples/pipeline/strands_to_hairstyle.py tests/data/strands/*.tfx --motion breeze --out ponytail.json

TressFX heads look to -Z: the hair is turned half a turn about Y, moved so that the head's center lies at --center, and
scaled to a person. The head is a sphere fitted to the strands' roots. Its radius in the AMD ponytail is 33.6 units, a third
of a metre if a unit were a centimetre; by default it becomes 0.09 m, and --unit sets a scale of your own instead.
A file's strands are reversed where their last points lie better on a sphere, such as a scalp, than their first ones.
The diameter is the median distance to the fourth nearest strand, measured where strands are widest: neighbours touch.
"""

from __future__ import annotations

import argparse
import math
import statistics
import struct
import sys
from typing import Any, Optional

from strokes_to_hairstyle import MOTIONS, Point, find_head, fit_sphere, motion_block, up_to_millimetre, write_json

Strand = list[Point]

HEAD_RADIUS = 0.09  # metres: the scalp of a grown-up
WIDEST_AT = 40  # percent of the length
OFFSET_FIELD = 144  # where the header keeps the offset of the positions: after 5 fields and 31 reserved words
HEADER_BYTES = 296


def read_tfx(data: bytes) -> list[Strand]:
    """The strands of a TFX 3.0 file, in its own axes and unit. Raises ValueError."""
    if len(data) < HEADER_BYTES:
        raise ValueError(f"is truncated: {len(data)} bytes, the header alone has {HEADER_BYTES}")
    version, strands, points = struct.unpack_from("<fII", data)
    if version != 3.0:
        raise ValueError(f"is not a TFX 3.0 file: its version reads {version:g}")
    if strands < 1 or not 2 <= points <= 64:
        raise ValueError(f"has {strands} strands of {points} points; at least 1 strand of 2 to 64 points is needed")
    (offset,) = struct.unpack_from("<I", data, OFFSET_FIELD)
    if offset != HEADER_BYTES:
        raise ValueError(f"keeps its positions at byte {offset}; only {HEADER_BYTES} is known")
    needed = offset + 12 * strands * points
    if len(data) != needed:
        fault = "is truncated" if len(data) < needed else "holds more than positions"
        raise ValueError(f"{fault}: {len(data)} bytes, {strands} strands of {points} points need {needed}")
    flat = [list(p) for p in struct.iter_unpack("<3f", data[offset:])]
    if not all(math.isfinite(x) for p in flat for x in p):
        raise ValueError("has a position that is not finite")
    return [flat[i:i + points] for i in range(0, len(flat), points)]


def misfit(ends: list[Point]) -> float:
    """How far the ends are from lying on one sphere, as a share of their spread; infinite where they fix no sphere."""
    sphere = fit_sphere(ends)
    if sphere is None:
        return math.inf
    center, radius = sphere
    error = math.sqrt(statistics.fmean((math.dist(p, center) - radius) ** 2 for p in ends))
    return error / max(math.dist(p, ends[0]) for p in ends)


def root_first(strands: list[Strand]) -> list[Strand]:
    """The strands of a file, all reversed where their last ends lie better on a scalp than their first ones."""
    first, last = (misfit([strand[end] for strand in strands]) for end in (0, -1))
    return [strand[::-1] for strand in strands] if last < first < math.inf else strands


def fit_head(roots: list[Point]) -> Optional[tuple[Point, float]]:
    """The sphere through the four fifths of the roots that lie best on one: a ponytail's roots hang in the air."""
    sphere = fit_sphere(roots)
    for _ in range(10):
        if sphere is None:
            return None
        center, radius = sphere
        off = sorted((abs(math.dist(p, center) - radius), i) for i, p in enumerate(roots))
        sphere = fit_sphere([roots[i] for _, i in off[:max(4, len(roots) * 4 // 5)]])
    return sphere


def spacing(points: list[Point], nth: int) -> float:
    """Median distance of a point to its nth nearest neighbour, or 0 where there are too few."""
    if len(points) <= nth:
        return 0.0
    return statistics.median(sorted(math.dist(p, other) for other in points)[nth] for p in points)


def to_hairstyle(files: list[list[Strand]], motion: str = "none", unit: Optional[float] = None,
                 center: Optional[Point] = None, diameter: Optional[float] = None, sides: int = 6,
                 tolerance: float = 0.0005) -> tuple[dict[str, Any], list[str]]:
    """The hairstyle, and notes for a person. `unit` in metres, `center` where the head's center goes, `diameter` in metres."""
    files = [root_first(strands) for strands in files]
    roots = [strand[0] for strands in files for strand in strands]
    middle, radius, fitted = find_head(roots, fit_head(roots))
    unit = unit or HEAD_RADIUS / radius
    at = center or [0.0, 0.0, 0.0]
    half_turn = (-unit, unit, -unit)
    files = [[[[round(at[i] + half_turn[i] * (p[i] - middle[i]), 6) for i in range(3)] for p in strand]
              for strand in strands] for strands in files]
    all_strands = [strand for strands in files for strand in strands]
    widest = [strand[round((len(strand) - 1) * WIDEST_AT / 100)] for strand in all_strands]
    diameter = diameter or spacing(widest, 4) or 0.005
    at_100 = up_to_millimetre(diameter)
    tufts = [{
        "name": f"f{file}_{index:04d}",
        "points": strand,
        "diameter": max(1.0, round(100 * diameter / at_100, 4)),
        "widest_at": WIDEST_AT,
        "taper": "round",
        "section": "circle",
        "joints": 4,
    } for file, strands in enumerate(files, 1) for index, strand in enumerate(strands, 1)]
    hairstyle = {
        "head": {"center": at, "up": [0, 1, 0], "front": [0, 0, 1], "root_depth": 0.005, "diameter_at_100": at_100},
        "tufts": tufts,
        "mesh": {"tolerance": tolerance, "sides": sides, "layout": "merged"},
    }
    notes = [
        f"head center {[round(x, 2) for x in middle]}, radius {radius:.2f} units "
        f"({'fitted to' if fitted else 'guessed from'} {len(roots)} roots), moved to {at}",
        f"1 unit = {unit:.6f} m, so the head's radius is {unit * radius:.4f} m",
        f"diameter {1000 * diameter:.1f} mm; the median root is {1000 * spacing([s[0] for s in all_strands], 1):.1f} mm from its nearest",
    ]
    block = motion_block(motion)
    return ({**hairstyle, "motion": block} if block else hairstyle), notes


def main(arguments: Optional[list[str]] = None) -> int:
    parser = argparse.ArgumentParser(description="TressFX strands to a Tuftwave hairstyle.")
    parser.add_argument("files", nargs="+", help=".tfx files of one head")
    parser.add_argument("--out", default="-", help="where the hairstyle goes (standard output)")
    parser.add_argument("--motion", choices=list(MOTIONS), default="none")
    parser.add_argument("--unit", type=float, help="metres in a unit of the files (default: a life-size head)")
    parser.add_argument("--center", type=float, nargs=3, metavar=("X", "Y", "Z"), help="where the head's center goes, metres (0 0 0)")
    parser.add_argument("--diameter", type=float, help="of every strand, metres (default: neighbours touch)")
    parser.add_argument("--sides", type=int, default=6, help="corners of a ring (%(default)s)")
    parser.add_argument("--tolerance", type=float, default=0.0005, help="of the mesh, metres (%(default)s)")
    options = parser.parse_args(arguments)
    for name in ("unit", "diameter"):
        if getattr(options, name) is not None and not getattr(options, name) > 0:
            parser.error(f"--{name} must be above 0")
    files: list[list[Strand]] = []
    path = ""
    try:
        for path in options.files:
            with open(path, "rb") as file:
                files.append(read_tfx(file.read()))
        path = options.out
        hairstyle, notes = to_hairstyle(files, options.motion, options.unit, options.center, options.diameter,
                                        options.sides, options.tolerance)
        write_json(hairstyle, path)
    except (OSError, ValueError) as error:
        print(f"strands_to_hairstyle: {path}: {error}", file=sys.stderr)
        return 1
    print(f"{len(hairstyle['tufts'])} tufts", *notes, sep="\n", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
