import schemas from "../../../client-examples/studio/src/api/generated/schemas.json";
import { gallery } from "../../../client-examples/studio/src/gallery/gallery";
import { fromHairstyle } from "../../../client-examples/studio/src/model/fromHairstyle";
import { toHairstyle } from "../../../client-examples/studio/src/model/toHairstyle";
import { galleryText } from "../../../client-examples/studio/src/text/galleryText";

interface Schema {
  readonly $ref?: string;
  readonly properties?: Readonly<Record<string, Schema>>;
  readonly items?: Schema;
  readonly oneOf?: readonly Schema[];
  readonly allOf?: readonly Schema[];
}

const known = schemas as unknown as Readonly<Record<string, Schema>>;
const resolved = (schema: Schema): Schema => (schema.$ref ? resolved(known[schema.$ref.split("/").at(-1)!]!) : schema);
const variants = (schema: Schema): Schema[] => [resolved(schema), ...[...(resolved(schema).oneOf ?? []), ...(resolved(schema).allOf ?? [])].flatMap(variants)];

/** Pointers of the fields of a value that its schema does not name. */
function unknownFields(value: unknown, schema: Schema, pointer = ""): string[] {
  if (typeof value !== "object" || value === null) return [];
  const all = variants(schema);
  if (Array.isArray(value)) {
    const items = all.find((one) => one.items)?.items;
    return items ? value.flatMap((item, i) => unknownFields(item, items, `${pointer}/${i}`)) : [];
  }
  return Object.entries(value).flatMap(([name, field]) => {
    const one = all.find(({ properties }) => properties?.[name])?.properties?.[name];
    return one ? unknownFields(field, one, `${pointer}/${name}`) : [`${pointer}/${name}`];
  });
}

test("Gallery: every name of the words has its hairstyle", () => {
  expect(gallery.map(({ name }) => name).sort()).toEqual(Object.keys(galleryText.en.names).sort());
});

test("Gallery: a field that the contract does not know is found", () => {
  expect(unknownFields({ tufts: [{ points: [], color: "red" }], motion: { phase: { speed: 1 } } }, known["HairstyleRequest"]!)).toEqual(["/tufts/0/color", "/motion/phase/speed"]);
});

describe.each(gallery)("Gallery: $name", ({ name, hairstyle }) => {
  test("has only fields that the contract knows", () => {
    expect(unknownFields(hairstyle, known["HairstyleRequest"]!)).toEqual([]);
  });

  test("has 20 to 120 tufts, each with a name of its own that somebody gave it and a file can keep", () => {
    const names = hairstyle.tufts.map((tuft) => tuft.name);
    expect(names.length).toBeGreaterThanOrEqual(20);
    expect(names.length).toBeLessThanOrEqual(120);
    expect(new Set(names).size).toBe(names.length);
    for (const one of names) expect(one).toMatch(/^(?!tuft)[A-Za-z0-9_]{1,12}$/);
  });

  test("comes back from a document as it was", () => {
    expect(toHairstyle(fromHairstyle(hairstyle, name))).toEqual(hairstyle);
  });
});
