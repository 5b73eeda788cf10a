import * as THREE from "three";

const kRows = 3; // texels of a matrix: the fourth row is always 0 0 0 1
const kWidths = [1024, 2048, 4096] as const; // every WebGL2 has textures of 2048 by 2048, almost every one of 4096 by 4096

export interface PoseUniforms {
  readonly poses: THREE.IUniform<THREE.DataTexture>;
  readonly poseJoints: THREE.IUniform<number>;
  readonly posePictures: THREE.IUniform<number>;
  /** The picture shown: whole = that one, still; a fraction blends to the next one, after the last to the first; negative = rest. */
  readonly picture: THREE.IUniform<number>;
}

function textureOf(texels: number): THREE.DataTexture {
  const width = kWidths.find((side) => texels <= side * side);
  if (!width) throw new RangeError(`too many poses for one texture: ${texels} rows of matrices`);
  const height = Math.max(1, Math.ceil(texels / width));
  const texture = new THREE.DataTexture(new Float32Array(4 * width * height), width, height, THREE.RGBAFormat, THREE.FloatType);
  texture.needsUpdate = true;
  return texture;
}

/** All pictures of all tufts' joints in one texture, from which kPosingGlsl reads. */
export class PoseTexture {
  readonly uniforms: PoseUniforms = {
    poses: { value: textureOf(0) },
    poseJoints: { value: 0 },
    posePictures: { value: 0 },
    picture: { value: -1 },
  };

  /**
   * Replaces all poses. No pictures at all is rest.
   * @param matrices  pictures × joints × 12: the upper three rows of the matrix that takes a vertex from rest to the picture
   * @throws RangeError if there are fewer numbers than that, or more than 5.5 million matrices
   */
  set(pictures: number, joints: number, matrices: Float32Array): void {
    const numbers = 4 * kRows * pictures * joints;
    if (matrices.length < numbers) throw new RangeError(`${pictures} × ${joints} poses have ${numbers} numbers, not ${matrices.length}`);
    const { poses, poseJoints, posePictures } = this.uniforms;
    const { width, height } = poses.value.image as { width: number; height: number };
    if (kRows * pictures * joints > width * height) {
      const grown = textureOf(kRows * pictures * joints);
      poses.value.dispose();
      poses.value = grown;
    }
    (poses.value.image.data as Float32Array).set(matrices.subarray(0, numbers));
    poses.value.needsUpdate = true;
    poseJoints.value = joints;
    posePictures.value = pictures;
  }

  dispose(): void {
    this.uniforms.poses.value.dispose();
  }
}
