const kDigits = 4;

/**
 * Files of the pictures of a track, from 1: "hair.0001.png". With a dot and four digits OpenToonz takes them for one level, "hair", and
 * finds it by itself beside the sheet, since it looks there for a level with the name of the track; TVPaint and After Effects read
 * them as a sequence. CLIP STUDIO goes by the names of cels, which there are the numbers alone: no file name suits both.
 */
export function pictureNames(track: string, pictures: number): string[] {
  return Array.from({ length: pictures }, (_, i) => `${track}.${String(i + 1).padStart(kDigits, "0")}.png`);
}
