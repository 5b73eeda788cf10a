"""The same request gives the same bytes, however many workers there are, and so does the recipe that a file carries."""

from __future__ import annotations

import hashlib
from typing import Any

import contract
from glb_files import CHARACTERS, character
from rows import tetrahedron
from service import Service
from support import ServiceTest, glb_parts

WORKERS = (1, 2, 4, 16)
CLIPS = ("glb&interpolation=held", "glb&interpolation=per_frame", "glb&clip=flip_book", "glb&compression=meshopt")
FORMATS = ("glb", "gltf", "json", "xdts", "csv", "vmd", "bvh", "usda")


def hair(copies: int) -> dict[str, Any]:
    """The example with its tufts repeated and their phases scattered: enough to keep every worker busy."""
    body = contract.example("hairstyles")
    body["tufts"] = [{**tuft, "diameter": 20 + i} for i in range(copies) for tuft in body["tufts"]]
    body["motion"]["phase"] = {"spread": 0.3, "seed": 9007199254740991, "gust_wavelength": 0.37}
    return body


def filled(copies: int) -> dict[str, Any]:
    """The example between its back tufts filled, on a scalp: enough to keep every worker busy."""
    body = contract.example("hairstyles")
    body["head"]["scalp"] = {"ellipsoid": {"radii": [0.1, 0.1, 0.1]}}
    body["fills"] = [{"from": "side_L", "to": "side_R", "density": {"along": 50, "crown": 40, "neck": 60}, "jitter": {"seed": i}} for i in range(copies)]
    return body


def dense_fill(**head: Any) -> dict[str, Any]:
    """The example of a fill with many more tufts."""
    body = contract.example("fills")
    body["head"].update(head)
    body["fill"].update(tufts_per_meter=150, density={"along": 90, "crown": 90, "neck": 85})
    return body


def many_drawings() -> dict[str, Any]:
    """The example's drawing again and again, each a little different: enough to keep every worker busy."""
    body = contract.example("fits")
    drawn = body["drawn"][0]
    body["drawn"] = [{**drawn, "pictures": [[[x * (1 + 0.02 * i), y] for x, y in line] for line in drawn["pictures"]]} for i in range(40)]
    return body


class Determinism(ServiceTest):
    def test_the_number_of_workers_changes_no_byte(self) -> None:
        bodies = {"per tuft": hair(8), "merged": {**hair(8), "mesh": {"layout": "merged", "sides": 7}}, "filled": filled(4)}
        fills = {"on an ellipsoid": dense_fill(), "on a mesh": dense_fill(scalp={"mesh": tetrahedron()})}
        hashes: dict[str, dict[int, str]] = {}
        for workers in WORKERS:
            with Service(self.program, "--workers", str(workers)) as service:
                for name, body in bodies.items():
                    for word in FORMATS + CLIPS:
                        answer = service.post(f"/v1/hairstyles?format={word}", body)
                        self.assertEqual(answer.status, 200, answer.body[:300])
                        hashes.setdefault(f"hairstyles {name} {word}", {})[workers] = hashlib.sha256(answer.body).hexdigest()
                for name, body in fills.items():
                    for word in ("json", "glb", "gltf"):
                        answer = service.post(f"/v1/fills?format={word}", body)
                        self.assertEqual(answer.status, 200, answer.body[:300])
                        hashes.setdefault(f"fills {name} {word}", {})[workers] = hashlib.sha256(answer.body).hexdigest()
                for word in FORMATS:
                    answer = service.post(f"/v1/motions?format={word}", contract.example("motions"))
                    hashes.setdefault(f"motions {word}", {})[workers] = hashlib.sha256(answer.body).hexdigest()
                for path, body in {"fits": many_drawings(), "evaluations": contract.example("evaluations")}.items():
                    answer = service.post(f"/v1/{path}", body)
                    self.assertEqual(answer.status, 200, answer.body[:300])
                    hashes.setdefault(path, {})[workers] = hashlib.sha256(answer.body).hexdigest()
        self.assertEqual(len(hashes), len(bodies) * len(FORMATS + CLIPS) + 3 * len(fills) + len(FORMATS) + 2)
        for what, by_workers in hashes.items():
            with self.subTest(what):
                self.assertEqual(len(set(by_workers.values())), 1, by_workers)

    def test_the_number_of_workers_changes_no_byte_of_a_character(self) -> None:
        glb = {"Content-Type": "model/gltf-binary"}
        ways = ["chains", "motion?springs=remove&spread=0.3&seed=7&gust_wavelength=0.37"]
        ways += [f"motion?format={word}&spread=0.3&seed=7" for word in ("json", "xdts", "csv")]
        hashes: dict[str, dict[int, str]] = {}
        for workers in WORKERS:
            with Service(self.program, "--workers", str(workers)) as service:
                for name in CHARACTERS:
                    for way in ways:
                        answer = service.request("POST", f"/v1/characters/{way}", character(name), glb)
                        self.assertEqual(answer.status, 200, answer.body[:300])
                        hashes.setdefault(f"{name} {way}", {})[workers] = hashlib.sha256(answer.body).hexdigest()
        self.assertEqual(len(hashes), len(CHARACTERS) * len(ways))
        for what, by_workers in hashes.items():
            with self.subTest(what):
                self.assertEqual(len(set(by_workers.values())), 1, by_workers)

    def test_asking_again_changes_no_byte(self) -> None:
        for op in contract.posts() + contract.uploads():
            body, headers = contract.sample(op)
            for word in contract.formats(op):
                with self.subTest(f"{op.path} {word}"):
                    answers = {self.service.request("POST", f"{op.path}?format={word}", body, headers).body for _ in range(3)}
                    self.assertEqual(len(answers), 1)

    def test_the_order_and_spelling_of_a_body_change_no_byte(self) -> None:
        body = contract.example("hairstyles")
        turned = {name: dict(reversed(value.items())) if isinstance(value, dict) else value for name, value in reversed(body.items())}
        self.assertEqual(self.service.post("/v1/hairstyles", turned).body, self.service.post("/v1/hairstyles", body).body)

    def test_the_recipe_in_a_file_makes_the_same_file(self) -> None:
        for name, change in RECIPES.items():
            with self.subTest(name):
                body = contract.example("hairstyles")
                change(body)
                first = self.service.post("/v1/hairstyles", body)
                self.assertEqual(first.status, 200, first.body[:300])
                recipe = glb_parts(first.body)[0]["asset"]["extras"]["tuftwave"]["hairstyle"]
                self.assertEqual(contract.faults(recipe, contract.named("HairstyleRequest")), [])
                for word in FORMATS if "motion" in recipe else ("glb", "gltf", "json"):
                    asked = self.service.post(f"/v1/hairstyles?format={word}", body).body
                    again = self.service.post(f"/v1/hairstyles?format={word}", recipe).body
                    self.assertEqual(hashlib.sha256(asked).hexdigest(), hashlib.sha256(again).hexdigest(), word)


