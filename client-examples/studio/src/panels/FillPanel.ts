import { rangeOf } from "../api/rangeOf";
import { element } from "../base/element";
import type { Part } from "../base/Part";
import type { FillPreview } from "../fill/FillPreview";
import type { Studio } from "../Studio";
import type { panelText } from "../text/panelText";
import { choice } from "../widgets/choice";
import { group } from "../widgets/group";
import { seedField } from "../widgets/seedField";
import { Slider } from "../widgets/Slider";
import { toggle } from "../widgets/toggle";
import type { Fields } from "./Fields";

type Direction = "along" | "crown" | "neck";

/** The gap that is to be filled, how densely, and what comes of it. */
export class FillPanel implements Part {
  readonly element: HTMLElement;
  private readonly endings: (() => void)[];

  constructor(studio: Studio, preview: FillPreview, words: typeof panelText.en, fields: Fields) {
    const { plan } = studio;
    const settle = () => undefined; // a plan is no edit
    const set = (settings: Partial<typeof plan.value.settings>) => (plan.value = { ...plan.value, settings: { ...plan.value.settings, ...settings } });
    const density = (direction: Direction, label: string) => fields.add(`/fill/density/${direction}`, new Slider({
      label, hint: words.off, range: rangeOf("Density"), track: { minimum: 0 }, step: 1, field: `/fill/density/${direction}`, onSettle: settle,
      onInput: (value) => set({ density: { ...plan.value.settings.density, [direction]: value === 0 ? null : value } }),
    }));
    const densities = { along: density("along", words.along), crown: density("crown", words.crown), neck: density("neck", words.neck) };
    const gap = fields.add("/fill/min_gap", new Slider({ label: words.minGap, range: rangeOf("MinGap"), track: { maximum: 1.5 }, field: "/fill/min_gap", onSettle: settle, onInput: (min_gap) => set({ min_gap }) }));
    const jitter = toggle(words.jitter, (isOn) => set({ jitter: isOn ? { seed: 1 } : null }));
    const seed = seedField(words.seed, words.dice, (value) => set({ jitter: { seed: value } }));
    const direction = choice(words.direction, (["shorter", "counter_clockwise", "clockwise"] as const).map((one) => [one, words.directions[one]] as const), (value) => set({ direction: value }));
    const ends = { from: element("output", {}), to: element("output", {}) };
    const add = element("button", { type: "button", className: "primary", onclick: () => preview.keep() });
    const report = element("p", { className: "help", role: "status" });
    this.element = element("div", { className: "panel-body" },
      element("p", { className: "help" }, words.fillHelp),
      element("dl", { className: "fill-ends" }, element("dt", {}, words.from), element("dd", {}, ends.from), element("dt", {}, words.to), element("dd", {}, ends.to)),
      add, report,
      group(words.fill, densities.along.element, densities.crown.element, densities.neck.element, gap.element, direction.element),
      group(words.jitter, jitter.element, seed.element));
    const nameOf = (id: number | null) => studio.document.tufts.find((tuft) => tuft.id === id)?.name ?? words.pick;
    const show = () => {
      const { from, to, settings } = plan.value;
      ends.from.value = nameOf(from);
      ends.to.value = to !== null && to === from ? words.ring : nameOf(to);
      for (const one of ["along", "crown", "neck"] as const) densities[one].set(Number(settings.density?.[one] ?? 0));
      gap.set(settings.min_gap ?? 0);
      direction.set(settings.direction ?? "counter_clockwise");
      jitter.set(settings.jitter != null);
      seed.element.hidden = settings.jitter == null;
      seed.set(settings.jitter?.seed ?? 0);
    };
    const showPreview = () => {
      const made = preview.preview.value;
      add.disabled = !made || made.tufts.length === 0;
      add.textContent = made && made.tufts.length === 0 ? words.nothingToAdd : made ? words.add(made.tufts.length) : words.pickBoth;
      report.textContent = made ? words.fillReport(made.report.tufts.along, made.report.tufts.crown, made.report.tufts.neck) : "";
    };
    this.endings = [plan.changed(show), studio.history.current.changed(show), preview.preview.changed(showPreview)];
    show();
    showPreview();
  }

  dispose(): void {
    for (const end of this.endings) end();
  }
}
