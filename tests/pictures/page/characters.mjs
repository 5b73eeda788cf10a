// The heads: whose hair, in which paint, and where the head stands in the hair's own frame, so that its scalp lies just under the roots.
import { loadHair } from "./hair.mjs";
import { makeHead } from "./head.mjs";
import { kHair } from "./paint.mjs";
import { makeStage } from "./stage.mjs";

const kCrown = 1.6659; // of the head in its file, metres from the floor
/** `crown` is where that comes to lie, the rest scales and moves the head. */
const fit = ({ crown, width, height, depth, x, z }) => ({ position: [x, crown - height * kCrown, z], scale: [width, height, depth] });

const kCharacters = {
  vita: {
    paint: kHair.rose,
    place: fit({ crown: 0.226, width: 1.2, height: 1.04, depth: 1.02, x: 0.0018, z: -0.062 }),
    face: { iris: ["#1d4d63", "#2f9aa6", "#8fe3d6"], brow: "#a8406f" },
  },
  shibu: {
    paint: kHair.gold,
    place: fit({ crown: 0.22, width: 1.2, height: 1.04, depth: 1.02, x: 0, z: -0.062 }),
    face: { iris: ["#30507f", "#4a83c9", "#a9d6f5"], brow: "#b0763a" },
  },
  fumiriya: {
    paint: kHair.violet,
    place: fit({ crown: 0.22, width: 1.22, height: 1.04, depth: 1.02, x: 0, z: -0.062 }),
    face: { iris: ["#7a3a20", "#c9772f", "#f5cf7a"], brow: "#45408f" },
  },
  // Fitted to the 1,393 roots of the top and the back, which lie 3 mm from the scalp (median). The data leaves the sides bare: cropped hair.
  ponytail: {
    paint: { ...kHair.auburn, pixels: 0.6, roundness: 0.6 },
    place: fit({ crown: 0.0875, width: 0.955, height: 0.81, depth: 0.915, x: 0.0013, z: -0.054 }),
    scalp: ["#c08469", "#d9a284", "#e8b799"],
    face: { iris: ["#2d5a3a", "#4c9a5f", "#b9e3a0"], brow: "#7e3328" },
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
