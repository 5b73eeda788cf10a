import { element } from "../base/element";

const kFree_ms = 10_000; // a browser asks the person first, and reads then

/** Hands a file to the browser's downloads. */
export function downloadBytes(bytes: ArrayBuffer, name: string): void {
  const url = URL.createObjectURL(new Blob([bytes], { type: "application/octet-stream" }));
  element("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), kFree_ms);
}
