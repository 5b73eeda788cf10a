import type { Fill, FillsAnswer, Tuft } from "../api/contract";
import { ServiceAway } from "../api/ServiceAway";
import { ServiceProblem } from "../api/ServiceProblem";
import { Newest } from "../base/Newest";
import { Signal } from "../base/Signal";
import type { TuftMesh } from "../hair/TuftMesh";
import { addTufts } from "../model/addTufts";
import { bareTuft } from "../model/bareTuft";
import type { Studio } from "../Studio";

export interface Preview {
  readonly tufts: readonly Tuft[];
  readonly meshes: readonly TuftMesh[];
  readonly report: FillsAnswer["report"];
}

/** The fill that is planned, as it would be; kept in one step. */
export class FillPreview {
  readonly preview = new Signal<Preview | null>(null);
  private readonly newest = new Newest();

  constructor(private readonly studio: Studio) {
    for (const signal of [studio.mode, studio.plan, studio.history.current]) signal.changed(() => this.load());
    studio.service.isHere.changed((isHere) => isHere && this.load());
  }

  /** The tufts of the preview become tufts of the document. */
  keep(): void {
    const made = this.preview.value;
    if (!made || made.tufts.length === 0) return;
    this.preview.value = null;
    this.studio.plan.value = { ...this.studio.plan.value, from: null, to: null };
    this.studio.edit((document) => addTufts(document, made.tufts));
  }

  private load(): void {
    const fill = this.studio.mode.value === "fill" ? this.fill() : null;
    this.newest.start((signal) => this.answer(fill, signal));
  }

  private fill(): Fill | null {
    const { from, to, settings } = this.studio.plan.value;
    const tuft = (id: number | null) => this.studio.document.tufts.find((one) => one.id === id);
    const [first, second] = [tuft(from), tuft(to)];
    if (!first || !second) return null;
    return { ...settings, from: bareTuft(first), to: first === second ? null : bareTuft(second), name: settings.name ?? "fill" };
  }

  private async answer(fill: Fill | null, signal: AbortSignal): Promise<void> {
    if (!fill) {
      this.preview.value = null;
      return;
    }
    const scalp = this.studio.scalp.value;
    const head = { ...this.studio.document.head, scalp: this.studio.document.head.scalp ?? (scalp && { mesh: scalp }) };
    try {
      const { tufts, report } = await this.studio.service.json<FillsAnswer>("/v1/fills", { body: { head, fill }, signal });
      const meshes = tufts.length > 0 ? await this.studio.loader.cache.load(tufts, head, signal) : [];
      this.preview.value = { tufts, meshes, report };
      this.studio.problem.value = null;
    } catch (error) {
      if (signal.aborted) throw error;
      if (error instanceof ServiceProblem) this.studio.problem.value = error;
      else if (!(error instanceof ServiceAway)) throw error;
      this.preview.value = null;
    }
  }
}
