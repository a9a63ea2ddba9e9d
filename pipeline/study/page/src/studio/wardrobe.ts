import { Skin } from "../figure/skin";

/** Files of figures by their keys, the last ones kept: a figure is put on again without asking. */
const mostFiles = 6;
const files = new Map<string, Promise<ArrayBuffer>>();

/**
 * What one figure of the stage wears. Another file is asked for when the motions have rested for a
 * moment; until it has come, what is worn stays.
 */
export class Wardrobe {
  private wanted = "";
  private timer = 0;

  /** `putOn` is told what is worn from now on; null: nothing. */
  constructor(private putOn: (skin: Skin | null) => void) {}

  /** Forgets what is worn: whoever wore it is gone. */
  beginAnew(): void {
    this.wanted = "";
  }

  /** `load` brings the file of that key; an empty key has none. */
  want(key: string, load: () => Promise<ArrayBuffer>): void {
    if (key === this.wanted) return;
    const isFirst = this.wanted === "";
    this.wanted = key;
    clearTimeout(this.timer);
    if (key === "") return this.putOn(null);
    this.timer = window.setTimeout(() => void this.fetch(key, load), isFirst || files.has(key) ? 0 : 250);
  }

  private async fetch(key: string, load: () => Promise<ArrayBuffer>): Promise<void> {
    try {
      if (!files.has(key)) files.set(key, load());
      const skin = await Skin.read(await files.get(key)!);
      if (key === this.wanted) this.putOn(skin);
      else skin.release();
      while (files.size > mostFiles) files.delete(files.keys().next().value!);
    } catch {
      // The motion is shown all the same; what is wrong with the figure is told with the motion.
      files.delete(key);
      if (key === this.wanted) this.putOn(null);
    }
  }
}
