"""Sends requests made of api/openapi.yaml, valid ones and broken ones, and checks every answer against it.

    python3 tests/fuzz/schema_fuzz.py --server build/release/server/tuftwave-server --valid 100000 --broken 100000
    python3 tests/fuzz/schema_fuzz.py --server ... --valid 2000 --broken 2000 --seed 7 --keep found

Holds: no 5xx but 503; every answer is one that the contract has for the operation, problems and JSON answers by their
schemas; what is valid is answered, or refused with 422 for one of RULES, which a schema cannot say; what is broken is
refused with 4xx and the place that was broken. Exit code 0 if all of it holds, else 1; what does not is printed, and
written to --keep as it was sent.
"""

from __future__ import annotations

import argparse
import collections
import json
import multiprocessing
import os
import random
import re
import struct
import sys
import time
import warnings
from typing import Any, NamedTuple, Optional

sys.dont_write_bytecode = True
warnings.filterwarnings("ignore", category=DeprecationWarning)  # newer jsonschema would like its resolver replaced
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "contract"))

import broken_values  # noqa: E402
import contract  # noqa: E402
import glb_files  # noqa: E402
from keep_alive import Connection  # noqa: E402
from quick_schema import compiled  # noqa: E402
from service import Answer, Service  # noqa: E402
from support import glb_parts  # noqa: E402
from valid_values import Values, target  # noqa: E402

# Why a request that fits the schema may be refused with 422: code, pointer, and what no schema says.
RULES = [(re.compile(code), re.compile(pointer), why) for code, pointer, why in (
    ("degenerate", "", "a vector without length, parallel vectors, a stroke on the spot, a root at the center, a head that a file does not name"),
    ("conflict", "", "two fields, or a field and the format, exclude each other"),
    ("undefined_as_printed", "", "a printed formula has no result"),
    ("too_many", "", "what a request adds up to: points, joints, vertices, pictures, frames, poses, cells"),
    ("too_few", "(period|nodes|positions|triangles|pictures|points|chains|kinds|density)", "less than half a frame, nothing chosen or made"),
    ("out_of_range", "fps$", "a fraction as text"),
    ("out_of_range", "/triangles", "a vertex that is not there"),
    ("not_a_choice", "(/from|/to|[?]chains|[?]kinds)$", "a name that nothing has"),
    ("missing_field", "/parent$", "the origin of a copy names its parent"),
    ("missing_field", "^/motion$", "a format or a setting that needs a motion"),
    ("missing_field", "^(/head/scalp|/lines)$", "either the one or the other is needed"),
    ("wrong_type", "^/head/scalp/mesh/(positions|triangles)$", "numbers come in threes"),
    ("out_of_range", "^/(fill/from|fill/to|tufts/[0-9]+)/points", "a stroke that leaves the range where a fill turns it"),
)]
KEPT = 40  # good requests of each operation, to be broken
CROSS_CHECK = 400  # one answer in so many is also checked by jsonschema itself, which is slow
SHOWN = 12  # findings that are printed
SMALL_FILES = ("vroid_Vita.chains.glb", "vroid_Sakurada_Fumiriya.chains.glb")
FILE_TYPES = ("model/gltf-binary", "model/vrm", "application/octet-stream")


class Sent(NamedTuple):
    op: contract.Operation
    target: str
    headers: dict[str, str]
    body: Optional[bytes]


class Good(NamedTuple):
    """A request that was answered, before it was put into words."""
    body: Any  # JSON, or the bytes of a file
    query: list[tuple[str, str]]


