import { Matrix4, Quaternion, Vector3 } from "three";
import type { Picture } from "../../../client-examples/studio/src/api/contract";
import { poseMatrices } from "../../../client-examples/studio/src/hair/poseMatrices";

const turn = new Quaternion().setFromAxisAngle(new Vector3(1, 2, 3).normalize(), 0.7);
const pose = (position: [number, number, number], q: Quaternion): Picture["chains"][number] => ({
  name: "", rotations: [], positions: [position, [0, 0, 0]], turns: [[q.x, q.y, q.z, q.w], [0, 0, 0, 1]],
});

describe("poseMatrices", () => {
  it("turns about the joint and brings it to its place", () => {
    const matrices = poseMatrices([{ chains: [pose([4, 5, 6], turn)] }], [new Float32Array([1, 2, 3])]);
    const expected = new Matrix4().makeTranslation(4, 5, 6).multiply(new Matrix4().makeRotationFromQuaternion(turn)).multiply(new Matrix4().makeTranslation(-1, -2, -3));
    expected.transpose().elements.slice(0, 12).forEach((value, i) => expect(matrices[i]).toBeCloseTo(value, 5));
  });

  it("is the identity where nothing moves", () => {
    const matrices = poseMatrices([{ chains: [pose([1, 2, 3], new Quaternion())] }], [new Float32Array([1, 2, 3])]);
    expect([...matrices]).toEqual([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]);
  });

  it("goes picture by picture, tuft by tuft, joint by joint", () => {
    const chain = (x: number) => ({ ...pose([x, 0, 0], new Quaternion()), positions: [[x, 0, 0], [x + 0.5, 0, 0]] as [number, number, number][], turns: [[0, 0, 0, 1], [0, 0, 0, 1]] as [number, number, number, number][] });
    const rests = [new Float32Array([0, 0, 0]), new Float32Array([0, 0, 0, 0, 0, 0])];
    const matrices = poseMatrices([{ chains: [chain(1), chain(2)] }, { chains: [chain(3), chain(4)] }], rests);
    expect(Array.from({ length: 6 }, (_, i) => matrices[12 * i + 3])).toEqual([1, 2, 2.5, 3, 4, 4.5]);
  });
});
