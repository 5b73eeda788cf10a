"""What may be asked of a character's motion, and in which formats it is answered."""

from __future__ import annotations

import csv
import json
from typing import Any
from urllib.parse import quote

import contract
from glb_files import character, in_order, small_character, to_glb
from support import GLB, CharacterTest, floats, glb_parts

PMCA = "pmca_sample3.glb"
# Query, slug and the parameter that is named.
REFUSED = [
    ("amplitude=a", "wrong_type", "amplitude"), ("amplitude=1e400", "wrong_type", "amplitude"), ("amplitude=101", "out_of_range", "amplitude"),
    ("amplitude=NaN", "wrong_type", "amplitude"), ("amplitude=0", "", ""), ("amplitude=-100", "", ""), ("amplitude=1,2", "wrong_type", "amplitude"),
    ("spatial_period=0", "out_of_range", "spatial_period"), ("spatial_period=100.5", "out_of_range", "spatial_period"),
    ("lightness=0", "out_of_range", "lightness"), ("lightness=101", "out_of_range", "lightness"),
    ("tip_exponent=0", "out_of_range", "tip_exponent"), ("tip_exponent=8.1", "out_of_range", "tip_exponent"),
    ("period=0", "out_of_range", "period"), ("period=60.5", "out_of_range", "period"), ("period=true", "wrong_type", "period"),
    ("fps=0", "out_of_range", "fps"), ("fps=241", "out_of_range", "fps"), ("fps=a", "wrong_type", "fps"), ("fps=24000/1001", "", ""),
    ("hold=0", "out_of_range", "hold"), ("hold=25", "out_of_range", "hold"), ("hold=2.5", "wrong_type", "hold"), ("hold=two", "wrong_type", "hold"),
    ("short_holds=x", "not_a_choice", "short_holds"), ("sampling=x", "not_a_choice", "sampling"), ("mode=x", "not_a_choice", "mode"),
    ("droop=x", "not_a_choice", "droop"), ("phase_step=x", "not_a_choice", "phase_step"), ("formulas=x", "not_a_choice", "formulas"),
    ("springs=true", "not_a_choice", "springs"), ("springs=Keep", "not_a_choice", "springs"), ("interpolation=linear", "not_a_choice", "interpolation"),
    ("format=gltf", "not_a_choice", "format"), ("wind=1,0", "wrong_type", "wind"), ("wind=1,0,0,0", "wrong_type", "wind"), ("wind=1,2,a", "wrong_type", "wind"),
    ("wind=0,0,0", "degenerate", "wind"), ("wind=0,1,0", "degenerate", "wind"), ("wind=1", "wrong_type", "wind"), ("up=0,0", "wrong_type", "up"),
    ("up=0,0,0", "degenerate", "up"), ("one_sided=yes", "wrong_type", "one_sided"), ("one_sided=1", "wrong_type", "one_sided"), ("one_sided=true", "", ""),
    ("lift=-0.1", "out_of_range", "lift"), ("lift=2", "out_of_range", "lift"), ("gust_wavelength=0", "out_of_range", "gust_wavelength"),
    ("spread=-1", "out_of_range", "spread"), ("spread=1.5", "out_of_range", "spread"), ("seed=-1", "out_of_range", "seed"), ("seed=1.5", "wrong_type", "seed"),
    ("seed=9007199254740992", "out_of_range", "seed"), ("cycles=0", "out_of_range", "cycles"), ("cycles=12", "out_of_range", "cycles"),
    ("repeat=0&format=csv", "out_of_range", "repeat"), ("repeat=1441&format=csv", "out_of_range", "repeat"), ("repeat=2", "conflict", "repeat"),
    ("repeat=2&format=bvh", "conflict", "repeat"), ("interpolation=held&format=json", "conflict", "interpolation"),
    ("kinds=bone", "not_a_choice", "kinds"), ("kinds=hair,", "not_a_choice", "kinds"), ("kinds=Hair", "not_a_choice", "kinds"), ("kinds=unknown", "too_few", "kinds"),
    ("kinds=" + "hair," * 13 + "hair", "too_many", "kinds"), ("kinds=hair&chains=0", "conflict", "kinds"), ("kinds=hair,hair", "", ""),
    ("chains=9", "not_a_choice", "chains"), ("chains=-1", "not_a_choice", "chains"), ("chains=0,", "not_a_choice", "chains"), ("chains=,0", "not_a_choice", "chains"),
    ("chains=nobody", "not_a_choice", "chains"), ("chains=" + "a" * 1025, "too_many", "chains"), ("chains=99999999999999999999", "not_a_choice", "chains"),
    ("phases=1,2,3", "conflict", "phases"), ("phases=1", "conflict", "phases"), ("phases=1,2,3,1000.5", "out_of_range", "phases"),
    ("phases=1,2,x,4", "wrong_type", "phases"), ("phases=1,,2,3", "wrong_type", "phases"), ("phases=1,2,3,4,", "wrong_type", "phases"), ("phases=1,2,3,4", "", ""),
    ("phases=1.5&chains=2", "", ""), ("clip_name=" + "a" * 65, "too_many", "clip_name"), ("clip_name=" + quote("髪") * 64, "", ""), ("clip_name=1", "", ""),
]


