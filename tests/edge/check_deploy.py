"""Checks that what lies in deploy/ fits the program, and that the programs it is written for accept it.

    python3 tests/edge/check_deploy.py --server build/release/server/tuftwave-server

Needs Debian's python3-yaml, haproxy, nginx-light and prometheus; script/setup edge installs them. Exit code 0 if everything
holds, else 1, with a line for each fault.
"""

from __future__ import annotations

import argparse
import glob
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from typing import Any, Optional

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import yaml  # noqa: E402

from cache import check_cache, nginx_refuses  # noqa: E402
from edge import CONFIGURATION, ROOT, Replica, samples, without_settings  # noqa: E402
from wire import Connection, request, schedule  # noqa: E402

DEPLOY = os.path.join(ROOT, "deploy")
PATHS = os.environ.get("PATH", "") + ":/usr/sbin:/usr/local/sbin"
METRIC = re.compile(r"\btuftwave_[a-z_]+")
NOBODY = 65534
PORTS = {"http": 8080, "admin": 8081}
VARIABLE = re.compile(r"\bTUFTWAVE_[A-Z_0-9]+")


def path(*parts: str) -> str:
    return os.path.join(DEPLOY, *parts)


def text_of(name: str) -> str:
    with open(name, encoding="utf-8") as file:
        return file.read()


def said(*command: str, **variables: str) -> tuple[int, str]:
    """Exit code and all that a command says. What is not installed is a fault."""
    program = shutil.which(command[0], path=PATHS)
    if not program:
        return 127, f"{command[0]} is not installed; script/setup edge installs it"
    done = subprocess.run([program, *command[1:]], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env={**without_settings(), **variables},
                          timeout=60, check=False)
    return done.returncode, done.stdout.decode()


def yaml_files() -> list[str]:
    return sorted(glob.glob(path("**", "*.yaml"), recursive=True))


def faults_of_yaml(_: str) -> Iterator[str]:
    for name in yaml_files():
        try:
            if not list(yaml.safe_load_all(text_of(name))):
                yield f"{name} is empty"
        except yaml.YAMLError as fault:
            yield f"{name}: {fault}"


def faults_of_tools(_: str) -> Iterator[str]:
    """HAProxy plain, with several replicas, with names and with TLS; promtool on the rules and their tests."""
    one = {"TUFTWAVE_REPLICA_1": "127.0.0.1:8080"}
    several = {f"TUFTWAVE_REPLICA_{number}": f"127.0.0.1:{8080 + number}" for number in range(1, 7)}
    named = {"TUFTWAVE_REPLICA_1": "replica1.invalid:8080", "TUFTWAVE_RESOLVER": "127.0.0.1:53"}
    with tempfile.TemporaryDirectory() as folder:
        runs = [(("haproxy", "-c", "-f", CONFIGURATION), one), (("haproxy", "-c", "-f", CONFIGURATION), several),
                (("haproxy", "-c", "-f", CONFIGURATION), named),
                (("promtool", "check", "rules", path("prometheus", "rules.yaml")), {}),
                (("promtool", "test", "rules", path("prometheus", "rules_test.yaml")), {})]
        if certificate := certificate_in(folder):
            runs.append((("haproxy", "-c", "-f", CONFIGURATION), {**one, "TUFTWAVE_CERTIFICATE": certificate}))
        for command, variables in runs:
            code, words = said(*command, **{"TUFTWAVE_MAXCONN": "500", **variables})
            if code != 0 or "WARNING" in words:
                yield f"{' '.join(command)}: {words.strip()}"
    if words := nginx_refuses():
        yield f"nginx: {words}"


def certificate_in(folder: str) -> str:
    """One for haproxy -c to read; nothing where there is no openssl."""
    both = os.path.join(folder, "both.pem")
    code, _ = said("openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "1", "-subj", "/CN=tuftwave.test",
                   "-keyout", both + ".key", "-out", both)
    if code != 0:
        return ""
    with open(both, "a", encoding="ascii") as file:
        file.write(text_of(both + ".key"))
    return both


def faults_of_cache(program: str) -> Iterator[str]:
    yield from check_cache(program)


