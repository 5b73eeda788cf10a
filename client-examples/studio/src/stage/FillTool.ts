import { strokeLine } from "../draw/strokeLine";
import type { Studio } from "../Studio";
import { hoverTuft } from "./hoverTuft";
import type { Scene } from "./Scene";
import type { StagePointer } from "./StagePointer";
import type { Tool } from "./Tool";

/** Two tufts are picked, one after the other, or one twice for a ring. */
export class FillTool implements Tool {
  private readonly endings: (() => void)[] = [];

  constructor(private readonly studio: Studio, private readonly scene: Scene) {}

  start(): void {
    const [from = null, to = null] = this.studio.selection.value;
    if (from !== null) this.studio.plan.value = { ...this.studio.plan.value, from, to };
    const show = () => this.show();
    this.endings.push(this.studio.plan.changed(show), this.studio.history.current.changed(show));
    this.show();
  }

  stop(): void {
    for (const end of this.endings.splice(0)) end();
    this.scene.hair.hovered = null;
    this.scene.hair.selected = [];
    this.scene.viewport.overlay.show([], []);
  }

  click({ ray }: StagePointer): void {
    const id = this.scene.tuftAt(ray);
    if (id === null) return;
    const { plan } = this.studio;
    const begins = plan.value.from === null || plan.value.to !== null;
    plan.value = begins ? { ...plan.value, from: id, to: null } : { ...plan.value, to: id };
  }

  hover(pointer: StagePointer | null): void {
    hoverTuft(this.scene, pointer);
  }

  key(event: KeyboardEvent): boolean {
    if (event.key !== "Escape") return false;
    this.studio.plan.value = { ...this.studio.plan.value, from: null, to: null };
    return true;
  }

  private show(): void {
    const { from, to } = this.studio.plan.value;
    const picked = this.studio.document.tufts.filter(({ id }) => id === from || id === to);
    this.scene.hair.selected = picked.map(({ id }) => id);
    this.scene.viewport.overlay.show([], picked.map(({ points }) => ({ places: strokeLine(points), kind: "stroke" })));
    this.scene.viewport.invalidate();
  }
}
