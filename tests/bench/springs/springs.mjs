// VRM spring bones beside the hair wave: does the loop close, does it depend on the frame rate, how long does it take?
//
//   node tests/bench/springs/springs.mjs http://127.0.0.1:8080        or: script/bench springs
//
// Both sides get the same chains. Springs are driven by the head, which sways about +Y once per period (SWAY_DEG); the service by its
// wind. Prints Markdown; times are medians on this machine, and nothing is asserted.
import { askService, closingGap, playClip } from "./ask.mjs";
import { SWAY_DEG, bakeLastCycle, springPoses } from "./bake.mjs";
import { apart, isFinitePose, worst } from "./poses.mjs";
import { workloads } from "./workloads.mjs";

const RATES = [24, 30, 60];
const WHOLE_PERIOD = 0.5; // seconds: a whole number of frames at every rate
const ODD_PERIOD = 0.45; // 10.8 frames at 24; whoever bakes it takes 11
const SETTLED = 16; // cycles, by which what remains of the start is gone
const COMMON = 6; // instants a second that all rates have
const RUNS = 7;

const median = (values) => values.sort((a, b) => a - b)[values.length >> 1];
const degrees = ({ degrees, percent }) => `${degrees.toPrecision(2)} deg, ${percent.toPrecision(2)} %`;
const row = (...cells) => console.log(`| ${cells.join(" | ")} |`);

async function time(work) {
  const times = [];
  await work(); // the first run pays for compiling and connecting
  for (let run = 0; run < RUNS; run++) {
    const begun = performance.now();
    await work();
    times.push(performance.now() - begun);
  }
  return `${median(times).toFixed(1)} ms`;
}

/** The gap of a cycle of `frames` steps that begins after `settle` cycles. */
function springGap(workload, period, rate, frames, settle) {
  const first = settle * frames;
  const poses = springPoses(workload, period, rate, (first + frames) / rate);
  return isFinitePose(poses.at(-1)) ? degrees(apart(poses[first], poses[first + frames])) : "has blown up";
}

/** Poses at the instants that all rates have, in the cycles after `settle` seconds. */
const atCommonTimes = (poses, rate, settle) => poses.filter((_, step) => step >= settle * rate && step % (rate / COMMON) === 0);

function rateDifference(played, settle) {
  const [reference, ...others] = RATES.map((rate, i) => atCommonTimes(played[i], rate, settle));
  return others.map((poses, i) => `${RATES[i + 1]}: ${degrees(worst(poses.map((pose, k) => apart(pose, reference[k]))))}`).join("; ");
}

async function measureGaps(url, workload) {
  console.log(`\n### ${workload.name}: ${workload.chains.length} chains\n\nFrom the first pose of a cycle to the pose one cycle later:\n`);
  row("cycles before", ...RATES.map((rate) => `springs, T ${WHOLE_PERIOD} s, ${rate} fps`), `springs, T ${ODD_PERIOD} s in 11 frames at 24 fps`, `service, T ${ODD_PERIOD} s, 24 fps`);
  row(...Array(RATES.length + 3).fill("---"));
  const clip = await askService(url, workload, ODD_PERIOD, 24, "glb");
  for (const settle of [0, 1, 4, SETTLED]) {
    const springs = RATES.map((rate) => springGap(workload, WHOLE_PERIOD, rate, WHOLE_PERIOD * rate, settle));
    row(settle, ...springs, springGap(workload, ODD_PERIOD, 24, 11, settle), settle ? "the same" : `${await closingGap(clip)} deg, to the last bit`);
  }
}

async function measureRates(url, workload) {
  const settle = SETTLED * WHOLE_PERIOD;
  const seconds = settle + 4 * WHOLE_PERIOD;
  const clip = await askService(url, workload, WHOLE_PERIOD, 24, "glb");
  const clips = await Promise.all(RATES.map((rate) => playClip(clip, workload.chains, rate, seconds)));
  const springs = RATES.map((rate) => springPoses(workload, WHOLE_PERIOD, rate, seconds));
  const swings = springs.map((poses, i) => `${RATES[i]}: ${worst(poses.slice(settle * RATES[i]).map((pose) => apart(pose, poses[0]))).percent.toPrecision(3)} %`);
  console.log(`\nHow far poses at the same instants are from those at ${RATES[0]} fps, T ${WHOLE_PERIOD} s:\n`);
  console.log(`- springs: ${rateDifference(springs, settle)}; farthest from rest, ${swings.join(", ")}`);
  console.log(`- service, one clip played by three.js at each rate: ${rateDifference(clips, settle)}`);
}

async function measureTime(url, workload) {
  console.log(`\nTime for one cycle, T ${WHOLE_PERIOD} s, 24 fps, medians of ${RUNS}:\n`);
  for (const settle of [0, SETTLED]) {
    console.log(`- springs, ${settle} cycles before: ${await time(() => bakeLastCycle(workload, WHOLE_PERIOD, 24, settle + 1))}`);
  }
  for (const format of ["json", "glb"]) {
    console.log(`- service, whole request, ${format}: ${await time(() => askService(url, workload, WHOLE_PERIOD, 24, format))}`);
  }
}

const [url] = process.argv.slice(2);
if (!url) {
  console.error("usage: node springs.mjs URL");
  process.exit(2);
}
console.log(`Springs: @pixiv/three-vrm, one update per frame, no colliders; the head turns by ${SWAY_DEG} degrees to either side.`);
for (const workload of await workloads(url)) {
  await measureGaps(url, workload);
  await measureRates(url, workload);
  await measureTime(url, workload);
}
