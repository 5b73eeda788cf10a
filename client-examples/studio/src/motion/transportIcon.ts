const kSvg = "http://www.w3.org/2000/svg";

/** Drawn on 20 x 20; "fill" parts are filled, the others are lines. */
const kIcons = {
  first: [["fill", "M4 4h2v12H4z"], ["fill", "M16 4.6v10.8a.8.8 0 0 1-1.3.6L8 10.7a.9.9 0 0 1 0-1.4L14.7 4a.8.8 0 0 1 1.3.6z"]],
  previous: [["line", "M12.5 5 7.5 10l5 5"]],
  play: [["fill", "M6 3.900v12.200a.9.9 0 0 0 1.4.8l9.1-6.100a.95.95 0 0 0 0-1.600L7.4 3.100a.9.9 0 0 0-1.4.8z"]],
  pause: [["fill", "M5.5 4h3v12h-3zM11.5 4h3v12h-3z"]],
  next: [["line", "m7.5 5 5 5-5 5"]],
  // One tuft in three pictures.
  onion: [["faint", "M4.5 3c-2 5-1.5 9.5 0 14"], ["half", "M9 3c-.8 5-.6 9.5 1.8 13.5"], ["line", "M13.5 3c.4 5 1 9 4 12.5"]],
  // The same way, smooth above and in steps below.
  compare: [["line", "M2.5 8.500C6 8.5 7 2.8 10 2.800s4 5.7 7.5 5.7"], ["half", "M2.5 17h4v-4h7v4h4"]],
} as const;

export type TransportIcon = keyof typeof kIcons;

/** A new icon of the transport, in the color of the text around it and unseen by screen readers. */
export function transportIcon(name: TransportIcon): SVGSVGElement {
  const icon = document.createElementNS(kSvg, "svg");
  icon.setAttribute("viewBox", "0 0 20 20");
  icon.setAttribute("aria-hidden", "true");
  for (const [look, way] of kIcons[name]) {
    const path = document.createElementNS(kSvg, "path");
    path.setAttribute("d", way);
    path.setAttribute("class", `icon-${look}`);
    icon.append(path);
  }
  return icon;
}
