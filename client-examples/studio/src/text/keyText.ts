const en = {
  title: "A key, please",
  why: "This service wants to know who calls. Whoever runs it gave you a key; this tab forgets it when it closes.",
  field: "Key",
  send: "Go on",
  refused: "The service did not accept that key.",
  notAKey: "A key has 20 to 200 letters, digits and signs, and no blanks.",
};

/** Words of the dialog that asks for a key. */
export const keyText: { readonly en: typeof en; readonly ja: typeof en } = {
  en,
  ja: {
    title: "キーの入力",
    why: "このサーバーの利用にはキーが必要です。管理者から受け取ったキーを入力してください。タブを閉じると消去されます。",
    field: "キー",
    send: "続ける",
    refused: "そのキーは受け付けられませんでした。",
    notAKey: "キーは空白を含まない 20～200 文字の英数字・記号です。",
  },
};