class Queries(CharacterTest):
    def ask(self, query: str, glb: bytes = b"") -> Any:
        return self.service.request("POST", "/v1/characters/motion?" + query, glb or character(PMCA), GLB)

    def parameters(self) -> list[Any]:
        return [parameter["name"] for parameter in map(contract.resolve, contract.operation("characterMotion").what["parameters"])]

    def test_the_table(self) -> None:
        for query, slug, name in REFUSED:
            with self.subTest(query[:80]):
                if slug:
                    self.assert_problem(self.ask(query), 422, slug, f"?{name}")
                else:
                    self.assert_ok(self.ask(query), "model/gltf-binary")

    def test_every_parameter_is_in_the_table(self) -> None:
        self.assertLessEqual(set(self.parameters()) - {"clip_name"}, {name for _, _, name in REFUSED})

    def test_every_parameter_comes_once_and_says_something(self) -> None:
        for name in self.parameters():
            with self.subTest(name):
                self.assert_problem(self.ask(f"{name}="), 422, "not_a_choice" if name in ("format", "interpolation") else "wrong_type", f"?{name}")
                self.assert_problem(self.ask(f"{name}=1&{name}=1"), 400, "duplicate_key", f"?{name}")
                self.assert_problem(self.ask(f"{name}s=1"), 422, "unknown_field", f"?{name}s")
                self.assert_problem(self.ask(f"{name}=%FF"), 422, "wrong_type", f"?{name}")
        self.assert_problem(self.service.request("POST", "/v1/characters/chains?kinds=hair", character(PMCA), GLB), 422, "unknown_field", "?kinds")

    def test_queries_are_read_before_the_file(self) -> None:
        self.assert_problem(self.ask("hold=0", b"no GLB"), 422, "out_of_range", "?hold")

    def names(self, glb: bytes, **query: Any) -> list[str]:
        return [chain["name"] for chain in self.poses(glb, **query)["chains"]]

    def test_chains_by_index_name_and_pattern(self) -> None:
        glb = character(PMCA)
        every = [chain["name"] for chain in self.chains(glb)["chains"]]
        hair = [chain["name"] for chain in self.chains(glb)["chains"] if chain["kind"] == "hair"]
        self.assertEqual(self.names(glb), hair)
        self.assertEqual(self.names(glb, chains="*"), every)
        self.assertEqual(self.names(glb, chains="3,0,3"), [every[0], every[3]])
        self.assertEqual(self.names(glb, chains="00"), every[:1])
        front = [name for name in every if name.startswith("前")]
        self.assertGreater(len(front), 1)
        self.assertEqual(self.names(glb, chains="前*"), front)
        self.assertEqual(self.names(glb, chains=front[1]), [front[1]])
        self.assertEqual(self.names(glb, chains=front[0][:-1] + "?"), [name for name in front if len(name) == len(front[0])])
        self.assertEqual(self.names(glb, chains="*" * 500 + every[-1][-1]), [name for name in every if name[-1] == every[-1][-1]])
        self.assertEqual(self.names(glb, kinds="ribbon,skirt"), [c["name"] for c in self.chains(glb)["chains"] if c["kind"] in ("skirt", "ribbon")])

    def test_a_file_without_hair(self) -> None:
        self.assert_problem(self.ask("", to_glb({"asset": {"version": "2.0"}})), 422, "too_few", "")
        document, binary = small_character()
        document["nodes"][0]["name"] = "body"
        self.assert_problem(self.ask("one_sided=true&chains=*", to_glb(document, binary)), 422, "degenerate", "?one_sided")

    def test_phases_move_one_chain_each(self) -> None:
        glb = character(PMCA)
        still = self.poses(glb, phases="0,0,0,0")["pictures"]
        self.assertEqual(still, self.poses(glb)["pictures"])
        for moved in range(4):
            pictures = self.poses(glb, phases=",".join("2" if i == moved else "0" for i in range(4)))["pictures"]
            self.assertEqual([pictures[0]["chains"][i] != still[0]["chains"][i] for i in range(4)], [i == moved for i in range(4)])

    def test_interpolations(self) -> None:
        for interpolation, kind, keys in (("step", "STEP", 7), ("held", "LINEAR", 13), ("per_frame", "STEP", 12)):
            with self.subTest(interpolation):
                document, binary = glb_parts(self.clip(character(PMCA), interpolation=interpolation))
                for sampler in document["animations"][-1]["samplers"]:
                    self.assertEqual(sampler["interpolation"], kind)
                    values = floats(document, binary, sampler["input"])
                    self.assertEqual((values[0], sorted(set(values)), len(values)), (0, values, keys))

    def test_springs_and_names_of_clips(self) -> None:
        self.assertEqual(in_order(self.clip(character(PMCA), clip_name="髪\u0000'"))["animations"][-1]["name"], "髪\u0000'")
        self.assertEqual(in_order(self.clip(character(PMCA)))["animations"][-1]["name"], "wave")

    def test_every_format_by_query_and_by_accept(self) -> None:
        for name in contract.formats(contract.operation("characterMotion")):
            with self.subTest(name):
                media_type = contract.MEDIA_TYPES[name]
                by_query = self.ask(f"format={name}")
                by_accept = self.service.request("POST", "/v1/characters/motion", character(PMCA), {**GLB, "Accept": media_type})
                self.assert_ok(by_query, media_type)
                self.assert_ok(by_accept, media_type)
                self.assertEqual(by_query.body, by_accept.body)
                if name != "json":
                    self.assertIn(f'"character_{30 if name == "vmd" else 24}fps.{name}"', by_query.headers["content-disposition"])
        self.assert_problem(self.service.request("POST", "/v1/characters/chains", character(PMCA), {**GLB, "Accept": "model/gltf-binary"}), 406, "not_acceptable")

    def test_what_formats_say(self) -> None:
        bone = self.chains(character(PMCA))["chains"][0]["bones"][0]["name"]
        self.assertTrue(self.ask("format=vmd").body.startswith(b"Vocaloid Motion Data 0002\0"))
        self.assertIn(self.poses(character(PMCA))["chains"][0]["bones"][0]["name"].encode("cp932"), self.ask("format=vmd").body)
        self.assertTrue(self.ask("format=bvh&chains=0").body.startswith(b"HIERARCHY"))
        self.assertIn(bone, self.ask("format=bvh&chains=0").body.decode())
        self.assertTrue(self.ask("format=usda").body.startswith(b"#usda 1.0"))
        self.assertTrue(self.ask("format=xdts").body.startswith(b"exchangeDigitalTimeSheet Save Data\n"))
        once, twice = (list(csv.reader(self.ask(f"format=csv&repeat={repeat}").body.decode("utf-8-sig").splitlines())) for repeat in (1, 2))
        self.assertEqual(len(twice) - len(once), 11)

    def test_a_vmd_has_room_for_short_names_only(self) -> None:
        for name, slug, pointer in (("hair_is_15_long", "", ""), ("hair_is_16_bytes", "conflict", "?chains"), ("髪髪髪髪髪髪髪髪", "conflict", "?chains"),
                                    ("hair \U0001f98a", "conflict", "?chains")):
            with self.subTest(name):
                document, binary = small_character()
                document["nodes"][1]["name"] = name
                answer = self.ask("format=vmd", to_glb(json.dumps(document).encode(), binary))
                if slug:
                    self.assert_problem(answer, 422, slug, pointer)
                else:
                    self.assert_ok(answer, "application/octet-stream")
        document["nodes"][1]["name"] = document["nodes"][2]["name"]
        self.assert_problem(self.ask("format=vmd", to_glb(document, binary)), 422, "conflict", "?format")
