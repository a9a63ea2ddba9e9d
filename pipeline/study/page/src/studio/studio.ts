import { find, mapOf, withFigure, type Document, type Json, type JsonMap, type ManifestState, type Stimulus } from "./document";
import { History } from "./history";
import { edited } from "./manifest_edit";
import { Refusal, sentenceOf, type Fault } from "./refusal";
import { loadChoices, loadFigure, loadPlaces, make, reload, save, type Choices, type Made, type Places,
  type StudioState } from "./server";

/** What has changed, for those who show it. */
export type Change = "document" | "choices" | "asked" | "motion" | "selection" | "faults" | "saved" | "places";

/** What the page is about: a document, what is chosen of it, and the motions that it makes. */
export class Studio {
  readonly history: History;
  readonly place: string;
  readonly file: string;
  readonly words: StudioState["words"];
  readonly hasWalker: boolean;
  readonly jobBefore: StudioState["job"];
  /** The examples of the manifest as it was opened: a folder can be named by nobody else. */
  readonly openedExamples: JsonMap;
  selected: string;
  /** What the motion is held against: a stimulus, an example, or nothing. */
  against = "";
  choices: Choices = { examples: [], sliders: { adjectives: [], features: [] }, blendable: true,
    simulated: false, warnings: [] };
  places: Places = { folders: [], characters: [], all: true };
  /** What motions are shown on here, whatever the manifest says; null: what it says. */
  shownOn: Json = null;
  made: Made | null = null;
  other: Made | null = null;
  faults: Fault[] = [];
  is_on_disk: boolean;
  /** Milliseconds from the last change to its motion, as measured here. */
  took = 0;
  private saved: ManifestState;
  private told: ((change: Change) => void)[] = [];
  private isMaking = false;
  private isStale = false;
  private examples = "";
  private otherKey = "";

  constructor(state: StudioState) {
    this.history = new History(state.manifest.document);
    this.saved = state.manifest;
    this.file = state.file;
    this.place = state.place;
    this.words = state.words;
    this.hasWalker = state.walker;
    this.jobBefore = state.job;
    this.openedExamples = mapOf(state.manifest.document["examples"]);
    this.is_on_disk = state.is_on_disk;
    this.selected = state.manifest.document.stimuli[0]?.id ?? "";
  }

  on(heard: (change: Change) => void): void {
    this.told.push(heard);
  }

  private tell(...changes: Change[]): void {
    for (const change of changes) for (const heard of this.told) heard(change);
  }

  document(): Document {
    return this.history.document();
  }

  stimulus(): Stimulus | undefined {
    return find(this.document(), this.selected);
  }

  hasChanges = (): boolean =>
    !this.is_on_disk || JSON.stringify(this.document()) !== JSON.stringify(this.saved.document);

  /** `gesture`: what is changed again and again while a slider is dragged. */
  change(document: Document, gesture = ""): void {
    this.history.change(document, gesture);
    this.afterChange();
  }

  changeStimulus(stimulus: Stimulus, gesture = ""): void {
    const document = this.document();
    const stimuli = document.stimuli.map((one) => (one.id === this.selected ? stimulus : one));
    this.change({ ...document, stimuli }, gesture && `${this.selected} ${gesture}`);
  }

  undo(): void {
    if (this.history.undo()) this.afterChange();
  }

  redo(): void {
    if (this.history.redo()) this.afterChange();
  }

  select(id: string): void {
    this.selected = id;
    this.tell("selection", "document");
    this.remake();
  }

  compareWith(name: string): void {
    this.against = name;
    this.tell("selection");
    this.remake();
  }

  showOn(figure: Json): void {
    this.shownOn = figure;
    this.remake();
  }

  /** The document with the figure that is chosen here in the place of its own. */
  private shownDocument(): Document {
    return this.shownOn === null ? this.document() : withFigure(this.document(), this.shownOn);
  }

  /** The file of the figure that a stimulus or an example is shown on. */
  figureOf = (name: string, key: string): Promise<ArrayBuffer> => loadFigure(this.shownDocument(), name, key);

  /** What of the folders about may be chosen. */
  async findPlaces(): Promise<void> {
    this.places = await loadPlaces();
    this.tell("places");
  }

  private afterChange(): void {
    if (!this.stimulus()) this.selected = this.document().stimuli[0]?.id ?? "";
    this.tell("document");
    this.remake();
  }

  /** The motions as the document has them now; what was asked meanwhile is asked once, when the last
      answer has come. */
  remake(): void {
    this.isStale = true;
    if (!this.isMaking) void this.makeAll();
  }

  private async makeAll(): Promise<void> {
    this.isMaking = true;
    while (this.isStale) {
      this.isStale = false;
      const from = performance.now();
      this.tell("asked");
      try {
        await this.loadChoices();
        await this.makeShown();
        this.took = performance.now() - from;
        this.setFaults([]);
      } catch (error) {
        this.setFaults(error instanceof Refusal ? error.faults
          : [{ path: "", wrong: String(error), remedy: "load the page again" }]);
      }
    }
    this.isMaking = false;
  }

  private async loadChoices(): Promise<void> {
    const { examples, seed } = this.document();
    const key = JSON.stringify([examples, seed]);
    if (key === this.examples) return;
    this.choices = await loadChoices(this.document());
    this.examples = key;
    if (this.against && !this.names().includes(this.against)) this.against = "";
    this.tell("choices");
  }

  private async makeShown(): Promise<void> {
    const document = this.shownDocument();
    const against = this.against === this.selected ? "" : this.against;
    const made = await make(document, this.selected, against);
    const key = against && JSON.stringify([find(document, against) ?? against, document["examples"],
      document["interpolation"], document["output"], document["recipes"], document["look"]]);
    if (key !== this.otherKey) this.other = against ? await make(document, against, "") : null;
    this.otherKey = key;
    this.made = made;
    this.tell("motion");
  }

  /** What a motion may be held against. */
  names(): string[] {
    return [...this.document().stimuli.map((stimulus) => stimulus.id), ...this.choices.examples];
  }

  private setFaults(faults: Fault[]): void {
    const isOther = faults.map(sentenceOf).join() !== this.faults.map(sentenceOf).join();
    this.faults = faults;
    if (isOther) this.tell("faults");
  }

  /** The manifest as it would be saved. Throws Refusal. */
  text = (base = this.saved): string => edited(base.text, this.file, base.document, this.document());

  /** Writes the changes into the text of `base`. Throws Refusal; of status 409, with the file's state now as
      `manifest`, when that is another. */
  async save(base = this.saved): Promise<void> {
    const document = this.document();
    const state = await save(document, this.text(base), base.version);
    this.saved = { ...state, document };
    this.is_on_disk = true;
    this.tell("saved");
  }

  /** The file as it is now; what was changed here is lost. */
  async reload(): Promise<void> {
    this.saved = await reload();
    this.is_on_disk = true;
    this.history.begin(this.saved.document);
    this.afterChange();
    this.tell("saved");
  }
}
