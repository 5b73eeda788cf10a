import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

/** A GLB or VRM as three.js has it, in the file's own frame. */
export interface LoadedModel {
  readonly scene: THREE.Group;
  /** Nodes by their index in the file. */
  readonly nodes: ReadonlyMap<number, THREE.Object3D>;
  /** Frees what the file brought: geometries, materials, pictures. */
  dispose(): void;
}

/** @throws Error if the file is broken, or needs what three.js does not read */
export async function loadModel(bytes: ArrayBuffer): Promise<LoadedModel> {
  const { scene, parser } = await new GLTFLoader().parseAsync(bytes, "");
  const nodes = new Map<number, THREE.Object3D>();
  // An association can be missing, whatever its type says.
  for (const [object, place] of parser.associations as Map<unknown, { readonly nodes?: number } | undefined>) {
    if (object instanceof THREE.Object3D && place?.nodes !== undefined) nodes.set(place.nodes, object);
  }
  return {
    scene,
    nodes,
    dispose() {
      scene.traverse((node) => {
        if (!(node instanceof THREE.Mesh || node instanceof THREE.Line || node instanceof THREE.Points)) return;
        const mesh = node as THREE.Mesh;
        mesh.geometry.dispose();
        if (mesh instanceof THREE.SkinnedMesh) mesh.skeleton.dispose();
        for (const material of [mesh.material].flat()) {
          for (const value of Object.values(material)) if (value instanceof THREE.Texture) value.dispose();
          material.dispose();
        }
      });
    },
  };
}
