"""Asks a server for glTF files of every kind, validates them and plays them; and for other tools' poses of the same hair.

    python3 tests/gltf/check_gltf.py --server build/release/server/tuftwave-server [--out build/gltf]

Needs Node.js and `npm ci` in this folder. Without --out the files go to a temporary directory. Exit code 0 or 1.
"""

from __future__ import annotations

import argparse
import base64
import json
import os
import re
import subprocess
import sys
import tempfile
from typing import Any, Iterator, Optional

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "..", ".."))
sys.path.insert(0, os.path.join(HERE, "..", "contract"))

from service import Service  # noqa: E402
from uploads import write_uploads  # noqa: E402

PIPELINE = os.path.join(ROOT, "client-examples", "pipeline")
DATA = os.path.join(ROOT, "tests", "data")
PYTHON = os.environ.get("PYTHON", "/usr/bin/python3")
HEADS = ("Vita", "Sendagaya_Shibu", "Sakurada_Fumiriya")
FRAME_RATES = (12, 24, 25, 30, 60, "24000/1001")
PERIODS = (0.45, 0.8, 0.58, 0.33)
HOLDS = (1, 2, 3)
Body = dict[str, Any]


def example(name: str) -> Body:
    with open(os.path.join(ROOT, "api", "examples", f"{name}.json"), encoding="utf-8") as file:
        return json.load(file)


def converted(script: str, *arguments: str) -> Body:
    """The hairstyle that a converter of client-examples makes of somebody else's file."""
    made = subprocess.run([PYTHON, "-B", os.path.join(PIPELINE, script), *arguments, "--motion", "breeze"], capture_output=True, check=True)
    return json.loads(made.stdout)


def people() -> Iterator[tuple[str, Body]]:
    for head in HEADS:
        yield f"vroid_{head}", converted("strokes_to_hairstyle.py", os.path.join(DATA, "strokes", f"vroid_{head}.strokes.json"))
    strands = os.path.join(DATA, "strands")
    yield "tressfx_ponytail", converted("strands_to_hairstyle.py", *(os.path.join(strands, name) for name in sorted(os.listdir(strands))))


def tight_tufts() -> list[Body]:
    """Strokes that bend more tightly than they are thick, or come back on themselves."""
    zigzag = [[0.1 if i % 2 else 0.14, 0.05 - 0.01 * i, 0] for i in range(10)]
    return [
        {"name": "hairpin", "points": [[0, 0.1, 0], [0.1, 0.1, 0], [0.15, 0.105, 0], [0.1, 0.11, 0], [0, 0.11, 0]]},
        {"name": "zigzag", "points": zigzag, "section": "ellipse", "flatness": 0.98, "twist_deg": 720},
        {"name": "there_back", "points": [[0, 0.1, 0], [0, 0.2, 0], [0, 0.1, 0]]},
        {"name": "short", "points": [[0, 0.1, 0], [0, 0.1001, 0]], "diameter": 100},
    ]


NAMES = ["\u524d\u9aea", "", "a", "a", "a_01", "a_02", "hair_root", "hair", "has a blank", "dotted.001", "1st", "thirteen_byte", "x_loop", "x_COL",
         "tuft_0001", "tuft_0001_01", "b_01", "b", "b_01_01", "wave", "quote\"\\", "A", "a_1", "a_001"]


def stills() -> Iterator[tuple[str, Body]]:
    """Bodies of /v1/tufts."""
    yield "example_tufts", example("tufts")
    fringe = example("tufts")["tufts"][0]
    for taper in ("sine", "linear", "smooth", "round"):
        yield f"still_{taper}", {"tufts": [{**fringe, "taper": taper}]}
    yield "still_flat_cap", {"tufts": [{**fringe, "widest_at": 100}]}
    yield "still_coarse", {"tufts": [fringe], "mesh": {"rings": 2, "sides": 3}}
    yield "still_one_bone", {"tufts": [{**fringe, "joints": 1}]}
    yield "still_64_bones", {"tufts": [{**fringe, "joints": 64}], "mesh": {"sides": 64}}
    yield "still_tight", {"tufts": tight_tufts()}
    yield "still_far_away", {"head": {"center": [999999, -999999, 999999]}, "tufts": [{"points": [[999999, -999999, 999990], [999990, -999980, 999980]], "diameter": 100}]}
    yield "still_ring_on_a_bone", {"tufts": [{"points": [[0, 0.1, 0], [0, 0.3, 0]], "joints": 13}], "mesh": {"rings": 25}}  # some ring lies next to the middle of a bone
    yield "still_many_vertices", {"tufts": [fringe], "mesh": {"rings": 1100, "sides": 60}}


