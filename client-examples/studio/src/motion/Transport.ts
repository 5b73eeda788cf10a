import type { motionText } from "../text/motionText";
import { make } from "./make";
import "./motion.css";
import { type TransportIcon, transportIcon } from "./transportIcon";

type Words = typeof motionText.en.transport;

/** The keys of each action, as KeyboardEvent.key. */
const kKeys = { first: "Home", previous: ",", play: " ", next: ".", onion: "o", compare: "c" } as const;

type Action = keyof typeof kKeys;

/** How a key is written in a tooltip. */
function keyName(key: string, words: Words): string {
  if (key === " ") return words.keys.space;
  return key === "Home" ? words.keys.home : key.toUpperCase();
}

/** The buttons of playback. They only report; whoever listens tells by setPlaying, setOnion and setCompare what is so now. */
export class Transport {
  readonly element: HTMLElement;
  onFirst: () => void = () => {};
  onPrevious: () => void = () => {};
  onToggle: () => void = () => {};
  onNext: () => void = () => {};
  /** Called with what is wished. */
  onOnion: (on: boolean) => void = () => {};
  onCompare: (on: boolean) => void = () => {};
  readonly #words: Words;
  readonly #buttons: Readonly<Record<Action, HTMLButtonElement>>;
  #playing = false;

  constructor(words: typeof motionText.en) {
    this.#words = words.transport;
    const { first, previous, play, next, onion, compare } = this.#words;
    this.#buttons = {
      first: this.#button("first", first),
      previous: this.#button("previous", previous),
      play: this.#button("play", play),
      next: this.#button("next", next),
      onion: this.#button("onion", onion),
      compare: this.#button("compare", compare),
    };
    // Switches keep their name in sight: their pictures alone are hard to guess.
    this.#buttons.onion.append(make("span", "", onion));
    this.#buttons.compare.append(make("span", "", compare));
    const { first: a, previous: b, play: c, next: d, onion: e, compare: f } = this.#buttons;
    this.element = make("div", "motion transport", make("div", "transport-group", a, b, c, d), make("div", "transport-group", e, f));
    this.element.setAttribute("role", "group");
    this.element.ariaLabel = this.#words.title;
    this.setOnion(false);
    this.setCompare(false);
  }

  setPlaying(playing: boolean): void {
    if (playing === this.#playing) return;
    this.#playing = playing;
    const button = this.#buttons.play;
    button.replaceChildren(transportIcon(playing ? "pause" : "play"));
    this.#name(button, playing ? this.#words.pause : this.#words.play, kKeys.play);
  }

  setOnion(on: boolean): void {
    this.#buttons.onion.ariaPressed = String(on);
  }

  setCompare(on: boolean): void {
    this.#buttons.compare.ariaPressed = String(on);
  }

  /** Without hair or timing there is nothing to play. */
  setEnabled(enabled: boolean): void {
    for (const button of Object.values(this.#buttons)) button.disabled = !enabled;
  }

  /**
   * Does what the tooltips promise, for keys pressed anywhere on the page.
   * @returns whether the key was one of the transport's; then the page should prevent its default
   */
  handleKey(event: KeyboardEvent): boolean {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey || this.#buttons.play.disabled) return false;
    // Fields take all keys, and whatever can be pressed takes its own space.
    const own = `input, select, textarea, [contenteditable]${event.key === " " ? ", button, a, summary" : ""}`;
    if (event.target instanceof Element && event.target.closest(own)) return false;
    const action = (Object.keys(kKeys) as Action[]).find((name) => kKeys[name].toLowerCase() === event.key.toLowerCase());
    if (action) this.#act(action);
    return action !== undefined;
  }

  #act(action: Action): void {
    const pressed = (name: "onion" | "compare") => this.#buttons[name].ariaPressed === "true";
    if (action === "first") this.onFirst();
    else if (action === "previous") this.onPrevious();
    else if (action === "play") this.onToggle();
    else if (action === "next") this.onNext();
    else if (action === "onion") this.onOnion(!pressed("onion"));
    else this.onCompare(!pressed("compare"));
  }

  #button(action: Action & TransportIcon, name: string): HTMLButtonElement {
    const button = make("button", `transport-button ${action}`, transportIcon(action));
    button.type = "button";
    button.addEventListener("click", () => this.#act(action));
    this.#name(button, name, kKeys[action]);
    return button;
  }

  #name(button: HTMLButtonElement, name: string, key: string): void {
    button.ariaLabel = name;
    button.title = this.#words.withKey(name, keyName(key, this.#words));
    button.setAttribute("aria-keyshortcuts", key === " " ? "Space" : key);
  }
}
