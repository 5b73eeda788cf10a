import { BufferGeometry, Group, Line, LineBasicMaterial } from "three";
import type { Tuft } from "../api/contract";
import { strokeLine } from "../draw/strokeLine";

/** Strokes as mere lines, for as long as nobody makes tufts of them. */
export class StrokeLines {
  readonly group = new Group();
  private readonly material = new LineBasicMaterial();
  private lines: Line[] = [];

  show(tufts: readonly Tuft[]): void {
    for (const { geometry } of this.lines) geometry.dispose();
    this.lines = tufts.map(({ points }) => new Line(new BufferGeometry().setFromPoints(strokeLine(points)), this.material));
    this.group.clear();
    for (const line of this.lines) this.group.add(line);
  }

  setColor(color: string): void {
    this.material.color.set(color);
  }

  dispose(): void {
    this.show([]);
    this.material.dispose();
  }
}
