"""The worst requests of at most 8 MiB: what is legal and asks for most, and what is broken and costs most to find out."""

from __future__ import annotations

import copy
import json
from dataclasses import dataclass
from typing import Any, Callable, Iterator

from loading import MIB, contract
from glb_files import small_character, to_glb

MOST = 8 * MIB
JSON, GLB = "application/json", "model/gltf-binary"
SIXTEEN = [i / 10 for i in range(16)]


@dataclass(frozen=True)
class Row:
    """One request. @param statuses  any of these is right"""

    path: str
    what: str
    make: Callable[[], bytes]
    statuses: tuple[int, ...] = (200,)
    media_type: str = JSON


def text(body: Any) -> bytes:
    made = json.dumps(body, separators=(",", ":")).encode()
    if len(made) > MOST:
        raise ValueError(f"{len(made)} bytes are more than 8 MiB")
    return made


def listed(item: bytes, size: int) -> bytes:
    """As many of them as fit into a list of that many bytes."""
    return b"[" + b",".join([item] * ((size - 2) // (len(item) + 1))) + b"]"


def filled(whole: bytes, size: int = MOST) -> bytes:
    """A body that is right but for its last byte, and as large as may be."""
    return whole[:-1] + b" " * (size - len(whole)) + b"x"


# What is legal

def line(count: int, number: int = 0) -> list[list[float]]:
    """A stroke from the crown outwards that no two tufts share."""
    step = 0.1 / count
    return [[round(0.001 * (number % 97) + 0.002 * (i % 2), 4), round(0.1 + i * step, 5), round(0.001 * (number // 97 % 89), 4)] for i in range(count)]


def tufts(count: int, points: int, **fields: Any) -> list[dict[str, Any]]:
    return [{"points": line(points, i), "diameter": 20, **fields} for i in range(count)]


def head(**fields: Any) -> dict[str, Any]:
    return {"center": [0, 0, 0], "root_depth": 0.01, "diameter_at_100": 0.1, **fields}


def scalp(vertices: int, triangles: int) -> dict[str, Any]:
    """Triangles side by side, far away, with short numbers."""
    places = [value for i in range(vertices) for value in (i % 999, i // 999, i % 2)]
    return {"mesh": {"positions": places, "triangles": [value for i in range(triangles) for value in (i, (i + 1) % vertices, (i + 999) % vertices)]}}


def motion(**timing: Any) -> dict[str, Any]:
    return {"wave": {"amplitude": 0.8, "spatial_period": 1, "lightness": 1.2}, "timing": {"period": 1, "fps": 24, "hold": 1, **timing}, "wind": [1, 0, 0]}


def hair(strokes: list[dict[str, Any]], mesh: dict[str, Any], **fields: Any) -> Callable[[], bytes]:
    return lambda: text({"head": fields.pop("head", head()), "tufts": strokes, "mesh": mesh, **fields})


def shapes(path: str, counts: dict[str, int]) -> Iterator[Row]:
    """Hair without motion: most tufts, points, scalp, vertices and triangles."""
    fine = {"rings": 1_000, "sides": 64}
    for word in ("glb", "gltf"):
        target = f"{path}?format={word}"
        yield Row(target, "most tufts", lambda: text({"head": head(), "tufts": tufts(counts["tufts"], 2, joints=1), "mesh": {"rings": 2, "sides": 3}}))
        yield Row(target, "most joints", lambda: text({"head": head(), "tufts": tufts(counts["joints"] // 64, 2, joints=64), "mesh": {"rings": 2, "sides": 3}}))
        yield Row(target, "most points", lambda: text({"head": head(), "tufts": tufts(counts["points"] // 1_024, 1_024), "mesh": {"rings": 4, "sides": 3}}))
        for layout in ("per_tuft", "merged"):
            yield Row(target, f"most vertices, {layout}", lambda layout=layout: text(most_vertices(counts, layout, **fine)))
        yield Row(target, "1,000 strokes of 64 x 12", lambda: text({"head": head(), "tufts": tufts(1_000, 4), "mesh": {"rings": 64, "sides": 12}}))
    yield Row(path, "most tufts and points, largest scalp", lambda: text(everything(counts)), (200, 422))


def most_vertices(counts: dict[str, int], layout: str, rings: int, sides: int) -> dict[str, Any]:
    """As many tufts as the limits on vertices and triangles let through; each has a seam and two poles more than rings times sides."""
    vertices, triangles = rings * (sides + 1) + 2, 2 * rings * sides
    count = min(counts["vertices"] // vertices, counts["triangles"] // triangles)
    return {"head": head(), "tufts": tufts(count, 4), "mesh": {"rings": rings, "sides": sides, "layout": layout}}


def everything(counts: dict[str, int]) -> dict[str, Any]:
    body = {"head": head(scalp=scalp(counts["scalp_vertices"], counts["scalp_triangles"])), "mesh": {"rings": 2, "sides": 3}}
    room = (MOST - len(json.dumps(body, separators=(",", ":"))) - 100) // 90
    return {**body, "tufts": tufts(min(room, counts["tufts"]), 2, joints=1)}


def moving(counts: dict[str, int]) -> Iterator[Row]:
    """Hair with motion: most node poses, joint keys and sheet cells, in each format."""
    path, mesh = "/v1/hairstyles", {"rings": 2, "sides": 3}
    pictures = counts["pictures"]
    joints = counts["node_poses"] // pictures // 65 * 64
    for word in ("glb", "gltf", "json", "xdts", "csv"):
        yield Row(f"{path}?format={word}", "most node poses", lambda: text({"head": head(), "tufts": tufts(joints // 64, 2, joints=64), "mesh": mesh, "motion": motion()}))
        yield Row(f"{path}?format={word}", "most tufts that move", lambda: text({"head": head(), "tufts": tufts(min(counts["tufts"], counts["node_poses"] // 6 // 2), 2, joints=1), "mesh": mesh, "motion": motion(hold=4)}))
    for word, keys in (("vmd", 49), ("bvh", 24), ("usda", 49)):
        for each in (64, 1):
            count = min(counts["joint_keys"] // keys // each, counts["node_poses"] // pictures // (each + 1))
            yield Row(f"{path}?format={word}", f"most joint keys, {each} joints in a tuft",
                      lambda count=count, each=each: text({"head": head(), "tufts": tufts(count, 2, joints=each), "mesh": mesh, "motion": motion(period=0.8, fps=30)}))
    for word in ("glb", "gltf"):
        yield Row(f"{path}?format={word}&interpolation=held", "most keys of a held clip",
                  lambda: text({"head": head(), "tufts": tufts(counts["joint_keys"] // 49 // 64, 2, joints=64), "mesh": mesh, "motion": motion()}))
        yield Row(f"{path}?format={word}&clip=flip_book", "most vertices of a flip book",
                  lambda: text({**most_vertices({**counts, "vertices": counts["vertices"] // pictures}, "merged", 100, 64), "motion": motion()}))
    yield Row(path + "?format=csv&repeat=600", "longest sheet", lambda: text({"head": head(), "tufts": tufts(1, 4), "mesh": mesh, "motion": motion()}))
    yield Row(path + "?format=glb", "1,000 strokes of 64 x 12 that move", lambda: text({"head": head(), "tufts": tufts(1_000, 4), "mesh": {"rings": 64, "sides": 12}, "motion": motion(hold=3)}))


def chained(counts: dict[str, int]) -> Iterator[Row]:
    """Chains: most of them, most nodes, each format."""
    pictures = counts["pictures"]
    poses = counts["node_poses"] // pictures

    def chains(count: int, nodes: int, block: str = "") -> list[dict[str, Any]]:
        return [{"nodes": [[0.1, round(-0.001 * n, 3), 0] for n in range(nodes)], "phase": i % 7, **({"block": block + str(i)} if block else {})} for i in range(count)]

    for word in ("json", "glb", "gltf", "xdts", "csv"):
        for nodes in (2, 65):
            yield Row(f"/v1/motions?format={word}", f"most node poses, {nodes} nodes in a chain",
                      lambda nodes=nodes: text({"chains": chains(min(poses // nodes, counts["chains"]), nodes), "motion": motion()}))
    for word, keys in (("vmd", 49), ("bvh", 24), ("usda", 49)):
        yield Row(f"/v1/motions?format={word}", "most joints, few keys", lambda: text({"chains": chains(counts["joints"] // 64, 65), "motion": motion(period=0.1, fps=30)}))
        for nodes in (2, 65):
            yield Row(f"/v1/motions?format={word}", f"most joint keys, {nodes} nodes in a chain",
                      lambda nodes=nodes, keys=keys: text({"chains": chains(min(counts["joint_keys"] // keys // (nodes - 1), poses // nodes), nodes), "motion": motion(period=0.8, fps=30)}))
    yield Row("/v1/motions?format=xdts", "most sheet cells", lambda: text({"chains": chains(counts["chains"], 2, "b"), "motion": motion(hold=4)}))
    yield Row("/v1/motions?format=xdts&repeat=20", "most sheet cells over cycles", lambda: text({"chains": chains(counts["sheet_cells"] // pictures // 20, 2, "b"), "motion": motion()}))
    yield Row("/v1/motions?format=glb", "most chains", lambda: text({"chains": chains(counts["chains"], 2), "motion": motion(hold=4)}))
    yield Row("/v1/motions?format=json", "most chains", lambda: text({"chains": chains(counts["chains"], 2), "motion": motion(hold=4)}))


def others(counts: dict[str, int]) -> Iterator[Row]:
    yield Row("/v1/schedules?format=csv", "longest sheet", lambda: text({"timing": {"period": 60, "fps": 24, "hold": 24}, "repeat": 10}), (200, 422))
    yield Row("/v1/schedules?format=xdts", "longest sheet", lambda: text({"timing": {"period": 1, "fps": 24, "hold": 1}, "repeat": 600}), (200, 422))
    dense = copy.deepcopy(contract.example("fills"))
    dense["fill"].update(density={"along": 100, "crown": 100, "neck": 100}, tufts_per_meter=4_000, min_gap=0)
    for word in ("json", "glb"):
        yield Row(f"/v1/fills?format={word}", "a dense fill", lambda word=word: text({**dense, "mesh": {"rings": 2, "sides": 3}} if word == "glb" else dense), (200, 406, 422))
    large = {**dense, "head": {**dense["head"], "scalp": scalp(counts["scalp_vertices"], counts["scalp_triangles"])}}
    yield Row("/v1/fills", "largest scalp", lambda: text(large), (200, 422))
    for path in ("fits", "evaluations"):
        body = contract.example(path)
        pictures = [[[round(0.01 * i, 2), round(0.3 - 0.001 * n, 3)] for n in range(2)] for i in range(counts["pictures"])]
        drawn = [{**body["drawn"][0], "pictures": pictures, **({"rest": pictures[0]} if "rest" in body["drawn"][0] else {})}]
        count = counts["drawn_nodes"] // counts["pictures"] // 2
        many = {**body, "drawn": [{**drawn[0], "name": f"n{i}"} for i in range(count)]}
        if path == "evaluations":
            many["chains"] = [{"name": f"n{i}", "nodes": [[0, 0.3, 0], [0, 0.299, 0]]} for i in range(count)]
            many["motion"] = motion()
        yield Row(f"/v1/{path}", "most drawn nodes", lambda many=many: text(many), (200, 422, 504))


def with_extras(extras: bytes) -> bytes:
    document, binary = small_character(extras="@")
    return to_glb(json.dumps(document).encode().replace(b'"@"', extras), binary)


def character_rows(counts: dict[str, int], files: dict[str, int]) -> Iterator[Row]:
    nodes = files["nodes"]

    def strands(bones: int, most: int) -> bytes:
        """A head from which strands hang, as many as nodes allow."""
        document, binary = small_character()
        count = min((nodes - 1) // bones, most)
        made = [{"name": "Head", "translation": [0, 1.5, 0], "children": [1 + i * bones for i in range(count)]}]
        for i in range(count):
            made += [{"name": f"h{i}_{b}", "translation": [0, -0.01, 0], **({"children": [2 + i * bones + b]} if b + 1 < bones else {})} for b in range(bones)]
        document["nodes"], document["skins"] = made, [{"joints": list(range(1, len(made)))}]
        return to_glb(json.dumps(document, separators=(",", ":")).encode(), binary)

    for bones in (2, 3, 64):
        yield Row("/v1/characters/chains", f"most chains of {bones} bones", lambda bones=bones: strands(bones, nodes), (200,), GLB)
        for word in ("glb", "json", "xdts", "csv", "vmd", "bvh", "usda"):
            yield Row(f"/v1/characters/motion?kinds=hair,skirt,ribbon,unknown&period=0.25&format={word}", f"most chains of {bones} bones",
                      lambda bones=bones, word=word: strands(bones, min(counts["chains"], counts["joints"] // bones, 16_384 // bones if word == "glb" else counts["node_poses"] // 3 // (bones + 1))), (200, 422) if word == "vmd" else (200,), GLB)
            if word == "glb":
                yield Row("/v1/characters/motion?kinds=hair,skirt,ribbon,unknown", f"more chains of {bones} bones than a clip moves", lambda bones=bones: strands(bones, nodes), (422,), GLB)
    for path in ("/v1/characters/chains", "/v1/characters/motion?kinds=hair,skirt,ribbon,unknown"):
        yield Row(path, "a large buffer", lambda: to_glb(small_character()[0], bytes(MOST - 2_000)), (200,), GLB)
        for what, item in FILLERS.items():
            yield Row(path, f"a sound file, extras of {what}", lambda item=item: with_extras(listed(item, MOST - 4_096)), (200, 413), GLB)
            yield Row(path, f"a sound file, few enough extras of {what}", lambda item=item: with_extras(listed(item, MOST // 16)), (200, 413), GLB)
        for noun in ("nodes", "accessors", "materials", "skins"):
            yield Row(path, f"{noun} without end", lambda noun=noun: to_glb(b'{"asset":{"version":"2.0"},"' + noun.encode() + b'":' + listed(b"{}", MOST - 4_096) + b"}"), (413, 422), GLB)
        yield Row(path, "a name without end", lambda: to_glb(b'{"asset":{"version":"2.0"},"nodes":[{"name":"' + b"x" * (MOST - 4_096) + b'"}]}'), (413, 422), GLB)
        yield Row(path, "JSON that is right but for its last byte", lambda: to_glb(filled(json.dumps(small_character(extras=[0] * 1_000_000)[0], separators=(",", ":")).encode(), MOST - 4_096)), (400, 413), GLB)
        yield Row(path, "no GLB", lambda: b"x" * MOST, (400,), GLB)


# What is not

FILLERS: dict[str, bytes] = {"numbers": b"0", "long numbers": b"0.1234567890123456", "lists": b"[]", "objects": b"{}", "lists of a number": b"[0]", "empty texts": b'""',
                             "texts": b'"0123456789abcdef"', "objects of a key": b'{"":0}', "nested lists": b"[[[[]]]]", "nested objects": b'{"":{"":{"":{}}}}', "null": b"null"}
BROKEN: dict[str, Callable[[], bytes]] = {
    **{f"8 MiB of {what}": lambda item=item: listed(item, MOST) for what, item in FILLERS.items()},
    **{f"{what}, a field that nobody knows": lambda item=item: b'{"x":' + listed(item, MOST - 6) + b"}" for what, item in FILLERS.items()},
    "deep nesting": lambda: b"[" * (MOST // 2) + b"]" * (MOST // 2),
    "31 levels again and again": lambda: listed(b"[" * 30 + b"]" * 30, MOST),
    "one long text": lambda: b'{"x":"' + b"a" * (MOST - 8) + b'"}',
    "one long number": lambda: b'{"x":' + b"1" * (MOST - 6) + b"}",
    "one long key": lambda: b'{"' + b"a" * (MOST - 6) + b'":1}',
    "blanks": lambda: b" " * MOST,
    "as many numbers as may be, then a fault": lambda: filled(listed(b"0", 3_900_000)),
    "half a million lists, then a fault": lambda: filled(listed(b"[]", 1_500_000)),
}


def broken(field: str, path: str) -> Iterator[Row]:
    for what, make in BROKEN.items():
        yield Row(path, what, make, (400, 413, 422))
    for what, item in FILLERS.items():
        yield Row(path, f"{what} in place of {field}", lambda item=item: b'{"' + field.encode() + b'":' + listed(item, MOST - 20) + b"}", (413, 422))


def rows(limits: dict[str, Any]) -> Iterator[Row]:
    """All of them. @param limits  what /v1/limits says"""
    counts = limits["counts"]
    yield from shapes("/v1/tufts", counts)
    yield from shapes("/v1/hairstyles", counts)
    yield from moving(counts)
    yield from chained(counts)
    yield from others(counts)
    yield from character_rows(counts, limits["files"])
    for name, field in (("tufts", "tufts"), ("hairstyles", "tufts"), ("motions", "chains"), ("schedules", "timing"), ("fills", "fill"), ("fits", "drawn"), ("evaluations", "chains")):
        yield from broken(field, f"/v1/{name}")
