import { element } from "../base/element";

const kKept_ms = 60_000; // a browser that asks where to put it reads it only then

/** Hands a file to the browser, which keeps it where downloads go. */
export function download(name: string, content: BlobPart, type: string): void {
  const url = URL.createObjectURL(new Blob([content], { type }));
  const link = element("a", { href: url, download: name, hidden: true });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), kKept_ms);
}