def options_of(program: str) -> tuple[set[str], set[str]]:
    """Flags and variables that the program's --help names."""
    words = subprocess.run([program, "--help"], stdout=subprocess.PIPE, check=True, env=without_settings()).stdout.decode()
    return set(re.findall(r"^  (--[a-z-]+)", words, re.MULTILINE)), set(re.findall(r"TUFTWAVE_[A-Z_]+", words))


def pod() -> Any:
    return yaml.safe_load(text_of(path("kubernetes", "deployment.yaml")))["spec"]["template"]["spec"]


def faults_of_flags(program: str) -> Iterator[str]:
    flags, variables = options_of(program)
    for word in pod()["containers"][0]["args"]:
        if word.startswith("--") and word not in flags:
            yield f"deployment.yaml: the server has no flag {word}"
    services = yaml.safe_load(text_of(path("compose.yaml")))["services"]
    known = set(VARIABLE.findall(text_of(CONFIGURATION)))
    for name, service in services.items():
        for variable in service["environment"]:
            if variable not in (known if name == "haproxy" else variables):
                yield f"compose.yaml: {name} knows no variable {variable}"
    if {service["environment"].get(f"TUFTWAVE_REPLICA_{number}") for service in services.values() for number in (1, 2, 3)} - {None} != {
            f"{name}:8080" for name in services if name != "haproxy"}:
        yield "compose.yaml: HAProxy does not have exactly the replicas"
    for variable in set(VARIABLE.findall(text_of(path("README.md")))) - known - variables:
        yield f"README.md: nothing knows the variable {variable}"
    for flag in set(re.findall(r"`(--[a-z-]+)", text_of(path("README.md")))) - flags - {"--full"}:
        yield f"README.md: the server has no flag {flag}"


def faults_of_problems(_: str) -> Iterator[str]:
    """HAProxy's own errors are kinds of problems that the contract knows."""
    contract = yaml.safe_load(text_of(os.path.join(ROOT, "api", "openapi.yaml")))
    slugs = set(re.findall(r"urn:tuftwave:problem:(\w+)", text_of(CONFIGURATION)))
    for slug in sorted(slugs - set(contract["components"]["schemas"]["Slug"]["enum"])):
        yield f"haproxy.cfg: the contract has no problem {slug}"


def faults_of_ports(program: str) -> Iterator[str]:
    container = pod()["containers"][0]
    if {port["name"]: port["containerPort"] for port in container["ports"]} != PORTS:
        yield f"deployment.yaml: ports {container['ports']}"
    args = dict(zip(container["args"][::2], container["args"][1::2]))
    if (args.get("--port"), args.get("--admin-port")) != tuple(str(port) for port in PORTS.values()):
        yield f"deployment.yaml: the flags say ports {args}"
    with_defaults = json.loads(subprocess.run([program, "--print-config"], stdout=subprocess.PIPE, check=True, env=without_settings()).stdout)
    if (with_defaults["port"], with_defaults["admin-port"]) != tuple(PORTS.values()):
        yield "the server's ports are no longer those of compose.yaml and haproxy.cfg"
    service = yaml.safe_load(text_of(path("kubernetes", "service.yaml")))["spec"]["ports"]
    policy = yaml.safe_load(text_of(path("kubernetes", "network-policy.yaml")))["spec"]
    named = [port["targetPort"] for port in service] + [port["port"] for rule in policy["ingress"] for port in rule["ports"]]
    if set(named) != set(PORTS) or policy["egress"]:
        yield f"service.yaml or network-policy.yaml: ports {named}, egress {policy['egress']}"
    deadline = float(args.get("--deadline", with_defaults["deadline"]))
    if pod()["terminationGracePeriodSeconds"] < float(args["--drain"]) + deadline + 15:
        yield "deployment.yaml: the grace period is shorter than drain, deadline and answer together"


