// The heads: whose hair, in which paint, on which face.
import { loadHair } from "./hair.mjs";
import { makeHead } from "./head.mjs";
import { kHair } from "./paint.mjs";
import { kPlaces } from "./places.mjs";
import { makeStage } from "./stage.mjs";

const kCharacters = {
  vita: {
    paint: kHair.rose,
    place: kPlaces.vita,
    face: { iris: ["#1d4d63", "#2f9aa6", "#8fe3d6"], brow: "#a8406f" },
  },
  shibu: {
    paint: kHair.gold,
    place: kPlaces.shibu,
    face: { iris: ["#30507f", "#4a83c9", "#a9d6f5"], brow: "#b0763a" },
  },
  fumiriya: {
    paint: kHair.violet,
    place: kPlaces.fumiriya,
    face: { iris: ["#7a3a20", "#c9772f", "#f5cf7a"], brow: "#45408f" },
  },
  // The data leaves the sides bare: cropped hair.
  ponytail: {
    paint: { ...kHair.auburn, pixels: 0.6, roundness: 0.6 },
    place: kPlaces.ponytail,
    scalp: ["#c08469", "#d9a284", "#e8b799"],
    face: { iris: ["#2d5a3a", "#4c9a5f", "#b9e3a0"], brow: "#7e3328" },
  },
  spiky: {
    paint: kHair.auburn,
    place: kPlaces.filled,
    face: { iris: ["#2d5a3a", "#4c9a5f", "#b9e3a0"], brow: "#7e3328" },
  },
  bob: {
    paint: kHair.teal,
    place: kPlaces.filled,
    face: { iris: ["#7a3a20", "#c9772f", "#f5cf7a"], brow: "#1f6c8c" },
  },
};

/** A scene with the character's head and hair. @param motion  none, calm, breeze or gale */
export async function loadCharacter(name, motion) {
  const { paint, place, face, scalp } = kCharacters[name];
  const scene = makeStage({ center: [0, 0.06, 0] });
  const hair = await loadHair(`${name}-${motion}`, paint);
  const [dark, middle] = paint.tones; // where locks part, the eye meets shaded hair and not skin
  const head = await makeHead(place, face, scalp ?? [dark, dark, middle]);
  scene.add(hair.group, head);
  return { scene, hair, head, paint, request: await (await fetch(`/hair/${name}-${motion}.json`)).json() };
}
