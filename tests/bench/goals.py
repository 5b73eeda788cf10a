"""What has to hold, and what we aim at."""

from __future__ import annotations

from typing import NamedTuple, Optional

from figures import Measure, combined, ratio, value, worst

MIB = 1024 * 1024
NODE_POSES = 200 * 16 * 12
TUBES = 1000


class Bounds(NamedTuple):
    must: float
    aim: float
    is_least: bool  # whether the figure has to be at least that, and not at most

    def holds(self, figure: float) -> bool:
        return figure >= self.must if self.is_least else figure <= self.must

    def text(self, bound: float) -> str:
        return f"{'>=' if self.is_least else '<='} {bound:,g}"


class Goal(NamedTuple):
    key: str  # its column in the results
    what: str
    measure: Measure
    bounds: Optional[Bounds] = None  # none: only told


def at_least(must: float, aim: float) -> Bounds:
    return Bounds(must, aim, True)


def at_most(must: float, aim: float) -> Bounds:
    return Bounds(must, aim, False)


def beats(work: str, peer: str) -> Measure:
    """How many times our time the peer takes."""
    return ratio(f"{work}/{peer}", f"{work}/tuftwave")


def http(work: str, scale: float = 1) -> Measure:
    """Ours in units of the peer's: the same HTTP library without our work."""
    return ratio(f"http/{work}/tuftwave", f"http/{work}/peer", scale)


