type Rows = readonly (readonly [keys: string, does: string])[];

const en = {
  title: "Help",
  intro: "Draw a few locks of hair, fill the gaps between them, and let them move as a few held pictures. Everything can be undone.",
  parts: [
    ["Draw", [
      ["Press on the head and draw", "a lock in one go; a pen's pressure is its thickness"],
      ["Click on the head, then click on", "a lock point by point, on a plane"],
      ["Enter, double click", "ends it; Esc gives it up; Backspace takes the last point back"],
      ["Violet ball, Shift + arrows", "turn the plane; F turns it to you"],
    ]],
    ["Shape", [
      ["Click, Shift + click", "selects a tuft, several"],
      ["Drag a point, arrow keys on it", "moves it; the root stays on the head"],
      ["Double click on the line", "inserts a point"],
      ["Delete", "removes the selected point, else the tufts"],
      ["Ctrl + D, M", "duplicates, mirrors"],
      ["F2, Alt + ↑ ↓ in the list", "renames, moves"],
    ]],
    ["Fill", [["Click two tufts", "fills the gap between them; one twice makes a ring"]]],
    ["Move", [
      ["Space", "plays and pauses"],
      [", and .", "the picture before, the picture after"],
      ["← → in the sheet", "frame by frame"],
      ["O, C", "onion skin, comparison with smooth motion"],
    ]],
    ["View", [
      ["Drag beside the head, arrow keys", "turn"],
      ["Wheel, two fingers, + −", "zoom"],
      ["Right button, two fingers", "shift"],
    ]],
    ["Everywhere", [
      ["1 2 3 4", "draw, shape, fill, move"],
      ["Ctrl + Z, Ctrl + Shift + Z", "undo, redo"],
      ["Ctrl + O, Ctrl + S", "open, take away"],
      ["?", "this help"],
    ]],
  ] satisfies [string, Rows][] as readonly (readonly [string, Rows])[],
};

/** Words of the help. */
export const helpText: { readonly en: typeof en; readonly ja: typeof en } = {
  en,
  ja: {
    title: "ヘルプ",
    intro: "髪の束を何本か描き、間を補完し、数枚の止め絵として動かします。操作はすべて元に戻せます。",
    parts: [
      ["描く", [
        ["頭の上を押して描く", "一筆で房を描く。筆圧が太さになります"],
        ["頭をクリックし、続けてクリック", "投影面の上に点を置いて描く"],
        ["Enter、ダブルクリック", "完了。Esc で取り消し、Backspace で最後の点を戻す"],
        ["紫の玉、Shift + 矢印キー", "投影面を回転。F で正面向き"],
      ]],
      ["整える", [
        ["クリック、Shift + クリック", "房を選択、複数選択"],
        ["点をドラッグ、点の上で矢印キー", "点を移動。毛根は頭の上に留まります"],
        ["線の上でダブルクリック", "点を追加"],
        ["Delete", "選択した点、なければ房を削除"],
        ["Ctrl + D、M", "複製、左右反転"],
        ["リストで F2、Alt + ↑ ↓", "名前の変更、並べ替え"],
      ]],
      ["補完", [["2 本の房をクリック", "間を補完。同じ房を 2 回で一周"]]],
      ["動かす", [
        ["スペース", "再生と一時停止"],
        [", と .", "前の絵、次の絵"],
        ["シート上で ← →", "1 フレームずつ"],
        ["O、C", "オニオンスキン、なめらかな動きとの比較"],
      ]],
      ["視点", [
        ["頭の外をドラッグ、矢印キー", "回転"],
        ["ホイール、2 本指、+ −", "拡大縮小"],
        ["右ボタン、2 本指", "平行移動"],
      ]],
      ["共通", [
        ["1 2 3 4", "描く、整える、補完、動かす"],
        ["Ctrl + Z、Ctrl + Shift + Z", "元に戻す、やり直し"],
        ["Ctrl + O、Ctrl + S", "開く、書き出し"],
        ["?", "このヘルプ"],
      ]],
    ],
  },
};