class Worker:
    def __init__(self, host: str, port: int, seed: str, keep: str) -> None:
        self._source = random.Random(seed)
        self._values = Values(self._source)
        self._connection = Connection(host, port)
        self._keep = keep
        self._operations = [op for op in contract.operations() if op in contract.posts() + contract.uploads() or op.what["operationId"] == "getSchedule"]
        self._good: dict[str, list[Good]] = collections.defaultdict(list)
        self._files = files()
        self.counts: collections.Counter[str] = collections.Counter()
        self.findings: list[str] = []

    def run(self, valid: int, broken: int) -> None:
        self._keep_examples()
        for index in range(valid + broken):
            op = self._source.choice(self._operations)
            if index * valid // (valid + broken) != (index + 1) * valid // (valid + broken):
                self._send_valid(op)
            else:
                self._send_broken(op)

    def _keep_examples(self) -> None:
        for op in self._operations:
            body = contract.example(op.what["operationId"]) if op in contract.posts() else self._files[0] if op in contract.uploads() else None
            self._good[op.path + op.method].append(Good(body, []))

    # ---- valid ----

    def _send_valid(self, op: contract.Operation) -> None:
        query, headers = self._values.query(op), {}
        body: Any = None
        if op in contract.posts():
            body, headers["Content-Type"] = self._values.body(op), "application/json"
        elif op in contract.uploads():
            body, headers["Content-Type"] = self._source.choice(self._files), self._source.choice(FILE_TYPES)
        wanted = self._wanted(op, query, headers)
        sent = Sent(op, target(op.path, query), headers, text_of(body))
        answer = self._connection.ask(op.method, sent.target, headers, sent.body)
        self._check(sent, answer)
        self.counts[f"valid {answer.status}"] += 1
        if answer.status == 200:
            if answer.media_type != wanted:
                self._find(sent, answer, f"wanted {wanted}")
            good = self._good[op.path + op.method]
            good[self._source.randrange(1, KEPT) if len(good) >= KEPT else len(good):][:1] = [Good(body, query)]
        elif answer.status == 422:
            error = json.loads(answer.body)["errors"][0]
            reason = next((why for code, pointer, why in RULES if code.fullmatch(error["code"]) and pointer.search(error["pointer"])), None)
            self.counts[f"  {error['code']}: {reason}"] += 1
            if reason is None:
                self._find(sent, answer, "a valid request is refused")
        elif answer.status != 503:
            self._find(sent, answer, "a valid request is refused")

    def _wanted(self, op: contract.Operation, query: list[tuple[str, str]], headers: dict[str, str]) -> str:
        """The media type to come, asked for by Accept unless the query says it."""
        known = contract.answer_content(op)
        given = dict(query).get("format")
        if given:
            headers["Accept"] = self._source.choice(["image/png", "*/*"])
            return contract.MEDIA_TYPES[given]
        wanted = self._source.choice([*known, None])
        if wanted is None or len(known) == 1:
            return next(iter(known))
        headers["Accept"] = self._source.choice([wanted, f"image/png, {wanted};q=0.9, */*;q=0.1"])
        return wanted

    # ---- broken ----

    def _send_broken(self, op: contract.Operation) -> None:
        good = self._source.choice(self._good[op.path + op.method])
        broken = self._broken(op, good)
        sent = Sent(op, target(op.path, broken.query), broken.headers, broken.body)
        answer = self._connection.ask(op.method, sent.target, sent.headers, sent.body)
        self._check(sent, answer)
        self.counts[f"broken {answer.status}"] += 1
        self.counts[f"  {broken.kind}"] += 1
        if answer.status == 503:
            return
        if answer.status not in broken.statuses:
            self._find(sent, answer, f"{broken.kind}: wanted {broken.statuses} for {broken.pointer}")
        elif broken.pointer is not None:
            pointers = [error["pointer"] for error in json.loads(answer.body).get("errors", [])]
            if not any(is_about(pointer, broken.pointer) for pointer in pointers):
                self._find(sent, answer, f"{broken.kind}: wanted {broken.pointer}, not {pointers}")

    def _broken(self, op: contract.Operation, good: Good) -> broken_values.Broken:
        source = self._source
        takes_body = op in contract.posts()
        dice = source.random()
        good_type = "application/json" if takes_body else FILE_TYPES[0]
        if takes_body and dice < 0.8:
            return broken_values.broken_body(source, op, good.body, good.query)
        if op in contract.uploads() and dice < 0.3:
            return broken_file(source, good)
        if op.method == "POST" and dice < 0.9:
            return broken_values.broken_media(source, text_of(good.body) or b"", good.query, good_type) if contract.formats(op) else broken_values.Broken(
                "media type", good.body, good.query, {"Content-Type": "application/json"}, None, (415,))
        kind, query, pointer = broken_values.broken_query(source, op, good.query)
        status = 400 if kind == "twice" else 422
        return broken_values.Broken(kind, text_of(good.body), query, {"Content-Type": good_type} if good.body is not None else {}, pointer, (status,))

    # ---- every answer ----

    def _check(self, sent: Sent, answer: Answer) -> None:
        if answer.status >= 500 and answer.status != 503:
            self._find(sent, answer, "the server failed")
        if answer.status == 503:
            self.counts["busy"] += 1
        fault = fault_of(sent.op, answer, self._source.randrange(CROSS_CHECK) == 0)
        if fault:
            self._find(sent, answer, fault)

    def _find(self, sent: Sent, answer: Answer, what: str) -> None:
        self.findings.append(f"{sent.op.method} {sent.target[:300]}: {answer.status}: {what}\n    {answer.body[:400]!r}")
        if self._keep:
            name = os.path.join(self._keep, f"{os.getpid()}-{len(self.findings)}")
            with open(name, "wb") as file:
                file.write(f"{what}\n{sent.op.method} {sent.target}\n{sent.headers}\n\n".encode() + (sent.body or b""))