GOALS = [
    Goal("w1_afternoon", "W1 merged, one worker, warm: afternoon / ours", beats("w1", "afternoon"), at_least(20, 60)),
    Goal("w1_three", "... three.js stock / ours", beats("w1", "three"), at_least(100, 300)),
    Goal("w1_gltf_transform", "... three.js with glTF-Transform / ours", beats("w1", "gltf_transform")),
    Goal("w1_lean_merged", "... three.js lean merged / ours", beats("w1", "three_lean_merged"), at_least(50, 180)),
    Goal("w1_lean_split", "... three.js lean split / ours", beats("w1", "three_lean_split"), at_least(35, 130)),
    Goal("w1_blender", "... Blender / ours", beats("w1", "blender"), at_least(600, 2000)),
    Goal("w1_memset_pct", "... share of the memset rate, %", ratio("w1/memset", "w1/tuftwave", 100), at_least(15, 50)),
    Goal("w1_memcpy_pct", "... share of the memcpy rate, %", ratio("w1/memcpy", "w1/tuftwave", 100)),
    Goal("w1_first", "... first call / (warm + fresh write)", combined(lambda first, warm, fresh: first / (warm + fresh), "w1_first/tuftwave", "w1_first/warm", "w1_first/fresh_write"), at_most(1.3, 1.1)),
    Goal("w1_two_workers", "W1 two workers: one / two", ratio("w1/tuftwave", "w1_two/tuftwave"), at_least(1.7, 1.9)),
    Goal("many_memset_pct", "20,000 strokes, two workers: share of the memset rate, %", ratio("many/memset", "many/tuftwave", 100), at_least(30, 65)),
    Goal("many_one_memset_pct", "... one worker", ratio("many/memset", "many_one/tuftwave", 100)),
    Goal("many_fresh_memset_pct", "... one worker, into fresh memory", ratio("many/memset", "many_fresh/tuftwave", 100)),
    Goal("many_peak_mib", "... peak memory above the GLB, MiB", combined(lambda peak, glb: (peak - glb) / MIB, "many_peak/tuftwave", "many_bytes/tuftwave"), at_most(32, 16)),
    Goal("one_afternoon", "1 tuft, core call: ours / afternoon", ratio("one/tuftwave", "one/afternoon"), at_most(0.25, 0.1)),
    Goal("one_http_pct", "1 tuft over HTTP: share of the same-bytes requests/s, %", http("one_tuft", 100), at_least(70, 90)),
    Goal("thousand_http", "1,000 strokes over HTTP: ours / same bytes", http("thousand_strokes"), at_most(1.6, 1.2)),
    Goal("thousand_nginx", "... ours / nginx serving the same file", ratio("http/thousand_file/tuftwave", "http/thousand_file/nginx")),
    Goal("read", "request parse: nlohmann / ours", beats("read", "nlohmann"), at_least(5, 9)),
    Goal("w2_afternoon", "W2 GLB clip: afternoon / ours", beats("w2", "afternoon"), at_least(10, 20)),
    Goal("w2_three", "... three.js / ours", beats("w2", "three"), at_least(180, 350)),
    Goal("w2_gltf_transform", "... glTF-Transform / ours", beats("w2", "gltf_transform"), at_least(130, 270)),
    Goal("w2_blender", "... Blender / ours", beats("w2", "blender"), at_least(1900, 3500)),
    Goal("evaluation", "W2 evaluation: afternoon / ours", beats("evaluation", "afternoon"), at_least(4, 12)),
    Goal("evaluation_rate", "... million node-poses/s", combined(lambda ms: NODE_POSES / ms / 1000, "evaluation/tuftwave")),
    Goal("pose_text", "W2 JSON poses: nlohmann build and dump / ours", beats("pose_text", "nlohmann"), at_least(3, 6)),
    Goal("w3_three_vrm", "W3: three-vrm cold / our clip of 24 pictures", beats("w3", "three_vrm"), at_least(100, 200)),
    Goal("w3_three_vrm_warm", "... three-vrm warm / our clip", beats("w3", "three_vrm_warm")),
    Goal("w3_bullet", "... native Bullet / our clip", beats("w3", "bullet"), at_least(250, 450)),
    Goal("pack", "GLB packing: ours / one fresh copy", ratio("pack/tuftwave", "pack/fresh_copy"), at_most(1.3, 1)),
    Goal("pack_memory", "... memory, GLBs", value("pack_memory/tuftwave"), at_most(1.1, 1)),
    Goal("primitive_us", "per-primitive JSON cost, us", value("primitives/tuftwave", 1000 / TUBES), at_most(5, 1)),
    Goal("meshopt", "meshopt answer: ours / the library's calls", ratio("meshopt/tuftwave", "meshopt/library"), at_most(1.4, 1.1)),
    Goal("meshopt_size_pct", "... size, %", value("meshopt_size/tuftwave"), at_most(26, 20)),
    Goal("null_http_pct", "health: share of the null handler's requests/s, %", ratio("http/null/health", "http/null/peer", 100), at_least(90, 97)),
    Goal("mebibyte_cpu", "1 MiB answer: CPU, ours / content provider", http("mebibyte_processor"), at_most(1.1, 1)),
    Goal("round_trip", "keep-alive round trip, p50: ours / null handler", http("round_trip"), at_most(3, 1.5)),
    Goal("keep_alive_never", "64 keep-alive clients: never answered", worst("http/keep_alive_64_never/tuftwave"), at_most(0, 0)),
    Goal("keep_alive_ms", "... worst first answer, ms", worst("http/keep_alive_64_slowest/tuftwave"), at_most(1000, 200)),
    Goal("connects_failed", "1,000 connects at once: failures", worst("http/connects_1000_never/tuftwave"), at_most(0, 0)),
    Goal("connects_ms", "... slowest, ms", worst("http/connects_1000_slowest/tuftwave"), at_most(1000, 400)),
    Goal("slow_heads_ms", "slow heads: good client answered, ms", worst("http/slow_heads/tuftwave"), at_most(6000, 1000)),
    Goal("slow_bodies_ms", "slow bodies: good client answered, ms", worst("http/slow_bodies/tuftwave"), at_most(6000, 1000)),
    Goal("fill_ms", "fill of 10,000 tufts, ms", value("fill/tuftwave"), at_most(20, 5)),
    Goal("head_ms", "65-tuft VRoid head over HTTP, ms", value("http/vroid_Vita/tuftwave"), at_most(5, 2)),
    Goal("head_shibu_ms", "... Sendagaya Shibu, ms", value("http/vroid_Sendagaya_Shibu/tuftwave")),
    Goal("head_fumiriya_ms", "... Sakurada Fumiriya, ms", value("http/vroid_Sakurada_Fumiriya/tuftwave")),
    Goal("strands_ms", "1,648 TressFX strands over HTTP, ms", value("http/strands/tuftwave")),
    Goal("start_ms", "start to ready, ms", value("http/start_to_ready/tuftwave"), at_most(100, 30)),
    Goal("idle_mib", "idle memory, MiB", value("http/idle_memory/tuftwave"), at_most(20, 12)),
]
