/** A column of an exposure sheet: which cell begins at which frame, both as the sheet has them (frames from 0). */
export interface SheetTrack {
  readonly name: string;
  readonly cells: readonly { readonly frame: number; readonly cell: string }[];
}

interface Frame {
  readonly frame: number;
  readonly data: readonly { readonly values: readonly string[] }[];
}

interface Xdts {
  readonly timeTables: readonly {
    readonly timeTableHeaders: readonly { readonly fieldId: number; readonly names: readonly string[] }[];
    readonly fields: readonly {
      readonly fieldId: number;
      readonly tracks: readonly { readonly trackNo: number; readonly frames: readonly Frame[] }[];
    }[];
  }[];
}

const kFirstLine = "exchangeDigitalTimeSheet Save Data\n";
const kCells = 0;
const kNothing = "SYMBOL_NULL_CELL";

/** The tracks of cells of an XDTS. @throws Error if it is none */
export function readXdts(text: string): SheetTrack[] {
  if (!text.startsWith(kFirstLine)) throw new Error("no XDTS");
  const [table] = (JSON.parse(text.slice(kFirstLine.length)) as Xdts).timeTables;
  const names = table?.timeTableHeaders.find(({ fieldId }) => fieldId === kCells)?.names ?? [];
  const tracks = table?.fields.find(({ fieldId }) => fieldId === kCells)?.tracks ?? [];
  return tracks.map(({ trackNo, frames }) => ({
    name: names[trackNo] ?? "",
    cells: frames.map(({ frame, data }) => ({ frame, cell: data[0]?.values[0] ?? "" })).filter(({ cell }) => cell !== kNothing),
  }));
}
