const en = {
  title: "Gallery",
  close: "Close",
  help: "Hairstyles that were drawn here. Pick one, then change whatever you like; Undo brings back what you had.",
  names: {
    bob: "Short bob",
    hime: "Hime cut",
    twintails: "Twin tails",
    ponytail: "High ponytail",
    spiky: "Spiky cut",
    waves: "Fluffy waves",
  },
  pictures: {
    bob: "Chin-length orange hair with a full, pointed fringe",
    hime: "Long straight violet hair with a straight fringe and side locks cut at the jaw",
    twintails: "Pink hair tied high on both sides into two long tails",
    ponytail: "Golden hair tied high at the back, with two long side locks",
    spiky: "Short blue hair with spikes that stand off the head",
    waves: "Shoulder-length silver waves with one curl that sticks up",
  },
  tufts: (count: number) => `${count} tufts`,
  motion: (period: string, hold: 1 | 2 | 3) => `${period} s on ${{ 1: "ones", 2: "twos", 3: "threes" }[hold]}`,
};

/** Words of the gallery. */
export const galleryText: { readonly en: typeof en; readonly ja: typeof en } = {
  en,
  ja: {
    title: "ギャラリー",
    close: "閉じる",
    help: "このスタジオで描いた髪型です。選ぶと開き、自由に手を加えられます。「元に戻す」で元の髪型に戻ります。",
    names: {
      bob: "ショートボブ",
      hime: "姫カット",
      twintails: "ツインテール",
      ponytail: "ポニーテール",
      spiky: "ツンツンヘア",
      waves: "ふわふわウェーブ",
    },
    pictures: {
      bob: "あごまでのオレンジ色の髪。先のとがった前髪が額を覆う",
      hime: "まっすぐな紫のロングヘア。前髪は一直線、横髪はあごの高さで切りそろえてある",
      twintails: "両側の高い位置で結んだ、長いピンクのツインテール",
      ponytail: "後ろの高い位置で結んだ金髪のポニーテール。両脇に長い横髪",
      spiky: "毛先が外へ跳ねた、青いショートヘア",
      waves: "肩までの銀色のウェーブヘアに、アホ毛が一本",
    },
    tufts: (count) => `${count}房`,
    motion: (period, hold) => `周期${period}秒・${hold}コマ打ち`,
  },
};
