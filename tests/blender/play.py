"""Run by Blender for check_blender.py: opens what the add-on made, and compares every frame with the service's answer.

    blender --background --python tests/blender/play.py -- URL ADDON FOLDER CHARACTERS

What is expected are the positions in the answer; what is found are the heads and tails of pose bones, so rotations, axes and
parents are all checked by where they lead.
"""

import importlib.util
import json
import os
import sys
import urllib.request

import bpy
from mathutils import Matrix, Quaternion, Vector

URL, ADDON, FOLDER, CHARACTERS = sys.argv[sys.argv.index("--") + 1:]
TOLERANCE = 1e-4  # of a chain's length
NEAR_FRAME = 1e-3  # glTF keys lie just below their frames

spec = importlib.util.spec_from_file_location("tuftwave_hair", ADDON)
hair = importlib.util.module_from_spec(spec)
sys.modules["tuftwave_hair"] = hair
spec.loader.exec_module(hair)

counts = {"passed": 0, "failed": 0}


def check(name, is_right, said=""):
    counts["passed" if is_right else "failed"] += 1
    if not is_right:
        print(f"FAILED {name}: {said}")


def length_of(nodes):
    return sum((b - a).length for a, b in zip(nodes, nodes[1:]))


def picture_at(schedule, frame):
    frame %= schedule["frames"]
    return max(j for j, start in enumerate(schedule["starts"]) if start <= frame)


def found_nodes(armature, chain):
    """Where the nodes of a chain are in the current frame, in the world."""
    seen = armature.evaluated_get(bpy.context.evaluated_depsgraph_get())
    bones = [seen.pose.bones[name] for name in chain.bones]
    at_rest = armature.matrix_world.inverted() @ chain.nodes[-1]
    ends = [child.head for child in bones[-1].children if (child.bone.head_local - at_rest).length < 1e-6]
    return [seen.matrix_world @ v for v in [*(bone.head for bone in bones), ends[0] if ends else bones[-1].tail]]


def expected_nodes(pose, moved=Matrix()):
    return [moved @ hair.from_gltf(v) for v in pose["positions"]]


def error_of(found, expected, length):
    """The largest distance of a node from where it should be, as a share of the chain's length. An invented end is left out."""
    return max((a - b).length for a, b in zip(found, expected)) / length


def check_frames(name, armature, chains, answer, start, moved=Matrix(), compare_ends=True):
    """Two cycles, each frame where it begins and just before it ends."""
    schedule, wrong, worst = answer["schedule"], [], 0.0
    scene = bpy.context.scene
    for frame in range(2 * schedule["frames"]):
        for within in (0.0, 0.99):
            scene.frame_set(start + frame, subframe=within)
            picture = answer["pictures"][picture_at(schedule, frame)]
            errors = []
            for chain, pose in zip(chains, picture["chains"]):
                found, expected = found_nodes(armature, chain), expected_nodes(pose, moved)
                last = len(found) if compare_ends else -1
                errors.append(error_of(found[:last], expected[:last], length_of(expected)))
            worst = max(worst, *errors)
            if max(errors) > TOLERANCE:
                wrong.append(frame + within)
    check(f"{name}: frames", not wrong, f"{len(wrong)} wrong of {4 * schedule['frames']}: {wrong[:8]}, worst {worst:.2g} of the length")
    tips = [[hair.from_gltf(p["chains"][c]["positions"][-1]) for p in answer["pictures"]] for c in range(len(chains))]
    apart = max((a - b).length / length_of(chain.nodes) for tip, chain in zip(tips, chains) for a, b in zip(tip, tip[1:]))
    check(f"{name}: the pictures differ", apart > 100 * TOLERANCE, f"by {apart:.2g} only")
    return worst


def check_keys(name, armature, bones, frames):
    curves = [c for c in hair.curves_of(armature) if c.data_path.endswith("rotation_quaternion") and any(f'"{bone}"' in c.data_path for bone in bones)]
    check(f"{name}: curves", len(curves) == 4 * len(bones), f"{len(curves)} for {len(bones)} bones")
    kinds = {point.interpolation for curve in curves for point in curve.keyframe_points}
    check(f"{name}: interpolation", kinds == {"CONSTANT"}, kinds)
    wrong = [k for k in ([point.co[0] for point in curve.keyframe_points] for curve in curves)
             if len(k) != len(frames) or any(abs(a - b) > NEAR_FRAME for a, b in zip(k, frames))]
    check(f"{name}: key frames", not wrong, f"{wrong[:1]} instead of {frames}")


def frames_of(schedule, start):
    return [start + first for first in schedule["starts"]] + [start + schedule["frames"]]


