import type { Tuft } from "../api/contract";
import { rangeOf } from "../api/rangeOf";
import { element } from "../base/element";
import type { panelText } from "../text/panelText";
import { choice } from "../widgets/choice";
import { Slider } from "../widgets/Slider";
import type { Fields } from "./Fields";

type Shape = Partial<Omit<Tuft, "points">>;

const kFlat = 0.55; // what "flat" begins with

const valueOf = (shape: Shape, name: "diameter" | "widest_at" | "flatness" | "twist_deg" | "roll_deg" | "joints") => shape[name] ?? rangeOf("Tuft", name).default ?? 0;

/** The shape of a tuft: of new ones, or of those that are selected. */
export class TuftFields {
  readonly element: HTMLElement;
  private readonly sliders: Record<"diameter" | "widest_at" | "flatness" | "twist_deg" | "roll_deg" | "joints", Slider>;
  private readonly section;
  private readonly taper;

  constructor(words: typeof panelText.en, fields: Fields, onChange: (change: Shape, field: string) => void, onSettle: () => void) {
    const slider = (name: keyof TuftFields["sliders"], label: string, more: { unit?: string; hint?: string; track?: { minimum?: number; maximum?: number }; step?: number }) =>
      fields.add(`/tufts/${name}`, new Slider({ label, range: rangeOf("Tuft", name), field: `/tufts/${name}`, ...more, onInput: (value) => onChange({ [name]: value }, name), onSettle }));
    this.sliders = {
      diameter: slider("diameter", words.diameter, { hint: words.hints.diameter, step: 1 }),
      widest_at: slider("widest_at", words.widestAt, { hint: words.hints.widestAt, step: 1 }),
      flatness: slider("flatness", words.flatness, { hint: words.hints.flatness }),
      twist_deg: slider("twist_deg", words.twist, { unit: "°", hint: words.hints.twist, track: { minimum: -360, maximum: 360 }, step: 1 }),
      roll_deg: slider("roll_deg", words.roll, { unit: "°", hint: words.hints.roll, track: { minimum: -180, maximum: 180 }, step: 1 }),
      joints: slider("joints", words.joints, { hint: words.hints.joints, track: { maximum: 16 } }),
    };
    this.section = choice(words.section, [["circle", words.circle], ["ellipse", words.ellipse]], (section) => {
      onChange({ section, flatness: section === "circle" ? 0 : kFlat }, "section");
      onSettle();
    });
    this.taper = choice(words.taper, (["sine", "linear", "smooth", "round"] as const).map((taper) => [taper, words.tapers[taper]] as const), (taper) => {
      onChange({ taper }, "taper");
      onSettle();
    });
    const { diameter, widest_at, flatness, twist_deg, roll_deg, joints } = this.sliders;
    this.element = element("div", { className: "tuft-fields" }, diameter.element, widest_at.element, this.section.element, flatness.element, this.taper.element, twist_deg.element, roll_deg.element, joints.element);
  }

  set(shape: Shape): void {
    for (const [name, slider] of Object.entries(this.sliders)) slider.set(valueOf(shape, name as keyof TuftFields["sliders"]));
    const section = shape.section ?? "circle";
    this.section.set(section);
    this.sliders.flatness.isEnabled = section === "ellipse";
    this.taper.set(shape.taper ?? "sine");
  }
}
