"""Tuftwave Hair: makes an armature's hair move in held pictures. An add-on for Blender 3.4 to 5, and a script for Blender
without a window:

    blender --background --python client-examples/blender/tuftwave_hair.py -- --server http://127.0.0.1:8080 character.glb

The rest positions of unbranched runs of bones go to POST /v1/motions of a Tuftwave service; its poses come back as CONSTANT
keys where each picture starts, and a closing key at the end of the cycle. Nothing else leaves Blender.

Without a window: files are .blend, .glb, .gltf or .vrm; NAME.vrm becomes NAME.hair.blend beside it or in --out. A failure
leaves exit code 1, wrong options or no service 2.
Installed, it is a panel: 3D viewport, sidebar, tab Tuftwave. It needs only what Blender brings along.
"""

import argparse
import fnmatch
import ipaddress
import json
import math
import os
import re
import sys
import threading
import time
import urllib.error
import urllib.parse
import urllib.request
import warnings
from dataclasses import dataclass

import bpy
from mathutils import Quaternion, Vector

bl_info = {
    "name": "Tuftwave Hair",
    "author": "Tuftwave",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "3D Viewport > Sidebar > Tuftwave",
    "description": "Makes hair move in held pictures, by asking a Tuftwave service",
    "category": "Animation",
}

DEFAULT_SERVER = "http://127.0.0.1:8080"
RETRIES = 5  # of a busy service
LONGEST_WAIT_S = 60.0
TIMEOUT_S = 60.0
SHEARED = 1e-4  # how far the scales of an object's axes may be apart, as a share
HEAD = re.compile(r"(?:^|[^a-z])head(?:$|[^a-z])|^頭$", re.IGNORECASE)
FACE = re.compile(r"eye|brow|lash|jaw|chin|teeth|tooth|tongue|lip|mouth|cheek|nose|目|眉|瞳|顎|あご|口|舌|歯|頬|鼻", re.IGNORECASE)

SETTINGS = [  # name, default, where it goes in the request's motion, what it is
    ("amplitude", 0.8, "wave", "How far the hair swings; 0 is still"),
    ("spatial_period", 1.0, "wave", "How long the wave is along a chain"),
    ("lightness", 1.2, "wave", "A larger value droops less"),
    ("tip_exponent", 1.0, "wave", "How much livelier the tip is than the root"),
    ("period", 0.45, "timing", "Seconds of one cycle"),
    ("hold", 2, "timing", "Frames that a picture is held"),
    ("gust_wavelength", 0.0, "phase", "Metres along the wind between roots one cycle apart; 0 is off"),
    ("spread", 0.0, "phase", "Share of a cycle that chains are scattered over"),
    ("seed", 0, "phase", "For the scatter"),
    ("one_sided", False, "", "Swing away from the head only"),
]


class Failed(Exception):
    """Something that a person should read; the add-on shows it, the script prints it."""


class NoService(Failed):
    """Nobody answered, or nobody may be asked."""


@dataclass
class Chain:
    """An unbranched run of bones, root first, and its nodes at rest: their heads and the end of the last, in the world."""
    bones: list
    nodes: list


# ---- the service ----

def is_this_machine(server):
    host = urllib.parse.urlsplit(server).hostname or ""
    try:
        return host == "localhost" or ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False


def refuse_offline(server):
    """Blender 4.2 and later have a switch for the internet; a service on this machine is not the internet."""
    if not server.startswith(("http://", "https://")):
        raise NoService(f"The service's address must begin with http:// or https://, not {server!r}")
    if not getattr(bpy.app, "online_access", True) and not is_this_machine(server):
        raise NoService("Blender is offline: allow online access in the preferences, System, Network")


def problem_text(status, body):
    """An RFC 9457 problem as lines to read."""
    try:
        problem = json.loads(body)
        errors = [f"{error.get('pointer') or '/'}: {error['detail']}" for error in problem.get("errors", [])]
        return "\n".join([f"{status} {problem['title']}", *(errors or [problem.get("detail", "")])])
    except (ValueError, LookupError, TypeError, AttributeError):
        return f"{status}: {body[:200].decode('utf-8', 'replace') or 'no text'}"


