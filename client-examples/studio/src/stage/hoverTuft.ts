import type { Scene } from "./Scene";
import type { StagePointer } from "./StagePointer";

/** Marks the tuft under the pointer; null is a pointer that has left. */
export function hoverTuft(scene: Scene, pointer: StagePointer | null): void {
  const { viewport, hair } = scene;
  const id = pointer && scene.tuftAt(pointer.ray);
  viewport.canvas.style.cursor = id === null ? "grab" : "pointer";
  if (id === hair.hovered) return;
  hair.hovered = id;
  viewport.invalidate();
}
