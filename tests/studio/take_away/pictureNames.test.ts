import { pictureNames } from "../../../client-examples/studio/src/take_away/pictureNames";

test("pictures are numbered from 1 with four digits behind the track", () => {
  expect(pictureNames("hair", 2)).toEqual(["hair.0001.png", "hair.0002.png"]);
  expect(pictureNames("hair", 24).at(-1)).toBe("hair.0024.png");
});