def wait_or_give_up(error, attempt):
    """Waits as long as a busy service asks for. Raises Failed where it is not busy or stays so."""
    text = problem_text(error.code, error.read())
    asked = (error.headers.get("Retry-After") or "").strip()
    wait_s = float(asked) if asked.isdecimal() else min(8.0, 0.5 * 2 ** attempt)
    if error.code not in (429, 503) or attempt == RETRIES or wait_s > LONGEST_WAIT_S:
        raise Failed(text) from None
    time.sleep(wait_s)


def ask(server, body):
    """The answer to a request body of POST /v1/motions. Uses no Blender data, so that a thread may call it. Raises Failed."""
    request = urllib.request.Request(server.rstrip("/") + "/v1/motions", data=json.dumps(body).encode(), method="POST", headers={
        "Content-Type": "application/json", "Accept": "application/json", "User-Agent": "tuftwave-blender"})
    handlers = [urllib.request.ProxyHandler({})] if is_this_machine(server) else []
    for attempt in range(RETRIES + 1):
        try:
            with urllib.request.build_opener(*handlers).open(request, timeout=TIMEOUT_S) as response:
                answer = json.loads(response.read())
                if not isinstance(answer, dict) or "pictures" not in answer:
                    raise ValueError("it answered with no pictures")
                return answer
        except urllib.error.HTTPError as error:
            wait_or_give_up(error, attempt)
        except (OSError, ValueError) as error:
            raise NoService(f"No Tuftwave service at {server}: {getattr(error, 'reason', None) or error}") from None
    raise AssertionError("unreachable: the last attempt returns or raises")


# ---- axes: Blender is Z up and looks to -Y, glTF is Y up and looks to +Z ----

def to_gltf(v):
    return [v[0], v[2], -v[1]]


def from_gltf(v):
    return Vector((v[0], -v[2], v[1]))


def turn_from_gltf(q):
    """A rotation x y z w in glTF axes as Blender's."""
    return Quaternion((q[3], q[0], -q[2], q[1]))


# ---- chains ----

def weighted_groups(armature):
    """The bones that move a vertex of some mesh; None where the armature has no mesh."""
    names = None
    for mesh in bpy.data.objects:
        if mesh.type == "MESH" and any(m.type == "ARMATURE" and m.object == armature for m in mesh.modifiers):
            used = {element.group for vertex in mesh.data.vertices for element in vertex.groups if element.weight > 0}
            names = (names or set()) | {group.name for group in mesh.vertex_groups if group.index in used}
    return names


def find_head(armature):
    """The bone called head that is nearest to the root, or None."""
    heads = [bone for bone in armature.data.bones if HEAD.search(bone.name)]
    return min(heads, key=lambda bone: len(bone.parent_recursive), default=None)


def is_face(bone):
    return any(FACE.search(b.name) for b in [bone, *bone.parent_recursive] if not HEAD.search(b.name))


def hair_bones(armature, patterns=()):
    """The bones that match a pattern; without patterns, those below the head that are not of the face."""
    bones = armature.data.bones
    if patterns:
        return {bone.name for bone in bones if any(fnmatch.fnmatchcase(bone.name, pattern) for pattern in patterns)}
    head = find_head(armature)
    return {bone.name for bone in head.children_recursive if not is_face(bone)} if head else set()


def runs_of(armature, names):
    """The chosen bones as lists from a root down; where chosen bones branch a list ends, and each branch is one of its own."""
    def below(bone):
        return [child for child in bone.children if child.name in names]

    runs = []
    for bone in armature.data.bones:
        parent = bone.parent
        if bone.name in names and not (parent and parent.name in names and len(below(parent)) == 1):
            runs.append([bone])
            while len(below(runs[-1][-1])) == 1:
                runs[-1] += below(runs[-1][-1])
    return runs


def find_chains(armature, names):
    """The chains of the named bones. An end bone that moves no vertex only says where the one before it ends."""
    matrix, weighted = armature.matrix_world, weighted_groups(armature)
    chains = []
    for run in runs_of(armature, names):
        end = run[-1].tail_local
        if weighted is not None:
            if not any(bone.name in weighted for bone in run):
                continue
            if run[-1].name not in weighted and not run[-1].children:
                end = run.pop().head_local
        heads = [bone.head_local for bone in run]
        chains.append(Chain([bone.name for bone in run], [matrix @ v for v in (*heads, end)]))
    return chains


