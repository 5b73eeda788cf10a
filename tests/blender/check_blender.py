"""Runs the Blender add-on against a server in a Blender without a window, and looks at every frame of what it made.

    python3 tests/blender/check_blender.py --server build/release/server/tuftwave-server [--blender /usr/bin/blender] [--out build/blender]

Needs Debian's blender and python3-numpy (`script/setup blender`). Exit code 0 or 1; 77 where one of
them is not there.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from typing import Optional

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "..", ".."))
sys.path.insert(0, os.path.join(HERE, "..", "contract"))

from service import Service  # noqa: E402

ADDON = os.path.join(ROOT, "client-examples", "blender", "tuftwave_hair.py")
CHARACTERS = os.path.join(ROOT, "tests", "data", "characters")
FILES = ("godette.vrm0.vrm", "godette.vrm1.vrm", "pmca_sample3.glb", "vroid_Sakurada_Fumiriya.chains.glb", "vroid_Vita.chains.glb")
TIMINGS = (("--period", "0.45"), ("--period", "0.8", "--hold", "3", "--fps", "30", "--start", "7"), ("--period", "0.58", "--fps", "24000/1001"))
# Another python3 in front makes Blender look for its modules there, and so do these variables.
PLAIN_PATH = "/usr/sbin:/usr/bin:/sbin:/bin"
SKIPPED = 77


def environment(folder: str) -> dict[str, str]:
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "TUFTWAVE_", "BLENDER_")) and "proxy" not in name.lower()}
    return {**kept, "PATH": PLAIN_PATH, "HOME": folder, "BLENDER_USER_SCRIPTS": os.path.join(folder, "scripts"), "PYTHONDONTWRITEBYTECODE": "1"}


class Blender:
    def __init__(self, program: str, folder: str) -> None:
        self._program, self._environment = program, environment(folder)
        self.passed = self.failed = 0

    def run(self, script: str, *arguments: str) -> tuple[int, str]:
        command = [self._program, "--background", "--factory-startup", "--python-exit-code", "3", "--python", script, "--", *arguments]
        done = subprocess.run(command, env=self._environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, timeout=600)
        return done.returncode, done.stdout

    def check(self, name: str, is_right: bool, said: str) -> None:
        self.passed += is_right
        self.failed += not is_right
        if not is_right:
            print(f"FAILED {name}: {said[-2000:]}")


def check_script(blender: Blender, url: str, folder: str) -> None:
    """The add-on as a script: files that are made, faults that are told."""
    paths = [os.path.join(CHARACTERS, name) for name in FILES]
    for number, timing in enumerate(TIMINGS):
        out = os.path.join(folder, f"timing{number}")
        code, said = blender.run(ADDON, "--server", url, "--out", out, "--loop", "--spread", "0.4", *timing, *paths)
        made = sorted(os.listdir(out)) if os.path.isdir(out) else []
        blender.check(f"{timing}", code == 0 and made == [os.path.splitext(name)[0] + ".hair.blend" for name in FILES], said)
    made_before = os.path.join(folder, "timing0", "pmca_sample3.hair.blend")
    faults = {
        "missing file": ([os.path.join(folder, "missing.glb")], 1, "There is no such file"),
        "no glTF": ([__file__], 1, "Blender cannot open it"),
        "no such armature": (["--armature", "Nobody", paths[2]], 1, "It has no armature Nobody"),
        "no such bones": (["--bones", "Nobody*", paths[2]], 1, "No bone matches --bones"),
        "a wrong value": (["--period", "99", paths[2]], 1, "/motion/timing/period"),
        "a wrong fps": (["--fps", "fast", paths[2]], 2, "--fps must be"),
        "its own input": (["--bones", "Nobody*", "--out", os.path.join(folder, "timing0"), paths[2], made_before], 1, "is an input itself"),
        "a file of two": ([os.path.join(folder, "missing.glb"), "--out", os.path.join(folder, "second"), paths[2]], 1, "2 of 2"),
        "no service": (["--server", "http://127.0.0.1:1", "--out", folder, paths[2]], 2, "No Tuftwave service at"),
        "some bones of a blend": (["--bones", "後髪*,前髪１", "--out", os.path.join(folder, "again"), made_before], 0, "2 chains"),
    }
    for name, (arguments, expected, text) in faults.items():
        code, said = blender.run(ADDON, "--server", url, *arguments)
        blender.check(name, code == expected and text in said, f"exit code {code}: {said}")


def check_manifest(blender: Blender) -> None:
    """What Blender 4.2 and later ask of an extension's manifest, as far as it can be told without them."""
    folder = os.path.dirname(ADDON)
    with open(os.path.join(folder, "blender_manifest.toml"), "rb") as file:
        manifest = tomllib.load(file)
    with open(ADDON, encoding="utf-8") as file:
        version = re.search(r'"version": \((\d+), (\d+), (\d+)\)', file.read())
    blender.check("manifest: version", version is not None and manifest["version"] == ".".join(version.groups()), manifest["version"])
    for text in (manifest["tagline"], manifest["permissions"]["network"]):
        blender.check(f"manifest: {text}", len(text) <= 64 and text[-1].isalnum(), "longer than 64 characters, or ends with a mark")
    missing = [name for name in manifest["build"]["paths"] if not os.path.isfile(os.path.join(folder, name))]
    blender.check("manifest: files", not missing, f"{missing}")


