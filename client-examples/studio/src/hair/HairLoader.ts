import type { Hairstyle, HairstyleAnswer, Schedule, ScheduleAnswer, Tuft } from "../api/contract";
import type { Service } from "../api/Service";
import { ServiceAway } from "../api/ServiceAway";
import { ServiceProblem } from "../api/ServiceProblem";
import { Newest } from "../base/Newest";
import { Signal } from "../base/Signal";
import type { StudioDocument, StudioTuft } from "../model/StudioDocument";
import { toHairstyle } from "../model/toHairstyle";
import { smoothTiming } from "../motion/smoothTiming";
import { posesOf, type Poses } from "./posesOf";
import { TuftCache } from "./TuftCache";
import type { TuftMesh } from "./TuftMesh";

/** Hair as it can be shown. */
export interface LoadedHair {
  readonly tufts: readonly StudioTuft[];
  readonly meshes: readonly TuftMesh[];
  /** What has no mesh because the service is away. */
  readonly unmeshed: readonly Tuft[];
  /** The pictures of the cycle, and nearly every moment of it; null while nothing moves. */
  readonly limited: Poses | null;
  readonly smooth: Poses | null;
}

export interface Wish {
  readonly document: StudioDocument;
  /** A tuft that is being drawn and is not yet of the document. */
  readonly drawn: Tuft | null;
  readonly moves: boolean;
  readonly compares: boolean;
}

const kNothing: LoadedHair = { tufts: [], meshes: [], unmeshed: [], limited: null, smooth: null };

/** Asks the service for the hair of the newest wish. */
export class HairLoader {
  readonly hair = new Signal<LoadedHair>(kNothing);
  readonly schedule = new Signal<Schedule | null>(null);
  readonly problem = new Signal<ServiceProblem | null>(null);
  readonly cache: TuftCache;
  private readonly newest = new Newest();
  private wish: Wish | null = null;

  constructor(private readonly service: Service) {
    this.cache = new TuftCache(service);
    service.isHere.changed((isHere) => isHere && this.wish && this.load(this.wish));
  }

  load(wish: Wish): void {
    this.wish = wish;
    this.newest.start((signal) => this.answer(wish, signal));
  }

  private async answer(wish: Wish, signal: AbortSignal): Promise<void> {
    const { document } = wish;
    const tufts: readonly StudioTuft[] = wish.drawn ? [...document.tufts, { ...wish.drawn, id: 0 }] : document.tufts;
    try {
      const [meshes, [limited, schedule], [smooth]] = await Promise.all([
        tufts.length > 0 ? this.cache.load(tufts, document.head, signal) : [],
        wish.moves ? this.pictures({ ...document, tufts }, signal) : [null, null],
        wish.moves && wish.compares ? this.pictures(smoothed({ ...document, tufts }), signal) : [null, null],
      ]);
      const posed = (answer: HairstyleAnswer | null): Poses | null => (answer?.pictures ? posesOf(answer.pictures, meshes) : null);
      this.schedule.value = schedule ?? this.schedule.value;
      this.hair.value = { tufts, meshes, unmeshed: [], limited: posed(limited), smooth: posed(smooth) };
      this.problem.value = null;
    } catch (error) {
      if (signal.aborted) throw error;
      if (error instanceof ServiceProblem) this.problem.value = error;
      else if (error instanceof ServiceAway) this.showKnown(tufts, document);
      else throw error;
    }
  }

  /** While the service is away, what was meshed before can still be shown, and of the rest its strokes. */
  private showKnown(tufts: readonly StudioTuft[], { head }: StudioDocument): void {
    const meshes = this.cache.known(tufts, head);
    this.hair.value = {
      tufts: tufts.filter((_, i) => meshes[i] !== null),
      meshes: meshes.filter((mesh) => mesh !== null),
      unmeshed: tufts.filter((_, i) => meshes[i] === null),
      limited: null,
      smooth: null,
    };
  }

  private async pictures(document: StudioDocument, signal: AbortSignal): Promise<[HairstyleAnswer | null, Schedule | null]> {
    if (document.tufts.length === 0) {
      const { schedule } = await this.service.json<ScheduleAnswer>("/v1/schedules", { body: { timing: document.motion.timing }, signal });
      return [null, schedule];
    }
    const { scalp: _, ...head } = document.head; // no pose depends on it
    const body: Hairstyle = { ...toHairstyle(document), head };
    const answer = await this.service.json<HairstyleAnswer>("/v1/hairstyles", { body, query: { format: "json" }, signal });
    return [answer, answer.schedule ?? null];
  }
}

function smoothed(document: StudioDocument): StudioDocument {
  return { ...document, motion: { ...document.motion, timing: smoothTiming(document.motion.timing ?? {}) } };
}