def refuse_sheared(armature):
    scale = armature.matrix_world.to_scale()
    if max(scale) - min(scale) > SHEARED * max(scale) or armature.matrix_world.is_negative:
        raise Failed(f"{armature.name} is scaled unevenly or mirrored: apply its scale first (Ctrl+A)")


# ---- asking ----

def frame_rate(scene):
    """The scene's frames per second as the service takes it: a number, or a fraction as text."""
    rate, base = scene.render.fps, scene.render.fps_base
    if math.isclose(base, 1.001, abs_tol=1e-5):
        return f"{rate * 1000}/1001"
    return rate if base == 1 else round(rate / base, 6)


def set_frame_rate(scene, rate):
    """@param rate  a number, or a fraction as text"""
    above, _, below = str(rate).partition("/")
    number = float(above) / float(below or 1)
    scene.render.fps = max(1, math.ceil(number - 1e-9))
    scene.render.fps_base = scene.render.fps / number


def request_body(armature, chains, settings, wind, fps):
    """The body of POST /v1/motions. Without rest rotations the local rotations that come back turn in the axes of the world."""
    motion = {"wave": {}, "timing": {"fps": fps}, "phase": {}, "wind": to_gltf(wind)}
    for name, _, place, _ in SETTINGS:
        value = settings[name]
        (motion[place] if place else motion)[name] = round(value, 6) if isinstance(value, float) else value
    motion["phase"]["gust_wavelength"] = motion["phase"]["gust_wavelength"] or None
    body = {"chains": [{"name": chain.bones[0], "nodes": [to_gltf(v) for v in chain.nodes]} for chain in chains], "motion": motion}
    head = find_head(armature)
    if head:
        body["head"] = {"center": to_gltf(armature.matrix_world @ ((head.head_local + head.tail_local) / 2))}
    return body


# ---- applying ----

def turns_of(pose):
    """How each node of an answer's chain is turned from rest, in the world."""
    if "turns" in pose:
        return [turn_from_gltf(q) for q in pose["turns"]]
    turns, turn = [], Quaternion()
    for rotation in pose["rotations"]:
        turn = turn @ turn_from_gltf(rotation)
        turns.append(turn)
    return turns


def local_rotations(armature, chain, turns):
    """What to write to the rotation_quaternion of a chain's bones, so that each is turned from rest as the nodes are."""
    world = armature.matrix_world.to_quaternion()
    rotations, above = [], Quaternion()
    for name, turn in zip(chain.bones, turns):
        bone = armature.data.bones[name]
        rest = bone.matrix_local.to_quaternion()
        turn = world.inverted() @ turn @ world
        rotations.append(rest.inverted() @ above.inverted() @ turn @ rest)
        above = turn
    return rotations


def curves_of(armature):
    """The F-curves that move an object: in a slot's bag from Blender 4.4 on, in the action itself before."""
    animation = armature.animation_data
    action = animation.action if animation else None
    slot = getattr(animation, "action_slot", None)
    if action and slot:
        for layer in action.layers:
            for strip in layer.strips:
                bag = strip.channelbag(slot)
                if bag:
                    return bag.fcurves
        return None
    return action.fcurves if action and hasattr(action, "fcurves") else None


def clear_keys(armature, paths):
    curves = curves_of(armature)
    for curve in [curve for curve in curves or [] if curve.data_path in paths]:
        curves.remove(curve)


def write_keys(armature, name, frames, rotations, loop):
    """CONSTANT keys for one bone. The first is inserted, which makes action, slot and curves in every Blender."""
    bone = armature.pose.bones[name]
    bone.rotation_mode = "QUATERNION"
    bone.rotation_quaternion = rotations[0]
    bone.keyframe_insert("rotation_quaternion", frame=frames[0], group=name)
    path = bone.path_from_id("rotation_quaternion")
    for index in range(4):
        curve = curves_of(armature).find(path, index=index)
        points = curve.keyframe_points
        points.add(len(frames) - len(points))
        points.foreach_set("co", [x for frame, rotation in zip(frames, rotations) for x in (frame, rotation[index])])
        for point in points:
            point.interpolation = "CONSTANT"
        if loop:
            curve.modifiers.new("CYCLES")
        curve.update()


