// Where the head of tests/data stands in each hair's own frame, so that its scalp lies just under the roots.
const kCrown = 1.6659; // of the head in its file, metres from the floor

/** `crown` is where that comes to lie, the rest scales and moves the head. */
const fit = ({ crown, width, height, depth, x, z }) => ({ position: [x, crown - height * kCrown, z], scale: [width, height, depth] });

export const kPlaces = {
  vita: fit({ crown: 0.226, width: 1.2, height: 1.04, depth: 1.02, x: 0.0018, z: -0.062 }),
  shibu: fit({ crown: 0.22, width: 1.2, height: 1.04, depth: 1.02, x: 0, z: -0.062 }),
  fumiriya: fit({ crown: 0.22, width: 1.22, height: 1.04, depth: 1.02, x: 0, z: -0.062 }),
  // Fitted to the 1,393 roots of the top and the back, which lie 3 mm from the scalp (median).
  ponytail: fit({ crown: 0.0875, width: 0.955, height: 0.81, depth: 0.915, x: 0.0013, z: -0.054 }),
  // Its center is the origin.
  filled: fit({ crown: 0.1, width: 1.2, height: 1.04, depth: 1.02, x: 0, z: -0.058 }),
};
