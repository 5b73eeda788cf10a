import * as THREE from "three";
import { bakedGeometry } from "./bakedGeometry";
import { skinTones } from "./skinTones";
import { outlineMaterial } from "./outlineMaterial";
import { outlineOf } from "./outlineOf";
import type { PaintedHead } from "./PaintedHead";
import { kSkin } from "./skinPaint";
import { surfaceOf } from "./surfaceOf";
import { toonMaterial } from "./toonMaterial";
import { toOklch } from "./toOklch";
import { weldedMesh } from "./weldedMesh";

const kTints = ["#c3aebf", "#dfd0da", "#ffffff"] as const; // multiply a picture
const kLineBehind = 0.004; // metres
const kGrey = 0.02; // chroma; what has less and is light is a default, not a choice
const kLight = 0.4; // lightness

/** What a file says of a material's base color; null where it says nothing. */
interface BaseColor {
  readonly map: THREE.Texture | null;
  readonly color: string | null;
  readonly side: THREE.Side;
}

function baseColorOf(material: THREE.Material): BaseColor {
  const { map, color } = material as Partial<Pick<THREE.MeshStandardMaterial, "map" | "color">>;
  // Files have linear colors; the painter's are as on the screen.
  const hex = color instanceof THREE.Color ? `#${color.clone().convertLinearToSRGB().getHexString(THREE.LinearSRGBColorSpace)}` : null;
  const chosen = hex !== null && (toOklch(hex).chroma > kGrey || toOklch(hex).lightness < kLight);
  return { map: map instanceof THREE.Texture ? map : null, color: chosen ? hex : null, side: material.side };
}

function paintOf({ map, color, side }: BaseColor): THREE.ShaderMaterial {
  const { light } = kSkin;
  if (!map) return toonMaterial({ tones: color ? skinTones(color) : kSkin.tones, light, side });
  const shown = map.clone(); // as the file has its bytes: without a change of color space
  shown.colorSpace = THREE.NoColorSpace;
  return toonMaterial({ tones: kTints, light, side, map: shown });
}

/** The parts of a geometry that its materials paint: first corner and number of corners. */
function rangesOf(mesh: THREE.Mesh): { material: THREE.Material; start: number; count: number }[] {
  const whole = { start: 0, count: Infinity };
  if (!Array.isArray(mesh.material)) return [{ material: mesh.material, ...whole }];
  const materials = mesh.material;
  return mesh.geometry.groups.flatMap(({ start, count, materialIndex = 0 }) => {
    const material = materials[materialIndex];
    return material ? [{ material, start, count }] : [];
  });
}

/**
 * A head from a file that a person brought, painted flat: pictures and colors stay, what has neither becomes skin, and all is outlined.
 * Bones and morphs are applied as they stand; nothing is moved or scaled. Hair may grow on all of it.
 * @param object  is left as it is and not disposed of
 * @throws RangeError if there is no triangle in it
 */
export function paintHead(object: THREE.Object3D): PaintedHead {
  object.updateWorldMatrix(true, true);
  const group = new THREE.Group();
  const geometries: THREE.BufferGeometry[] = [];
  const paints = new Map<THREE.Material, THREE.ShaderMaterial>();
  const line = outlineMaterial(kSkin.line, kSkin.pixels, kLineBehind);
  object.traverseVisible((node) => {
    if (!(node instanceof THREE.Mesh)) return;
    const baked = bakedGeometry(node as THREE.Mesh);
    geometries.push(baked);
    for (const { material, start, count } of rangesOf(node as THREE.Mesh)) {
      const part = count === Infinity ? baked : baked.clone();
      if (part !== baked) part.setDrawRange(start, count);
      const paint = paints.get(material) ?? paintOf(baseColorOf(material));
      paints.set(material, paint);
      const mesh = new THREE.Mesh(part, paint);
      mesh.castShadow = mesh.receiveShadow = true;
      group.add(mesh);
    }
    group.add(outlineOf(new THREE.Mesh(baked), line));
  });
  const surface = surfaceOf(geometries);
  const scalp = weldedMesh(surface.geometry.getAttribute("position").array);
  if (scalp.triangles.length === 0) throw new RangeError("there is no triangle in this file");
  return {
    group,
    surface,
    scalp,
    setScalpTones() {}, // its scalp is its own
    dispose() {
      group.traverse((node) => node instanceof THREE.Mesh && (node.geometry as THREE.BufferGeometry).dispose());
      for (const { uniforms } of paints.values()) {
        for (const name of ["ramp", "map"]) (uniforms[name]?.value as THREE.Texture | undefined)?.dispose();
      }
      for (const material of [...paints.values(), line, surface.material as THREE.Material]) material.dispose();
      surface.geometry.dispose();
    },
  };
}
