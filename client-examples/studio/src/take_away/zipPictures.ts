import { strToU8, zipSync, type Zippable } from "fflate";

const kDate = new Date(1980, 0, 1); // the first that a zip can tell: equal pictures give equal bytes whenever they are taken

export interface PictureZip {
  /** Of the folder, the sheet and the list. */
  readonly name: string;
  readonly pictures: readonly { readonly name: string; readonly png: Uint8Array }[];
  readonly xdts: string;
  readonly csv: string;
  readonly readme: string;
}

/** One folder with the pictures, and beside them the sheet, where OpenToonz looks for them. PNGs are compressed already. */
export function zipPictures({ name, pictures, xdts, csv, readme }: PictureZip): Uint8Array<ArrayBuffer> {
  const files: Zippable = {};
  for (const { name: file, png } of pictures) files[`${name}/${file}`] = [png, { level: 0 }];
  const texts = { [`${name}.xdts`]: xdts, [`${name}.csv`]: csv, "README.txt": readme };
  for (const [file, text] of Object.entries(texts)) files[`${name}/${file}`] = [strToU8(text), { level: 9 }];
  return zipSync(files, { mtime: kDate });
}
