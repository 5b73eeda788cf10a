const kLongest = 60;

/** What a file of that name can be called on every system; "hair" if nothing is left of it. */
export function fileName(name: string): string {
  const bare = name.normalize("NFC").replace(/[\u0000-\u001f\u007f/\\:*?"<>|]+/g, "_").replace(/\s+/g, " ");
  const short = [...bare].slice(0, kLongest).join("");
  return short.replace(/^[. ]+|[. ]+$/g, "") || "hair";
}