def is_about(pointer: str, place: str) -> bool:
    """Whether one is the other or a part of it: what is missing in a list may be said of the list."""
    def parts(text: str) -> list[str]:
        return text.split("/")
    place = place if place.startswith("?") else place.replace("~", "~0")
    shorter = min(len(parts(pointer)), len(parts(place)))
    return parts(pointer)[:shorter] == parts(place)[:shorter] or (len(place) > 64 and pointer.startswith(place[:64]))


def text_of(body: Any) -> Optional[bytes]:
    return body if body is None or isinstance(body, bytes) else json.dumps(body, ensure_ascii=False).encode()


def files() -> list[bytes]:
    """Characters to be posted: the smallest that there can be, and some real ones."""
    document, binary = glb_files.small_character()
    return [glb_files.to_glb(document, binary), *map(glb_files.character, SMALL_FILES)]


def broken_file(source: random.Random, good: Good) -> broken_values.Broken:
    file = bytearray(good.body)
    kind = source.choice(["cut file", "garbled file", "garbled JSON"])
    if kind == "cut file":
        file = file[:source.randrange(len(file))]
    elif kind == "garbled file":
        file[source.randrange(20)] ^= source.randrange(1, 256)
    else:
        file[20] = source.choice(b"[x0")
    return broken_values.Broken(kind, bytes(file), good.query, {"Content-Type": FILE_TYPES[0]}, None, (400,))


def fault_of(op: contract.Operation, answer: Answer, thoroughly: bool) -> Optional[str]:
    """What an answer has that the contract has not."""
    responses = op.what["responses"]
    described = contract.resolve(responses.get(str(answer.status), responses["default"]))
    if not answer.headers.get("request-id"):
        return "no Request-Id"
    known = described.get("content", {})
    if answer.media_type not in known:
        return f"the contract has no {answer.media_type!r} for {answer.status}"
    if answer.media_type == "model/gltf-binary":
        try:
            return None if glb_parts(answer.body)[0]["asset"]["version"] == "2.0" else "no glTF 2.0"
        except (ValueError, KeyError, struct.error) as error:
            return f"no GLB: {error}"
    schema = known[answer.media_type].get("schema")
    if schema is None or not answer.media_type.endswith(("/json", "problem+json", "gltf+json")):
        return None if answer.body else "an empty answer"
    document = json.loads(answer.body)
    if answer.status != 200 and (document["status"] != answer.status or document["request_id"] != answer.headers["request-id"]):
        return "a problem about something else"
    faults = contract.faults(document, schema) if thoroughly else []
    return compiled(schema)(document) or (faults[0] if faults else None)


def work(arguments: tuple[str, int, str, str, int, int]) -> tuple[collections.Counter[str], list[str]]:
    host, port, seed, keep, valid, broken = arguments
    worker = Worker(host, port, seed, keep)
    try:
        worker.run(valid, broken)
    except (OSError, ValueError, KeyError) as error:
        worker.findings.append(f"{type(error).__name__}: {error}; the server said something that is no answer, or nothing")
    return worker.counts, worker.findings


def share(total: int, parts: int, index: int) -> int:
    return total * (index + 1) // parts - total * index // parts


def main(arguments: Optional[list[str]] = None) -> int:
    parser = argparse.ArgumentParser(description="Sends random requests made of the contract.")
    parser.add_argument("--server", required=True, help="the program")
    parser.add_argument("--valid", type=int, default=2_000)
    parser.add_argument("--broken", type=int, default=2_000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--processes", type=int, default=3, help="each has a connection of its own")
    parser.add_argument("--keep", default="", metavar="FOLDER", help="where to write requests that found something")
    options = parser.parse_args(arguments)
    if options.keep:
        os.makedirs(options.keep, exist_ok=True)
    begin = time.monotonic()
    with Service(options.server) as service, multiprocessing.Pool(options.processes) as pool:
        shares = [(service.host, service.port, f"{options.seed}/{i}", options.keep, share(options.valid, options.processes, i), share(options.broken, options.processes, i))
                  for i in range(options.processes)]
        results = pool.map(work, shares, chunksize=1)
        is_running = service.is_running
    counts = sum((counts for counts, _ in results), collections.Counter())
    findings = [finding for _, found in results for finding in found]
    for name in sorted(counts):
        print(f"{counts[name]:8} {name}")
    for finding in findings[:SHOWN]:
        print(finding)
    if not is_running:
        findings.append("the server has ended")
    answered = counts["valid 200"]
    if answered * 2 < options.valid:
        findings.append(f"only {answered} of {options.valid} valid requests were answered: they say little")
        print(findings[-1])
    print(f"seed {options.seed}: {options.valid} valid and {options.broken} broken requests in {time.monotonic() - begin:.0f} s, {len(findings)} findings")
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
