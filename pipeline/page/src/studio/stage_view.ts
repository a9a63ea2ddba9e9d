import { element } from "../questionnaire/elements";
import { FigureView, type Arrangement } from "../figure/figure_view";
import type { BodyStyle } from "../figure/body_shape";
import type { Turn } from "../figure/camera_turn";
import { heat_colours } from "./heat";
import { look_of, name_of } from "./look_panel";
import type { Studio } from "./studio";

/** About what a set's background looks like. */
const backgrounds: Record<string, string> = {
  studio: "#d2d3d3", void: "#808080", treadmill: "#c9cccf", corridor: "#d7d2c8", "lab-grid": "#e8ebee",
};
const directions: Record<string, number> = {
  front: 0, side: Math.PI / 2, "three-quarter": 0.9, follow: 0.9, orbit: 0.9,
};
const colours = ["#3a5f9e", "#2e8b57"];

/** The figure, or two of them, playing. */
export class StageView {
  readonly element = element("div", { class: "stage" });
  private view: FigureView | null = null;
  private shape = "";
  private camera = "";
  private arrangement: Arrangement = "beside";
  private style: BodyStyle | "manifest" = "manifest";
  is_hot = true;

  constructor(private studio: Studio) {
    studio.on((change) => {
      if (change === "motion") this.show();
      if (change === "document" || change === "selection") this.show_look();
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

  /** Sticks, a mannequin, or what the manifest has. */
  set_style(style: BodyStyle | "manifest"): void {
    this.style = style;
    this.show();
  }

  set_heat(is_hot: boolean): void {
    this.is_hot = is_hot;
    this.paint();
  }

  private body_style(): BodyStyle {
    if (this.style !== "manifest") return this.style;
    return name_of(look_of(this.studio)["figure"], "mannequin") === "stick" ? "stick" : "mannequin";
  }

  /** A new view where the body or the kind of figure is another; camera and moment stay. */
  private rebuild(): void {
    const { made } = this.studio;
    if (!made) return;
    const style = this.body_style();
    const shape = JSON.stringify([style, made.body]);
    if (this.view && shape === this.shape) return;
    const before: { turn: Turn; phase: number; plays: boolean } | null = this.view
      ? { turn: this.view.stands(), phase: this.view.phase(), plays: this.view.plays() } : null;
    this.view?.release();
    this.view?.element.remove();
    this.view = new FigureView(made.body, colours, "the motion in three dimensions", style);
    this.shape = shape;
    this.element.prepend(this.view.element);
    if (!before) return;
    this.view.stand_at(before.turn);
    this.view.seek(before.phase);
    if (!before.plays) this.view.pause();
  }

  private show(): void {
    const { made, other } = this.studio;
    if (!made) return;
    this.rebuild();
    this.view!.show(0, made.motion);
    this.view!.show(1, other?.motion ?? null);
    this.view!.arrange(this.arrangement);
    this.show_look();
    this.paint();
  }

  private show_look(): void {
    if (!this.view) return;
    const look = look_of(this.studio);
    if (this.studio.made && JSON.stringify([this.body_style(), this.studio.made.body]) !== this.shape) this.show();
    this.view.set_background(backgrounds[name_of(look["scene"], "studio")] ?? "#b8b8b8");
    const camera = name_of(look["camera"], "three-quarter");
    if (camera === this.camera) return;
    this.camera = camera;
    this.view.stand_at({ ...this.view.stands(), azimuth: directions[camera] ?? 0.9, elevation: 0.12 });
  }

  /** Joints in the colours of their distance. */
  private paint(): void {
    const distance = this.studio.made?.distance;
    this.view?.paint(0, distance && this.is_hot ? heat_colours(distance.by_joint) : null);
  }
}