def fills() -> Iterator[tuple[str, Body]]:
    """Bodies of /v1/fills."""
    back = example("fills")
    yield "example_fills", back
    yield "fill_merged", {**back, "mesh": {"layout": "merged"}}
    free = {"head": {}, "fill": {**back["fill"], "min_gap": 0}}
    ring = {**free["fill"], "to": None, "density": {"along": 60, "crown": 100, "neck": 100}}
    yield "fill_without_scalp", free
    yield "fill_ring", {**free, "fill": ring}
    yield "fill_ring_as_printed", {**free, "fill": {**ring, "formulas": "as_printed"}}
    yield "fill_foreign_name", {**free, "fill": {**ring, "name": "\u9aea"}}
    pole = {"points": [[0, 0.1, 0], [0, 0.2, 0.01]]}
    yield "fill_from_the_pole", {"fill": {"from": pole, "density": {"along": 100, "neck": 90}, "jitter": {}}}
    yield "fill_to_the_pole", {**free, "fill": {**free["fill"], "to": {**pole, "diameter": 100}}}
    opposite = {"points": [[0.1, 0, 0], [0.2, 0, 0], [0.1, 0, 0]]}
    yield "fill_there_back", {"head": {"root_depth": 0}, "fill": {"from": opposite, "density": {"along": 50, "crown": 50}}}
    yield "fill_small_scalp", {**back, "head": {"scalp": {"ellipsoid": {"radii": [0.08, 0.07, 0.09], "center": [0, 0.01, 0]}}}}
    yield "fill_large_scalp", {**back, "head": {"scalp": {"ellipsoid": {"radii": [0.12, 0.15, 0.13]}}}}


# Around the head 720 times and up and down from there; small meshes with few bones.
MANY = {"head": {"diameter_at_100": 0.01},
        "fill": {"from": {"points": [[0.1, 0, 0], [0.11, -0.05, 0]], "joints": 1}, "tufts_per_meter": 1146, "density": {"along": 100, "crown": 100, "neck": 100}, "jitter": {}},
        "mesh": {"rings": 3, "sides": 4}}
MANY_TUFTS = 10000


def hairs() -> Iterator[tuple[str, Body]]:
    """Bodies of /v1/hairstyles, all of which move."""
    bob = example("hairstyles")
    yield "example_hairstyles", bob
    yield "hair_merged", {**bob, "mesh": {"layout": "merged"}}
    yield "hair_tight", {**bob, "tufts": tight_tufts()}
    yield "hair_names", {**bob, "tufts": [{**bob["tufts"][0], "name": name} for name in NAMES]}
    yield "hair_names_merged", {**bob, "tufts": [{**bob["tufts"][0], "name": name} for name in NAMES], "mesh": {"layout": "merged"}}
    yield "hair_flat_cap", {**bob, "tufts": [{**bob["tufts"][0], "widest_at": 100}]}
    yield "hair_absolute", {**bob, "motion": {**bob["motion"], "mode": "absolute", "one_sided": False}}
    yield "hair_on_its_side", {**bob, "head": {"up": [1, 0, 0]}, "motion": {**bob["motion"], "wind": [0, -1, 1]}}
    yield "hair_closed", {**bob, "head": {"root_depth": 0}, "tufts": [{"points": [[0.1, 0, 0], [0.2, 0, 0], [0.1, 0, 0]], "joints": 1}]}
    yield "hair_wild", {**bob, "motion": {"wave": {"amplitude": 100, "spatial_period": -0.05, "lightness": -0.05, "tip_exponent": 8}}}
    filled = {**bob, "head": {**bob["head"], "scalp": {"ellipsoid": {"radii": [0.1, 0.1, 0.1]}}},
              "fills": [{"from": "back_R1", "to": "back_L1", "density": {"along": 80, "crown": None, "neck": 30}, "jitter": {"seed": 1}},
                        {"from": "fringe_L2", "to": "fringe_R2", "direction": "shorter", "name": "\u524d\u9aea"}, {"from": "ahoge", "density": {"along": 20}}]}
    yield "hair_filled", filled
    yield "hair_filled_merged", {**filled, "mesh": {"layout": "merged"}}
    for head, body in people():
        for layout in ("per_tuft", "merged"):
            yield f"{head}_{layout}", {**body, "mesh": {**body["mesh"], "layout": layout}}


