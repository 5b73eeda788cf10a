"""Random requests that the contract's schemas allow, small ones, most of which also make sense."""

from __future__ import annotations

import json
import math
import random
from typing import Any, Optional
from urllib.parse import quote

import contract
from quick_schema import compiled

OPTIONAL = 0.3  # share of the optional fields that are given
MORE_ITEMS = 3  # than a list must have
END, DEFAULT = 0.02, 0.15  # shares of numbers that are at an end of their range, or their default
PATTERNS = {"^#[0-9a-fA-F]{6}$": ["#8a5a44", "#FFFFFF", "#000000"], "^[0-9]{1,7}(/[0-9]{1,7})?$": ["24", "24000/1001", "12", "30000/1001", "60/2"]}
TEXTS = ["", "lock", "fringe", "左 髪", "a/b~c", "<b>&\"'\\", "tab\there", "é" * 3, "🦊", "x" * 12, "hair_01"]
# Words of parameters whose schema is only a string.
QUERY_TEXTS = {"fps": ["24", "12", "30", "24000/1001", "23.976", "60/2"], "wind": ["1,0,0", "0.5,0,-2", "-1,0.1,0"], "up": ["0,1,0", "0.1,2,0"],
               "chains": ["*", "0", "0,1", "?*"], "kinds": ["hair", "hair,ribbon", "hair,skirt,ribbon,unknown"], "clip_name": ["w", "breeze", "風"], "phases": ["0", "0.5"]}
# Ranges in which answers stay small; beyond them is the generator's END.
MODEST = {"rings": (2, 24), "sides": (3, 16), "steps": (1, 20), "repeat": (1, 4), "seed": (0, 2**53 - 1), "tolerance": (0.0003, 0.1), "index": (1, 99), "parent": (1, 99),
          "diameter_at_100": (0.01, 1), "tufts_per_meter": (1, 100), "node": (0, 9), "root_depth": (0, 0.02), "fps": (6, 60), "phase": (-7, 7), "cycles": (1, 2)}


