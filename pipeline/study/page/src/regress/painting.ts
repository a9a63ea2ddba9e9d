import { element } from "../questionnaire/elements";

/** A part of what is shown of a stimulus. */
export interface View {
  node: HTMLElement;
  /** Draws it anew: the page has another size, or other colours. */
  paint(): void;
  /** Whether a key was for it. */
  keys?(event: KeyboardEvent): boolean;
}

export const font = (size: number): string => `${size}px "Noto Sans", system-ui, sans-serif`;

export const colour = (name: string): string => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

export const isDark = (): boolean => matchMedia("(prefers-color-scheme: dark)").matches;

/** A canvas of so many of the page's pixels, empty, whatever the screen makes of these. */
export function prepared(canvas: HTMLCanvasElement, width: number, height: number): CanvasRenderingContext2D {
  const dense = window.devicePixelRatio || 1;
  if (canvas.width !== Math.round(width * dense)) canvas.width = Math.round(width * dense);
  if (canvas.height !== Math.round(height * dense)) canvas.height = Math.round(height * dense);
  const context = canvas.getContext("2d")!;
  context.setTransform(dense, 0, 0, dense, 0, 0);
  context.clearRect(0, 0, width, height);
  return context;
}

export function stroke(context: CanvasRenderingContext2D, ...places: [number, number][]): void {
  context.beginPath();
  for (const place of places) context.lineTo(...place);
  context.stroke();
}

export function dot(context: CanvasRenderingContext2D, [x, y]: [number, number], radius: number): void {
  context.beginPath();
  context.arc(x, y, radius, 0, 7);
}

/** A button with its key. */
export function keyButton(text: string, key: string, pressed: () => void): HTMLButtonElement {
  const made = element("button", { type: "button", "aria-keyshortcuts": key }, text, " ", element("kbd", {}, key));
  made.addEventListener("click", pressed);
  return made;
}
