import type { Head } from "../api/contract";
import type { HeadBall } from "../model/HeadBall";

/** A head that came as a file: it belongs to the visit; its measures go into documents. */
export interface BroughtHead {
  readonly name: string;
  readonly bytes: ArrayBuffer;
  readonly ball: HeadBall;
  readonly head: Head;
}
