import { element } from "../questionnaire/elements";
import { FigureView, type Arrangement } from "../figure/figure_view";
import type { Turn } from "../figure/camera_turn";
import { find } from "./document";
import { heatColours } from "./heat";
import { lookOf, nameOf } from "./look_panel";
import type { Made } from "./server";
import type { Studio } from "./studio";
import { Wardrobe } from "./wardrobe";

/** About what a set's background looks like. */
const backgrounds: Record<string, string> = {
  studio: "#d2d3d3", void: "#808080", treadmill: "#c9cccf", corridor: "#d7d2c8", "lab-grid": "#e8ebee",
};
const degree = Math.PI / 180;
/** Azimuth and elevation, as the renderer's cameras stand about who walks along +Z. */
const directions: Record<string, [number, number]> = {
  front: [0, 6 * degree], side: [-90 * degree, 6 * degree], "three-quarter": [-42 * degree, 10 * degree],
};
/** Of roles, as on sheets and overlays; of examples. */
const roleColours: Record<string, string> = { target: "#2ea05c", created: "#3474cc", reference: "#ce483c" };
const exampleColour = "#7a8696";

/** The figure, or two of them, playing. */
export class StageView {
  readonly element = element("div", { class: "stage" });
  private view: FigureView | null = null;
  private shape = "";
  private camera = "";
  private arrangement: Arrangement = "beside";
  /** Of the motion and of what it is held against. */
  private wardrobes = [0, 1].map((figure) => new Wardrobe((skin) => this.view?.wear(figure, skin)));
  isHot = true;

  constructor(private studio: Studio) {
    studio.on((change) => {
      if (change === "asked") this.view?.expectMotion();
      if (change === "motion") this.show();
      if (change === "document" || change === "selection") this.showLook();
    });
  }

  phase = (): number => this.view?.phase() ?? 0;
  plays = (): boolean => this.view?.plays() ?? false;
  drawn = (): Promise<void> => this.view?.drawn() ?? Promise.resolve();

  toggle(): void {
    if (!this.view) return;
    if (this.view.plays()) this.view.pause();
    else this.view.play();
  }

  seek(phase: number): void {
    this.view?.pause();
    this.view?.seek(phase);
  }

  arrange(arrangement: Arrangement): void {
    this.arrangement = arrangement;
    this.view?.arrange(arrangement);
  }

  setHeat(isHot: boolean): void {
    this.isHot = isHot;
    this.paint();
  }

  /** Of the motion and of what it is held against. */
  private colours(): string[] {
    const { studio } = this;
    return [studio.selected, studio.against].map((name) => {
      const stimulus = find(studio.document(), name);
      return stimulus ? roleColours[String(stimulus["role"] ?? "created")]! : exampleColour;
    });
  }

  /** What a view is made for: another one needs another. */
  private shapeNow(): string {
    return JSON.stringify([this.studio.made?.body, this.colours()]);
  }

  /** A new view where the body or its colour is another; camera and moment stay. */
  private rebuild(): void {
    const { made } = this.studio;
    if (!made) return;
    const shape = this.shapeNow();
    if (this.view && shape === this.shape) return;
    const before: { turn: Turn; phase: number; plays: boolean } | null = this.view
      ? { turn: this.view.stands(), phase: this.view.phase(), plays: this.view.plays() } : null;
    this.view?.release();
    this.view?.element.remove();
    for (const wardrobe of this.wardrobes) wardrobe.beginAnew();
    this.view = new FigureView(made.body, this.colours(), "the motion in three dimensions", made.hands);
    this.shape = shape;
    this.element.prepend(this.view.element);
    if (!before) return;
    this.view.standAt(before.turn);
    this.view.seek(before.phase);
    if (!before.plays) this.view.pause();
  }

  private show(): void {
    const { made, other } = this.studio;
    if (!made) return;
    this.rebuild();
    [made, other].forEach((one, figure) => this.showFigure(figure, one));
    this.view!.arrange(this.arrangement);
    this.showLook();
    this.paint();
  }

  private showFigure(figure: number, made: Made | null): void {
    const { studio } = this;
    const name = figure === 0 ? studio.selected : studio.against;
    const key = made?.figure.key ?? "";
    this.view!.show(figure, made?.motion ?? null, made?.poses ?? null, made?.face ?? null);
    this.wardrobes[figure]!.want(key, () => studio.figureOf(name, key));
  }

  private showLook(): void {
    if (!this.view) return;
    const look = lookOf(this.studio);
    if (this.studio.made && this.shapeNow() !== this.shape) return this.show();
    this.view.setBackground(backgrounds[nameOf(look["scene"], "studio")] ?? "#b8b8b8");
    const camera = nameOf(look["camera"], "three-quarter");
    if (camera === this.camera) return;
    this.camera = camera;
    const [azimuth, elevation] = directions[camera] ?? directions["three-quarter"]!;
    this.view.standAt({ ...this.view.stands(), azimuth, elevation });
  }

  /** Joints in the colours of their distance. */
  private paint(): void {
    const distance = this.studio.made?.distance;
    this.view?.paint(0, distance && this.isHot ? heatColours(distance.by_joint) : null);
  }
}
