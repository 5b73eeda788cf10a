// Chains baked with VRM spring bones: the head sways, the springs follow, and every step is a pose.
import { VRMSpringBoneJoint, VRMSpringBoneManager } from "@pixiv/three-vrm";
import { Object3D, Vector3 } from "three";

/** How far the head turns about +Y to either side; springs know no wind, so this is what moves them. */
export const SWAY_DEG = 10;

function addBones(head, chain, center, manager) {
  const bones = chain.nodes.map((node, i) => {
    const bone = new Object3D();
    const from = i ? chain.nodes[i - 1] : center;
    bone.position.set(node[0] - from[0], node[1] - from[1], node[2] - from[2]);
    return bone;
  });
  bones.reduce((parent, bone) => (parent.add(bone), bone), head);
  const settings = { ...chain.settings, gravityDir: new Vector3(...chain.settings.gravityDir) };
  bones.slice(0, -1).forEach((bone, i) => manager.addJoint(new VRMSpringBoneJoint(bone, bones[i + 1], settings)));
  return bones;
}

/** Runs the springs from rest; `record(step, bones, head)` is called at the times 0, 1/rate, 2/rate, ... up to and with `seconds`. */
function runSprings({ head: center, chains }, period, rate, seconds, record) {
  const head = new Object3D();
  head.position.set(...center);
  const manager = new VRMSpringBoneManager();
  const bones = chains.map((chain) => addBones(head, chain, center, manager));
  head.updateMatrixWorld(true);
  manager.setInitState();
  record(0, bones, head);
  for (let step = 1; step <= Math.round(seconds * rate); step++) {
    head.rotation.y = ((SWAY_DEG * Math.PI) / 180) * Math.sin((2 * Math.PI * step) / (rate * period));
    head.updateMatrixWorld(true); // without it, the manager measures bones from new heads to old tails
    manager.update(1 / rate);
    record(step, bones, head);
  }
}

/** @returns  poses at all steps */
export function springPoses(workload, period, rate, seconds) {
  const place = new Vector3();
  const poses = [];
  runSprings(workload, period, rate, seconds, (_, bones, head) => {
    head.updateMatrixWorld(true);
    poses.push(bones.map((chain) => chain.map((bone) => head.worldToLocal(place.setFromMatrixPosition(bone.matrixWorld)).toArray())));
  });
  return poses;
}

/** What a baker does: springs for some cycles, and the rotations of the last one kept. */
export function bakeLastCycle(workload, period, rate, cycles) {
  const keys = [];
  runSprings(workload, period, rate, cycles * period, (step, bones) => {
    if (step >= (cycles - 1) * period * rate) keys.push(bones.map((chain) => chain.map((bone) => bone.quaternion.toArray())));
  });
  return keys;
}
