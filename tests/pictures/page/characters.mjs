// The heads: whose hair, in which paint, on which face.
import { loadBundledHead } from "../../../client-examples/studio/src/paint/loadBundledHead";
import { loadHair } from "./hair.mjs";
import { kHair } from "./paint.mjs";
import { kPlaces } from "./places.mjs";
import { makeScene } from "./stage.mjs";

const kCharacters = {
  vita: {
    paint: kHair.rose,
    place: kPlaces.vita,
    iris: ["#1d4d63", "#2f9aa6", "#8fe3d6"],
  },
  shibu: {
    paint: kHair.gold,
    place: kPlaces.shibu,
    iris: ["#30507f", "#4a83c9", "#a9d6f5"],
  },
  fumiriya: {
    paint: kHair.violet,
    place: kPlaces.fumiriya,
    iris: ["#7a3a20", "#c9772f", "#f5cf7a"],
  },
  // The data leaves the sides bare: cropped hair.
  ponytail: {
    paint: { ...kHair.auburn, pixels: 0.6, roundness: 0.6 },
    place: kPlaces.ponytail,
    scalp: ["#c08469", "#d9a284", "#e8b799"],
    iris: ["#2d5a3a", "#4c9a5f", "#b9e3a0"],
  },
  spiky: {
    paint: kHair.auburn,
    place: kPlaces.filled,
    iris: ["#2d5a3a", "#4c9a5f", "#b9e3a0"],
  },
  bob: {
    paint: kHair.teal,
    place: kPlaces.filled,
    iris: ["#7a3a20", "#c9772f", "#f5cf7a"],
  },
};

/** A scene with the character's head and hair. @param motion  none, calm, breeze or gale */
export async function loadCharacter(name, motion) {
  const { paint, place, iris, scalp } = kCharacters[name];
  const scene = makeScene({ center: [0, 0.06, 0] });
  const hair = await loadHair(`${name}-${motion}`, paint);
  const head = await loadBundledHead({ place, iris });
  const [dark, middle] = paint.tones; // where locks part, the eye meets shaded hair and not skin
  head.setScalpTones(scalp ?? [dark, dark, middle], dark);
  scene.add(hair.group, head.group);
  return { scene, hair, head, paint, request: await (await fetch(`/hair/${name}-${motion}.json`)).json() };
}