def faults_of_probes(program: str) -> Iterator[str]:
    container = pod()["containers"][0]
    replica = Replica(program)
    replica.start()
    try:
        for kind, target in (("startupProbe", "/livez"), ("livenessProbe", "/livez"), ("readinessProbe", "/readyz")):
            probe = container[kind]["httpGet"]
            if (probe["path"], probe["port"]) != (target, "admin"):
                yield f"deployment.yaml: {kind} asks {probe}"
            with Connection(("127.0.0.1", replica.admin_port), 5) as connection:
                if (status := connection.ask(request("GET", probe["path"])).status) != 200:
                    yield f"deployment.yaml: {kind}'s {probe['path']} answers {status}"
    finally:
        replica.kill()


def faults_of_privileges(_: str) -> Iterator[str]:
    spec = pod()
    own, shared = spec["containers"][0]["securityContext"], spec["securityContext"]
    wanted = {"allowPrivilegeEscalation": False, "readOnlyRootFilesystem": True, "capabilities": {"drop": ["ALL"]}}
    if own != wanted or not shared["runAsNonRoot"] or shared["runAsUser"] != NOBODY or shared["seccompProfile"]["type"] != "RuntimeDefault":
        yield f"deployment.yaml: {own} {shared}"
    if spec["automountServiceAccountToken"] or spec["enableServiceLinks"]:
        yield "deployment.yaml: a token, or variables of services"
    for name, service in yaml.safe_load(text_of(path("compose.yaml")))["services"].items():
        if not (service["read_only"] and service["cap_drop"] == ["ALL"] and service["security_opt"] == ["no-new-privileges:true"]
                and service["user"] == f"{NOBODY}:{NOBODY}" and service["mem_limit"] and service["pids_limit"]):
            yield f"compose.yaml: {name} may more than it needs"


def faults_of_kustomization(_: str) -> Iterator[str]:
    listed = set(yaml.safe_load(text_of(path("kubernetes", "kustomization.yaml")))["resources"])
    there = {os.path.basename(name) for name in glob.glob(path("kubernetes", "*.yaml"))} - {"kustomization.yaml"}
    if listed != there:
        yield f"kustomization.yaml: {sorted(listed ^ there)}"
    for name in there:
        document = yaml.safe_load(text_of(path("kubernetes", name)))
        if not {"apiVersion", "kind", "metadata", "spec"} <= set(document) or document["metadata"]["name"] != "tuftwave":
            yield f"{name}: no manifest of tuftwave"


def faults_of_metrics(program: str) -> Iterator[str]:
    """Every metric that a rule, the dashboard or the autoscaler names is served."""
    replica = Replica(program)
    replica.start()
    try:
        with Connection(replica.address) as connection:
            connection.ask(schedule(1))
        served = {name for name, _ in samples(("127.0.0.1", replica.admin_port))}
    finally:
        replica.kill()
    for name in (path("prometheus", "rules.yaml"), path("grafana", "tuftwave.json"), path("kubernetes", "horizontal-pod-autoscaler.yaml")):
        named = {word for word in METRIC.findall(text_of(name)) if word not in ("tuftwave_recorded", "tuftwave_alerts")}
        if not named:
            yield f"{name} names no metric"
        for metric in sorted(named - served):
            yield f"{os.path.basename(name)}: no such metric: {metric}"
    if len(json.loads(text_of(path("grafana", "tuftwave.json")))["panels"]) < 8:
        yield "tuftwave.json: hardly a dashboard"


def main(arguments: Optional[list[str]] = None) -> int:
    parser = argparse.ArgumentParser(description="Checks deploy/.")
    parser.add_argument("--server", default=os.environ.get("TUFTWAVE_SERVER"), help="the program (default: the environment's TUFTWAVE_SERVER)")
    options = parser.parse_args(arguments)
    if not options.server or not os.access(options.server, os.X_OK):
        print(f"check_deploy: {options.server!r} is no program; build the server and name it with --server", file=sys.stderr)
        return 1
    checks = [faults_of_yaml, faults_of_tools, faults_of_flags, faults_of_problems, faults_of_ports, faults_of_probes,
              faults_of_privileges, faults_of_kustomization, faults_of_metrics, faults_of_cache]
    faults = [fault for check in checks for fault in check(os.path.abspath(options.server))]
    for fault in faults:
        print("FAIL " + fault)
    print(f"{len(checks)} checks of deploy/, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
