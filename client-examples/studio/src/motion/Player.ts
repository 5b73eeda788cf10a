import type { Schedule } from "../api/contract";
import { frameRate } from "./frameRate";
import { pictureOfFrame } from "./pictureOfFrame";
import { pictureStep } from "./pictureStep";
import { wrap } from "./wrap";

/** Frames. A frame that is due comes although its time is rounded down; a thousand times below what a clock of a page can tell. */
const kTiny = 1e-6;

/**
 * The clock of playback. It follows real time, so a page that draws late drops frames and never runs slow. Call tick() before
 * each drawing; frame, picture and phase01 belong to the last tick, seek or step, so all that is drawn between two is of one moment.
 */
export class Player {
  readonly #now: () => number;
  #schedule: Schedule | null = null;
  #rate = 24;
  /** Frames since the cycle began, with a fraction, at #since. Without a schedule a cycle is 1 long. */
  #place = 0;
  #since = 0;
  #frame = 0;
  #ticked = -1;
  #playing = false;

  /** @param now  milliseconds that only grow */
  constructor(now: () => number = () => performance.now()) {
    this.#now = now;
    this.#since = now();
  }

  /** 0 to schedule.frames - 1. */
  get frame(): number {
    return this.#frame;
  }

  /** The picture of that frame, from 0. */
  get picture(): number {
    return this.#schedule ? pictureOfFrame(this.#schedule, this.#frame) : 0;
  }

  /** Place in the cycle, 0 up to 1, between the frames too: for motion that is not held. */
  get phase01(): number {
    return this.#place / this.#length;
  }

  get playing(): boolean {
    return this.#playing;
  }

  get schedule(): Schedule | null {
    return this.#schedule;
  }

  /**
   * Takes another sheet and stays at the same part of the cycle.
   * @param schedule  null shows frame 0 and nothing runs until there is one again
   * @throws RangeError if its fps is no frame rate
   */
  setSchedule(schedule: Schedule | null): void {
    const rate = schedule ? frameRate(schedule.fps) : this.#rate;
    this.#advance();
    const part = this.phase01;
    this.#schedule = schedule;
    this.#rate = rate;
    this.#moveTo(part * this.#length);
    this.#ticked = -1;
  }

  play(): void {
    this.#advance();
    this.#playing = true;
  }

  pause(): void {
    this.#advance();
    this.#playing = false;
  }

  toggle(): void {
    if (this.#playing) this.pause();
    else this.play();
  }

  /** Stops, and goes on by whole frames; negative is back. */
  step(frames: number): void {
    this.pause();
    this.#moveTo(this.#frame + frames);
  }

  /** Stops, and goes to the first frame of the next picture (1) or the one before (-1). */
  stepPicture(pictures: number): void {
    this.pause();
    if (this.#schedule) this.#moveTo(pictureStep(this.#schedule, this.#frame, pictures));
  }

  /** Goes to the beginning of a frame, any whole number, and plays on from there if it was playing. */
  seek(frame: number): void {
    this.#since = this.#now();
    this.#moveTo(frame);
  }

  /** Takes the time. @returns whether another frame is to be shown than at the last tick */
  tick(): boolean {
    this.#advance();
    const changed = this.#frame !== this.#ticked;
    this.#ticked = this.#frame;
    return changed;
  }

  get #length(): number {
    return this.#schedule?.frames ?? 1;
  }

  #advance(): void {
    const now = this.#now();
    if (this.#playing && this.#schedule) this.#moveTo(this.#place + ((now - this.#since) / 1000) * this.#rate);
    this.#since = now;
  }

  #moveTo(place: number): void {
    this.#place = wrap(place, this.#length);
    this.#frame = this.#schedule ? wrap(Math.floor(this.#place + kTiny), this.#length) : 0;
  }
}
