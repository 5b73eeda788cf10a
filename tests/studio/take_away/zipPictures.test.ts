import { strFromU8, unzipSync } from "fflate";
import { zipPictures } from "../../../client-examples/studio/src/take_away/zipPictures";

const content = {
  name: "前髪", xdts: "sheet", csv: "list", readme: "how",
  pictures: [{ name: "hair.0001.png", png: new Uint8Array([137, 80, 78, 71]) }, { name: "hair.0002.png", png: new Uint8Array([1, 2, 3]) }],
};

test("everything lies in one folder and comes out as it went in", () => {
  const files = unzipSync(zipPictures(content));
  expect(Object.keys(files)).toEqual(["前髪/hair.0001.png", "前髪/hair.0002.png", "前髪/前髪.xdts", "前髪/前髪.csv", "前髪/README.txt"]);
  expect([...files["前髪/hair.0001.png"]!]).toEqual([137, 80, 78, 71]);
  expect(strFromU8(files["前髪/前髪.xdts"]!)).toBe("sheet");
});

test("equal pictures give equal bytes at another time", () => {
  vi.useFakeTimers({ now: new Date(2026, 0, 1) });
  const before = zipPictures(content);
  vi.setSystemTime(new Date(2027, 5, 1));
  expect(zipPictures(content)).toEqual(before);
  vi.useRealTimers();
});
