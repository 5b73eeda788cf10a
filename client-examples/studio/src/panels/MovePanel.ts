import type { Motion, Phasing, Timing, Wave } from "../api/contract";
import { rangeOf } from "../api/rangeOf";
import { element } from "../base/element";
import type { Part } from "../base/Part";
import type { Signal } from "../base/Signal";
import { WavePlot } from "../motion/WavePlot";
import type { Studio } from "../Studio";
import { motionText } from "../text/motionText";
import { language } from "../text/language";
import type { panelText } from "../text/panelText";
import { choice } from "../widgets/choice";
import { group } from "../widgets/group";
import { seedField } from "../widgets/seedField";
import { Slider, type SliderOptions } from "../widgets/Slider";
import { toggle } from "../widgets/toggle";
import type { Fields } from "./Fields";

const kRates = ["24", "24000/1001", "25", "30", "30000/1001", "48", "60", "12"] as const;
const kGust = 0.8; // metres, when it is switched on

/** The wave, its timing and how it is laid on the hair. */
export class MovePanel implements Part {
  readonly element: HTMLElement;
  private readonly endings: (() => void)[];

  constructor(private readonly studio: Studio, private readonly picture: Signal<number>, private readonly words: typeof panelText.en, private readonly fields: Fields) {
    const plot = new WavePlot(motionText[language.value]);
    const waves = this.waveSliders();
    const period = this.slider({ label: words.period, unit: "s", range: rangeOf("Period"), track: { minimum: 0.1, maximum: 2 }, field: "/motion/timing/period" }, (value) => this.setTiming({ period: value }, "period"));
    const fps = element("select", { onchange: () => this.setTiming({ fps: fps.value.includes("/") ? fps.value : Number(fps.value) }) },
      ...kRates.map((rate) => element("option", { value: rate }, rate)));
    const hold = choice(words.hold, (["1", "2", "3"] as const).map((one) => [one, words.holds[one]] as const), (value) => this.setTiming({ hold: Number(value) }));
    const shortHolds = choice(words.shortHolds, (["last", "spread"] as const).map((one) => [one, words.shortHoldsAt[one]] as const), (value) => this.setTiming({ short_holds: value }));
    const mode = choice(words.mode, (["relative", "absolute"] as const).map((one) => [one, words.modes[one]] as const), (value) => this.set({ mode: value, one_sided: false }));
    const oneSided = toggle(words.oneSided, (value) => this.set({ one_sided: value }));
    const lift = this.slider({ label: words.lift, range: rangeOf("Motion", "lift"), field: "/motion/lift" }, (value) => this.set({ lift: value }, "lift"));
    const spread = this.slider({ label: words.spread, range: rangeOf("Phasing", "spread"), field: "/motion/phase/spread" }, (value) => this.setPhase({ spread: value }, "spread"));
    const gustOn = toggle(words.gustOn, (value) => this.setPhase({ gust_wavelength: value ? kGust : null }));
    const gust = this.slider({ label: words.gust, unit: "m", range: rangeOf("Phasing", "gust_wavelength"), track: { minimum: 0.1, maximum: 3 }, field: "/motion/phase/gust_wavelength" }, (value) => this.setPhase({ gust_wavelength: value }, "gust"));
    const stepped = toggle(words.stepped, (value) => this.setPhase({ step: value ? "picture" : "free" }));
    const seed = seedField(words.seed, words.dice, (value) => this.setPhase({ seed: value }));
    this.element = element("div", { className: "panel-body" },
      group(words.wave, plot.element, ...Object.values(waves).map((slider) => slider.element)),
      group(words.timing, period.element, hold.element, element("label", { className: "select" }, element("span", {}, words.fps), fps), shortHolds.element),
      group(words.wind, element("p", { className: "help" }, words.windHelp), mode.element, oneSided.element, lift.element),
      group(words.phase, spread.element, seed.element, gustOn.element, gust.element, stepped.element));

    const show = () => {
      const { wave = {}, timing = {}, phase = {}, ...motion } = studio.document.motion;
      for (const [name, slider] of Object.entries(waves)) slider.set(wave[name as keyof Wave] ?? rangeOf("Wave", name).default ?? 0);
      period.set(timing.period ?? rangeOf("Period").default ?? 0);
      const rate = String(timing.fps ?? 24);
      if (![...fps.options].some(({ value }) => value === rate)) fps.append(element("option", { value: rate }, rate));
      fps.value = rate;
      hold.set(String(timing.hold ?? 2) as "1" | "2" | "3");
      shortHolds.set(timing.short_holds ?? "last");
      const isRelative = (motion.mode ?? "relative") === "relative";
      mode.set(motion.mode ?? "relative");
      oneSided.set(motion.one_sided ?? false);
      oneSided.element.hidden = !isRelative;
      lift.set(motion.lift ?? (isRelative ? 0 : 1));
      spread.set(phase.spread ?? 0);
      gustOn.set(phase.gust_wavelength != null);
      gust.element.hidden = phase.gust_wavelength == null;
      gust.set(phase.gust_wavelength ?? kGust);
      stepped.set(phase.step === "picture");
      seed.set(phase.seed ?? 0);
      this.showPlot(plot);
    };
    this.endings = [studio.history.current.changed(show), studio.loader.schedule.changed(show), picture.changed(() => this.showPlot(plot)), () => plot.dispose()];
    show();
  }

  dispose(): void {
    for (const end of this.endings) end();
  }

  private showPlot(plot: WavePlot): void {
    const wave = this.studio.document.motion.wave ?? {};
    const of = (name: keyof Wave) => wave[name] ?? rangeOf("Wave", name).default!;
    const full = { amplitude: of("amplitude"), spatial_period: of("spatial_period"), lightness: of("lightness"), tip_exponent: of("tip_exponent") };
    const schedule = this.studio.loader.schedule.value;
    if (schedule) plot.update({ wave: full, schedule, picture: this.picture.value });
  }

  private waveSliders(): Record<keyof Wave, Slider> {
    const slider = (name: keyof Wave, label: string, hint: string, minimum: number, maximum: number) =>
      this.slider({ label, hint, range: rangeOf("Wave", name), track: { minimum, maximum }, field: `/motion/wave/${name}` }, (value) => this.set({ wave: { ...this.studio.document.motion.wave, [name]: value } }, name));
    const { words } = this;
    return {
      amplitude: slider("amplitude", words.amplitude, words.waveHints.amplitude, 0, 1.5),
      spatial_period: slider("spatial_period", words.spatialPeriod, words.waveHints.spatialPeriod, -3, 3),
      lightness: slider("lightness", words.lightness, words.waveHints.lightness, 0.3, 4),
      tip_exponent: slider("tip_exponent", words.tipExponent, words.waveHints.tipExponent, 0.05, 4),
    };
  }

  private slider(options: Omit<SliderOptions, "onInput" | "onSettle">, onInput: (value: number) => void): Slider {
    return this.fields.add(options.field, new Slider({ ...options, onInput, onSettle: () => this.studio.history.settle() }));
  }

  private set(change: Partial<Motion>, merge: string | null = null): void {
    this.studio.edit((document) => ({ ...document, motion: { ...document.motion, ...change } }), merge);
  }

  private setTiming(change: Partial<Timing>, merge: string | null = null): void {
    this.set({ timing: { ...this.studio.document.motion.timing, ...change } }, merge);
  }

  private setPhase(change: Partial<Phasing>, merge: string | null = null): void {
    this.set({ phase: { ...this.studio.document.motion.phase, ...change } }, merge);
  }
}
