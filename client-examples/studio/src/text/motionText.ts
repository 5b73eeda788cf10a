import type { WaveSummary } from "../motion/WaveSummary";

const percent = (share: number) => `${Math.round(100 * share)}%`;

/** Says how far something is above or below, unless it is neither by half a percent. */
const offset = (share: number, say: (much: string, above: boolean) => string) =>
  Math.abs(share) < 0.005 ? "" : say(percent(Math.abs(share)), share > 0);

const en = {
  plot: {
    root: "root",
    tip: "tip",
    wave: "wave now",
    hair: "hair in each picture, faint to strong",
    path: "path of the tip",
    straight: (pictures: number) => `The hair lies still along a straight line, ${pictures === 1 ? "1 picture" : `${pictures} pictures`}.`,
    label: (wave: WaveSummary) =>
      `A wave of ${wave.wavelength.toFixed(1)} hair lengths runs ${wave.toTip ? "from root to tip" : "from tip to root"}. ` +
      `The tip swings over ${percent(wave.swing)} of the hair's length` +
      `${offset(wave.rise, (much, above) => ` about a middle ${much} ${above ? "above" : "below"} the straight line`)}. ` +
      `${wave.pictures === 1 ? "1 picture" : `${wave.pictures} pictures`}, number ${wave.picture + 1} shown.`,
  },
  sheet: {
    title: "Exposure sheet",
    frame: "Frame",
    picture: "Picture",
    empty: "No timing yet.",
    position: (frame: number, frames: number, picture: number) => `frame ${frame} of ${frames}, picture ${picture}`,
    fps: (fps: string) => `${fps} fps`,
    frames: (frames: number) => (frames === 1 ? "1 frame" : `${frames} frames`),
    pictures: (pictures: number) => (pictures === 1 ? "1 picture" : `${pictures} pictures`),
    period: (seconds: string) => `${seconds} s a cycle`,
    requested: (seconds: string) => `${seconds} s asked`,
  },
  transport: {
    title: "Playback",
    first: "First frame",
    previous: "Previous picture",
    play: "Play",
    pause: "Pause",
    next: "Next picture",
    onion: "Onion skin",
    compare: "Compare with smooth",
    withKey: (name: string, key: string) => `${name} (${key})`,
    keys: { home: "Home", space: "Space" },
  },
};

const ja: typeof en = {
  plot: {
    root: "根元",
    tip: "毛先",
    wave: "いまの波",
    hair: "各作画の毛の線（淡→濃）",
    path: "毛先の軌跡",
    straight: (pictures) => `毛はまっすぐのまま動きません。作画枚数${pictures}。`,
    label: (wave) =>
      `波は${wave.toTip ? "根元から毛先へ" : "毛先から根元へ"}進み、` +
      `波長は毛の長さの${wave.wavelength.toFixed(1)}倍です。` +
      `毛先の揺れ幅は毛の長さの${percent(wave.swing)}` +
      `${offset(wave.rise, (much, above) => `、揺れの中心はまっすぐな線より${much}${above ? "上" : "下"}`)}です。` +
      `作画枚数${wave.pictures}、表示中は${wave.picture + 1}枚目。`,
  },
  sheet: {
    title: "タイムシート",
    frame: "コマ",
    picture: "作画",
    empty: "タイミングがまだありません。",
    position: (frame, frames, picture) => `${frames}コマ中${frame}コマ目、作画${picture}`,
    fps: (fps) => `${fps} fps`,
    frames: (frames) => `${frames}コマ`,
    pictures: (pictures) => `作画枚数 ${pictures}`,
    period: (seconds) => `周期 ${seconds}秒`,
    requested: (seconds) => `指定 ${seconds}秒`,
  },
  transport: {
    title: "再生",
    first: "最初のコマへ",
    previous: "前の作画へ",
    play: "再生",
    pause: "一時停止",
    next: "次の作画へ",
    onion: "オニオンスキン",
    compare: "なめらかな動きと比較",
    withKey: (name, key) => `${name}（${key}）`,
    keys: { home: "Home", space: "スペース" },
  },
};

/** The words of the motion widgets. Frames and pictures in them count from 1, as on paper. */
export const motionText = { en, ja };