def check_found(name, chains, character):
    """The chains that the add-on finds are those that the service finds in the file itself, ends and all."""
    found = json.loads(post_character(os.path.join(CHARACTERS, character), "json", "hair"))["chains"]
    expected = sorted([bone["name"] for bone in chain["bones"]] for chain in found)
    check(f"{name}: chains", sorted(chain.bones for chain in chains) == expected, f"{sorted(chain.bones for chain in chains)} instead of {expected}")


def check_turns_of(name, answer):
    """An older service states local rotations only; they must lead to the turns that this one states."""
    poses = [pose for picture in answer["pictures"] for pose in picture["chains"]]
    apart = max(a.rotation_difference(b).angle for pose in poses
                for a, b in zip(hair.turns_of({"rotations": pose["rotations"]}), hair.turns_of(pose)))
    check(f"{name}: turns are local rotations added up", apart < 1e-5, f"{apart} rad apart")


def check_made_files():
    """What the add-on wrote as a script, see TIMINGS of check_blender.py."""
    timings = [(0, {"period": 0.45}, 24), (7, {"period": 0.8, "hold": 3}, 30), (0, {"period": 0.58}, "24000/1001")]
    for number, (start, timing, fps) in enumerate(timings):
        folder = os.path.join(FOLDER, f"timing{number}")
        for file in sorted(os.listdir(folder)):
            name = f"timing{number}/{file}"
            bpy.ops.wm.open_mainfile(filepath=os.path.join(folder, file), load_ui=False)
            scene, armature = bpy.context.scene, next(o for o in bpy.data.objects if o.type == "ARMATURE")
            chains = hair.find_chains(armature, hair.hair_bones(armature))
            settings = {key: default for key, default, _, _ in hair.SETTINGS}
            answer = hair.ask(URL, hair.request_body(armature, chains, {**settings, **timing, "spread": 0.4}, (1, 0, 0), fps))
            schedule = answer["schedule"]
            check_turns_of(name, answer)
            worst = check_frames(name, armature, chains, answer, start)
            check_keys(name, armature, {bone for chain in chains for bone in chain.bones}, frames_of(schedule, start))
            check(f"{name}: range", (scene.frame_start, scene.frame_end) == (start, start + schedule["frames"] - 1))
            check(f"{name}: frame rate", hair.frame_rate(scene) == fps, hair.frame_rate(scene))
            if number == 0:
                check_found(name, chains, next(c for c in os.listdir(CHARACTERS) if file.startswith(os.path.splitext(c)[0] + ".hair")))
                print(f"  {file}: {len(chains)} chains, worst node {worst:.1g} of its chain's length")


def post_character(path, word, kinds):
    with open(path, "rb") as file:
        request = urllib.request.Request(f"{URL}/v1/characters/motion?format={word}&kinds={kinds}", data=file.read(), method="POST",
                                         headers={"Content-Type": "model/gltf-binary"})
    with urllib.request.urlopen(request) as response:
        return response.read()


def check_clips():
    """What /v1/characters/motion answers, imported by Blender's own importer."""
    for file in ("godette.vrm0.vrm", "godette.vrm1.vrm", "pmca_sample3.glb", "vroid_Vita.chains.glb"):
        path, copy = os.path.join(CHARACTERS, file), os.path.join(FOLDER, "clip.glb")
        answer = json.loads(post_character(path, "json", "hair,ribbon"))
        with open(copy, "wb") as out:
            out.write(post_character(path, "glb", "hair,ribbon"))
        hair.open_file(copy, "24")
        armature = next(o for o in bpy.data.objects if o.type == "ARMATURE")
        chains = [hair.Chain([bone["name"] for bone in chain["bones"]], [hair.from_gltf(bone["position"]) for bone in chain["bones"]]
                             + [hair.from_gltf(chain["tip"]["position"])]) for chain in answer["chains"]]
        check_keys(f"clip of {file}", armature, {bone for chain in chains for bone in chain.bones}, frames_of(answer["schedule"], 0))
        for curve in hair.curves_of(armature):
            curve.modifiers.new("CYCLES")
            curve.update()
        # Blender invents the ends of last bones; nodes before them, and ends that are bones, are compared.
        for chain, description in zip(chains, answer["chains"]):
            tip = description["tip"].get("name")
            if tip in armature.pose.bones:
                chain.bones.append(tip)
                for picture in answer["pictures"]:
                    pose = next(p for p in picture["chains"] if p["name"] == description["name"])
                    pose["positions"].append(pose["positions"][-1])  # the tip's own end, which is not compared
        check_frames(f"clip of {file}", armature, chains, answer, 0, compare_ends=False)


