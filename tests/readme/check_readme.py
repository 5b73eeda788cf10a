"""Runs every command of the README as it stands there, on a server of its own, and compares the answers it shows.

    python3 tests/readme/check_readme.py --server build/release/server/tuftwave-server
"""

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ADDRESS = "http://127.0.0.1:8080"
# These two build everything, so they cannot run inside a test; what they are made of runs in every other test.
SELF = {"script/server", "script/test"}
# Needs an engine; the image is built from the same script/setup and presets.
ENGINE = "docker "


def blocks(text: str) -> list[tuple[str, str]]:
    """Every fenced block: its language and its content."""
    return re.findall(r"^```(\w+)\n(.*?)^```$", text, flags=re.MULTILINE | re.DOTALL)


def without_request_id(answer: dict) -> dict:
    """Each request has its own id, so the README leaves it out."""
    return {key: value for key, value in answer.items() if key != "request_id"}


def run(command: str, address: str, scratch: Path) -> bytes:
    """Runs a command line in a copy of the checkout's surroundings and returns what it printed."""
    line = command.replace(ADDRESS, address).replace("-o ", f"-o {scratch}/")
    done = subprocess.run(line, shell=True, cwd=ROOT, capture_output=True, timeout=60)
    if done.returncode != 0:
        raise AssertionError(f"{command}\n  exited with {done.returncode}: {done.stderr.decode()}")
    return done.stdout


def check(address: str, scratch: Path) -> int:
    """Runs the commands in order; a JSON block is the answer to the command before it. Returns how many were checked."""
    printed = b""
    checked = 0
    for language, content in blocks((ROOT / "README.md").read_text(encoding="utf-8")):
        if language == "json":
            expected, got = json.loads(content), without_request_id(json.loads(printed))
            if expected != got:
                raise AssertionError(f"the README shows\n  {expected}\nbut the answer is\n  {got}")
            checked += 1
            continue
        for command in filter(None, content.splitlines()):
            if command.startswith(ENGINE):
                assert (ROOT / "Dockerfile").exists(), "there is no Dockerfile"
            elif command in SELF:
                assert os.access(ROOT / command, os.X_OK), f"{command} is not there or cannot be run"
            else:
                printed = run(command, address, scratch)
            checked += 1
    glb = (scratch / "hair.glb").read_bytes()
    assert glb[:4] == b"glTF" and b'"animations"' in glb, "hair.glb is not an animated GLB"
    return checked


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--server", required=True, help="path of tuftwave-server")
    options = parser.parse_args()
    command = [options.server, "--port", "0", "--admin-port", "0", "--log-level", "off"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as server, tempfile.TemporaryDirectory() as scratch:
        try:
            address = re.search(r"listening on (http://[^,\s]+)", server.stdout.readline()).group(1)
            checked = check(address, Path(scratch))
        except AssertionError as problem:
            print(problem)
            print("0 passed, 1 failed")
            return 1
        finally:
            server.terminate()
    print(f"{checked} passed, 0 failed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
