"""W1 and W2 by Blender without a window: curves to a mesh, bones with constant keys, and its glTF exporter.

    blender --background --factory-startup --python-exit-code 3 --python tests/bench/peers/blender.py -- FOLDER

FOLDER has w1.json and w2.json; the files that it writes go there, too. Prints lines as tests/bench/bench.py reads them.
"""

from __future__ import annotations

import json
import math
import os
import sys
import time
from typing import Any, Callable

import bpy
from mathutils import Quaternion, Vector

WIDEST = 0.02  # radius, metres
PIECES = 9  # between two points of eight: 64 rings
BEVEL = 4  # 12 sides
PICTURES, HOLD = 12, 2
AMPLITUDE, SPATIAL_PERIOD, LIGHTNESS = 0.8, 1.0, 1.2  # a, k, s, as the service has them


def read(folder: str, name: str) -> Any:
    with open(os.path.join(folder, name), encoding="ascii") as file:
        return json.load(file)


def empty() -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)


def link(thing: Any) -> None:
    bpy.context.collection.objects.link(thing)
    bpy.context.view_layer.objects.active = thing
    thing.select_set(True)


def export(path: str, **options: Any) -> None:
    """The exporter's failures leave no trace but a missing file."""
    if os.path.exists(path):
        os.remove(path)
    bpy.ops.export_scene.gltf(filepath=path, export_format="GLB", **options)
    if not os.path.exists(path):
        raise RuntimeError("the exporter wrote nothing")


def tubes(strokes: list[list[list[float]]]) -> None:
    curve = bpy.data.curves.new("hair", "CURVE")
    curve.dimensions, curve.resolution_u = "3D", PIECES
    curve.bevel_depth, curve.bevel_resolution = WIDEST, BEVEL
    for stroke in strokes:
        spline = curve.splines.new("BEZIER")
        spline.bezier_points.add(len(stroke) - 1)
        for i, (point, place) in enumerate(zip(spline.bezier_points, stroke)):
            point.co = place
            point.handle_left_type = point.handle_right_type = "AUTO"
            point.radius = math.sin(math.pi * i / (len(stroke) - 1))
    link(bpy.data.objects.new("hair", curve))
    bpy.ops.object.convert(target="MESH")


def height(x: float, phase: float) -> float:
    """Furukawa and Nakata 2018, equation (1)."""
    return -AMPLITUDE / LIGHTNESS * x / math.pi * (math.cos(x / SPATIAL_PERIOD - phase) + 1 / LIGHTNESS)


def angles_of(nodes: int) -> list[list[float]]:
    """Of bones of equal length, for every picture, their mean taken out."""
    x = [math.pi * i / (nodes - 1) for i in range(nodes)]
    angles = []
    for n in range(PICTURES):
        phase = 2 * math.pi * n / PICTURES
        angles.append([math.atan2(height(x[i + 1], phase) - height(x[i], phase), x[i + 1] - x[i]) for i in range(nodes - 1)])
    means = [sum(bone) / PICTURES for bone in zip(*angles)]
    return [[angle - mean for angle, mean in zip(picture, means)] for picture in angles]


def bones(armature: Any, chains: list[dict[str, Any]]) -> None:
    bpy.ops.object.mode_set(mode="EDIT")
    for chain in chains:
        parent = None
        for i, (head, tail) in enumerate(zip(chain["nodes"], chain["nodes"][1:])):
            bone = armature.data.edit_bones.new(f"{chain['name']}_{i}")
            bone.head, bone.tail, bone.parent = head, tail, parent
            parent = bone
    bpy.ops.object.mode_set(mode="OBJECT")


def clip(chains: list[dict[str, Any]]) -> None:
    bpy.context.scene.render.fps = 24
    armature = bpy.data.objects.new("hair", bpy.data.armatures.new("hair"))
    link(armature)
    bones(armature, chains)
    action = bpy.data.actions.new("breeze")
    armature.animation_data_create().action = action
    axis = Vector((1, 0, 0))
    for chain in chains:
        pictures = angles_of(len(chain["nodes"]))
        for i in range(len(chain["nodes"]) - 1):
            turns = [Quaternion(axis, picture[i] - (picture[i - 1] if i else 0)) for picture in pictures]
            path = f'pose.bones["{chain["name"]}_{i}"].rotation_quaternion'
            for component in range(4):
                key_one(action.fcurves.new(path, index=component), [turn[component] for turn in turns + turns[:1]])


def key_one(fcurve: Any, values: list[float]) -> None:
    fcurve.keyframe_points.add(len(values))
    for n, (key, value) in enumerate(zip(fcurve.keyframe_points, values)):
        key.co = (n * HOLD, value)
        key.interpolation = "CONSTANT"


def measure(name: str, work: Callable[[], None]) -> None:
    empty()
    begin = time.perf_counter()
    work()
    print(json.dumps({"name": name, "ms": [1000 * (time.perf_counter() - begin)]}), flush=True)


def main(folder: str) -> None:
    strokes = [tuft["points"] for tuft in read(folder, "w1.json")["tufts"]]
    chains = read(folder, "w2.json")["chains"]
    mesh, motion = os.path.join(folder, "blender_w1.glb"), os.path.join(folder, "blender_w2.glb")

    def w1() -> None:
        tubes(strokes)
        export(mesh)

    def w2() -> None:
        clip(chains)
        export(motion, export_force_sampling=False, export_frame_range=False)

    measure("w1/blender", w1)
    measure("w2/blender", w2)
    for name, path in (("w1", mesh), ("w2", motion)):
        print(json.dumps({"name": f"{name}_bytes/blender", "value": [os.path.getsize(path)], "unit": "B"}), flush=True)


main(sys.argv[sys.argv.index("--") + 1])
