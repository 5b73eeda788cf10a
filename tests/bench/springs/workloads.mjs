// The chains that both sides move: { name, nodes: [[x, y, z], ...], settings } with the head that they hang on, and its name.
import { readFileSync } from "node:fs";

const CHARACTERS = new URL("../../data/characters/", import.meta.url);
/** What VRM 1.0 gives a joint that states nothing. */
export const VRM1_DEFAULTS = { hitRadius: 0, stiffness: 1, gravityPower: 0, gravityDir: [0, -1, 0], dragForce: 0.5 };

/** A VRM 0.x bone group's settings in VRM 1.0's words. */
function settingsOfGroup(group) {
  const { x, y, z } = group.gravityDir;
  return { hitRadius: group.hitRadius, stiffness: group.stiffiness, gravityPower: group.gravityPower, gravityDir: [x, y, z], dragForce: group.dragForce };
}

/** The hair of a character as the service finds it, with the file's own spring settings where it is a VRM 0.x. */
async function character(url, file) {
  const glb = readFileSync(new URL(file, CHARACTERS));
  const json = JSON.parse(glb.subarray(20, 20 + glb.readUInt32LE(12)).toString());
  const groups = json.extensions?.VRM?.secondaryAnimation.boneGroups ?? [];
  const response = await fetch(`${url}/v1/characters/chains`, { method: "POST", headers: { "Content-Type": "model/gltf-binary" }, body: glb });
  if (!response.ok) throw new Error(`${file}: ${response.status} ${await response.text()}`);
  const { head, chains } = await response.json();
  return {
    name: file,
    head: head.center,
    chains: chains.filter((chain) => chain.kind === "hair").map((chain) => ({
      name: chain.name.slice(0, 64),
      nodes: [...chain.bones.map((bone) => bone.position), chain.tip.position],
      settings: chain.bone_group === undefined ? VRM1_DEFAULTS : settingsOfGroup(groups[chain.bone_group]),
    })),
  };
}

/** Long hair all round a head: chains of 16 nodes, 2 cm apart. */
function longHair(count) {
  const chains = Array.from({ length: count }, (_, c) => {
    const angle = (2 * Math.PI * c) / count;
    return {
      name: `lock_${c}`,
      nodes: Array.from({ length: 16 }, (_, i) => [0.1 * Math.sin(angle), 0.05 - 0.02 * i, 0.1 * Math.cos(angle)]),
      settings: VRM1_DEFAULTS,
    };
  });
  return { name: `${count} chains of 16 nodes`, head: [0, 0, 0], chains };
}

export async function workloads(url) {
  return [await character(url, "godette.vrm0.vrm"), await character(url, "vroid_Vita.chains.glb"), longHair(200)];
}
