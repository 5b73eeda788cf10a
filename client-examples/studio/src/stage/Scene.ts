import type { Ray } from "three";
import type { Signal } from "../base/Signal";
import type { HairView } from "../hair/HairView";
import type { HeadBall } from "../model/HeadBall";
import type { HeadSurface } from "./HeadSurface";
import type { Viewport } from "./Viewport";

/** What tools work on: the picture, the head in it and the hair. */
export interface Scene {
  readonly viewport: Viewport;
  readonly head: Signal<HeadSurface>;
  readonly hair: HairView;
  /** The head that is shown. Tools are as large as it is. */
  readonly ball: HeadBall;
  /** The tuft under the pointer, by its id. */
  tuftAt(ray: Ray): number | null;
}
