import type { Fill, FillsAnswer, Hairstyle, HairstyleAnswer, Tuft } from "../api/contract";
import type { Service } from "../api/Service";
import { fromHairstyle } from "../model/fromHairstyle";
import type { StudioDocument } from "../model/StudioDocument";

/**
 * A hairstyle as a document. The service checks all of it first, as one request, so that pointers in a problem are those of the file.
 * Fills become ordinary tufts: after the drawn ones, fill by fill, under the names that the service gives.
 * @param name  of the document
 * @throws as Service does
 */
export async function openHairstyle(service: Service, hairstyle: Hairstyle, name: string, signal?: AbortSignal): Promise<StudioDocument> {
  const asked = signal ? { signal } : {};
  await service.json<HairstyleAnswer>("/v1/hairstyles", { body: hairstyle, query: { format: "json" }, ...asked });
  const drawn = new Map(hairstyle.tufts.map((tuft) => [tuft.name ?? "", tuft]));
  const tufts: Tuft[] = [...hairstyle.tufts];
  for (const [i, settings] of (hairstyle.fills ?? []).entries()) {
    const from = drawn.get(settings.from)!; // the service has seen that it is there
    const to = settings.to == null || settings.to === settings.from ? null : drawn.get(settings.to)!;
    const formulas = settings.formulas ?? hairstyle.formulas;
    const { formulas: _, ...rest } = settings;
    const fill: Fill = { ...rest, ...(formulas ? { formulas } : {}), name: settings.name ?? `fill${i + 1}`, from, to };
    const answer = await service.json<FillsAnswer>("/v1/fills", { body: { ...(hairstyle.head ? { head: hairstyle.head } : {}), fill }, ...asked });
    tufts.push(...answer.tufts);
  }
  const { fills: _, ...bare } = hairstyle;
  return fromHairstyle({ ...bare, tufts }, name);
}
