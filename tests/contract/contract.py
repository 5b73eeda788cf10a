"""openapi.yaml as the tests read it: references, operations, schemas, examples."""

from __future__ import annotations

import json
import os
from typing import Any, Iterator, NamedTuple, Optional

import jsonschema
import yaml

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
CONTRACT = os.path.join(ROOT, "api", "openapi.yaml")
EXAMPLES = os.path.join(ROOT, "api", "examples")
CHARACTER = os.path.join(ROOT, "tests", "data", "characters", "pmca_sample3.glb")
METHODS = ("get", "put", "post", "delete", "options", "head", "patch", "trace")

with open(CONTRACT, encoding="utf-8") as file:
    DOCUMENT: dict[str, Any] = yaml.safe_load(file)

_RESOLVER = jsonschema.RefResolver("", DOCUMENT)
MEDIA_TYPES = {"glb": "model/gltf-binary", "gltf": "model/gltf+json", "json": "application/json", "xdts": "application/x-xdts+json", "csv": "text/csv",
               "vmd": "application/octet-stream", "bvh": "application/x-bvh", "usda": "model/vnd.usda"}


class Operation(NamedTuple):
    method: str  # in upper case
    path: str
    what: dict[str, Any]


def resolve(node: Any) -> Any:
    """What a reference stands for. Raises KeyError where it stands for nothing."""
    while isinstance(node, dict) and "$ref" in node:
        reference = node["$ref"]
        node = DOCUMENT
        for part in reference.removeprefix("#/").split("/"):
            node = node[part.replace("~1", "/").replace("~0", "~")]
    return node


def operations() -> list[Operation]:
    return [Operation(method.upper(), path, what) for path, item in DOCUMENT["paths"].items() for method, what in item.items() if method in METHODS]


def operation(operation_id: str) -> Operation:
    return next(op for op in operations() if op.what["operationId"] == operation_id)


def walk(node: Any, place: str = "#") -> Iterator[tuple[str, Any]]:
    """Every node of a document with its place."""
    yield place, node
    if isinstance(node, dict):
        for key, value in node.items():
            yield from walk(value, f"{place}/{key}")
    elif isinstance(node, list):
        for index, value in enumerate(node):
            yield from walk(value, f"{place}/{index}")


def schemas() -> Iterator[tuple[str, dict[str, Any]]]:
    """Every schema with its place: the named ones and those of parameters, headers and bodies, and what they are made of."""
    for place, node in walk(DOCUMENT):
        is_named = place.count("/") == 3 and place.startswith("#/components/schemas/")
        if (is_named or place.endswith("/schema")) and isinstance(node, dict):
            yield from parts(node, place)


def parts(schema: Any, place: str) -> Iterator[tuple[str, dict[str, Any]]]:
    if not isinstance(schema, dict):
        return
    yield place, schema
    for keyword in ("items", "additionalProperties", "not"):
        yield from parts(schema.get(keyword), f"{place}/{keyword}")
    for keyword in ("allOf", "oneOf", "anyOf", "prefixItems"):
        for index, part in enumerate(schema.get(keyword, [])):
            yield from parts(part, f"{place}/{keyword}/{index}")
    for name, part in schema.get("properties", {}).items():
        yield from parts(part, f"{place}/properties/{name}")


def faults(instance: Any, schema: dict[str, Any]) -> list[str]:
    """What is wrong with an instance, in words; empty where nothing is."""
    validator = jsonschema.Draft202012Validator(schema, resolver=_RESOLVER)
    return [f"/{'/'.join(map(str, error.absolute_path))}: {error.message[:300]}" for error in validator.iter_errors(instance)]


def named(name: str) -> dict[str, Any]:
    return {"$ref": f"#/components/schemas/{name}"}


def request_schema(op: Operation) -> dict[str, Any]:
    return op.what["requestBody"]["content"]["application/json"]["schema"]


def answer_content(op: Operation) -> dict[str, Any]:
    return op.what["responses"]["200"]["content"]


def formats(op: Operation) -> list[str]:
    """The words of ?format=; none where the operation has a single form."""
    for parameter in map(resolve, op.what.get("parameters", [])):
        if parameter["name"] == "format":
            return parameter["schema"]["enum"]
    return []


def posts() -> list[Operation]:
    """Operations that take JSON."""
    return [op for op in operations() if "application/json" in resolve(op.what.get("requestBody", {})).get("content", {})]


def uploads() -> list[Operation]:
    """Operations whose body is a file."""
    return [op for op in operations() if "model/gltf-binary" in resolve(op.what.get("requestBody", {})).get("content", {})]


def example(operation_id: str, rejected: bool = False) -> Any:
    with open(os.path.join(EXAMPLES, "rejected" if rejected else "", f"{operation_id}.json"), encoding="utf-8") as body:
        return json.load(body)


def sample(op: Operation) -> tuple[Optional[bytes], dict[str, str]]:
    """A body that an operation takes, and the headers that go with it."""
    if op in uploads():
        with open(CHARACTER, "rb") as file:
            return file.read(), {"Content-Type": "model/gltf-binary"}
    return (json.dumps(example(op.what["operationId"])).encode(), {"Content-Type": "application/json"}) if op in posts() else (None, {})


def lookup(document: Any, pointer: str) -> Optional[Any]:
    """The value at a JSON pointer, or None."""
    for part in pointer.split("/")[1:]:
        part = part.replace("~1", "/").replace("~0", "~")
        try:
            document = document[int(part)] if isinstance(document, list) else document[part]
        except (KeyError, IndexError, ValueError, TypeError):
            return None
    return document