class Values:
    def __init__(self, source: random.Random) -> None:
        self._source = source

    def value(self, schema: Any, name: str = "") -> Any:
        """An instance of a schema. @param name  of the field that it is for"""
        node = contract.resolve(schema)
        made = self._value(node, name)
        while "not" in node and compiled(node)(made):
            made = self._value(node, name)
        return made

    def _value(self, node: Any, name: str) -> Any:
        source = self._source
        if "allOf" in node:
            return self.value(node["allOf"][0], name)
        if "oneOf" in node:
            return self.value(source.choice(node["oneOf"]), name)
        if "enum" in node:
            return source.choice(node["enum"])
        kind = node.get("type")
        if isinstance(kind, list):
            kind = source.choice(kind)
        return {"null": lambda *_: None, "boolean": lambda *_: source.random() < 0.5, "number": self._number, "integer": self._integer, "string": self._text,
                "array": self._list, "object": self._object}[kind](node, name)

    def _number(self, node: Any, name: str) -> float:
        source, least, most, default = self._source, node["minimum"], node["maximum"], node.get("default")
        if source.random() < END:
            return source.choice([least, most])
        if default is not None and source.random() < DEFAULT:
            return default
        low, high = MODEST.get(name, (max(least, -1), min(most, 1)) if least < 0 else (least, min(most, 100)))
        if default and name not in MODEST:
            return min(max(default * math.exp(source.gauss(0, 0.6)), least), most)
        return source.choice([source.uniform(low, high), round(source.uniform(low, high), 2)]) if low <= round(low, 2) <= round(high, 2) <= high else source.uniform(low, high)

    def _integer(self, node: Any, name: str) -> Any:
        source, least, most = self._source, node["minimum"], node["maximum"]
        if source.random() < END:
            return source.choice([least, most])
        low, high = MODEST.get(name, (least, min(most, least + 11)))
        number = source.randint(max(low, least), min(high, most))
        return float(number) if source.random() < 0.05 else number

    def _text(self, node: Any, name: str) -> str:
        if "pattern" in node:
            return self._source.choice(PATTERNS[node["pattern"]])
        longest = node.get("maxLength", 64)
        if self._source.random() < END:
            return "髪" * longest
        return self._source.choice(TEXTS)[:longest]

    def _list(self, node: Any, name: str) -> list[Any]:
        if "prefixItems" in node:
            return [self.value(part, name) for part in node["prefixItems"]]
        least = node.get("minItems", 0)
        count = self._source.randint(least, min(node["maxItems"], least + MORE_ITEMS))
        return [self.value(node["items"], name) for _ in range(count)]

    def _object(self, node: Any, _: str) -> dict[str, Any]:
        needed = node.get("required", [])
        made = {name: self.value(part, name) for name, part in node.get("properties", {}).items() if name in needed or self._source.random() < OPTIONAL}
        names = list(made)
        self._source.shuffle(names)
        return {name: made[name] for name in names}

    # ---- what schemas cannot say, so that most requests have an answer ----

    def body(self, op: contract.Operation) -> Any:
        body = self.value(contract.request_schema(op))
        if self._source.random() < 0.1:
            return body  # as the schema has it
        self._settle_head(body.get("head", {}))
        for chain in body.get("chains") or []:
            self._settle_chain(chain)
        for tuft in [*body.get("tufts", []), *[body["fill"].get(side) for side in ("from", "to") if "fill" in body]]:
            self._settle_tuft(tuft or {})
        settle = {"evaluations": self._settle_evaluations, "fits": self._settle_fits, "hairstyles": self._settle_fills}.get(op.what["operationId"])
        if settle:
            settle(body)
        return body

    def _settle_head(self, head: dict[str, Any]) -> None:
        scalp = head.get("scalp")
        if scalp is not None:
            head["scalp"] = self._source.choice([None, {"ellipsoid": {"radii": [0.08, 0.11, 0.1]}}, {"mesh": octahedron(0.1)}])
            head.pop("center", None)

    def _settle_tuft(self, tuft: dict[str, Any]) -> None:
        if tuft.get("section") != "ellipse":
            tuft.pop("flatness", None)
        if tuft.get("origin"):
            tuft["origin"] = self._source.choice([{"kind": "along", "index": 3}, {"kind": "neck", "index": 1, "parent": 2}])

    def _settle_chain(self, chain: dict[str, Any]) -> None:
        if chain.get("rest_rotations"):
            chain["rest_rotations"] = [[0, 0, 0.6, 0.8] for _ in chain["nodes"]]

    def _lines(self, pictures: int, nodes: int) -> list[Any]:
        return [[[0.1 * node, self._source.uniform(-0.05, 0.05) * node] for node in range(nodes)] for _ in range(pictures)]

    def _settle_evaluations(self, body: dict[str, Any]) -> None:
        shapes = [(self._source.randint(2, 6), self._source.randint(2, 5)) for _ in body["drawn"]]
        for lines, shape in zip(body["drawn"], shapes):
            lines["pictures"] = self._lines(*shape)
        body.pop("chains", None)
        body.pop("motion", None)
        body["lines"] = [{"pictures": self._lines(*shape)} for shape in shapes]

    def _settle_fits(self, body: dict[str, Any]) -> None:
        for lines in body["drawn"]:
            nodes = self._source.randint(3, 5)
            lines["pictures"] = self._lines(self._source.randint(3, 6), nodes)
            if lines.get("rest"):
                lines["rest"] = self._lines(1, nodes)[0]
        body["steps"] = min(body.get("steps", 20), 20)
        body.pop("timing", None)

    def _settle_fills(self, body: dict[str, Any]) -> None:
        for index, tuft in enumerate(body["tufts"]):
            tuft["name"] = f"tuft {index}"
        for fill in body.get("fills", []):
            fill["from"] = self._source.choice(body["tufts"])["name"]
            fill["to"] = self._source.choice([None, self._source.choice(body["tufts"])["name"]])

    # ---- queries ----

    def query(self, op: contract.Operation) -> list[tuple[str, str]]:
        """Parameters and their values, as text."""
        chosen = [p for p in map(contract.resolve, op.what.get("parameters", [])) if p["in"] == "query" and self._source.random() < OPTIONAL]
        names = [p["name"] for p in chosen]
        if "chains" in names:
            chosen = [p for p in chosen if p["name"] != "kinds"]
        return [(p["name"], self.parameter(p)) for p in chosen]

    def parameter(self, parameter: Any) -> str:
        if parameter["name"] in QUERY_TEXTS:
            return self._source.choice(QUERY_TEXTS[parameter["name"]])
        value: Optional[Any] = None
        while value is None or value == "":
            value = self.value(parameter["schema"], parameter["name"])
        return value if isinstance(value, str) else json.dumps(value)


def octahedron(radius: float) -> dict[str, list[float]]:
    """A closed mesh around the origin."""
    corners = [(radius, 0, 0), (-radius, 0, 0), (0, radius, 0), (0, -radius, 0), (0, 0, radius), (0, 0, -radius)]
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    return {"positions": [part for corner in corners for part in corner], "triangles": [part for face in faces for part in face]}


def target(path: str, query: list[tuple[str, str]]) -> str:
    return path + ("?" + "&".join(f"{quote(name, safe='')}={quote(value, safe='')}" for name, value in query) if query else "")
