"""Who takes part in a round, and how they are started."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from typing import NamedTuple, Optional

HERE = os.path.dirname(os.path.abspath(__file__))
PEERS = os.path.join(HERE, "peers")
# Another python3 in front makes Blender look for its modules there.
PLAIN_PATH = "/usr/sbin:/usr/bin:/sbin:/bin"
WARM = ("hair", "motion", "reading", "packing", "meshopt", "fill")


class Party(NamedTuple):
    names: tuple[str, ...]  # behind the slash of its figures
    program: Optional[str]  # none, or no file: not there
    arguments: tuple[str, ...]
    without: str  # why it is not there, if it is not
    is_slow: bool = False  # takes part in the first rounds only
    is_quick: bool = True  # takes part in a quick run
    environment: Optional[dict[str, str]] = None

    @property
    def is_there(self) -> bool:
        return self.program is not None and os.access(self.program, os.X_OK)

    def run(self) -> Optional[str]:
        """@return  what it printed; nothing where it failed, which it says itself"""
        assert self.program
        done = subprocess.run([self.program, *self.arguments], stdout=subprocess.PIPE, text=True, errors="replace", env=self.environment, check=False)
        if done.returncode != 0:
            print(f"script/bench: {os.path.basename(self.program)} ended with {done.returncode}", file=sys.stderr)
            return None
        return done.stdout


def parties(build: str, work: str) -> list[Party]:
    """@param work  a folder with w1.json and w2.json"""
    def built(name: str) -> str:
        return os.path.join(build, "tests", f"tuftwave_bench_{name}")

    blender = shutil.which("blender", path=PLAIN_PATH)
    plain = {"PATH": PLAIN_PATH, "HOME": work}
    script = os.path.join(PEERS, "blender.py")
    return [
        Party(("tuftwave", "memset", "memcpy", "fresh_write", "fresh_copy", "warm"), built("ours"), (work, *WARM), "not built"),
        Party((), built("ours"), (work, "first"), ""),
        Party((), built("ours"), (work, "pack_memory"), ""),
        Party((), built("ours"), (work, "many"), "", is_slow=True),
        Party(("afternoon",), built("afternoon"), (work,), "no glm or tinygltf"),
        Party(("nlohmann",), built("json"), (work,), "not built"),
        Party(("library",), built("meshopt"), (work,), "no meshoptimizer"),
        Party(("three", "gltf_transform", "three_lean_merged", "three_lean_split", "three_vrm", "three_vrm_warm"), shutil.which("node"), (os.path.join(PEERS, "three", "three.mjs"), work), "no Node.js"),
        Party(("bullet",), built("bullet"), (work,), "no Bullet", is_quick=False),
        Party(("blender",), blender, ("--background", "--factory-startup", "--python-exit-code", "3", "--python", script, "--", work), "no Blender", is_slow=True, is_quick=False, environment=plain),
    ]
