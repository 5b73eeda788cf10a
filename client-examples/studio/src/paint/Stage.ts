import * as THREE from "three";
import { fitCamera } from "./fitCamera";
import { shrunkPicture } from "./shrunkPicture";

/** A part of the canvas, CSS pixels from its left upper corner. */
export interface Viewport {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

const kSun = [0.45, 0.6, 0.85] as const; // right, up, towards the eye: low, so that a fringe leaves the eyes in the light
const kSunDistance = 2; // metres
const kNormalBias = 0.02; // of the radius in which shadows are cast
const kShadowMap = 2048; // texels a side
const kLineAt = 640; // pixels of a picture's height at which its lines are as wide as on the screen

/**
 * One renderer, one scene, one light that casts shadows and stays at the eye's side, so that hair is lit alike from everywhere.
 * Three's color management goes off for the whole page: colors are what the painter mixed.
 */
export class Stage {
  readonly scene = new THREE.Scene();
  readonly #renderer: THREE.WebGLRenderer;
  readonly #sun = new THREE.DirectionalLight("#ffffff", 1);
  #size = { width: 1, height: 1 };

  /** @throws Error if the browser has no WebGL 2 */
  constructor(canvas: HTMLCanvasElement) {
    THREE.ColorManagement.enabled = false;
    this.#renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.#renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    this.#renderer.setClearColor("#000000", 0);
    this.#renderer.shadowMap.enabled = true;
    this.#renderer.shadowMap.type = THREE.BasicShadowMap;
    this.#sun.castShadow = true;
    this.#sun.shadow.mapSize.set(kShadowMap, kShadowMap);
    this.#sun.shadow.bias = -0.001;
    this.lightUp([0, 0, 0], 0.3);
    this.scene.add(this.#sun, this.#sun.target);
  }

  /** Whether shadows are cast. Without them a frame of 204 tufts takes a quarter less (software rendering). */
  get shadows(): boolean {
    return this.#sun.castShadow;
  }

  set shadows(cast: boolean) {
    this.#sun.castShadow = cast;
  }

  /** The ball in which shadows are cast; metres. */
  lightUp(center: readonly [number, number, number], radius: number): void {
    this.#sun.target.position.set(...center);
    const { camera } = this.#sun.shadow;
    Object.assign(camera, { left: -radius, right: radius, top: radius, bottom: -radius });
    Object.assign(camera, { near: Math.max(0.01, kSunDistance - 2 * radius), far: kSunDistance + 2 * radius });
    this.#sun.shadow.normalBias = kNormalBias * radius;
    camera.updateProjectionMatrix();
  }

  /** @param width, height  CSS pixels of the canvas; @param pixelRatio  of the screen */
  resize(width: number, height: number, pixelRatio: number): void {
    this.#size = { width: Math.max(1, width), height: Math.max(1, height) };
    this.#renderer.setPixelRatio(pixelRatio);
    this.#renderer.setSize(this.#size.width, this.#size.height, false);
  }

  /** Draws the scene. The camera takes the viewport's proportions. @param viewport  the whole canvas if left out */
  render(camera: THREE.PerspectiveCamera | THREE.OrthographicCamera, viewport?: Viewport): void {
    const { x, y, width, height } = viewport ?? { x: 0, y: 0, ...this.#size };
    const bottom = this.#size.height - y - height;
    this.#renderer.setScissorTest(true);
    this.#renderer.setScissor(x, bottom, width, height);
    this.#renderer.setViewport(x, bottom, width, height);
    this.#draw(camera, width, height, 1);
  }

  /**
   * The scene as a picture of its own, transparent where nothing is, with soft edges. The live view stays as it is.
   * Lines keep their width relative to the picture, and are never thinner than on the screen.
   * @param oversampling  samples a side of each pixel; less if the graphics card has no textures of that size
   */
  snapshot(camera: THREE.PerspectiveCamera | THREE.OrthographicCamera, width: number, height: number, oversampling = 3): HTMLCanvasElement {
    const most = Math.floor(this.#renderer.capabilities.maxTextureSize / Math.max(width, height));
    const samples = Math.max(1, Math.min(oversampling, most));
    const target = new THREE.WebGLRenderTarget(samples * width, samples * height, { samples: 0, depthBuffer: true });
    const own = camera.clone();
    this.#renderer.setRenderTarget(target);
    this.#draw(own, width, height, Math.max(1, height / kLineAt));
    const pixels = new Uint8Array(4 * target.width * target.height);
    this.#renderer.readRenderTargetPixels(target, 0, 0, target.width, target.height, pixels);
    this.#renderer.setRenderTarget(null);
    target.dispose();
    const canvas = document.createElement("canvas");
    Object.assign(canvas, { width, height });
    canvas.getContext("2d")?.putImageData(new ImageData(shrunkPicture(pixels, width, height, samples), width, height), 0, 0);
    return canvas;
  }

  /** Frees the renderer and its shadows. What is in the scene belongs to those who put it there. */
  dispose(): void {
    this.#sun.dispose();
    this.#renderer.dispose();
  }

  #draw(camera: THREE.PerspectiveCamera | THREE.OrthographicCamera, width: number, height: number, lineScale: number): void {
    fitCamera(camera, width / height);
    camera.updateMatrixWorld();
    const towards = new THREE.Vector3(...kSun).normalize().transformDirection(camera.matrixWorld);
    this.#sun.position.copy(this.#sun.target.position).addScaledVector(towards, kSunDistance);
    // Tufts are not sorted, nearest first: tried 2026-11-26, 204 tufts took as long (1.08 s and 1.07 s, busy machine, software).
    this.scene.traverse((node) => {
      if (!(node instanceof THREE.Mesh) || !(node.material instanceof THREE.ShaderMaterial)) return;
      const pixel: unknown = node.material.uniforms["pixel"]?.value;
      if (pixel instanceof THREE.Vector2) pixel.set((2 * lineScale) / width, (2 * lineScale) / height);
    });
    this.#renderer.render(this.scene, camera);
  }
}
