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
  for (const [object, { nodes: index }] of parser.associations) if (object instanceof THREE.Object3D && index !== undefined) nodes.set(index, object);
  return {
    scene,
    nodes,
    dispose() {
      scene.traverse((node) => {
        if (!(node instanceof THREE.Mesh)) return;
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
