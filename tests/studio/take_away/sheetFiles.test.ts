import { sheetFiles } from "../../../client-examples/studio/src/take_away/sheetFiles";
import { schedule, xdts } from "./sheets";

test("each frame names the file that it shows", () => {
  const { track, pictures, csv } = sheetFiles(xdts(), schedule);
  expect(track).toBe("hair");
  expect(pictures).toEqual(["hair.0001.png", "hair.0002.png"]);
  expect(csv).toBe("frame,picture,key,file\r\n1,1,1,hair.0001.png\r\n2,1,0,hair.0001.png\r\n3,2,1,hair.0002.png\r\n");
});

test("files are named after the track", () => {
  expect(sheetFiles(xdts({ name: "fringe" }), schedule).pictures[0]).toBe("fringe.0001.png");
});

test.each([
  ["is no XDTS", "frame,picture,key\r\n"],
  ["has another number", xdts({ cells: [[0, "1"], [2, "3"]] })],
  ["changes at another frame", xdts({ cells: [[0, "1"], [1, "2"]] })],
  ["has a picture less", xdts({ cells: [[0, "1"]] })],
])("a sheet that %s is refused", (_, text) => expect(() => sheetFiles(text, schedule)).toThrow());
