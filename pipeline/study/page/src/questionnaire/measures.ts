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

/** How often, and for how long, the window was left. */
export interface Blurs {
  blurs: number;
  blur_ms: number;
}

/** Counts until it is asked. */
export function countBlurs(): () => Blurs {
  let blurs = 0, away = 0;
  let since: number | null = null;
  // A window that is left and hidden says so twice.
  const left = () => {
    if (since !== null) return;
    blurs += 1;
    since = performance.now();
  };
  const back = () => {
    if (since === null || document.hidden) return;
    away += performance.now() - since;
    since = null;
  };
  const changed = () => (document.hidden ? left() : back());
  addEventListener("blur", left);
  addEventListener("focus", back);
  document.addEventListener("visibilitychange", changed);
  return () => {
    removeEventListener("blur", left);
    removeEventListener("focus", back);
    document.removeEventListener("visibilitychange", changed);
    return { blurs, blur_ms: Math.round(away + (since === null ? 0 : performance.now() - since)) };
  };
}

/** There is no mouse; where fingers are what there is, there is seldom a keyboard. */
export const isTouched = (): boolean => matchMedia("(pointer: coarse)").matches;

/** A phone: fingers, and a screen whose shorter side is short. */
export const isPhone = (): boolean =>
  isTouched() && Math.min(screen.width, screen.height) < 600;
