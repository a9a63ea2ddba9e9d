const frame = (): Promise<number> => new Promise((seen) => requestAnimationFrame(seen));

/** Frames a second that the screen shows, to a tenth; null where that cannot be told. */
export async function refreshRate(): Promise<number | null> {
  const steps: number[] = [];
  let before = await Promise.race([frame(), new Promise<number>((no) => setTimeout(no, 1000, -1))]);
  if (before < 0) return null;  // a window that is not seen draws nothing
  for (let i = 0; i < 45; i += 1) {
    const now = await frame();
    steps.push(now - before);
    before = now;
  }
  const middle = steps.sort((a, b) => a - b)[22]!;
  return middle > 0 ? Math.round(10000 / middle) / 10 : null;
}

/** Counts how often the window is left until it is told to stop. */
export function countBlurs(): () => number {
  let blurs = 0;
  let last = -1000;
  const left = () => {
    // A window that is left and hidden says so twice.
    if (performance.now() - last > 200) blurs += 1;
    last = performance.now();
  };
  const hidden = () => { if (document.hidden) left(); };
  addEventListener("blur", left);
  document.addEventListener("visibilitychange", hidden);
  return () => {
    removeEventListener("blur", left);
    document.removeEventListener("visibilitychange", hidden);
    return blurs;
  };
}

/** There is no mouse; where fingers are what there is, there is seldom a keyboard. */
export const isTouched = (): boolean => matchMedia("(pointer: coarse)").matches;

/** A phone: fingers, and a screen whose shorter side is short. */
export const isPhone = (): boolean =>
  isTouched() && Math.min(screen.width, screen.height) < 600;
