import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import headUrl from "../../../../tests/data/heads/mpfb_head_base.glb?url";
import { bundledHeadParts } from "./bundledHeadParts";
import { drawFace, type FaceLook } from "./drawFace";
import { hairTones } from "./hairTones";
import { type HeadPlace, kHeadPlace } from "./HeadPlace";
import { outlineMaterial } from "./outlineMaterial";
import { outlineOf } from "./outlineOf";
import type { PaintedHead } from "./PaintedHead";
import { placedFace } from "./placedFace";
import { setTones } from "./setTones";
import { kSkin } from "./skinPaint";
import { surfaceOf } from "./surfaceOf";
import { toonMaterial } from "./toonMaterial";
import { weldedMesh } from "./weldedMesh";

/** What may differ from the studio's own head. */
export interface BundledHeadOptions {
  readonly place?: HeadPlace;
  readonly iris?: FaceLook["iris"];
}

const kFaceSize = 1024; // pixels a side
const kIris: FaceLook["iris"] = ["#3a2568", "#6a55c0", "#b9a6f2"];
const kLineBehind = 0.045; // metres: the chin stands off the neck by more, lips and lids off the face by less

function faceContext(): CanvasRenderingContext2D {
  const canvas = document.createElement("canvas");
  Object.assign(canvas, { width: kFaceSize, height: kFaceSize });
  const context = canvas.getContext("2d");
  if (!context) throw new Error("this browser draws no pictures");
  return context;
}

/**
 * The head that comes with the studio: MakeHuman's, painted flat, with a drawn face.
 * @throws Error if its file is not there
 */
export async function loadBundledHead({ place = kHeadPlace, iris = kIris }: BundledHeadOptions = {}): Promise<PaintedHead> {
  const parts = bundledHeadParts((await new GLTFLoader().loadAsync(headUrl)).scene, place);
  const { light } = kSkin;
  const start = hairTones("#6a5a78").tones;
  const face = faceContext();
  drawFace(face, { iris, brow: start[0] });
  const texture = new THREE.CanvasTexture(face.canvas);
  texture.anisotropy = 4;
  const skin = toonMaterial({ tones: kSkin.tones, light, decal: { texture, ...placedFace(place) } });
  const scalp = toonMaterial({ tones: start, light });
  const line = outlineMaterial(kSkin.line, kSkin.pixels, kLineBehind);
  const group = new THREE.Group();
  for (const [name, { painted, outlined }] of parts) {
    const mesh = new THREE.Mesh(painted, name === "scalp" ? scalp : skin);
    mesh.castShadow = mesh.receiveShadow = true;
    group.add(mesh);
    if (name !== "eyes") group.add(outlineOf(new THREE.Mesh(outlined), line));
  }
  const surface = surfaceOf([...parts.values()].map(({ painted }) => painted));
  return {
    group,
    surface,
    scalp: weldedMesh(parts.get("scalp")?.painted.getAttribute("position").array ?? []),
    setScalpTones(tones, brow = tones[0]) {
      setTones(scalp, tones);
      drawFace(face, { iris, brow });
      texture.needsUpdate = true;
    },
    dispose() {
      for (const { painted, outlined } of parts.values()) for (const geometry of [painted, outlined]) geometry.dispose();
      for (const material of [skin, scalp]) (material.uniforms["ramp"]?.value as THREE.Texture).dispose();
      for (const material of [skin, scalp, line, surface.material as THREE.Material]) material.dispose();
      texture.dispose();
      surface.geometry.dispose();
    },
  };
}
