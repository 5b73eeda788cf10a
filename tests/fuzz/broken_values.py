"""One thing wrong: mutations of a request that is known to be answered, each with the place that the answer must name."""

from __future__ import annotations

import copy
import json
import random
from typing import Any, Callable, Iterator, NamedTuple, Optional

import contract
from quick_schema import TYPES, compiled

WRONG = [None, True, False, 7, 0.5, "x", "", [], {}, [1, "2"], {"x": 1}, [[]]]  # values of every type
TOKENS = ["NaN", "Infinity", "-Infinity", "1e999", "-1e999", "0x10", "01", "+1", ".5", "1.", "undefined", "1e", "'1'"]  # no JSON numbers
FINEST = 2e-6  # that a number is beyond its range: frame rates are taken to a millionth
MARK = "\ue000"  # stands where a token will be


class Broken(NamedTuple):
    kind: str
    body: Optional[bytes]
    query: list[tuple[str, str]]
    headers: dict[str, str]
    pointer: Optional[str]  # the place that must be named; None where there is none
    statuses: tuple[int, ...]


class Spot(NamedTuple):
    pointer: str
    parent: Any  # holds it at `key`
    key: Any
    schema: Any


def spots(schema: Any, holder: Any, key: Any, pointer: str = "") -> Iterator[Spot]:
    """Every value in a body with its schema, the body itself included."""
    node, value = contract.resolve(schema), holder[key]
    yield Spot(pointer, holder, key, node)
    for part in node.get("oneOf", []) + node.get("allOf", []):
        part = contract.resolve(part)
        if part.get("type") in ("object", "array") and isinstance(value, dict if part["type"] == "object" else list):
            node = part
    if isinstance(value, dict):
        for name in value:
            if name in node.get("properties", {}):
                yield from spots(node["properties"][name], value, name, f"{pointer}/{name}")
    elif isinstance(value, list):
        for index in range(len(value)):
            part = node["prefixItems"][index] if "prefixItems" in node else node["items"]
            yield from spots(part, value, index, f"{pointer}/{index}")


def parts_of(schema: Any) -> Iterator[Any]:
    """A schema and those that it offers or is made of."""
    node = contract.resolve(schema)
    yield node
    for part in node.get("oneOf", []) + node.get("allOf", []):
        yield from parts_of(part)


