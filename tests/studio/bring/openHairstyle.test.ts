import type { Service } from "../../../client-examples/studio/src/api/Service";
import { openHairstyle } from "../../../client-examples/studio/src/bring/openHairstyle";

/** Answers fills with one tuft, and keeps what was asked. */
function fakeService(): { service: Service; asked: { path: string; body: unknown }[] } {
  const asked: { path: string; body: unknown }[] = [];
  const json = (path: string, { body }: { body: unknown }) => {
    asked.push({ path, body });
    const name = (body as { fill?: { name: string } }).fill?.name;
    return Promise.resolve({ tufts: [{ name: `${name}_1`, points: [[0, 0, 0], [0, 1, 0]] }] });
  };
  return { service: { json } as unknown as Service, asked };
}

const kA = { name: "a", points: [[0, 0, 0], [1, 0, 0]] as [number, number, number][] };
const kB = { ...kA, name: "b" };

describe("openHairstyle", () => {
  it("keeps head, scalp, color and tufts", async () => {
    const head = { center: [0, 1, 0] as [number, number, number], scalp: { ellipsoid: { radii: [1, 1, 1] as [number, number, number] } } };
    const document = await openHairstyle(fakeService().service, { head, tufts: [kA], mesh: { color: "#123456" } }, "mine");
    expect(document).toMatchObject({ name: "mine", head, color: "#123456", tufts: [{ ...kA, id: 1 }] });
  });

  it("makes tufts of fills, after the drawn ones and in their order", async () => {
    const { service, asked } = fakeService();
    const document = await openHairstyle(service, { tufts: [kA, kB], fills: [{ from: "a", to: "b", name: "row" }, { from: "b" }, { from: "a", to: "a" }] }, "mine");
    expect(document.tufts.map(({ name }) => name)).toEqual(["a", "b", "row_1", "fill2_1", "fill3_1"]);
    expect(asked.map(({ path }) => path)).toEqual(["/v1/hairstyles", "/v1/fills", "/v1/fills", "/v1/fills"]);
    expect(asked.slice(1).map(({ body }) => (body as { fill: { from: unknown; to: unknown } }).fill)).toMatchObject([{ from: kA, to: kB }, { from: kB, to: null }, { from: kA, to: null }]);
  });

  it("hands on the hairstyle's formulas where a fill has none", async () => {
    const { service, asked } = fakeService();
    await openHairstyle(service, { tufts: [kA, kB], formulas: "as_printed", fills: [{ from: "a", to: "b", formulas: null }, { from: "a", to: "b", formulas: "corrected" }] }, "mine");
    expect(asked.slice(1).map(({ body }) => (body as { fill: { formulas: unknown } }).fill.formulas)).toEqual(["as_printed", "corrected"]);
  });
});
