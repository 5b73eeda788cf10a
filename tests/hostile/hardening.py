"""How the program was built: what turns a mistake of ours into an end and not into a way in."""

from __future__ import annotations

import platform
import re
import shutil
import subprocess

from report import Report

ENDBR64 = b"\xf3\x0f\x1e\xfa"
MARKS = 1_000  # each function that may be called through a pointer has one


def read(*command: str) -> str:
    return subprocess.run(command, capture_output=True, check=True, text=True, env={"PATH": "/usr/bin:/bin", "LC_ALL": "C"}).stdout


def run(report: Report, program: str, full: bool) -> None:
    if not shutil.which("readelf") or not shutil.which("nm"):
        report.skip("hardening", "binutils are not installed")
        return
    head, segments, dynamic = (read("readelf", flag, program) for flag in ("-hW", "-lW", "-dW"))
    taken = {line.split()[-1].partition("@")[0] for line in read("nm", "-D", "--undefined-only", program).splitlines()}
    if re.search(r"__[at]san_init", read("nm", "-D", program)):
        report.skip("hardening", "a build with sanitizers is for finding faults")
        return
    report.check("position-independent", re.search(r"Type:\s+DYN", head) and "PIE" in dynamic, head)
    report.check("relocations are read-only", "GNU_RELRO" in segments)
    report.check("all of them, since nothing is bound later", "BIND_NOW" in dynamic and re.search(r"FLAGS_1\).*NOW", dynamic), dynamic)
    stack = re.search(r"GNU_STACK.*\s(R[W ][E ])\s", segments)
    report.check("no code on the stack", stack is not None and stack[1] == "RW ", stack)
    loads = re.findall(r"LOAD .*\s(R?[W ]?[E ]?)\s+0x", segments)
    report.check("nothing writable is executable", loads and not any("W" in flags and "E" in flags for flags in loads), loads)
    report.check("stack protector", "__stack_chk_fail" in taken)
    fortified = sorted(name for name in taken if name.endswith("_chk") and name != "__stack_chk_fail")
    report.check("FORTIFY", fortified, sorted(taken)[:5])
    report.check("no path to look for libraries in", "RPATH" not in dynamic and "RUNPATH" not in dynamic, dynamic)
    report.check("no functions that cannot be used safely", not taken & {"gets", "strcpy", "strcat", "sprintf", "system", "popen", "execve", "execvp", "dlopen", "mktemp", "tmpnam"}, taken)
    if platform.machine() == "x86_64":
        # Debian's start-up objects have no such marks, so the program as a whole cannot claim them; its functions have.
        with open(program, "rb") as file:
            marks = file.read().count(ENDBR64)
        report.check("indirect jumps have marked ends", marks > MARKS, marks)
    report.note(f"fortified: {', '.join(fortified)}")
