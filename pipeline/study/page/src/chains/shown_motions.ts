import type { FigureView } from "../figure/figure_view";
import type { LiveCore, LiveSetting } from "../live/core";
import { pause } from "../questionnaire/store";

/**
 * Makes motions and shows them, one a figure. Of settings that come faster than motions are made, only the last are
 * made; what fails is tried again until it succeeds, or others come.
 */
export class ShownMotions {
  private wanted: LiveSetting[] | null = null;
  private making: Promise<void> | null = null;

  /** `failed` is told when motions cannot be made, and again when they can. */
  constructor(private core: LiveCore, private view: FigureView, private failed: (has: boolean) => void) {}

  /** Resolved when these, or later ones, are shown. */
  show(settings: LiveSetting[]): Promise<void> {
    this.wanted = settings;
    return this.shown();
  }

  /** Resolved when what was asked for last is shown. */
  shown(): Promise<void> {
    this.making ??= this.make().finally(() => { this.making = null; });
    return this.making;
  }

  private async make(): Promise<void> {
    for (let hasFailed = false; this.wanted;) {
      const settings = this.wanted;
      this.wanted = null;
      try {
        this.view.expectMotion();
        const motions = await Promise.all(settings.map((setting) => this.core.make(setting)));
        motions.forEach((motion, figure) => this.view.show(figure, motion));
        if (hasFailed) this.failed(hasFailed = false);
      } catch (error) {
        console.error(error);
        this.failed(hasFailed = true);
        this.wanted ??= settings;
        await pause(1000);
      }
    }
  }
}
