const kLongest = 64; // the contract's

/** `wanted`, with a number behind it if it is taken. */
export function uniqueName(wanted: string, taken: Iterable<string>): string {
  const names = new Set(taken);
  const stem = wanted.trim() || "tuft";
  if (!names.has(stem)) return stem.slice(0, kLongest);
  const bare = stem.replace(/_\d+$/, "").slice(0, kLongest - 6);
  for (let number = 2; ; number++) {
    const name = `${bare}_${number}`;
    if (!names.has(name)) return name;
  }
}