def make_armature(bones, matrix):
    """An armature of bones (name, parent, head, tail, roll), in pose mode."""
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    armature = bpy.data.objects.new("Rig", bpy.data.armatures.new("Rig"))
    bpy.context.collection.objects.link(armature)
    armature.matrix_world = matrix
    bpy.context.view_layer.objects.active = armature
    bpy.ops.object.mode_set(mode="EDIT")
    for name, parent, head, tail, roll in bones:
        bone = armature.data.edit_bones.new(name)
        bone.head, bone.tail, bone.roll = head, tail, roll
        bone.parent = armature.data.edit_bones[parent] if parent else None
    bpy.ops.object.mode_set(mode="POSE")
    return armature


def skew_rig():
    """A head with two locks of skewed bones with gaps, one of which forks, on an object that is turned, moved and scaled."""
    bones = [("Root", None, (0, 0, 0), (0, 0.1, 1), 0.3), ("head", "Root", (0, 0, 1.4), (0.02, 0.01, 1.6), 0.2), ("Jaw", "head", (0, 0, 1.4), (0, -0.1, 1.4), 0)]
    for lock, x in (("a", -0.1), ("b", 0.1)):
        parent = "head"
        for i in range(4):
            name = f"{lock}\"{i}"  # a quote in a name must not break data paths
            bones.append((name, parent, (x, 0.05 * i, 1.5 - 0.1 * i), (x + 0.01 * i, 0.05 * i + 0.03, 1.42 - 0.1 * i), 0.7 * i))
            parent = name
    for fork in ("left", "right"):
        bones.append((fork, "b\"3", (0.1, 0.2, 1.1), (0.1 + (0.05 if fork == "left" else -0.05), 0.2, 1.0), 1.0))
    matrix = Matrix.Translation((1, 2, 3)) @ Quaternion((0.9, 0.2, -0.3, 0.1)).normalized().to_matrix().to_4x4() @ Matrix.Scale(1.5, 4)
    return make_armature(bones, matrix)


def chains_by_root(armature, names):
    return {chain.bones[0]: chain for chain in hair.find_chains(armature, names)}


def check_operator():
    """The add-on as it is installed, on selected bones, with a head that is posed."""
    bpy.ops.preferences.addon_install(filepath=ADDON, overwrite=True)
    bpy.ops.preferences.addon_enable(module="tuftwave_hair")
    addon = bpy.context.preferences.addons["tuftwave_hair"]
    addon.preferences.server = URL
    armature = skew_rig()
    found = chains_by_root(armature, hair.hair_bones(armature))
    check("chains below the head", {root: len(c.bones) for root, c in found.items()} == {'a"0': 4, 'b"0': 4, "left": 1, "right": 1}, found)
    for bone in armature.data.bones:
        bone.select = bone.name.startswith(("a", "b"))
    head = armature.pose.bones["head"]
    rest = armature.matrix_world @ head.matrix @ armature.matrix_world.inverted()
    head.rotation_mode, head.rotation_quaternion = "QUATERNION", Quaternion((0.8, 0.1, 0.5, -0.2)).normalized()
    bpy.context.view_layer.update()
    moved = armature.matrix_world @ head.matrix @ armature.matrix_world.inverted() @ rest.inverted()
    settings = bpy.context.scene.tuftwave_hair
    settings.wind, settings.period, settings.spread, settings.one_sided, settings.start = (0.3, -1, 0.2), 0.5, 0.7, True, 3
    for again, settings.hold in (("first", 2), ("again, with fewer keys", 3)):
        check(f"operator, {again}", bpy.ops.pose.tuftwave_hair() == {"FINISHED"})
        chains = hair.find_chains(armature, {bone.name for bone in armature.data.bones if bone.select})
        values = {name: getattr(settings, name) for name, _, _, _ in hair.SETTINGS}
        answer = hair.ask(URL, hair.request_body(armature, chains, values, settings.wind, 24))
        check_frames(f"operator, {again}", armature, chains, answer, 3, moved)
        names = {bone.replace('"', '\\"') for chain in chains for bone in chain.bones}
        check_keys(f"operator, {again}", armature, names, frames_of(answer["schedule"], 3))
    check("other bones have no keys", {curve.data_path.split('"')[1][:1] for curve in hair.curves_of(armature)} == {"a", "b"})
    check_refusals(armature, addon)
    check_thread(armature)
    bpy.ops.preferences.addon_disable(module="tuftwave_hair")
    check("unregistered", not hasattr(bpy.types.Scene, "tuftwave_hair"))


def refusal():
    """What the operator says when it refuses."""
    try:
        return str(bpy.ops.pose.tuftwave_hair())
    except RuntimeError as error:  # an operator's ERROR report, when a script calls it
        return str(error)


