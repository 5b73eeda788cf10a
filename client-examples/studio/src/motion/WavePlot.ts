import type { Schedule, Timing, Wave } from "../api/contract";
import type { motionText } from "../text/motionText";
import { drawWave } from "./drawWave";
import { make } from "./make";
import "./motion.css";
import { picturePhases } from "./picturePhases";
import { WaveShape } from "./WaveShape";

/** As many bones as make a hair look like what it is, a line. */
const kSegments = 20;

export interface WavePlotState {
  readonly wave: Required<Wave>;
  readonly schedule: Schedule;
  /** The picture now shown, from 0. */
  readonly picture: number;
  readonly sampling?: Timing["sampling"];
  /** Waves per loop, 1 if left out. */
  readonly cycles?: number;
}

/**
 * The live plot of equation (1), with the hair of every picture and the path of its tip.
 * It fills the width of its container and draws itself again when that or the page's colors change; dispose() ends this.
 */
export class WavePlot {
  readonly element: HTMLElement;
  readonly #words: typeof motionText.en.plot;
  readonly #canvas = make("canvas", "");
  readonly #area = make("div", "wave-plot-area", this.#canvas);
  readonly #keys: Readonly<Record<"wave" | "hair" | "path", HTMLElement>>;
  readonly #resized: ResizeObserver;
  readonly #rethemed: MutationObserver;
  readonly #dark = matchMedia("(prefers-color-scheme: dark)");
  readonly #redraw = () => this.#requestDrawing();
  #state: WavePlotState | null = null;
  #shape: WaveShape | null = null;
  #shapeKey = "";
  #request = 0;

  constructor(words: typeof motionText.en) {
    this.#words = words.plot;
    const key = (name: "wave" | "hair" | "path") => make("span", `wave-plot-key ${name}`);
    this.#keys = { wave: key("wave"), hair: key("hair"), path: key("path") };
    const entry = (name: "wave" | "hair" | "path") => make("span", "wave-plot-entry", this.#keys[name], this.#words[name]);
    this.element = make("figure", "motion wave-plot", this.#area, make("figcaption", "", entry("wave"), entry("hair"), entry("path")));
    this.#canvas.setAttribute("role", "img");
    this.#resized = new ResizeObserver(this.#redraw);
    this.#resized.observe(this.#area);
    this.#rethemed = new MutationObserver(this.#redraw);
    this.#rethemed.observe(document.documentElement, { attributes: true });
    this.#dark.addEventListener("change", this.#redraw);
  }

  /** Shows another wave, schedule or picture; what has not changed costs nothing. */
  update(state: WavePlotState): void {
    this.#state = state;
    const { wave, schedule, picture, sampling, cycles } = state;
    const key = JSON.stringify([wave, schedule.starts, schedule.frames, sampling, cycles]);
    if (key !== this.#shapeKey) this.#shape = new WaveShape(wave, picturePhases(schedule, sampling, cycles), kSegments);
    this.#shapeKey = key;
    this.#canvas.setAttribute("aria-label", this.#label(wave, schedule, picture));
    this.#requestDrawing();
  }

  dispose(): void {
    cancelAnimationFrame(this.#request);
    this.#resized.disconnect();
    this.#rethemed.disconnect();
    this.#dark.removeEventListener("change", this.#redraw);
  }

  #label(wave: Required<Wave>, { pictures }: Schedule, picture: number): string {
    if (wave.amplitude === 0 || !this.#shape) return this.#words.straight(pictures);
    const { tipTop, tipBottom } = this.#shape;
    return this.#words.label({
      toTip: wave.spatial_period > 0,
      wavelength: 2 * Math.abs(wave.spatial_period),
      swing: (tipTop - tipBottom) / Math.PI,
      rise: (tipTop + tipBottom) / 2 / Math.PI,
      pictures,
      picture,
    });
  }

  /** Many causes, one drawing. */
  #requestDrawing(): void {
    this.#request ||= requestAnimationFrame(() => this.#draw());
  }

  #draw(): void {
    this.#request = 0;
    const context = this.#canvas.getContext("2d");
    const [width, height] = [this.#area.clientWidth, this.#area.clientHeight];
    if (!context || !this.#state || !this.#shape || width === 0 || height === 0) return;
    const density = devicePixelRatio;
    const [columns, rows] = [Math.round(width * density), Math.round(height * density)];
    if (this.#canvas.width !== columns) this.#canvas.width = columns;
    if (this.#canvas.height !== rows) this.#canvas.height = rows;
    context.setTransform(density, 0, 0, density, 0, 0);
    // The colors are those of the legend's keys: custom properties alone would come as written, functions unresolved.
    const color = (key: HTMLElement) => getComputedStyle(key).color;
    drawWave(context, [width, height], this.#shape, this.#state.picture, {
      accent: color(this.#keys.wave),
      ink: color(this.#keys.hair),
      soft: color(this.#keys.path),
      paper: getComputedStyle(this.#area).backgroundColor,
      font: `11px ${getComputedStyle(this.element).fontFamily}`,
      root: this.#words.root,
      tip: this.#words.tip,
    });
  }
}
