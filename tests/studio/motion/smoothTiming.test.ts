import { smoothTiming } from "../../../client-examples/studio/src/motion/smoothTiming";

/** As the service counts: half a frame rounds up. */
const pictures = ({ period, fps, hold }: ReturnType<typeof smoothTiming>) => Math.ceil(Math.floor(Number(fps) * period! + 0.5 + 1e-9) / hold!);

describe("smoothTiming", () => {
  it.each([0.1, 0.125, 0.45, 0.5, 1, 2.3, 24, 24.4, 24.6, 37, 60])("gives a period of %s s as many pictures as can be had", (period) => {
    const count = pictures(smoothTiming({ period }));
    expect(count).toBeLessThanOrEqual(24);
    expect(count).toBeGreaterThanOrEqual(12);
  });

  it("keeps within the contract at the shortest period", () => {
    expect(smoothTiming({ period: 0.01 })).toEqual({ period: 0.01, fps: 240, hold: 1 });
  });
});
