"""Characters: what is found in them, and what an answer keeps of their file."""

from __future__ import annotations

import json
import math
import struct
from collections import Counter
from typing import Any

from glb_files import CHARACTERS, character, chunk, chunks, in_order, inverse, moved, placed, small_character, times, to_glb, without_clip
from support import CharacterTest, floats, glb_parts

KINDS = {"godette.vrm0.vrm": {"hair": 7, "ribbon": 1}, "godette.vrm1.vrm": {"hair": 7, "ribbon": 1}, "pmca_sample3.glb": {"hair": 4, "skirt": 4, "ribbon": 1},
         "vroid_Vita.chains.glb": {"hair": 15}, "vroid_Sendagaya_Shibu.chains.glb": {"hair": 14}, "vroid_Sakurada_Fumiriya.chains.glb": {"hair": 13}}
ALL_KINDS = "hair,skirt,ribbon"


def float32(number: float) -> float:
    return struct.unpack("<f", struct.pack("<f", number))[0]


class Found(CharacterTest):
    def test_every_chain_of_every_character(self) -> None:
        for name in CHARACTERS:
            with self.subTest(name):
                answer = self.chains(character(name))
                self.assertEqual(Counter(chain["kind"] for chain in answer["chains"]), KINDS[name])
                self.assertEqual(answer["facing"], "-Z" if name.endswith("vrm0.vrm") else "+Z")
                self.assertEqual([chain["index"] for chain in answer["chains"]], list(range(len(answer["chains"]))))

    def test_places_are_those_of_the_file_and_lengths_lie_between_them(self) -> None:
        for name in CHARACTERS:
            rest = placed(glb_parts(character(name))[0]["nodes"], {})
            for chain in self.chains(character(name))["chains"]:
                with self.subTest(f"{name}: {chain['name']}"):
                    places = [bone["position"] for bone in chain["bones"]] + [chain["tip"]["position"]]
                    for bone, (start, end) in zip(chain["bones"], zip(places, places[1:])):
                        self.assertTrue(all(map(math.isfinite, start + end)))
                        self.assertAlmostEqual(bone["length"], math.dist(start, end), delta=1e-6)
                        self.assertLess(math.dist(start, rest[bone["node"]][3]), 1e-6)
                    if "node" in chain["tip"]:
                        self.assertLess(math.dist(places[-1], rest[chain["tip"]["node"]][3]), 1e-6)