def timing(**fields: Any) -> Any:
    return lambda body: body["motion"]["timing"].update(fields)


RECIPES = {
    "the example": lambda body: None,
    "without motion": lambda body: body.pop("motion"),
    "only points": lambda body: (body.clear(), body.update(tufts=[{"points": [[0, 0.1, 0.05], [0, 0.05, 0.1]]}])),
    "a fraction": timing(fps="24000/1001"),
    "a fraction not in lowest terms": timing(fps="48000/2000"),
    "a decimal rate": timing(fps=23.976),
    "a decimal rate of many digits": timing(fps=23.976023),
    "all of the motion": lambda body: body["motion"].update(
        mode="absolute", one_sided=False, droop="keep", lift=0.75, up=[0.1, 1, -0.2], wind=[0.3, 0.1, -2],
        phase={"step": "picture", "gust_wavelength": 0.123456789012345, "spread": 1, "seed": 9007199254740991, "cycles": 2}),
    "a head on its side": lambda body: (body["head"].update(up=[1, 0, 0], front=[0, 0, -1], center=[0, -0.02, 1e-17]), body["motion"].update(wind=[0, 1, 0])),
    "all of a tuft": lambda body: body["tufts"][0].update(
        taper="round", section="ellipse", flatness=1 / 3, twist_deg=-720.5, roll_deg=1e-7, joints=64, phase=-999.999, cycles=2, widest_at=100, diameter=100 / 3),
    "a name that no tool keeps": lambda body: body["tufts"][0].update(name="\u524d\u9aea \"\\/\n\u0000 <b>"),
    "a coarse mesh": lambda body: body.update(mesh={"rings": 2, "sides": 3, "layout": "merged", "color": "#ABCDEF", "tolerance": 0.5}),
    "as printed": lambda body: body.update(formulas="as_printed"),
    "fills": lambda body: body.update(fills=[
        {"from": "back_R1", "to": "back_L1", "density": {"along": 60, "crown": None, "neck": 30}}, {"from": "back_R1", "direction": "shorter", "density": {"along": 0, "crown": 1}},
        {"from": "fringe_M", "to": "ahoge", "name": "\u9aea", "density": {}, "arc": "path", "min_gap": 1 / 3}]),
    "all of a fill": lambda body: body.update(fills=[{
        "from": "side_R", "to": "ahoge", "name": "between", "tufts_per_meter": 100 / 3, "density": {"along": 200 / 3, "crown": 1, "neck": 100},
        "jitter": {"seed": 9007199254740991}, "formulas": "as_printed", "spacing": "half_gap", "arc": "path", "direction": "clockwise", "resample": True, "min_gap": 0.1}]),
    "a fill as printed": lambda body: body.update(formulas="as_printed", fills=[{"from": "back_M", "to": "back_L3"}, {"from": "back_M", "formulas": "corrected"}]),
    "a fill that is corrected in words": lambda body: body.update(fills=[{"from": "back_M", "formulas": "corrected", "jitter": {}, "spacing": None, "resample": None}]),
    "a fill that must not resample": lambda body: body.update(fills=[{"from": "back_M", "to": "back_L3", "resample": False, "spacing": "diameter"}]),
    "no fill": lambda body: body.update(fills=[]),
    "an ellipsoid": lambda body: (body["head"].update(scalp={"ellipsoid": {"radii": [0.1, 0.3, 1 / 3], "center": [0.01, 0.01 + 0.02, 1e-17]}}), body.update(fills=[{"from": "back_M"}])),
    "an ellipsoid without a center": lambda body: (body["head"].update(scalp={"ellipsoid": {"radii": [0.1, 0.1, 0.1]}}, center=[0, 0.01, 0]), body.update(fills=[{"from": "back_M"}])),
    "a scalp mesh": lambda body: (body["head"].update(scalp={"mesh": tetrahedron()}), body.update(fills=[{"from": "back_M", "density": {"crown": 50}}])),
    "a scalp that nothing grows on": lambda body: body["head"].update(scalp={"mesh": {"positions": [1 / 3] * 9, "triangles": [2, 2, 2]}}),
    "filled tufts": lambda body: [tuft.update(origin={"kind": kind, "index": 16386, **more}) for tuft, (kind, more) in zip(
        body["tufts"], (("along", {}), ("crown", {"parent": 1}), ("neck", {"parent": None})))],
    "numbers at the edge": lambda body: body["tufts"][0]["points"].__setitem__(1, [0.1 + 0.2, -0.0, 5e-324]),
}
