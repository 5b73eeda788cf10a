import { addTufts } from "../../../client-examples/studio/src/model/addTufts";
import { newDocument } from "../../../client-examples/studio/src/model/newDocument";
import { toHairstyle } from "../../../client-examples/studio/src/model/toHairstyle";
import { hairstyleFile } from "../../../client-examples/studio/src/take_away/hairstyleFile";

// A name that looks like a list, since those are rewritten.
const document = addTufts(newDocument(), [{ name: "[ 1, 2 ]\n[\n3\n]", points: [[0, 0.1, 0], [0, 0.05, 0.123456]], diameter: 60 }]);

test("the file is the document as the service takes it", () => {
  expect(JSON.parse(hairstyleFile(document))).toEqual(toHairstyle(document));
});

test("a point has one line", () => {
  expect(hairstyleFile(document)).toContain("\n        [0, 0.05, 0.123456]\n");
});