class Kept(CharacterTest):
    def assert_only_a_clip_is_new(self, before: bytes, after: bytes) -> None:
        (_, _), *old_chunks = chunks(before)
        (_, _), (kind, binary), *others = chunks(after)
        self.assertEqual(kind, 0x004E4942)
        old_binary = old_chunks.pop(0)[1] if old_chunks and old_chunks[0][0] == kind else b""
        self.assertTrue(binary.startswith(old_binary))
        self.assertEqual(others, old_chunks)
        self.assertEqual(struct.unpack_from("<I", after, 8)[0], len(after))
        self.assert_same(without_clip(after, in_order(before)), in_order(before))
        document = in_order(after)
        self.assertEqual(document["buffers"][0]["byteLength"], len(binary))
        clip, firsts = document["animations"][-1], {list_: len(in_order(before).get(list_, [])) for list_ in ("accessors", "bufferViews")}
        for sampler in clip["samplers"]:
            for accessor in (sampler["input"], sampler["output"]):
                self.assertGreaterEqual(accessor, firsts["accessors"])
                self.assertGreaterEqual(document["accessors"][accessor]["bufferView"], firsts["bufferViews"])
        for view in document["bufferViews"][firsts["bufferViews"]:]:
            self.assertGreaterEqual(view["byteOffset"], len(old_binary))
            self.assertLessEqual(view["byteOffset"] + view["byteLength"], len(binary))

    def test_every_character(self) -> None:
        for name in CHARACTERS:
            for query in ({}, {"kinds": ALL_KINDS}, {"interpolation": "held"}, {"interpolation": "per_frame", "clip_name": "風"}):
                if query.get("kinds") == ALL_KINDS and set(KINDS[name]) == {"hair"}:
                    query = {"kinds": "hair"}
                with self.subTest(name, **query):
                    self.assert_only_a_clip_is_new(character(name), self.clip(character(name), **query))

    def test_what_nobody_knows(self) -> None:
        strange = {"extras": {"z": 1, "a": [1e-7, 0.1, -0.0, 123456789012, 1.0, 0, -1, 5e-324, 1.7976931348623157e308, 18446744073709551615]},
                   "extensions": {"ACME_unknown": {"b": {}, "a": [[], {}, None, True]}}}
        document, binary = small_character(extensionsUsed=["ACME_unknown"], materials=[{"name": "\U0001f98a\u00e9\u9aea \"\\/\b\u0001\u2028", **strange}],
                                           animations=[{"name": "walk", "channels": [], "samplers": [], **strange}], zebra=[strange], **strange)
        for part in (document["asset"], *document["nodes"], *document["skins"], *document["buffers"], *document["scenes"]):
            part.update(strange)
        others = chunk(0x12345678, b"somebody else's") + chunk(0x454D4341, b"")
        for text in (json.dumps(document).encode(), json.dumps(document, ensure_ascii=False, indent=3).encode()):
            glb = to_glb(text, binary, others)
            self.assert_only_a_clip_is_new(glb, self.clip(glb))

    def test_escaped_keys(self) -> None:
        """As exporters write them that keep to ASCII."""
        document, binary = small_character(extras={"髪の長さ": 1, "a\"b\\c": 2, "前": {"髪": {}}})
        glb = to_glb(json.dumps(document).encode(), binary)
        self.assertIn(b"\\u9aea", glb)
        self.assert_only_a_clip_is_new(glb, self.clip(glb))

    def test_without_a_buffer_one_is_made(self) -> None:
        document, _ = small_character()
        del document["buffers"]
        after = in_order(self.clip(to_glb(document)))
        self.assertEqual(after["buffers"], [{"byteLength": len(chunks(self.clip(to_glb(document)))[1][1])}])
        self.assertEqual(json.dumps(after["nodes"]), json.dumps(document["nodes"]))

    def test_a_moved_matrix_becomes_what_a_clip_can_move(self) -> None:
        document, binary = small_character()
        still = document["nodes"][0]
        still["matrix"] = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1.5, 0, 1]
        del still["translation"]
        turned = {"name": "hair_1", "matrix": [0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 0.25, 0.5, -0.125, 1], "children": [2], "extras": {"kept": 1}}
        document["nodes"][1] = turned
        before = to_glb(document, binary)
        nodes = in_order(self.clip(before))["nodes"]
        self.assertEqual(nodes[0], still)
        self.assertEqual(set(nodes[1]), {"name", "children", "extras", "translation", "rotation", "scale"})
        for old, new in zip(placed(document["nodes"], {}), placed(nodes, {})):
            for a, b in zip(old, new):
                self.assertLess(math.dist(a, b), 1e-12)
        for index in (2, 3):
            self.assert_same(nodes[index], document["nodes"][index])


