import type { Ray } from "three";

/** A mouse, finger or pen over the picture. */
export interface StagePointer {
  /** From the eye through the pointer, scene. */
  readonly ray: Ray;
  /** Pixels from the picture's left and top. */
  readonly x: number;
  readonly y: number;
  /** 0..1; a mouse reports 0.5. */
  readonly pressure: number;
  readonly shift: boolean;
}
