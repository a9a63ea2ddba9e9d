import {
  BufferGeometry, Color, DirectionalLight, Float32BufferAttribute, HemisphereLight, LineBasicMaterial,
  LineSegments, Scene, WebGLRenderer,
} from "three";

/** The side of a square of the floor, metres. */
export const floorSquare = 0.5;

/** Squares, in short pieces: some drivers lose lines that begin behind the camera. */
export function floor(): LineSegments {
  const points: number[] = [];
  for (let across = -10; across <= 10; across += floorSquare) {
    for (let along = -10; along < 10; along += floorSquare) {
      const next = along + floorSquare;
      points.push(across, 0, along, across, 0, next, along, 0, across, next, 0, across);
    }
  }
  const lines = new BufferGeometry();
  lines.setAttribute("position", new Float32BufferAttribute(points, 3));
  return new LineSegments(lines, new LineBasicMaterial({ color: "#727272" }));
}

/** Middle grey, with light from above and the front. */
export function litScene(): Scene {
  const scene = new Scene();
  scene.background = new Color("#808080");
  scene.add(new HemisphereLight("#ffffff", "#777777", 2.2));
  const sun = new DirectionalLight("#ffffff", 1.6);
  sun.position.set(2, 4, 3);
  scene.add(sun);
  return scene;
}

/** Names of what draws on the processor, in WebGL's name of the renderer. */
const onProcessor = /swiftshader|llvmpipe|softpipe|software|basic render/i;

/** Whether pictures are drawn by a graphics card; without one, what follows a hand has to be plain. */
function findGraphicsCard(): boolean {
  const context = document.createElement("canvas").getContext("webgl2", { failIfMajorPerformanceCaveat: true });
  if (!context) return false;
  const names = context.getExtension("WEBGL_debug_renderer_info");
  const name = String(context.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : context.RENDERER));
  context.getExtension("WEBGL_lose_context")?.loseContext();
  return !onProcessor.test(name);
}

let hasCard: boolean | undefined;

export const hasGraphicsCard = (): boolean => (hasCard ??= findGraphicsCard());

/** Draws on a canvas; with smooth edges where there is a graphics card, as they more than double a frame without. */
export function rendererOn(canvas: HTMLCanvasElement): WebGLRenderer {
  return new WebGLRenderer({ canvas, antialias: hasGraphicsCard() });
}
