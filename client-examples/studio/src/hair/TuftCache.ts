import type { Head, Tuft } from "../api/contract";
import { rangeOf } from "../api/rangeOf";
import type { Service } from "../api/Service";
import { bareTuft } from "../model/bareTuft";
import { readTufts } from "./readTufts";
import type { TuftMesh } from "./TuftMesh";
import { tuftKey } from "./tuftKey";

const kSides = 8;
const kTolerance = 0.005; // of the thickest tuft: half a millimetre on the bundled head
const kKept = 2000; // meshes of about 25 kB

/** Meshes of tufts. Only those that were not asked for before are asked for, so that undoing needs no service. */
export class TuftCache {
  private readonly meshes = new Map<string, TuftMesh>();

  /** @param detail  for the screen, or as fine as what is taken away */
  constructor(private readonly service: Service, private readonly detail: "screen" | "fine" = "screen") {}

  /** A mesh per tuft, null where `tufts` has one that is not known. */
  known(tufts: readonly Tuft[], head: Head): (TuftMesh | null)[] {
    return tufts.map((tuft) => this.meshes.get(tuftKey(tuft, head)) ?? null);
  }

  /** A mesh per tuft. @throws as Service does */
  async load(tufts: readonly Tuft[], head: Head, signal: AbortSignal): Promise<TuftMesh[]> {
    const keys = tufts.map((tuft) => tuftKey(tuft, head));
    const missing = [...new Set(keys)].filter((key) => !this.meshes.has(key));
    if (missing.length > 0) {
      const asked = missing.map((key) => bareTuft(tufts[keys.indexOf(key)]!));
      const { scalp: _, ...bareHead } = head; // nothing drawn depends on it
      const made = readTufts(await this.service.bytes("/v1/tufts", { body: { head: bareHead, tufts: asked, ...(this.detail === "screen" && { mesh: screenDetail(head) }) }, signal }));
      missing.forEach((key, i) => this.meshes.set(key, made[i]!));
    }
    const meshes = keys.map((key) => this.touch(key));
    for (const key of this.meshes.keys()) {
      if (this.meshes.size <= Math.max(kKept, tufts.length)) break;
      this.meshes.delete(key);
    }
    return meshes;
  }

  /** Moves a mesh to the end, away from those that are dropped first. */
  private touch(key: string): TuftMesh {
    const mesh = this.meshes.get(key)!;
    this.meshes.delete(key);
    this.meshes.set(key, mesh);
    return mesh;
  }
}

/** Coarser than what is taken away, by half: 200 tufts have 42,000 vertices and not 81,000, and look the same on the screen. */
function screenDetail({ diameter_at_100 }: Head): { sides: number; tolerance: number } {
  const { minimum, maximum } = rangeOf("MeshDetail", "tolerance");
  const wanted = kTolerance * (diameter_at_100 ?? rangeOf("Head", "diameter_at_100").default!);
  return { sides: kSides, tolerance: Math.min(maximum, Math.max(minimum, wanted)) };
}