def apply_motion(armature, chains, answer, start, loop):
    """Writes an answer's pictures as keys from frame `start` on, in place of what was there. @return  frames of a cycle"""
    schedule = answer["schedule"]
    frames = [start + first for first in schedule["starts"]] + [start + schedule["frames"]]
    paths = {armature.pose.bones[name].path_from_id("rotation_quaternion") for chain in chains for name in chain.bones}
    clear_keys(armature, paths)
    for index, chain in enumerate(chains):
        pictures = [local_rotations(armature, chain, turns_of(picture["chains"][index])) for picture in answer["pictures"]]
        for number, name in enumerate(chain.bones):
            rotations = [pictures[0][number]]
            for picture in (*pictures[1:], pictures[0]):  # the closing key is the first picture again
                rotation = picture[number]
                rotations.append(-rotation if rotation.dot(rotations[-1]) < 0 else rotation)
            write_keys(armature, name, frames, rotations, loop)
    return schedule["frames"]


# ---- without a window ----

def import_gltf(path):
    """Imports a glTF or VRM file. Debian 12's importer uses numpy.bool, which its numpy no longer has."""
    import numpy
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        if not hasattr(numpy, "bool"):
            numpy.bool = bool
    bpy.ops.import_scene.gltf(filepath=path)


def open_file(path, fps):
    """Opens or imports a file into an otherwise empty Blender. Raises Failed."""
    if not os.path.isfile(path):
        raise Failed("There is no such file")
    try:
        if path.lower().endswith(".blend"):
            bpy.ops.wm.open_mainfile(filepath=path, load_ui=False)
        else:
            bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
            bpy.context.scene.render.fps = 24
        if fps:
            set_frame_rate(bpy.context.scene, fps)
        if not path.lower().endswith(".blend"):
            import_gltf(path)
    except (RuntimeError, ModuleNotFoundError) as error:
        raise Failed(f"Blender cannot open it: {str(error).strip()}") from None


def animate_armature(armature, options):
    """Moves one armature of the open file. @return  how many chains moved; 0 where it has none"""
    scene = bpy.context.scene
    chains = find_chains(armature, hair_bones(armature, options.bones.split(",") if options.bones else ()))
    if not chains:
        return 0
    refuse_sheared(armature)
    settings = {name: getattr(options, name) for name, _, _, _ in SETTINGS}
    answer = ask(options.server, request_body(armature, chains, settings, options.wind, frame_rate(scene)))
    frames = apply_motion(armature, chains, answer, options.start, options.loop)
    scene.frame_start, scene.frame_end = options.start, options.start + frames - 1
    return len(chains)


def animate_file(path, options):
    """Moves the hair of a file and writes it as a .blend. Raises Failed."""
    target = os.path.join(options.out or os.path.dirname(path), os.path.splitext(os.path.basename(path))[0] + ".hair.blend")
    if os.path.realpath(target) in {os.path.realpath(other) for other in options.files}:
        raise Failed(f"{target} is an input itself and is not written over")
    open_file(path, options.fps)
    armatures = [o for o in bpy.context.scene.objects if o.type == "ARMATURE" and options.armature in ("", o.name)]
    if not armatures:
        raise Failed(f"It has no armature {options.armature}".rstrip())
    chains = sum(animate_armature(armature, options) for armature in armatures)
    if not chains:
        raise Failed("No bone matches --bones" if options.bones else "It has no hair below a bone called head; name some with --bones")
    if options.out:
        os.makedirs(options.out, exist_ok=True)
    bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(target), copy=True, check_existing=False)
    return target, chains


