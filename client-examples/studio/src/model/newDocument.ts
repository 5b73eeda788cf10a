import type { StudioDocument } from "./StudioDocument";

/** An empty head. Its measures are those of the bundled head, its motion a light breeze. */
export function newDocument(): StudioDocument {
  return {
    name: "hair",
    head: { center: [0, 0, 0], root_depth: 0.012, diameter_at_100: 0.1, scalp: null },
    color: "#e8638c",
    tufts: [],
    motion: {
      wave: { amplitude: 0.3, spatial_period: 1, lightness: 1.2, tip_exponent: 1.5 },
      timing: { period: 0.45, fps: 24, hold: 2 },
      wind: [1, 0, 0],
      one_sided: true,
      phase: { gust_wavelength: 0.8, spread: 0.08, seed: 7 },
    },
  };
}