def chains() -> Iterator[tuple[str, Body]]:
    """Bodies of /v1/motions."""
    hanging = example("motions")
    yield "example_motions", hanging
    turned = {"name": "turned", "nodes": hanging["chains"][0]["nodes"], "parent_rotation": [0.1, -0.2, 0.3, 0.9],
              "rest_rotations": [[0.1 * i, 0.2, -0.1 * i, 1 - 0.1 * i] for i in range(7)]}
    flipped = {"name": "flipped", "nodes": [[0, 0.1, 0], [0, 0, 0], [0, 0, 0], [0.1, 0, 0]], "parent_rotation": [0, 0, 0, -2]}
    yield "chains_turned", {**hanging, "chains": [turned, {**turned, "parent_rotation": [0, 0, 0, 1]}, flipped]}
    oblique = {"name": "oblique", "nodes": [[0, 0, 0], [0.03, -0.1, 0.05], [-0.02, -0.2, 0.02], [0.04, -0.22, -0.06]]}
    yield "chains_oblique", {"chains": [turned, oblique], "motion": {"wave": {"amplitude": 3}, "wind": [1, 0.4, -0.7], "lift": 0.3}}  # turned about all three axes
    yield "chains_names", {**hanging, "chains": [{**hanging["chains"][0], "name": name} for name in NAMES]}
    yield "chains_longest", {"chains": [{"nodes": [[0, -0.01 * i, 0.001 * (i % 3)] for i in range(65)]}], "motion": {"timing": {"period": 1, "hold": 1}}}
    yield "chains_one_picture", {**hanging, "motion": {"timing": {"period": 0.05}}}


def timings() -> Iterator[tuple[str, Body]]:
    for fps in FRAME_RATES:
        for hold in HOLDS:
            for period in PERIODS:
                name = f"{str(fps).replace('/', '-')}fps_{hold}s_{round(period * 1000)}ms"
                for short_holds in ("last", "spread") if period == 0.45 else ("last",):
                    yield f"{name}_{short_holds}", {"period": period, "fps": fps, "hold": hold, "short_holds": short_holds}


def fitting_timings() -> Iterator[tuple[str, Body]]:
    """Those without too many pictures."""
    for name, timing in timings():
        if timing["period"] * rate_of(timing["fps"]) / timing["hold"] <= 24:
            yield name, timing


class Files:
    """Answers written to a directory; a refusal is a failed check."""

    def __init__(self, service: Service, directory: str) -> None:
        self.service, self._directory = service, directory
        self.passed = self.failed = 0

    def check(self, name: str, fault: str) -> None:
        self.failed += bool(fault)
        self.passed += not fault
        if fault:
            print(f"FAILED {name}: {fault}")

    def write(self, operation: str, name: str, body: Body, *formats: str, query: str = "") -> dict[str, bytes]:
        """@return  the files by format; those before the first refusal"""
        text = json.dumps(body, ensure_ascii=False)
        bytes_of: dict[str, bytes] = {}
        for word in formats:
            answer = self.service.post(f"/v1/{operation}?format={word}{query}", text)
            self.check(f"{name}.{word}", "" if answer.status == 200 else f"{answer.status} {answer.body[:300]!r}")
            if answer.status != 200:
                return bytes_of
            bytes_of[word] = answer.body
            with open(os.path.join(self._directory, f"{name}.{word}"), "wb") as file:
                file.write(answer.body)
        if "gltf" in formats:
            self.check(f"{name}: GLB and glTF", "" if unpacked(bytes_of["glb"]) == embedded(bytes_of["gltf"]) else "differ in more than their packing")
        return bytes_of