def check(server: str, program: str, folder: str) -> int:
    blender = Blender(program, folder)
    check_manifest(blender)
    shutil.copytree(os.path.dirname(ADDON), os.path.join(folder, "scripts", "addons", "tuftwave_folder"), dirs_exist_ok=True)
    with Service(server) as service:
        check_script(blender, service.url, folder)
        code, said = blender.run(os.path.join(HERE, "play.py"), service.url, ADDON, folder, CHARACTERS)
    lines = [line for line in said.splitlines() if line.startswith(("FAILED", "  ")) or "passed" in line]
    print("\n".join(lines) if code in (0, 1) and lines else said)
    counts = re.search(r"^(\d+) passed, (\d+) failed$", said, re.MULTILINE)
    passed, failed = (int(counts[1]), int(counts[2])) if counts and code in (0, 1) else (0, 1)
    print(f"{blender.passed + passed} passed, {blender.failed + failed} failed")
    return 1 if blender.failed or failed else 0


def main(arguments: Optional[list[str]] = None) -> int:
    parser = argparse.ArgumentParser(description="Runs the Blender add-on against a server.")
    parser.add_argument("--server", default=os.environ.get("TUFTWAVE_SERVER"), help="the program (default: the environment's TUFTWAVE_SERVER)")
    parser.add_argument("--blender", default=shutil.which("blender", path=PLAIN_PATH), help="the program (%(default)s)")
    parser.add_argument("--out", help="keep the files in this folder")
    options = parser.parse_args(arguments)
    if not options.blender:
        print("check_blender: skipped, there is no Blender; `script/setup blender` installs it")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        finds_numpy = [options.blender, "--background", "--factory-startup", "--python-exit-code", "3", "--python-expr", "import numpy"]
        if subprocess.run(finds_numpy, env=environment(folder), capture_output=True, check=False).returncode:
            print("check_blender: skipped, Blender finds no numpy, which its importer needs; `script/setup blender` installs it")
            return SKIPPED
    if not options.server or not os.access(options.server, os.X_OK):
        print(f"check_blender: {options.server!r} is no program; build the server and name it with --server", file=sys.stderr)
        return 1
    if options.out:
        os.makedirs(options.out, exist_ok=True)
        return check(options.server, options.blender, os.path.abspath(options.out))
    with tempfile.TemporaryDirectory() as folder:
        return check(options.server, options.blender, folder)


if __name__ == "__main__":
    sys.exit(main())
