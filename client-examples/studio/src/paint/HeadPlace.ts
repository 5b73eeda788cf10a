/** Where the bundled head stands in the hair's frame: its file's frame, scaled on each axis, then moved; metres. */
export interface HeadPlace {
  readonly scale: readonly [number, number, number];
  readonly position: readonly [number, number, number];
}

const kCrown = 1.6659; // in the file's frame, metres from the floor
const kScale = [1.2, 1.04, 1.02] as const;

/** Where it stands in the studio: the head's center is the origin, the crown at 0.1. */
export const kHeadPlace: HeadPlace = { scale: kScale, position: [0, 0.1 - kScale[1] * kCrown, -0.058] };