def check_refusals(armature, addon):
    settings = bpy.context.scene.tuftwave_hair
    settings.period = 99
    check("a refused value is told", "/motion/timing/period" in refusal(), refusal())
    settings.period = 0.45
    for address, text in (("ftp://example", "must begin with"), ("http://127.0.0.1:1", "No Tuftwave service")):
        addon.preferences.server = address
        check(f"{address} is told", text in refusal(), refusal())
    addon.preferences.server = URL
    armature.scale = (1, 2, 1)
    bpy.context.view_layer.update()
    check("uneven scale is told", "scaled unevenly" in refusal(), refusal())
    armature.scale = (1.5, 1.5, 1.5)
    bpy.context.view_layer.update()
    for bone in armature.data.bones:
        bone.select = bone.name == "Root"
    check("a single selected bone is a chain", refusal() == "{'FINISHED'}", refusal())


def check_thread(armature):
    """What the panel does while the window stays alive: a thread asks, and a timer applies."""
    said = lambda: bpy.context.window_manager.tuftwave_hair_said  # noqa: E731
    chains = hair.find_chains(armature, {"left", "right"})
    settings = {key: default for key, default, _, _ in hair.SETTINGS}
    body = hair.request_body(armature, chains, settings, (1, 0, 0), 24)
    pending = hair.Pending(armature, chains, URL, body, 1, False, True)
    pending.thread.join()
    check("a timer applies what a thread got", pending.poll() is None and "2 chains move, 6 pictures in 11 frames." in said(), said())
    check("and sets the range", (bpy.context.scene.frame_start, bpy.context.scene.frame_end) == (1, 11))
    check_keys("by a timer", armature, {"left", "right"}, [1, 3, 5, 7, 9, 11, 12])
    pending = hair.Pending(armature, chains, URL, body, 1, False, True)
    pending.armature = "Gone"
    pending.thread.join()
    check("an armature that is gone is told", pending.poll() is None and "has changed meanwhile" in said(), said())
    pending = hair.Pending(armature, chains, URL, {}, 1, False, True)
    pending.thread.join()
    check("a refusal is told", pending.poll() is None and "/chains" in said(), said())


def check_turns():
    """A service that states turns is believed; local rotations that lie beside them are not added up."""
    turned = {"turns": [[0, 0, 1, 0]], "rotations": [[1, 0, 0, 0]]}
    added = hair.turns_of({"rotations": [[0, 0, 0.5 ** 0.5, 0.5 ** 0.5]] * 2})[1]
    check("rotations are added up", added.rotation_difference(Quaternion((0, 0, -1, 0))).angle < 1e-6, added)
    check("turns are used", hair.turns_of(turned)[0].rotation_difference(Quaternion((0, 0, -1, 0))).angle < 1e-6, hair.turns_of(turned))


class Slotted:
    """As much of Blender 4.4's and 5's animation data as the add-on touches: curves lie in the bag of a slot."""

    class Strip:
        def __init__(self, bags):
            self.channelbag = bags.get

    class Data:
        pass

    def __init__(self, bags, slot):
        layer, self.animation_data = self.Data(), self.Data()
        layer.strips = [self.Strip(bags)]
        self.animation_data.action, self.animation_data.action_slot = self.Data(), slot
        self.animation_data.action.layers = [layer]


def check_later_blenders():
    bag = Slotted.Data()
    bag.fcurves = ["curve"]
    check("curves of a slot", hair.curves_of(Slotted({"Rig": bag}, "Rig")) == ["curve"])
    check("a slot without curves", hair.curves_of(Slotted({}, "Rig")) is None)
    for address, is_here in (("http://127.0.0.1:8080", True), ("http://localhost", True), ("http://[::1]:1", True), ("https://example.org", False)):
        check(f"{address} is this machine: {is_here}", hair.is_this_machine(address) == is_here)


def check_folder():
    """The folder, as an extension loads it: its settings are kept under the folder's own name."""
    bpy.ops.preferences.addon_enable(module="tuftwave_folder")
    addon = bpy.context.preferences.addons.get("tuftwave_folder")
    check("the folder is an add-on", addon is not None and addon.preferences.server.startswith("http"), addon)
    bpy.ops.preferences.addon_disable(module="tuftwave_folder")


def check_rates():
    scene = bpy.context.scene
    for rate, expected in (("24", 24), ("24000/1001", "24000/1001"), ("30000/1001", "30000/1001"), ("12.5", 12.5), ("60", 60)):
        hair.set_frame_rate(scene, rate)
        check(f"frame rate {rate}", hair.frame_rate(scene) == expected, hair.frame_rate(scene))


def main():
    check_turns()
    check_later_blenders()
    check_rates()
    check_made_files()
    check_clips()
    check_operator()
    check_folder()
    print(f"{counts['passed']} passed, {counts['failed']} failed", flush=True)
    return 1 if counts["failed"] or not counts["passed"] else 0


sys.exit(main())