def numbers(text):
    values = [float(x) for x in text.split(",")]
    if len(values) != 3:
        raise argparse.ArgumentTypeError("three numbers are needed")
    return values


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(prog="tuftwave_hair.py", description="Makes the hair in Blender, glTF and VRM files move.")
    parser.add_argument("files", nargs="+", help=".blend, .glb, .gltf or .vrm")
    parser.add_argument("--server", default=os.environ.get("TUFTWAVE_URL") or DEFAULT_SERVER, help="address (%(default)s)")
    parser.add_argument("--out", default="", metavar="FOLDER", help="where the .hair.blend files go (beside the inputs)")
    parser.add_argument("--armature", default="", metavar="NAME", help="the object to move (all that have hair)")
    parser.add_argument("--bones", default="", help="patterns of bone names, by commas (all below the head but the face)")
    parser.add_argument("--fps", default="", help="frames per second, a number or a fraction (the file's; 24 for glTF)")
    parser.add_argument("--start", type=int, default=0, help="frame of the first picture (%(default)s)")
    parser.add_argument("--loop", action="store_true", help="repeat the cycle for ever, by a modifier on each F-curve")
    parser.add_argument("--wind", type=numbers, default=[1.0, 0.0, 0.0], metavar="X,Y,Z", help="where it blows to, in Blender's axes; --wind=-1,0,0")
    for name, default, _, text in SETTINGS:
        kind = {"action": "store_true"} if default is False else {"type": type(default), "default": default, "metavar": "N"}
        parser.add_argument("--" + name.replace("_", "-"), help=f"{text} ({default})", **kind)
    options = parser.parse_intermixed_args(arguments)
    try:
        set_frame_rate(bpy.context.scene, options.fps or 24)
    except (ValueError, ZeroDivisionError, OverflowError):
        parser.error(f"--fps must be a number or a fraction, not {options.fps!r}")
    return options


def main(arguments):
    options = parse_arguments(arguments)
    failed = 0
    for number, path in enumerate(options.files, 1):
        place, begun = f"{number} of {len(options.files)}  {path}", time.monotonic()
        try:
            refuse_offline(options.server)
            target, chains = animate_file(path, options)
            print(f"{place} -> {target}: {chains} chain{'s' * (chains != 1)}, {time.monotonic() - begun:.2f} s", flush=True)
        except NoService as error:
            print(f"tuftwave_hair: {place}: {error}", file=sys.stderr, flush=True)
            return 2
        except (Failed, OSError) as error:
            print(f"tuftwave_hair: {place}: {error}", file=sys.stderr, flush=True)
            failed += 1
    return 1 if failed else 0


# ---- the panel ----

class Pending:
    """A request under way in a thread; what comes back is applied by a timer, since only the main thread may touch Blender's data."""

    def __init__(self, armature, chains, server, body, start, loop, set_range):
        self.armature, self.scene = armature.name, bpy.context.scene.name
        self.chains, self.start, self.loop, self.set_range = chains, start, loop, set_range
        self.answer = self.error = None
        self.thread = threading.Thread(target=self.run, args=(server, body), daemon=True)
        self.thread.start()

    def run(self, server, body):
        try:
            self.answer = ask(server, body)
        except Exception as error:  # a thread has nobody else to tell
            self.error = error

    def finish(self):
        """Waits for the answer and applies it. @return  what to tell. Raises Failed."""
        self.thread.join()
        if self.error:
            raise Failed(str(self.error))
        armature, scene = bpy.data.objects.get(self.armature), bpy.data.scenes.get(self.scene)
        wanted = {name for chain in self.chains for name in chain.bones}
        if not armature or not scene or armature.type != "ARMATURE" or not wanted <= set(armature.pose.bones.keys()):
            raise Failed(f"{self.armature} has changed meanwhile")
        frames = apply_motion(armature, self.chains, self.answer, self.start, self.loop)
        if self.set_range:
            scene.frame_start, scene.frame_end = self.start, self.start + frames - 1
        warnings_said = "".join(f" {warning['detail']}" for warning in self.answer.get("warnings", []))
        return f"{len(self.chains)} chains move, {len(self.answer['pictures'])} pictures in {frames} frames.{warnings_said}"

    def poll(self):
        """For bpy.app.timers."""
        if self.thread.is_alive():
            return 0.05
        try:
            tell(self.finish(), "INFO")
            if bpy.ops.ed.undo_push.poll():
                bpy.ops.ed.undo_push(message="Tuftwave Hair")
        except Failed as error:
            tell(str(error), "ERROR")
        return None


def tell(text, icon):
    """Shows something when no operator is there to report it."""
    print(f"tuftwave_hair: {text}")
    bpy.context.window_manager.tuftwave_hair_said = text
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            area.tag_redraw()
    if icon == "ERROR" and bpy.context.window and not bpy.app.background:
        bpy.context.window_manager.popup_menu(lambda menu, _: [menu.layout.label(text=line) for line in text.split("\n")], title="Tuftwave", icon=icon)


