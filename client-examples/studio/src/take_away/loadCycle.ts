import type { HairstyleAnswer, Schedule } from "../api/contract";
import type { LoadedHair } from "../hair/HairLoader";
import { posesOf } from "../hair/posesOf";
import { TuftCache } from "../hair/TuftCache";
import { toHairstyle } from "../model/toHairstyle";
import type { Studio } from "../Studio";

/** The hair with every picture of its cycle, and their schedule, whatever the page shows. @throws as Service does */
export async function loadCycle(studio: Studio, signal: AbortSignal): Promise<{ readonly hair: LoadedHair; readonly schedule: Schedule }> {
  const { document, service } = studio;
  const [meshes, { pictures, schedule }] = await Promise.all([
    new TuftCache(service, "fine").load(document.tufts, document.head, signal),
    service.json<HairstyleAnswer>("/v1/hairstyles", { body: toHairstyle(document), query: { format: "json" }, signal }),
  ]);
  if (!pictures || !schedule) throw new Error("a hairstyle that does not move has no cycle");
  return { hair: { tufts: document.tufts, meshes, unmeshed: [], limited: posesOf(pictures, meshes), smooth: null }, schedule };
}
