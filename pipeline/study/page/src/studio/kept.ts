import type { Studio } from "./studio";

/** Builds something now, and again when what it is `of` has become something else: not for every change
    of a slider. */
export function keepBuilt(studio: Studio, of: () => unknown, build: () => void): void {
  let built = "";
  const look = (): void => {
    const now = JSON.stringify(of());
    if (now === built) return;
    built = now;
    build();
  };
  studio.on(look);
  look();
}
