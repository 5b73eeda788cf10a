import type { Schedule } from "../../../client-examples/studio/src/api/contract";

/** Three frames in two pictures: the smallest with a hold and a short one. */
export const schedule: Schedule = { frames: 3, pictures: 2, holds: [2, 1], starts: [0, 2], fps: 24, requested_period: 0.125, period: 0.125 };

/** Its XDTS as the service writes it, or one that differs. */
export function xdts({ name = "hair", cells = [[0, "1"], [2, "2"]] as readonly (readonly [number, string])[] } = {}): string {
  const frames = [...cells, [3, "SYMBOL_NULL_CELL"] as const].map(([frame, value]) => ({ frame, data: [{ id: 0, values: [value] }] }));
  const table = { name, duration: 3, timeTableHeaders: [{ fieldId: 0, names: [name] }], fields: [{ fieldId: 0, tracks: [{ trackNo: 0, frames }] }] };
  return `exchangeDigitalTimeSheet Save Data\n${JSON.stringify({ timeTables: [table], version: 5 })}`;
}
