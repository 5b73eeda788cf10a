const kIcons = {
  draw: "M4 20c5-1 4-7 8-9s5-4 8-8M4 20l1-4",
  shape: "M4 18C8 6 14 16 20 5M4 18m-2 0a2 2 0 1 0 4 0a2 2 0 1 0-4 0M20 5m-2 0a2 2 0 1 0 4 0a2 2 0 1 0-4 0M12 11m-2 0a2 2 0 1 0 4 0a2 2 0 1 0-4 0",
  fill: "M4 20C4 12 5 7 9 4M20 20c0-8-1-13-5-16M9 20c0-6 0-10 2-14M15 20c0-6 0-10-2-14",
  move: "M3 8c4-4 6 4 10 0s5-2 8-1M3 16c4-4 6 4 10 0s5-2 8-1",
  undo: "M8 5L4 9l4 4M4 9h10a5 5 0 0 1 0 10h-3",
  redo: "M16 5l4 4-4 4M20 9H10a5 5 0 0 0 0 10h3",
  open: "M3 7a2 2 0 0 1 2-2h4l2 2h8a2 2 0 0 1 2 2v8a2 2 0 0 1-2 2H5a2 2 0 0 1-2-2z",
  save: "M12 4v11M7 11l5 5 5-5M4 20h16",
  gallery: "M4 4h7v7H4zM13 4h7v7h-7zM4 13h7v7H4zM13 13h7v7h-7z",
  duplicate: "M8 8h12v12H8zM4 16V4h12",
  mirror: "M12 3v18M8 7l-5 10h5zM16 7l5 10h-5z",
  erase: "M5 7h14M10 7V4h4v3M7 7l1 13h8l1-13",
  up: "M12 19V5M6 11l6-6 6 6",
  down: "M12 5v14M6 13l6 6 6-6",
  dice: "M5 3h14a2 2 0 0 1 2 2v14a2 2 0 0 1-2 2H5a2 2 0 0 1-2-2V5a2 2 0 0 1 2-2zM8 8h.01M16 8h.01M12 12h.01M8 16h.01M16 16h.01",
  fresh: "M12 5v14M5 12h14",
  close: "M6 6l12 12M18 6L6 18",
  help: "M9 9a3 3 0 1 1 4 3c-1 .5-1 1-1 2M12 18h.01",
  sun: "M12 8a4 4 0 1 0 0 8a4 4 0 1 0 0-8zM12 2v2M12 20v2M2 12h2M20 12h2M5 5l1.5 1.5M17.5 17.5L19 19M19 5l-1.5 1.5M6.5 17.5L5 19",
} as const;

export type IconName = keyof typeof kIcons;

/** A line drawing for a button, in the color of its text; the button's name says what it means. */
export function icon(name: IconName): SVGSVGElement {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 24 24");
  svg.setAttribute("class", "icon");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", kIcons[name]);
  svg.append(path);
  return svg;
}
