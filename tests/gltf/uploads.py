"""Characters that others made, posted as files: what was sent and what came back, side by side."""

from __future__ import annotations

import os
from typing import Callable
from urllib.parse import urlencode

from service import Service

CHARACTERS = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "data", "characters"))
EVERYTHING = {"kinds": "hair,skirt,ribbon,unknown"}
# By what the files are called: the motion that is asked for.
MOTIONS = {
    "breeze": {"amplitude": "0.8", "spread": "0.3", "seed": "7", "gust_wavelength": "0.4"},
    "gale": {**EVERYTHING, "amplitude": "3", "wind": "1,0.2,-0.7", "fps": "24000/1001", "hold": "3", "period": "0.8", "droop": "keep"},
    "off_the_head": {"one_sided": "true", "phase_step": "picture", "spread": "1", "cycles": "2", "springs": "remove", "clip_name": "wave-loop"},
    "along_the_wind": {"mode": "absolute", "lift": "0.5", "wind": "0,0,-1"},
    "held": {**EVERYTHING, "interpolation": "held"},
    "per_frame": {**EVERYTHING, "interpolation": "per_frame", "fps": "30"},
}


def write_uploads(service: Service, directory: str, check: Callable[[str, str], None]) -> None:
    """NAME.in.glb, NAME.glb and NAME.json, the poses, of every character and motion."""
    os.makedirs(directory, exist_ok=True)
    for file in sorted(os.listdir(CHARACTERS)):
        with open(os.path.join(CHARACTERS, file), "rb") as opened:
            character = opened.read()
        for motion, settings in MOTIONS.items():
            name = f"{file.rsplit('.', 1)[0]}.{motion}"
            with open(os.path.join(directory, f"{name}.in.glb"), "wb") as copy:
                copy.write(character)
            for word in ("glb", "json"):
                kept = {key: value for key, value in settings.items() if key != "interpolation" or word == "glb"}
                answer = service.request("POST", f"/v1/characters/motion?{urlencode({**kept, 'format': word})}", character, {"Content-Type": "model/gltf-binary"})
                check(f"{name}.{word}", "" if answer.status == 200 else f"{answer.status} {answer.body[:300]!r}")
                with open(os.path.join(directory, f"{name}.{word}"), "wb") as made:
                    made.write(answer.body)
