"""script/sbom names every library that the program links, and what it carries, in a sound SPDX document."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from typing import Any

import contract
from report import Report

KNOWN = ("cpp-httplib", "spdlog", "fmt", "nlohmann-json3", "simdjson", "meshoptimizer", "libssl", "zlib1g", "libbrotli", "libc6", "libstdc++6", "swagger-ui-dist", "three", "three-mesh-bvh", "fflate")
REQUIRED = {"SPDXID", "name", "versionInfo", "downloadLocation", "licenseConcluded", "licenseDeclared", "copyrightText"}
SCRIPT = os.path.join(contract.ROOT, "script", "sbom")


def run(report: Report, program: str, full: bool) -> None:
    if not shutil.which("dpkg-query"):
        report.skip("bill of materials", "this is no Debian")
        return
    made = [subprocess.run([sys.executable, SCRIPT, program], capture_output=True, text=True) for _ in range(2)]
    report.equal("exit code", made[0].returncode, 0)
    report.equal("nothing to complain of", made[0].stderr, "")
    report.check("the same twice", made[0].stdout == made[1].stdout)
    bill = json.loads(made[0].stdout)
    sound(report, bill)
    comments = " ".join(package["comment"] for package in bill["packages"])
    linked = [line.split()[0] for line in subprocess.run(["ldd", program], capture_output=True, text=True).stdout.splitlines() if "vdso" not in line]
    for name in linked:
        report.check(f"{name} is named", re.search(r"(?<![\w.])" + re.escape(os.path.basename(name)) + r"(?![\w.])", comments), comments)
    report.check("ldd names some", len(linked) >= 5, linked)
    names = " ".join(package["name"] for package in bill["packages"])
    for name in KNOWN:
        report.check(f"{name} is there", name in names, names)
    report.equal("no program, no document", subprocess.run([sys.executable, SCRIPT, "/dev/null"], capture_output=True).returncode, 1)
    report.note(f"{len(bill['packages'])} packages, {len(linked)} libraries")


def sound(report: Report, bill: dict[str, Any]) -> None:
    """SPDX 2.3, clauses 6, 7 and 11: what a document must have, and that every relation joins two elements of it."""
    report.equal("version", (bill["spdxVersion"], bill["dataLicense"], bill["SPDXID"]), ("SPDX-2.3", "CC0-1.0", "SPDXRef-DOCUMENT"))
    report.check("creation", re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", bill["creationInfo"]["created"]) and bill["creationInfo"]["creators"], bill["creationInfo"])
    keys = [package["SPDXID"] for package in bill["packages"]]
    report.equal("identifiers used once", len(keys), len(set(keys)))
    for package in bill["packages"]:
        report.check(f"{package['name']} has all that it must", REQUIRED <= package.keys() and all(package[key] for key in REQUIRED), package)
        report.check(f"{package['name']} has a sound identifier", re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", package["SPDXID"]), package["SPDXID"])
    ends = {relation[side] for relation in bill["relationships"] for side in ("spdxElementId", "relatedSpdxElement")}
    report.check("every relation joins two of them", ends <= {*keys, "SPDXRef-DOCUMENT"}, ends)
