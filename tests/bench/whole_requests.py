"""Whole heads of hair over HTTP, and 1,000 strokes beside nginx, which serves the same file. One client.

    python3 tests/bench/whole_requests.py --server build/bench/server/tuftwave-server --generator build/bench/tests/tuftwave_load

Prints lines as figures.py reads them, one sample a round. Servers listen on 127.0.0.1 only.
"""

from __future__ import annotations

import argparse
import glob
import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
from typing import Any, Iterator, Optional

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.normpath(os.path.join(HERE, "..", ".."))
sys.dont_write_bytecode = True
sys.path[:0] = [os.path.join(ROOT, "tests", folder) for folder in ("bench", "load", "edge")]

import thousand_strokes  # noqa: E402
from edge import free_ports, wait_until  # noqa: E402
from loading import QUIET, Program, load, quantile  # noqa: E402

PIPELINE = os.path.join(ROOT, "client-examples", "pipeline")
DATA = os.path.join(ROOT, "tests", "data")
NGINX = shutil.which("nginx", path=os.environ.get("PATH", "") + ":/usr/sbin:/usr/local/sbin")
CONFIGURATION = """daemon off; pid nginx.pid; worker_processes 1; error_log stderr crit;
events {{}}
http {{
    access_log off; sendfile on; tcp_nopush on; keepalive_requests 1000000;
    client_body_temp_path body; proxy_temp_path proxy; fastcgi_temp_path fastcgi; uwsgi_temp_path uwsgi; scgi_temp_path scgi;
    server {{ listen 127.0.0.1:{port}; location / {{ root {folder}; }} }}
}}
"""


class Nginx:
    """Serves the files of a folder."""

    def __init__(self, folder: str) -> None:
        os.chmod(folder, 0o755)  # as root, nginx's workers are somebody else
        self.port = free_ports(1)[0]
        file = os.path.join(folder, "nginx.conf")
        with open(file, "w", encoding="ascii") as to:
            to.write(CONFIGURATION.format(port=self.port, folder=folder))
        self._command = [NGINX or "nginx", "-e", "stderr", "-p", folder, "-c", file]

    def __enter__(self) -> "Nginx":
        self._process = subprocess.Popen(self._command)
        wait_until(self._listens, "nginx listened")
        return self

    def __exit__(self, *_: Any) -> None:
        self._process.terminate()
        self._process.wait(10)

    def _listens(self) -> bool:
        if self._process.poll() is not None:
            raise RuntimeError("nginx has ended")
        with socket.socket() as probe:
            return probe.connect_ex(("127.0.0.1", self.port)) == 0


def requests(work: str) -> Iterator[tuple[str, str]]:
    """The name of each hairstyle, and the file of its request: moving, as the pipeline's tools make them."""
    for strokes in sorted(glob.glob(os.path.join(DATA, "strokes", "*.strokes.json"))):
        name = os.path.basename(strokes).partition(".")[0]
        yield name, made(work, name, "strokes_to_hairstyle.py", strokes)
    yield "strands", made(work, "strands", "strands_to_hairstyle.py", *sorted(glob.glob(os.path.join(DATA, "strands", "*.tfx"))))


def made(work: str, name: str, tool: str, *files: str) -> str:
    to = os.path.join(work, name + ".json")
    subprocess.run([sys.executable, os.path.join(PIPELINE, tool), *files, "--motion", "breeze", "--out", to], stdout=subprocess.DEVNULL, check=True)
    return to


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--server", required=True)
    parser.add_argument("--generator", required=True)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--seconds", type=float, default=1, help="of each sample")
    options = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # by which every server is stopped

    with tempfile.TemporaryDirectory() as work, Program(options.server, *QUIET) as server:
        def median(what: Any, path: str, body: Optional[str]) -> float:
            return quantile(load(options.generator, what, path, body, 0, options.seconds, 1), 200, "p50")

        bodies = dict(requests(work))
        samples: dict[str, list[float]] = {}
        body = json.dumps(thousand_strokes.request()).encode()
        strokes, answer = os.path.join(work, "thousand.json"), os.path.join(work, "thousand.glb")
        for path, content in ((strokes, body), (answer, server.request("POST", "/v1/tufts", body, {"Content-Type": "application/json"}).body)):
            with open(path, "wb") as file:
                file.write(content)
        for _ in range(options.rounds):
            for name, request in bodies.items():
                samples.setdefault(f"http/{name}/tuftwave", []).append(median(server, "/v1/hairstyles", request))
            samples.setdefault("http/thousand_file/tuftwave", []).append(median(server, "/v1/tufts", strokes))
            if NGINX:
                with Nginx(work) as nginx:
                    samples.setdefault("http/thousand_file/nginx", []).append(median(nginx, "/thousand.glb", None))
        for name, ms in samples.items():
            print(json.dumps({"name": name, "ms": ms}), flush=True)


if __name__ == "__main__":
    main()
