// A scene as a GLB: by three.js's own exporter, and by glTF-Transform.
import { Document, NodeIO } from "@gltf-transform/core";
import { GLTFExporter } from "three/examples/jsm/exporters/GLTFExporter.js";

/** The exporter reads its blobs by this class of browsers, which Node.js has not got. */
globalThis.FileReader ??= class {
  async readAsArrayBuffer(blob) {
    this.result = await blob.arrayBuffer();
    this.onloadend();
  }
};

/** @returns  ArrayBuffer */
export const exportGlb = (scene, animations = []) => new GLTFExporter().parseAsync(scene, { binary: true, animations });

/** One node for each geometry. @returns  Uint8Array */
export function transformGlb(geometries) {
  const document = new Document();
  const buffer = document.createBuffer();
  const scene = document.createScene();
  const accessor = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const material = document.createMaterial("hair");
  for (const { attributes, index } of geometries) {
    const primitive = document
      .createPrimitive()
      .setAttribute("POSITION", accessor("VEC3", attributes.position.array))
      .setAttribute("NORMAL", accessor("VEC3", attributes.normal.array))
      .setAttribute("TEXCOORD_0", accessor("VEC2", attributes.uv.array))
      .setIndices(accessor("SCALAR", index.array))
      .setMaterial(material);
    scene.addChild(document.createNode().setMesh(document.createMesh().addPrimitive(primitive)));
  }
  return new NodeIO().writeBinary(document);
}
