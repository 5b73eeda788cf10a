import * as THREE from "three";
import { toOklch } from "./toOklch";

/** What a file says of a material's base color. */
export interface BaseColor {
  readonly map: THREE.Texture | null;
  /** #rrggbb, as on the screen. */
  readonly color: string;
  readonly opacity: number;
  /** Whether its picture may have holes. */
  readonly hasHoles: boolean;
  readonly side: THREE.Side;
  /** Whether somebody picked it: a picture, or a color that is neither white nor a light grey, as files without materials have. */
  readonly isChosen: boolean;
}

const kGrey = 0.02; // chroma; what has less and is light is a default, not a choice
const kLight = 0.4; // lightness

/** Reads a material as GLTFLoader makes them. */
export function baseColorOf(material: THREE.Material): BaseColor {
  const { map, color } = material as Partial<Pick<THREE.MeshStandardMaterial, "map" | "color">>;
  // Files have linear colors; the painter's are as on the screen.
  const hex = color instanceof THREE.Color ? `#${color.clone().convertLinearToSRGB().getHexString(THREE.LinearSRGBColorSpace)}` : "#ffffff";
  const { chroma, lightness } = toOklch(hex);
  const picture = map instanceof THREE.Texture ? map : null;
  return {
    map: picture,
    color: hex,
    opacity: material.opacity,
    hasHoles: picture !== null && (material.transparent || material.alphaTest > 0),
    side: material.side,
    isChosen: picture !== null || chroma > kGrey || lightness < kLight,
  };
}
