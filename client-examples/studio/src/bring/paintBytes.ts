import type { PaintedHead } from "../paint/PaintedHead";
import { paintHead } from "../paint/paintHead";
import type { HeadBall } from "../model/HeadBall";
import { loadModel } from "./loadModel";

/** The head in a file, painted. @param ballOf  see paintHead @throws as loadModel and paintHead do */
export async function paintBytes(bytes: ArrayBuffer, ballOf: (corners: ArrayLike<number>) => HeadBall): Promise<PaintedHead> {
  const model = await loadModel(bytes);
  try {
    return paintHead(model.scene, ballOf);
  } finally {
    model.dispose();
  }
}
