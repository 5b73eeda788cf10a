import { Service } from "../../../client-examples/studio/src/api/Service";
import { ServiceAway } from "../../../client-examples/studio/src/api/ServiceAway";
import { Doorkeeper } from "../../../client-examples/studio/src/key/Doorkeeper";
import { ServiceProblem } from "../../../client-examples/studio/src/api/ServiceProblem";

const problem = { type: "urn:tuftwave:problem:out_of_range", title: "t", status: 422, detail: "d", request_id: "1", errors: [{ code: "out_of_range", pointer: "/tufts/0/diameter", detail: "too large" }] };
const answers = (...list: (Response | Error)[]) => {
  const fetched = vi.fn(async (..._: Parameters<typeof fetch>) => {
    const next = list.shift() ?? new Error("no more answers");
    if (next instanceof Error) throw next;
    return next;
  });
  vi.stubGlobal("fetch", fetched);
  return fetched;
};

describe("Service", () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
  });

  it("posts JSON as JSON and a file as it is, with the query", async () => {
    const fetched = answers(Response.json({ ok: 1 }), Response.json({ ok: 2 }));
    const service = new Service("http://service");
    expect(await service.json("/v1/fills", { body: { a: 1 }, query: { format: "json" } })).toEqual({ ok: 1 });
    await service.json("/v1/characters/chains", { body: new ArrayBuffer(8) });
    expect(fetched.mock.calls[0]).toMatchObject(["http://service/v1/fills?format=json", { body: '{"a":1}', headers: { "Content-Type": "application/json" } }]);
    expect(fetched.mock.calls[1]![1]).toMatchObject({ headers: { "Content-Type": "application/octet-stream" } });
    expect(fetched.mock.calls[1]![1]!.body).toBeInstanceOf(ArrayBuffer);
  });

  it("throws a problem with its fields, and is still here", async () => {
    answers(new Response(JSON.stringify(problem), { status: 422, headers: { "Content-Type": "application/problem+json" } }));
    const service = new Service();
    const error = await service.json("/v1/tufts", { body: {} }).catch((one: unknown) => one);
    expect(error).toBeInstanceOf(ServiceProblem);
    expect((error as ServiceProblem).fields[0]!.pointer).toBe("/tufts/0/diameter");
    expect(service.isHere.value).toBe(true);
  });

  it.each([["nobody answers", new TypeError("failed to fetch")], ["a proxy answers for it", new Response("<h1>502</h1>", { status: 502 })]])("is away when %s, and asks until it is back", async (_, answer) => {
    answers(answer, new TypeError("still away"), Response.json({ name: "tuftwave" }));
    const service = new Service();
    await expect(service.json("/v1/tufts", { body: {} })).rejects.toBeInstanceOf(ServiceAway);
    expect(service.isHere.value).toBe(false);
    await vi.advanceTimersByTimeAsync(1500);
    expect(service.isHere.value).toBe(false);
    await vi.advanceTimersByTimeAsync(1500);
    expect(service.isHere.value).toBe(true);
  });

  it("is not away when the page itself gave up", async () => {
    const controller = new AbortController();
    controller.abort();
    answers(new DOMException("", "AbortError"));
    const service = new Service();
    await expect(service.json("/v1/tufts", { body: {}, signal: controller.signal })).rejects.toThrow(DOMException);
    expect(service.isHere.value).toBe(true);
  });

  const refusal = () => new Response(JSON.stringify({ ...problem, type: "urn:tuftwave:problem:unauthorized", status: 401, errors: undefined }), { status: 401, headers: { "Content-Type": "application/problem+json" } });
  const keysOf = (fetched: ReturnType<typeof answers>) => fetched.mock.calls.map(([, init]) => (init!.headers as Record<string, string>).Authorization);

  it("asks for a key when it needs one, again when that is refused, and sends it from then on", async () => {
    const fetched = answers(refusal(), refusal(), Response.json({ ok: 1 }), Response.json({ ok: 2 }));
    const ask = vi.fn().mockResolvedValueOnce("wrong").mockResolvedValueOnce("right");
    const service = new Service("", new Doorkeeper({ value: null }, ask));
    expect(await service.json("/v1/tufts", { body: {} })).toEqual({ ok: 1 });
    expect(await service.json("/v1/tufts", { body: {} })).toEqual({ ok: 2 });
    expect(ask.mock.calls).toEqual([[false], [true]]);
    expect(keysOf(fetched)).toEqual([undefined, "Bearer wrong", "Bearer right", "Bearer right"]);
  });

  it("throws the problem when nobody gives a key, and is still here", async () => {
    answers(refusal());
    const service = new Service("", new Doorkeeper({ value: null }, async () => null));
    await expect(service.json("/v1/tufts", { body: {} })).rejects.toBeInstanceOf(ServiceProblem);
    expect(service.isHere.value).toBe(true);
  });

  it("is back when it asks for a key", async () => {
    answers(new TypeError("away"), refusal());
    const service = new Service();
    await expect(service.json("/v1/tufts", { body: {} })).rejects.toBeInstanceOf(ServiceAway);
    await vi.advanceTimersByTimeAsync(1500);
    expect(service.isHere.value).toBe(true);
  });
});
