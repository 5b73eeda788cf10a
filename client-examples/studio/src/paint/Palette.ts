import * as THREE from "three";
import { baseColorOf, type BaseColor } from "./baseColorOf";
import { outlineMaterial } from "./outlineMaterial";
import { kSkin } from "./skinPaint";
import { toonOf } from "./toonOf";

const kUnseen = 0.05; // opacity; what has less is there for tools, not for eyes

/** The paints for a file's materials, one each, and their outline. A file of which nobody picked a color is all skin. */
export class Palette {
  readonly line: THREE.ShaderMaterial;
  private readonly colors = new Map<THREE.Material, BaseColor>();
  private readonly paints = new Map<THREE.Material, THREE.ShaderMaterial>();
  private readonly isSkin: boolean;

  constructor(object: THREE.Object3D) {
    object.traverse((node) => {
      if (!(node instanceof THREE.Mesh)) return;
      for (const material of [(node as THREE.Mesh).material].flat()) this.colors.set(material, baseColorOf(material));
    });
    this.isSkin = [...this.colors.values()].every(({ isChosen }) => !isChosen);
    this.line = outlineMaterial(kSkin.line, kSkin.pixels);
  }

  /** How far a line lies behind its surface; see outlineMaterial. */
  setBehind(behind: number): void {
    this.line.uniforms["behind"]!.value = behind;
  }

  paint(material: THREE.Material): THREE.ShaderMaterial {
    const known = this.paints.get(material);
    if (known) return known;
    const made = toonOf(this.colors.get(material) ?? baseColorOf(material), this.isSkin);
    this.paints.set(material, made);
    return made;
  }

  isSeen(material: THREE.Material): boolean {
    return (this.colors.get(material)?.opacity ?? 1) > kUnseen;
  }

  /** A hull knows nothing of the holes in a picture. */
  isOutlined(material: THREE.Material): boolean {
    return !(this.colors.get(material)?.hasHoles ?? false);
  }

  dispose(): void {
    for (const paint of this.paints.values()) {
      for (const name of ["ramp", "map"]) (paint.uniforms[name]?.value as THREE.Texture | undefined)?.dispose();
      paint.dispose();
    }
    this.line.dispose();
  }
}
