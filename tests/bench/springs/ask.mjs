// The same chains moved by the service, and its clip as three.js plays it.
import { setImmediate } from "node:timers/promises";
import { AnimationMixer, LoopRepeat, Quaternion, Vector3 } from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";

export async function askService(url, { head, chains }, period, fps, format) {
  // Springs take so long that the server may have closed the connection; two turns of the loop, so that it is noticed.
  await setImmediate();
  await setImmediate();
  const body = JSON.stringify({ head: { center: head }, chains: chains.map(({ name, nodes }) => ({ name, nodes })), motion: { timing: { period, fps, hold: 2 } } });
  const response = await fetch(`${url}/v1/motions?format=${format}`, { method: "POST", headers: { "Content-Type": "application/json" }, body });
  if (!response.ok) throw new Error(`${response.status} ${await response.text()}`);
  return format === "json" ? response.json() : response.arrayBuffer();
}

/** Node objects of every chain, root first; the clip's file holds them in the order in which they were asked for. */
function chainsOf(scene, chains) {
  return scene.getObjectByName("hair_root").children.map((bone, c) => {
    const nodes = [bone];
    while (nodes.length < chains[c].nodes.length) nodes.push(nodes.at(-1).children[0]);
    return nodes;
  });
}

/** A player of a clip: steps of 1/rate from its beginning. @returns  poses at 0, 1/rate, ... up to and with `seconds` */
export async function playClip(glb, chains, rate, seconds) {
  const { scene, animations } = await new GLTFLoader().parseAsync(glb.slice(0), "");
  const bones = chainsOf(scene, chains);
  const mixer = new AnimationMixer(scene);
  mixer.clipAction(animations[0]).setLoop(LoopRepeat, Infinity).play();
  const place = new Vector3();
  const poses = [];
  for (let step = 0; step <= Math.round(seconds * rate); step++) {
    mixer.update(step ? 1 / rate : 0);
    scene.updateMatrixWorld(true);
    poses.push(bones.map((chain) => chain.map((bone) => place.setFromMatrixPosition(bone.matrixWorld).toArray())));
  }
  return poses;
}

/** How far the last key of the clip's curves is from the first, degrees; the end of a cycle from its beginning. */
export async function closingGap(glb) {
  const { animations } = await new GLTFLoader().parseAsync(glb.slice(0), "");
  const gaps = animations[0].tracks.map(({ values }) => {
    const [first, last] = [new Quaternion().fromArray(values, 0), new Quaternion().fromArray(values, values.length - 4)];
    return first.equals(last) ? 0 : (first.angleTo(last) * 180) / Math.PI;
  });
  return Math.max(...gaps);
}
