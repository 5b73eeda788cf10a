const en = {
  picture: "The head. Draw on it; drag beside it to turn; arrow keys turn, plus and minus zoom",
  root: "Root",
  point: (number: number) => `Point ${number}`,
  planeHandle: "Drawing plane: drag, or arrow keys, to turn it",
  windHandle: "Wind: drag, or arrow keys, to turn it",
};

/** Words of the picture and of what one takes hold of in it. */
export const stageText: { readonly en: typeof en; readonly ja: typeof en } = {
  en,
  ja: {
    picture: "頭部。ここに描きます。外側をドラッグすると回転、矢印キーで回転、プラスとマイナスで拡大縮小",
    root: "毛根",
    point: (number) => `制御点 ${number}`,
    planeHandle: "投影面：ドラッグまたは矢印キーで回転",
    windHandle: "風向き：ドラッグまたは矢印キーで回転",
  },
};
