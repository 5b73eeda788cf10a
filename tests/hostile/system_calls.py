"""No file is opened, no connection made and no program started on behalf of a request: strace sees none of these calls."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import tempfile
from typing import IO

import contract
from glb_bombs import DAMAGES, glb
from logs import hostile
from malformed import CASES
from report import Report
from running import Program, eventually
from support import glb_parts
from wire import WireError, exchange

# Whatever names a file, starts a program, or makes a socket that accept() did not give.
CALLS = "trace=%file,execve,execveat,fork,vfork,connect,socket,socketpair,bind,listen,memfd_create,ptrace,mount,kill"
ATTACH_S = 20.0
# glibc's malloc asks these once in the life of a process, when its second arena comes and when it first gives memory back.
MALLOC = ("/sys/devices/system/cpu/online", "/proc/sys/vm/overcommit_memory")
FILES = ("a buffer from a file", "a buffer from a file, as a URL", "a buffer from elsewhere", "an image from a file")


def run(report: Report, program: str, full: bool) -> None:
    if not shutil.which("strace"):
        report.skip("system calls", "strace is not installed")
        return
    with tempfile.TemporaryDirectory() as folder, open(os.path.join(folder, "words"), "wb+") as words, Program(program) as server:
        record = os.path.join(folder, "calls")
        tracer = subprocess.Popen(["strace", "-f", "-p", str(server.pid), "-e", CALLS, "-e", "signal=none", "-o", record], stderr=words)
        try:
            if not eventually(lambda: is_attached(words) or tracer.poll() is not None, ATTACH_S) or tracer.poll() is not None:
                words.seek(0)
                report.skip("system calls", f"strace may not look: {words.read()[:200]!r}")
                return
            requests = ask_everything(report, server, full)
        finally:
            tracer.terminate()
            tracer.wait()
        with open(record, encoding="utf-8", errors="replace") as lines:
            seen = [line for line in lines if re.search(r"\w+\(", line)]
    calls = [line for line in seen if not any(f'"{path}"' in line for path in MALLOC)]
    report.check("malloc asks once", len(seen) - len(calls) <= len(MALLOC), seen)
    report.check("no call on behalf of a request", not calls, f"{len(calls)}, e.g. {calls[:3]}")
    report.note(f"{requests} requests, {len(calls)} calls, {len(seen) - len(calls)} of malloc")
    with open(os.devnull, "wb") as nowhere:
        report.check("the search itself", finds_an_open(nowhere), "strace saw no call of a program that opens a file")


def is_attached(words: IO[bytes]) -> bool:
    words.seek(0)
    return b"attached" in words.read()


def finds_an_open(nowhere: IO[bytes]) -> bool:
    """A trace that does not see `cat` open a file would see nothing anywhere."""
    with tempfile.NamedTemporaryFile("r") as record:
        subprocess.run(["strace", "-f", "-e", CALLS, "-o", record.name, "cat", "/etc/passwd"], stdout=nowhere, stderr=nowhere, check=False)
        return "/etc/passwd" in record.read()


def ask_everything(report: Report, server: Program, full: bool) -> int:
    """@return  how many requests were made"""
    count = 0
    for operation in contract.operations():
        path = operation.path.replace("{file}", "swagger-ui.css")
        body, headers = contract.sample(operation)
        for word in contract.formats(operation) or [""]:
            server.request(operation.method, path + (f"?format={word}" if word else ""), body, headers)
            count += 1
    with open(contract.CHARACTER, "rb") as file:
        gltf, data = glb_parts(file.read())
    for name in FILES:
        DAMAGES[name](gltf)
        for path in ("/v1/characters/chains", "/v1/characters/motion"):
            server.request("POST", path, glb(json.dumps(gltf).encode(), data), {"Content-Type": "model/gltf-binary"})
            count += 1
    for request in [case.data for case in (CASES if full else CASES[::4])] + hostile():
        try:
            exchange(server.address, request, 1)
        except WireError:
            pass  # judged elsewhere
        count += 1
    report.check("well under strace", server.is_well())
    return count
