import type { Group, Vector3 } from "three";
import type { HeadBall } from "../model/HeadBall";

/** A character that is shown in place of head and hair while things move. */
export interface Guest {
  readonly group: Group;
  /** Its head, about which the wind is dragged. */
  readonly ball: HeadBall;
  /** Its middle, and as much of the scene as shows all of it; metres. */
  readonly middle: Vector3;
  readonly height: number;
  /** Where its face looks. */
  readonly front: readonly [number, number, number];
  /** A still of the cycle. */
  showPicture(picture: number): void;
  /** The motion as it would be without holds. @param part  of the cycle, 0..1 */
  showSmooth(part: number): void;
}
