import type { Hairstyle } from "../api/contract";
import { glbJson } from "./glbJson";

/** What a file is by what is in it. `cut` is a GLB whose end is missing. A hairstyle is as it was read: the service checks it. */
export type KindOfFile =
  | { readonly kind: "hairstyle"; readonly hairstyle: Hairstyle }
  | { readonly kind: "model" }
  | { readonly kind: "cut" }
  | { readonly kind: "unknown" };

const kFields = ["tufts", "fills", "head", "motion"]; // any of them names a hairstyle

function isObject(value: unknown): value is Readonly<Record<string, unknown>> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function readJson(bytes: ArrayBuffer): unknown {
  try {
    return JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes)) as unknown;
  } catch {
    return null; // no text, or no JSON
  }
}

/** The recipe that Tuftwave writes into its files. */
function recipeIn(gltf: unknown): unknown {
  let place = gltf;
  for (const name of ["asset", "extras", "tuftwave", "hairstyle"]) place = isObject(place) ? place[name] : null;
  return place;
}

/** Tells files apart by their bytes; names are not looked at. */
export function kindOfFile(bytes: ArrayBuffer): KindOfFile {
  const gltf = glbJson(bytes);
  if (gltf === "cut") return { kind: "cut" };
  const hairstyle = gltf === null ? readJson(bytes) : recipeIn(gltf);
  if (isObject(hairstyle) && (gltf !== null || kFields.some((field) => field in hairstyle))) {
    return { kind: "hairstyle", hairstyle: hairstyle as unknown as Hairstyle };
  }
  return { kind: gltf === null ? "unknown" : "model" };
}