def property_of(name, default, text):
    label = name.replace("_", " ").capitalize()
    if isinstance(default, bool):
        return bpy.props.BoolProperty(name=label, default=default, description=text)
    kind = bpy.props.IntProperty if isinstance(default, int) else bpy.props.FloatProperty
    return kind(name=label, default=default, description=text)


class TuftwaveHairSettings(bpy.types.PropertyGroup):
    __annotations__ = {
        **{name: property_of(name, default, text) for name, default, _, text in SETTINGS},
        "wind": bpy.props.FloatVectorProperty(name="Wind", default=(1, 0, 0), subtype="XYZ", description="Where it blows to"),
        "start": bpy.props.IntProperty(name="Start", default=1, description="Frame of the first picture"),
        "loop": bpy.props.BoolProperty(name="Repeat", default=True, description="Repeat the cycle for ever, by a modifier on each F-curve"),
        "set_range": bpy.props.BoolProperty(name="Set frame range", default=False, description="Make the scene as long as one cycle"),
    }


class TuftwaveHairPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__ or __name__
    __annotations__ = {"server": bpy.props.StringProperty(name="Service", default=os.environ.get("TUFTWAVE_URL") or DEFAULT_SERVER,
                                                          description="Address of the Tuftwave service")}

    def draw(self, _):
        self.layout.prop(self, "server")


def server_address():
    addon = bpy.context.preferences.addons.get(TuftwaveHairPreferences.bl_idname)
    return addon.preferences.server if addon and addon.preferences else os.environ.get("TUFTWAVE_URL") or DEFAULT_SERVER


class POSE_OT_tuftwave_hair(bpy.types.Operator):
    """Ask the Tuftwave service to move the selected bones, or all hair below the head where none is selected"""
    bl_idname = "pose.tuftwave_hair"
    bl_label = "Make Hair Move"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.type == "ARMATURE"

    def execute(self, context):
        armature, settings = context.object, context.scene.tuftwave_hair
        try:
            server = server_address()
            refuse_offline(server)
            refuse_sheared(armature)
            selected = {bone.name for bone in context.selected_pose_bones or [] if bone.id_data == armature}
            chains = find_chains(armature, selected or hair_bones(armature))
            if not chains:
                raise Failed("Select the bones of the hair in pose mode: there is none below a bone called head")
            values = {name: getattr(settings, name) for name, _, _, _ in SETTINGS}
            body = request_body(armature, chains, values, settings.wind, frame_rate(context.scene))
            pending = Pending(armature, chains, server, body, settings.start, settings.loop, settings.set_range)
            if not bpy.app.background:
                context.window_manager.tuftwave_hair_said = f"Asking for {len(chains)} chains ..."
                bpy.app.timers.register(pending.poll, first_interval=0.05)
                return {"FINISHED"}
            self.report({"INFO"}, pending.finish())
        except Failed as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


class VIEW3D_PT_tuftwave_hair(bpy.types.Panel):
    bl_label = "Hair"
    bl_category = "Tuftwave"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"

    def draw(self, context):
        layout, settings = self.layout, context.scene.tuftwave_hair
        layout.use_property_split, layout.use_property_decorate = True, False
        for name in ["wind", *(name for name, _, _, _ in SETTINGS), "start", "loop", "set_range"]:
            layout.prop(settings, name)
        layout.operator(POSE_OT_tuftwave_hair.bl_idname, icon="FORCE_WIND")
        for line in context.window_manager.tuftwave_hair_said.split("\n"):
            layout.label(text=line)


CLASSES = [TuftwaveHairSettings, TuftwaveHairPreferences, POSE_OT_tuftwave_hair, VIEW3D_PT_tuftwave_hair]


def register():
    for kind in CLASSES:
        bpy.utils.register_class(kind)
    bpy.types.Scene.tuftwave_hair = bpy.props.PointerProperty(type=TuftwaveHairSettings)
    bpy.types.WindowManager.tuftwave_hair_said = bpy.props.StringProperty(options={"SKIP_SAVE"})


def unregister():
    del bpy.types.WindowManager.tuftwave_hair_said
    del bpy.types.Scene.tuftwave_hair
    for kind in reversed(CLASSES):
        bpy.utils.unregister_class(kind)


if __name__ == "__main__":
    if bpy.app.background and "--" in sys.argv:
        sys.exit(main(sys.argv[sys.argv.index("--") + 1:]))
    register()
