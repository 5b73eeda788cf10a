import type { App } from "../App";
import { element } from "../base/element";
import type { Part } from "../base/Part";
import { ExposureSheet } from "../motion/ExposureSheet";
import { Transport } from "../motion/Transport";
import { language } from "../text/language";
import { motionText } from "../text/motionText";

const kStill = "(prefers-reduced-motion: reduce)";

/** Playback: its buttons and the exposure sheet, while things move. */
export function timeline({ studio, player, stage }: App): Part & { readonly transport: Transport } {
  const words = motionText[language.value];
  const transport = new Transport(words);
  const sheet = new ExposureSheet(words);
  const show = () => {
    transport.setPlaying(player.playing);
    sheet.showFrame(player.frame);
    stage.viewport.invalidate();
  };
  const after = <Given extends unknown[]>(act: (...given: Given) => void) => (...given: Given) => {
    act(...given);
    show();
  };
  transport.onFirst = after(() => player.seek(0));
  transport.onPrevious = after(() => player.stepPicture(-1));
  transport.onNext = after(() => player.stepPicture(1));
  transport.onToggle = after(() => player.toggle());
  transport.onOnion = (isOn) => (studio.isOnion.value = isOn);
  transport.onCompare = (isOn) => (studio.compares.value = isOn);
  sheet.onSeek = after((frame: number) => player.seek(frame));
  const bar = element("footer", { className: "timeline" }, transport.element, sheet.element);
  const endings = [
    studio.isOnion.follow((isOn) => transport.setOnion(isOn)),
    studio.compares.follow((isOn) => transport.setCompare(isOn)),
    studio.loader.schedule.follow((schedule) => sheet.update(schedule)),
    stage.frame.follow(show),
    studio.mode.follow((mode) => {
      bar.hidden = mode !== "move";
      if (mode !== "move") player.pause();
      else if (!player.playing && !matchMedia(kStill).matches) player.play(); // whoever wishes for less motion starts it by hand
      show();
    }),
    () => sheet.dispose(),
  ];
  return { element: bar, transport, dispose: () => endings.forEach((end) => end()) };
}