class Clips(CharacterTest):
    def test_pictures_are_held_and_the_loop_closes(self) -> None:
        for name in CHARACTERS:
            with self.subTest(name):
                document, binary = glb_parts(self.clip(character(name)))
                clip = document["animations"][-1]
                schedule = clip["extras"]
                self.assertEqual(schedule, self.poses(character(name))["schedule"])
                self.assertEqual((schedule["frames"], schedule["starts"]), (11, [0, 2, 4, 6, 8, 10]))
                for sampler in clip["samplers"]:
                    self.assertEqual(sampler["interpolation"], "STEP")
                    keys, values = floats(document, binary, sampler["input"]), floats(document, binary, sampler["output"])
                    self.assertEqual((keys[0], len(keys), len(values)), (0, 7, 28))
                    for key, frame in zip(keys[1:], schedule["starts"][1:] + [schedule["frames"]]):
                        self.assertLess(key, frame / schedule["fps"])
                        self.assertAlmostEqual(key, frame / schedule["fps"], delta=1e-6)
                    self.assertEqual(values[:4], values[-4:])
                    for i in range(0, len(values), 4):
                        self.assertAlmostEqual(math.hypot(*values[i:i + 4]), 1, delta=1e-6)
                targets = [(channel["target"]["node"], channel["target"]["path"]) for channel in clip["channels"]]
                self.assertEqual(len(set(targets)), len(targets))

    def test_poses_are_those_of_the_clip(self) -> None:
        """The clip's numbers, and where they put bones and tips as plain forward kinematics has it. So bones keep their lengths."""
        for name in CHARACTERS:
            query = {"kinds": ",".join(KINDS[name]), "amplitude": 2, "wind": "1,0,-1"}
            glb = character(name)
            document, binary = glb_parts(self.clip(glb, **query))
            answer, clip, nodes = self.poses(glb, **query), document["animations"][-1], document["nodes"]
            keys = {channel["target"]["node"]: floats(document, binary, clip["samplers"][channel["sampler"]]["output"]) for channel in clip["channels"]}
            rest = placed(nodes, {})
            for picture, pose in enumerate(answer["pictures"]):
                places = placed(nodes, {node: values[4 * picture:4 * picture + 4] for node, values in keys.items()})
                for chain, chain_pose in zip(answer["chains"], pose["chains"]):
                    with self.subTest(f"{name}: {chain['name']}, picture {picture}"):
                        for bone, rotation, place in zip(chain["bones"], chain_pose["rotations"], chain_pose["positions"]):
                            self.assertEqual([float32(part) for part in rotation], keys[bone["node"]][4 * picture:4 * picture + 4])
                            self.assertLess(math.dist(places[bone["node"]][3], place), 1e-5)
                        last = chain["bones"][-1]["node"]
                        tip = moved(times(places[last], inverse(rest[last])), chain["tip"]["position"])
                        self.assertLess(math.dist(tip, chain_pose["positions"][-1]), 1e-5)
                        points = chain_pose["positions"]
                        for bone, start, end in zip(chain["bones"], points, points[1:]):
                            self.assertAlmostEqual(math.dist(start, end), bone["length"], delta=1e-5)

    def test_a_name_that_is_taken(self) -> None:
        document, binary = small_character(animations=[{"name": "walk"}, {"name": "wave"}])
        self.assert_problem(self.motion(to_glb(document, binary)), 422, "conflict", "/animations/1/name")
        after = in_order(self.clip(to_glb(document, binary), clip_name="wave 2"))
        self.assertEqual([animation["name"] for animation in after["animations"]], ["walk", "wave", "wave 2"])
        self.assert_ok(self.motion(to_glb(document, binary), format="json"), "application/json")


class Springs(CharacterTest):
    def test_springs_of_moved_chains_go_and_no_others(self) -> None:
        for name, path in (("godette.vrm1.vrm", ("VRMC_springBone", "springs")), ("godette.vrm0.vrm", ("VRM", "secondaryAnimation", "boneGroups"))):
            for query in ({}, {"kinds": "ribbon"}, {"chains": "0"}, {"chains": "0,7"}, {"kinds": ALL_KINDS}):
                with self.subTest(name, **query):
                    glb = character(name)
                    before, chains = in_order(glb), self.poses(glb, **query)["chains"]
                    self.assertEqual([w["code"] for w in self.poses(glb, **query)["warnings"]], ["springs_overwrite"])
                    self.assertEqual(self.poses(glb, **query, springs="remove")["warnings"], [])
                    after = without_clip(self.clip(glb, **query, springs="remove"), before)
                    *way, last = path
                    owner, old_owner = after["extensions"], before["extensions"]
                    for step in way:
                        owner, old_owner = owner[step], old_owner[step]
                    moving = {bone["node"] for chain in chains for bone in chain["bones"]}
                    expected = []
                    for spring in old_owner.pop(last):
                        if last == "boneGroups" and spring["bones"]:
                            spring["bones"] = [bone for bone in spring["bones"] if bone not in moving]
                        if spring["bones"] if last == "boneGroups" else not moving & {joint["node"] for joint in spring["joints"]}:
                            expected.append(spring)
                    self.assert_same(owner.pop(last, []), expected)
                    self.assert_same(after, before)

    def test_an_empty_group_of_bones_stays(self) -> None:
        groups = [{"comment": "none", "bones": []}, {"comment": "hair", "bones": [1], "colliderGroups": []}, {"comment": "nothing said"}]
        document, binary = small_character(extensions={"VRM": {"secondaryAnimation": {"boneGroups": groups, "colliderGroups": []}}})
        glb = to_glb(document, binary)
        after = without_clip(self.clip(glb, springs="remove"), in_order(glb))
        self.assert_same(after["extensions"]["VRM"], {"secondaryAnimation": {"boneGroups": [groups[0], groups[2]], "colliderGroups": []}})
