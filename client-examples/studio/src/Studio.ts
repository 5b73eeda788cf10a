import type { Fill, ScalpMesh, Tuft } from "./api/contract";
import { Service } from "./api/Service";
import type { ServiceProblem } from "./api/ServiceProblem";
import { Signal } from "./base/Signal";
import { HairLoader } from "./hair/HairLoader";
import { askForKey } from "./key/askForKey";
import { Doorkeeper } from "./key/Doorkeeper";
import { KeyStore } from "./key/KeyStore";
import { History } from "./model/History";
import { newDocument } from "./model/newDocument";
import type { StudioDocument, StudioTuft } from "./model/StudioDocument";

export const kModes = ["draw", "shape", "fill", "move"] as const;
export type Mode = (typeof kModes)[number];

/** What a new tuft is like, and where strokes go. */
export interface Pen {
  readonly follows: "head" | "plane";
  readonly shape: Omit<Tuft, "points" | "name">;
  /** Whether the other side is drawn along. */
  readonly mirrors: boolean;
}

/** The fill that is being prepared; `from` and `to` are ids, equal for a ring. */
export interface PlannedFill {
  readonly from: number | null;
  readonly to: number | null;
  readonly settings: Omit<Fill, "from" | "to">;
}

const kNewShape = { diameter: 60, widest_at: 45, taper: "sine", section: "ellipse", flatness: 0.55, twist_deg: 0 } as const;

/** All that the page knows: the document with its history, what is selected, and what is shown how. */
export class Studio {
  readonly service = new Service("", new Doorkeeper(new KeyStore(), askForKey));
  readonly history = new History<StudioDocument>(newDocument());
  readonly loader = new HairLoader(this.service);
  readonly mode = new Signal<Mode>("draw");
  /** Ids of the selected tufts, in the order of selection, and the selected point of the only one. */
  readonly selection = new Signal<readonly number[]>([]);
  readonly point = new Signal<number | null>(null);
  readonly pen = new Signal<Pen>({ follows: "head", shape: kNewShape, mirrors: false });
  /** A tuft that is being drawn. */
  readonly drawn = new Signal<Tuft | null>(null);
  readonly plan = new Signal<PlannedFill>({ from: null, to: null, settings: { density: { along: 60, crown: null, neck: null }, jitter: null, direction: "shorter", min_gap: 0.2 } });
  /** Where hair grows on the head that is shown; for fills. */
  readonly scalp = new Signal<ScalpMesh | null>(null);
  readonly isOnion = new Signal(false);
  readonly compares = new Signal(false);
  readonly problem = new Signal<ServiceProblem | null>(null);

  constructor() {
    this.loader.problem.changed((problem) => (this.problem.value = problem));
    for (const signal of [this.history.current, this.mode, this.drawn, this.compares]) signal.changed(() => this.load());
    this.history.current.changed(() => this.dropLostSelection());
  }

  get document(): StudioDocument {
    return this.history.value;
  }

  get selected(): readonly StudioTuft[] {
    return this.selection.value.flatMap((id) => this.document.tufts.find((tuft) => tuft.id === id) ?? []);
  }

  /** Asks for the hair of what is there now. */
  load(): void {
    const moves = this.mode.value === "move";
    this.loader.load({ document: this.document, drawn: this.drawn.value, moves, compares: moves && this.compares.value });
  }

  /** @param merge  see History.change */
  edit(change: (document: StudioDocument) => StudioDocument, merge: string | null = null): void {
    this.history.change(change(this.document), merge);
  }

  select(ids: readonly number[]): void {
    this.point.value = null;
    this.selection.value = ids;
  }

  private dropLostSelection(): void {
    const left = this.selection.value.filter((id) => this.document.tufts.some((tuft) => tuft.id === id));
    if (left.length !== this.selection.value.length) this.select(left);
    const { from, to } = this.plan.value;
    const has = (id: number | null) => this.document.tufts.some((tuft) => tuft.id === id);
    if ((from !== null && !has(from)) || (to !== null && !has(to))) this.plan.value = { ...this.plan.value, from: has(from) ? from : null, to: has(to) ? to : null };
  }
}
