import type { Wave } from "../../../client-examples/studio/src/api/contract";

export interface ServicePose {
  readonly wave: Required<Wave>;
  readonly sampling: "uniform" | "by_frame";
  readonly picture: number;
  /** The chain's nodes, in units where the hair is pi long. */
  readonly line: readonly (readonly [number, number])[];
  /** Equation (1) at those nodes' x: the tangents of the bones' angles, summed, times the length of a bone. */
  readonly heights: readonly number[];
}

const kPaper: Required<Wave> = { amplitude: 0.8, spatial_period: 1, lightness: 1.2, tip_exponent: 1 };
const kBackwards: Required<Wave> = { amplitude: 2, spatial_period: -0.7, lightness: 0.9, tip_exponent: 1.5 };

/**
 * How they were made: POST /v1/motions with {"chains": [{"nodes": [[0,0,0],[0.1,0,0],[0.2,0,0],[0.3,0,0],[0.4,0,0],[0.5,0,0]]}], "motion":
 * {"wave": ..., "timing": {"period": 0.45, "fps": 24, "hold": 2, "sampling": ...}, "mode": "absolute", "wind": [1,0,0]}}; x and y of
 * pictures[].chains[0].positions, divided by 0.5 m, times pi. 11 frames, 6 pictures. The service gives them to about nine digits.
 */
export const kServicePoses: readonly ServicePose[] = [
  {
    wave: kPaper, sampling: "uniform", picture: 1,
    line: [[0, 0], [0.589141802, -0.218394379], [1.172899166, -0.450798251], [1.790435499, -0.566698604], [2.410822514, -0.46717839], [2.98542157, -0.212973366]],
    heights: [0, -0.23291716, -0.483061601, -0.600985576, -0.500193017, -0.222222274],
  },
  {
    wave: kPaper, sampling: "uniform", picture: 4,
    line: [[0, 0], [0.62822755, 0.010693401], [1.255926559, 0.038588057], [1.875763418, -0.064302257], [2.434562901, -0.351577789], [2.926135318, -0.742909731]],
    heights: [0, 0.010694949, 0.038617137, -0.065681099, -0.388695965, -0.888889024],
  },
  {
    wave: kBackwards, sampling: "by_frame", picture: 0,
    line: [[0, 0], [0.550839731, -0.302257763], [1.160920462, -0.452543092], [1.733975236, -0.194875757], [2.35165602, -0.310004679], [2.576385578, -0.896759141]],
    heights: [0, -0.344772068, -0.499550038, -0.217034006, -0.334145687, -1.974645072],
  },
  {
    wave: kBackwards, sampling: "by_frame", picture: 5,
    line: [[0, 0], [0.526538846, -0.342842528], [1.0540355, -0.6842096], [1.650318393, -0.486142048], [2.173277771, -0.137863623], [2.595221939, -0.603424739]],
    heights: [0, -0.40911381, -0.815727304, -0.60701846, -0.188573361, -0.881842042],
  },
];
