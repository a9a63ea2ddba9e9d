import { element } from "../questionnaire/elements";
import { FigureView, type Arrangement } from "../figure/figure_view";
import type { Turn } from "../figure/camera_turn";
import { peopleOf } from "../figure/people";
import { PeopleView } from "../figure/people_view";
import { find, type JsonMap } from "./document";
import { heatColours } from "./heat";
import { lookOf, nameOf } from "./look_panel";
import type { Made, People } from "./server";
import type { Studio } from "./studio";
import { Wardrobe } from "./wardrobe";

/** About what a set's background looks like. */
const backgrounds: Record<string, string> = {
  studio: "#d2d3d3", void: "#808080", treadmill: "#c9cccf", corridor: "#d7d2c8", "lab-grid": "#e8ebee",
};
const backgroundOf = (look: JsonMap): string => backgrounds[nameOf(look["scene"], "studio")] ?? "#b8b8b8";
const degree = Math.PI / 180;
/** Azimuth and elevation, as the renderer's cameras stand about who walks along +Z. */
const directions: Record<string, [number, number]> = {
  front: [0, 6 * degree], side: [-90 * degree, 6 * degree], "three-quarter": [-42 * degree, 10 * degree],
};
/** Of roles, as on sheets and overlays; of examples. */
const roleColours: Record<string, string> = { target: "#2ea05c", created: "#3474cc", reference: "#ce483c" };
const exampleColour = "#7a8696";

/** The figure, or two of them, or several people, playing. */
export class StageView {
  readonly element = element("div", { class: "stage" });
  private view: FigureView | null = null;
  private peopleView: PeopleView | null = null;
  /** Told of last; their figures may still be on their way. */
  private people: People | null = null;
  private peopleName = "";
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

  private shown = (): FigureView | PeopleView | null => this.peopleView ?? this.view;
  phase = (): number => this.shown()?.phase() ?? 0;
  plays = (): boolean => this.shown()?.plays() ?? false;
  drawn = (): Promise<void> => this.shown()?.drawn() ?? Promise.resolve();

  toggle(): void {
    const shown = this.shown();
    if (shown?.plays()) shown.pause();
    else shown?.play();
  }

  seek(phase: number): void {
    this.shown()?.pause();
    this.shown()?.seek(phase);
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
    if (made.people) return void this.showPeople(made.people);
    this.dropPeople();
    this.rebuild();
    [made, other].forEach((one, figure) => this.showFigure(figure, one));
    this.view!.arrange(this.arrangement);
    this.showLook();
    this.paint();
  }

  /** Once all of their figures are here; camera and moment stay. */
  private async showPeople(people: People): Promise<void> {
    const { studio } = this;
    const name = studio.selected;
    this.people = people;
    const files = await Promise.all(people.head.figures.map((key) => studio.figureOf(name, key))).catch(() => null);
    if (!files || this.people !== people) return;  // another document is about to be shown
    const turned = await peopleOf(people.head, people.numbers, files);
    if (this.people !== people) return turned.release();
    const before = this.peopleName === name ? this.peopleView : null;
    const next = new PeopleView(turned, "the people in three dimensions");
    if (before) {
      next.standAt(before.stands());
      next.seek(before.phase());
    }
    if (this.shown()?.plays() === false) next.pause();
    this.view?.element.remove();
    this.removePeople();
    this.peopleView = next;
    this.peopleName = name;
    this.element.prepend(next.element);
    this.showLook();
  }

  private removePeople(): void {
    this.peopleView?.release();
    this.peopleView?.element.remove();
    this.peopleView = null;
  }

  private dropPeople(): void {
    this.people = null;
    if (!this.peopleView) return;
    this.removePeople();
    if (this.view) this.element.prepend(this.view.element);
  }

  private showFigure(figure: number, made: Made | null): void {
    const { studio } = this;
    const name = figure === 0 ? studio.selected : studio.against;
    const key = made?.figure.key ?? "";
    this.view!.show(figure, made?.motion ?? null, made?.poses ?? null, made?.face ?? null);
    this.wardrobes[figure]!.want(key, () => studio.figureOf(name, key));
  }

  private showLook(): void {
    const look = lookOf(this.studio);
    this.peopleView?.setBackground(backgroundOf(look));
    if (!this.view || this.people) return;
    if (this.studio.made && this.shapeNow() !== this.shape) return this.show();
    this.view.setBackground(backgroundOf(look));
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
