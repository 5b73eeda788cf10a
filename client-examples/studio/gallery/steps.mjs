// The words of a recipe. Each gives a step: a function that has an Artist do something.

const kPen = { thickness: "diameter", widest: "widest_at", flat: "flatness", twist: "twist_deg", roll: "roll_deg", joints: "joints" };
const kTapers = { sine: "Sine", linear: "Straight", smooth: "Smooth", round: "Round" };

/** What the following strokes are like: thickness 1..100, widest 1..100 (root to tip), flat 0..0.98, twist and roll in degrees, taper. */
export const pen = ({ taper, ...numbers }) => async (artist) => {
  await artist.mode("draw");
  if (taper) await artist.choose("Taper", kTapers[taper]);
  for (const [word, value] of Object.entries(numbers)) await artist.setNumber(`/tufts/${kPen[word]}`, value);
};

const drawn = (how, isPair) => (name, ...way) => async (artist) => {
  await artist.mode("draw");
  await artist.toggle("Draw both sides", isPair);
  await how(artist, way);
  artist.names.push(...(isPair ? [`${name}_L`, `${name}_R`] : [name]));
};
const freehand = (artist, [view, ...points]) => artist.draw(view, points);
const bent = (artist, [root, view, ...points]) => artist.bend(root, view, points);

/** A freehand stroke, root first: name, view, points. */
export const stroke = drawn(freehand, false);
/** The same on both sides; draw the left one. */
export const pair = drawn(freehand, true);
/** Point by point on a plane: name, [view, root], then the view that the plane faces and the points in it. */
export const plane = drawn(bent, false);
export const planePair = drawn(bent, true);

/** Tufts in the gap between two; densities 1..100, 0 is off. */
export const fill = (from, to, { along = 0, crown = 0, neck = 0, gap = 0.2, seed = 0, way = "Shorter" }) => async (artist) => {
  await artist.selectTufts([from, to]);
  await artist.mode("fill");
  for (const [direction, value] of Object.entries({ along, crown, neck })) await artist.setNumber(`/fill/density/${direction}`, value);
  await artist.setNumber("/fill/min_gap", gap);
  await artist.choose("Way around", way);
  await artist.toggle("Scatter", seed > 0);
  if (seed > 0) await artist.page.locator(".panel").getByRole("spinbutton", { name: "Seed" }).fill(String(seed));
  const add = artist.page.locator(".panel button.primary");
  await artist.page.waitForTimeout(600);
  await add.and(artist.page.locator(":enabled")).waitFor({ timeout: 5000 }).catch(() => { throw new Error(`nothing to fill from ${from} to ${to}`); });
  const count = Number((await add.textContent()).match(/\d+/)[0]);
  await add.click();
  artist.names.push(...Array(count).fill(null));
};

/** Wave, timing and phases, by the contract's names; `wind` is left as it is. */
export const motion = ({ amplitude, spatial_period, lightness, tip_exponent, period, hold, spread, gust, lift }) => async (artist) => {
  await artist.mode("move");
  for (const [name, value] of Object.entries({ amplitude, spatial_period, lightness, tip_exponent })) await artist.setNumber(`/motion/wave/${name}`, value);
  await artist.setNumber("/motion/timing/period", period);
  await artist.choose("Hold", { 1: "Ones", 2: "Twos", 3: "Threes" }[hold]);
  if (lift !== undefined) await artist.setNumber("/motion/lift", lift);
  await artist.setNumber("/motion/phase/spread", spread);
  await artist.toggle("A gust runs over the head", gust !== undefined);
  if (gust !== undefined) await artist.setNumber("/motion/phase/gust_wavelength", gust);
};

/** The color of the hair, #rrggbb. */
export const color = (value) => async (artist) => {
  await artist.mode("draw");
  await artist.page.locator(".panel input[type=color]").fill(value);
};