def unpacked(glb: bytes) -> tuple[Any, bytes]:
    """The JSON and the buffer of a GLB, padding cut off."""
    size = int.from_bytes(glb[12:16], "little")
    gltf = json.loads(glb[20:20 + size])
    return gltf, glb[28 + size:][:gltf["buffers"][0]["byteLength"]]


def embedded(text: bytes) -> tuple[Any, bytes]:
    gltf = json.loads(text)
    head, data = gltf["buffers"][0].pop("uri").split(",")
    assert head == "data:application/octet-stream;base64", head
    return gltf, base64.b64decode(data)


def write_files(files: Files) -> None:
    for name, body in stills():
        files.write("tufts", name, body, "glb", "gltf")
    for name, body in fills():
        files.write("fills", name, body, "glb", "gltf")
    write_many(files)
    for name, body in hairs():
        files.write("hairstyles", name, body, "json", "glb", *([] if "tressfx" in name else ["gltf", "bvh", "usda"]))
    for name, body in chains():
        files.write("motions", name, body, "json", "glb", "gltf", "bvh", "usda")
        if name != "chains_longest":  # which has as many pictures as there may be
            write_at_30_fps(files, "motions", name, body)
    write_at_30_fps(files, "hairstyles", "example_hairstyles", example("hairstyles"))
    write_interpolations(files)
    write_flip_books(files)
    write_packed(files)
    tuft = example("hairstyles")["tufts"][0]
    for name, timing in fitting_timings():
        files.write("motions", f"chains_{name}", {**example("motions"), "motion": {"timing": timing}}, "json", "glb")
        files.write("hairstyles", f"tuft_{name}", {"tufts": [tuft], "motion": {"timing": timing}}, "json", "glb")


def write_at_30_fps(files: Files, operation: str, name: str, body: Body) -> None:
    """The frame rate of every VMD, and all formats at it: what is asked for at another rate must give the same VMD."""
    motion = body.get("motion", {})
    at_30 = {**body, "motion": {**motion, "timing": {**motion.get("timing", {}), "fps": 30}}}
    made = files.write(operation, f"{name}_30fps", at_30, "json", "glb", "bvh", "usda", "vmd")
    with tempfile.TemporaryDirectory() as elsewhere:  # not beside the JSON of the other rate
        other = Files(files.service, elsewhere).write(operation, name, body, "vmd")
    files.check(f"{name}: VMD at another rate", "" if made and other == {"vmd": made["vmd"]} else "differs from the one at 30 frames per second")


def write_interpolations(files: Files) -> None:
    """Clips for importers that read STEP as linear, of all timings with chains and of a hairstyle."""
    bodies = [("hairstyles", "hair", example("hairstyles")), ("hairstyles", "hair_merged", {**example("hairstyles"), "mesh": {"layout": "merged"}}),
              *(("motions", f"chains_{name}", {**example("motions"), "motion": {"timing": timing}}) for name, timing in fitting_timings())]
    for operation, name, body in bodies:
        for word in ("held", "per_frame"):
            files.write(operation, f"{name}_{word}", body, "json")
            files.write(operation, f"{name}_{word}", body, "glb", query=f"&interpolation={word}")


def write_flip_books(files: Files) -> None:
    """Each beside the merged clip of the same hair, NAME.glb, which has the same vertices in the same order."""
    bodies = dict(hairs())
    timing = {"period": 0.8, "fps": "24000/1001", "hold": 3}
    bodies["hair_ntsc_merged"] = {**bodies["hair_merged"], "motion": {**example("hairstyles")["motion"], "timing": timing}}
    files.write("hairstyles", "hair_ntsc_merged", bodies["hair_ntsc_merged"], "json", "glb")
    for name in ("hair_merged", "hair_filled_merged", "hair_names_merged", "hair_ntsc_merged", "vroid_Vita_merged"):
        files.write("hairstyles", f"{name}_flip_book", bodies[name], "glb", query="&clip=flip_book")
    for word in ("held", "per_frame"):
        files.write("hairstyles", f"hair_merged_{word}_flip_book", bodies["hair_merged"], "glb", query=f"&clip=flip_book&interpolation={word}")