class Mutations:
    """Each returns whether it found something to break, and changes `self.holder[0]`, a copy of a good body."""

    def __init__(self, source: random.Random, op: contract.Operation, body: Any) -> None:
        self._source = source
        self._schema = contract.request_schema(op)
        self.holder = [copy.deepcopy(body)]
        self._spots = list(spots(self._schema, self.holder, 0))
        self.pointer: Optional[str] = None

    def broken(self) -> tuple[str, bytes, Optional[str]]:
        """Its kind, its text and the place."""
        kinds: list[tuple[str, Callable[[], bool]]] = [
            ("missing", self.missing), ("unknown", self.unknown), ("wrong type", self.wrong_type), ("out of range", self.out_of_range),
            ("too many or few", self.too_many_or_few), ("no choice", self.no_choice), ("too long", self.too_long), ("no number", self.no_number),
            ("duplicate", self.duplicate), ("cut", self.cut), ("garbled", self.garbled), ("deep", self.deep)]
        while True:
            kind, mutate = self._source.choice(kinds)
            if mutate():
                text = self._text()
                if text is not None:
                    return kind, text, self.pointer

    def _text(self) -> Optional[bytes]:
        if isinstance(self.holder[0], bytes):
            return self.holder[0]
        return json.dumps(self.holder[0], ensure_ascii=False).encode() if compiled(self._schema)(self.holder[0]) else None

    def _pick(self, fits: Callable[[Spot], bool]) -> Optional[Spot]:
        found = [spot for spot in self._spots if fits(spot)]
        return self._source.choice(found) if found else None

    def _put(self, spot: Optional[Spot], value: Any) -> bool:
        if spot is None:
            return False
        spot.parent[spot.key] = value
        self.pointer = spot.pointer
        return True

    def missing(self) -> bool:
        def needed(spot: Spot) -> list[str]:
            return [name for part in parts_of(spot.schema) if isinstance(spot.parent[spot.key], dict) for name in part.get("required", []) if name in spot.parent[spot.key]]
        spot = self._pick(lambda spot: bool(needed(spot)))
        if spot is None:
            return False
        name = self._source.choice(needed(spot))
        del spot.parent[spot.key][name]
        self.pointer = f"{spot.pointer}/{name}"
        return True

    def unknown(self) -> bool:
        spot = self._pick(lambda spot: isinstance(spot.parent[spot.key], dict))
        name = self._source.choice(["nmae", "", "髪", "Points", "__proto__", "x" * 80])
        spot.parent[spot.key][name] = self._source.choice(WRONG)
        self.pointer = f"{spot.pointer}/{name}"
        return True

    def wrong_type(self) -> bool:
        spot = self._pick(lambda spot: True)
        wrong = [value for value in WRONG if compiled(spot.schema)(value)]
        return self._put(spot, self._source.choice(wrong))

    def out_of_range(self) -> bool:
        spot = self._pick(lambda spot: TYPES["number"](spot.parent[spot.key]) and any("minimum" in part for part in parts_of(spot.schema)))
        if spot is None:
            return False
        part = next(part for part in parts_of(spot.schema) if "minimum" in part)
        least, most = part["minimum"], part["maximum"]
        step = 1 if part.get("type") == "integer" or "integer" in part.get("type", []) else max(FINEST, abs(most) * 1e-9)
        values = [least - step, most + step, -1e300, 1e300, 2**63, -2**63, 2**64 + 1]
        return self._put(spot, self._source.choice([value for value in values if compiled(spot.schema)(value)]))

    def too_many_or_few(self) -> bool:
        spot = self._pick(lambda spot: isinstance(spot.parent[spot.key], list) and any(part.get("minItems") or part.get("maxItems", 9999) < 100 for part in parts_of(spot.schema)))
        if spot is None:
            return False
        value = spot.parent[spot.key]
        part = next(part for part in parts_of(spot.schema) if "minItems" in part)
        few = value[:part["minItems"] - 1] if part["minItems"] else None
        many = (value * (part["maxItems"] + 1))[:part["maxItems"] + 1] if part["maxItems"] < 100 and value else None
        return self._put(spot, self._source.choice([made for made in (few, many) if made is not None]))

    def no_choice(self) -> bool:
        return self._put(self._pick(lambda spot: "enum" in spot.schema), self._source.choice(["", "x", "SINE", "null", 0.25, "sine "]))

    def too_long(self) -> bool:
        spot = self._pick(lambda spot: isinstance(spot.parent[spot.key], str) and any("maxLength" in part for part in parts_of(spot.schema)))
        if spot is None:
            return False
        longest = next(part["maxLength"] for part in parts_of(spot.schema) if "maxLength" in part)
        return self._put(spot, self._source.choice("x髪🦊") * (longest + self._source.choice([1, 1, 1000])))

    # ---- what is wrong with the text; no place is named ----

    def no_number(self) -> bool:
        spot = self._pick(lambda spot: TYPES["number"](spot.parent[spot.key]))
        if spot is None or not self._put(spot, MARK):
            return False
        text = json.dumps(self.holder[0], ensure_ascii=False).replace(f'"{MARK}"', self._source.choice(TOKENS))
        return self._is(text.encode())

    def duplicate(self) -> bool:
        spot = self._pick(lambda spot: isinstance(spot.parent[spot.key], dict) and bool(spot.parent[spot.key]))
        if spot is None:
            return False
        name = self._source.choice(list(spot.parent[spot.key]))
        spot.parent[spot.key][MARK] = 0
        return self._is(json.dumps(self.holder[0], ensure_ascii=False).replace(MARK, name).encode())

    def cut(self) -> bool:
        text = json.dumps(self.holder[0], ensure_ascii=False).encode()
        return self._is(text[:self._source.randrange(len(text))])

    def garbled(self) -> bool:
        text = bytearray(json.dumps(self.holder[0], ensure_ascii=False).encode())
        for _ in range(self._source.randint(1, 4)):
            text[self._source.randrange(len(text))] = self._source.choice([0, 9, 34, 44, 58, 91, 92, 125, 128, 192, 255])
        try:
            json.loads(bytes(text).decode())
        except ValueError:
            return self._is(bytes(text))
        return False

    def deep(self) -> bool:
        depth = self._source.choice([33, 100, 20_000])
        return self._is(self._source.choice([b"[" * depth + b"]" * depth, b'{"a":' * depth + b"0" + b"}" * depth, b"[" * depth]))

    def _is(self, text: bytes) -> bool:
        self.holder[0] = text
        self.pointer = None
        return True


