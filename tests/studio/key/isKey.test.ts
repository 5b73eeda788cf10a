import { isKey } from "../../../client-examples/studio/src/key/isKey";

describe("isKey", () => {
  it.each(["x".repeat(20), "x".repeat(200), "tw_0-9_AZaz!~0123456789"])("takes %s", (text) => expect(isKey(text)).toBe(true));
  it.each(["", "x".repeat(19), "x".repeat(201), `${"x".repeat(20)} x`, `${"x".repeat(20)}\n`, `${"x".repeat(20)}é`])("refuses %j", (text) => expect(isKey(text)).toBe(false));
});