def write_packed(files: Files) -> None:
    """Each beside the plain file of the same hair, NAME.glb."""
    for operation, bodies in (("tufts", stills()), ("fills", fills()), ("hairstyles", hairs())):
        for name, body in bodies:
            if "tressfx" not in name:  # which takes long to bend
                files.write(operation, f"{name}_packed", body, "glb", query="&compression=meshopt")


def write_many(files: Files) -> None:
    for layout in ("merged", "per_tuft"):
        name = f"fill_many_{layout}"
        glb = files.write("fills", name, {**MANY, "mesh": {**MANY["mesh"], "layout": layout}}, "glb").get("glb")
        if glb:
            gltf, _ = unpacked(glb)
            tufts, meshes = len(gltf["asset"]["extras"]["tuftwave"]["hairstyle"]["tufts"]), len(gltf["meshes"])
            files.check(f"{name}: tufts", "" if tufts >= MANY_TUFTS else f"only {tufts}")
            files.check(f"{name}: meshes", "" if meshes == (1 if layout == "merged" else tufts) else f"{meshes} of {tufts} tufts")


def rate_of(fps: Any) -> float:
    numerator, _, denominator = str(fps).partition("/")
    return float(numerator) / float(denominator or 1)


def run_node(script: str, directory: str) -> tuple[int, int]:
    """Runs a script over the directory and shows what it says. @return  what passed and failed"""
    done = subprocess.run(["node", os.path.join(HERE, script), directory], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    print(f"-- {script}\n{done.stdout.rstrip()}")
    counts = re.search(r"^(\d+) passed, (\d+) failed\s*\Z", done.stdout, re.MULTILINE)
    return (int(counts[1]), int(counts[2])) if counts and done.returncode in (0, 1) else (0, 1)


def check(server: str, directory: str) -> int:
    with Service(server) as service:
        files = Files(service, directory)
        write_files(files)
        write_uploads(service, os.path.join(directory, "uploads"), files.check)
    passed, failed = files.passed, files.failed
    print(f"{len(os.listdir(directory))} files in {directory}")
    for script in ("validate.mjs", "playback.mjs", "flip_book.mjs", "packed.mjs", "poses.mjs", "uploads.mjs"):
        more_passed, more_failed = run_node(script, os.path.join(directory, "uploads") if script == "uploads.mjs" else directory)
        passed, failed = passed + more_passed, failed + more_failed
    print(f"{passed} passed, {failed} failed")
    return 0 if passed and not failed else 1


def main(arguments: Optional[list[str]] = None) -> int:
    parser = argparse.ArgumentParser(description="Validates and plays a server's glTF files.")
    parser.add_argument("--server", default=os.environ.get("TUFTWAVE_SERVER"), help="the program (default: the environment's TUFTWAVE_SERVER)")
    parser.add_argument("--out", help="keep the files in this directory, whose glTF files are replaced")
    options = parser.parse_args(arguments)
    if not options.server or not os.access(options.server, os.X_OK):
        print(f"check_gltf: {options.server!r} is no program; build the server and name it with --server", file=sys.stderr)
        return 1
    if not os.path.isdir(os.path.join(HERE, "node_modules")):
        print("check_gltf: run `npm ci` in tests/gltf first", file=sys.stderr)
        return 1
    if not options.out:
        with tempfile.TemporaryDirectory() as directory:
            return check(options.server, directory)
    os.makedirs(options.out, exist_ok=True)
    for name in os.listdir(options.out):
        if name.endswith((".glb", ".gltf", ".json", ".bvh", ".usda", ".vmd")):
            os.remove(os.path.join(options.out, name))
    return check(options.server, options.out)


if __name__ == "__main__":
    sys.exit(main())