def broken_body(source: random.Random, op: contract.Operation, body: Any, query: list[tuple[str, str]]) -> Broken:
    """A body that its schema refuses, or none at all."""
    while True:
        mutations = Mutations(source, op, body)
        kind, text, pointer = mutations.broken()
        return Broken(kind, text, query, {"Content-Type": "application/json"}, pointer, (422,) if pointer is not None else (400,))


def broken_media(source: random.Random, body: bytes, query: list[tuple[str, str]], good_type: str) -> Broken:
    query = [(name, value) for name, value in query if name != "format"]
    wrong_types = ["text/plain", "application/xml", "", "multipart/form-data; boundary=x", "application/x-www-form-urlencoded"]
    return source.choice([
        Broken("media type", body, query, {"Content-Type": source.choice(wrong_types)}, None, (415,)),
        Broken("packed", body, query, {"Content-Type": good_type, "Content-Encoding": source.choice(["gzip", "br", "deflate, gzip"])}, None, (415,)),
        Broken("nothing acceptable", body, query, {"Content-Type": good_type, "Accept": source.choice(["image/png", "*/*;q=0", "text/html, image/*;q=0.9"])}, None, (406,)),
    ])


def broken_query(source: random.Random, op: contract.Operation, query: list[tuple[str, str]]) -> tuple[str, list[tuple[str, str]], str]:
    """@return  its kind, the query and the place"""
    parameters = [p for p in map(contract.resolve, op.what.get("parameters", [])) if p["in"] == "query"]
    kind = source.choice(["unknown parameter", "twice", "wrong value"])
    if kind == "twice" and query:
        name, value = source.choice(query)
        return kind, query + [(name, value)], f"?{name}"
    strict = [(p, wrong) for p in parameters for wrong in wrong_texts(p)]
    if kind == "wrong value" and strict:
        parameter, wrong = source.choice(strict)
        rest = [pair for pair in query if pair[0] != parameter["name"]]
        return kind, rest + [(parameter["name"], wrong)], f"?{parameter['name']}"
    name = source.choice(["x", "Format", "髪", "format ", "a" * 60])
    return "unknown parameter", query + [(name, "1")], f"?{name}"


def wrong_texts(parameter: Any) -> list[str]:
    """Texts that a parameter's schema refuses."""
    schema = contract.resolve(parameter["schema"])
    candidates = ["x", "-1e300", "1e300", "1e999", "nan", "inf", "0x1", "1,2", "true", "[]", "null", "\ufffe"]
    if schema.get("type") in ("number", "integer") or "enum" in schema:
        return [text for text in candidates if compiled(schema)(as_value(text))]
    return {"fps": ["x", "1/0", "-24", "24/", "1e9", "1,2"], "wind": ["x", "1,2", "1,2,3,4", "nan,0,0"], "up": ["0,1", "x,1,0"], "phases": ["x", "1,,2", "1e9"],
            "kinds": ["tail", ","], "clip_name": ["x" * 65, ""], "one_sided": ["1", "yes"]}.get(parameter["name"], [])


def as_value(text: str) -> Any:
    try:
        return json.loads(text, parse_constant=str)
    except ValueError:
        return text
