import { find, map_of, with_figure, type Document, type Json, type JsonMap, type ManifestState, type Stimulus } from "./document";
import { History } from "./history";
import { edited } from "./manifest_edit";
import { Refusal, sentence_of, type Fault } from "./refusal";
import { load_choices, load_figure, load_places, make, reload, save, type Choices, type Made, type Places,
  type StudioState } from "./server";

/** What has changed, for those who show it. */
export type Change = "document" | "choices" | "asked" | "motion" | "selection" | "faults" | "saved" | "places";

/** What the page is about: a document, what is chosen of it, and the motions that it makes. */
export class Studio {
  readonly history: History;
  readonly place: string;
  readonly file: string;
  readonly words: StudioState["words"];
  readonly has_walker: boolean;
  readonly job_before: StudioState["job"];
  /** The examples of the manifest as it was opened: a folder can be named by nobody else. */
  readonly opened_examples: JsonMap;
  selected: string;
  /** What the motion is held against: a stimulus, an example, or nothing. */
  against = "";
  choices: Choices = { examples: [], sliders: { adjectives: [], features: [] }, blendable: true,
    simulated: false, warnings: [] };
  places: Places = { folders: [], characters: [], all: true };
  /** What motions are shown on here, whatever the manifest says; null: what it says. */
  shown_on: Json = null;
  made: Made | null = null;
  other: Made | null = null;
  faults: Fault[] = [];
  is_on_disk: boolean;
  /** Milliseconds from the last change to its motion, as measured here. */
  took = 0;
  private saved: ManifestState;
  private told: ((change: Change) => void)[] = [];
  private is_making = false;
  private is_stale = false;
  private examples = "";
  private other_key = "";

  constructor(state: StudioState) {
    this.history = new History(state.manifest.document);
    this.saved = state.manifest;
    this.file = state.file;
    this.place = state.place;
    this.words = state.words;
    this.has_walker = state.walker;
    this.job_before = state.job;
    this.opened_examples = map_of(state.manifest.document["examples"]);
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

  has_changes = (): boolean =>
    !this.is_on_disk || JSON.stringify(this.document()) !== JSON.stringify(this.saved.document);

  /** `gesture`: what is changed again and again while a slider is dragged. */
  change(document: Document, gesture = ""): void {
    this.history.change(document, gesture);
    this.after_change();
  }

  change_stimulus(stimulus: Stimulus, gesture = ""): void {
    const document = this.document();
    const stimuli = document.stimuli.map((one) => (one.id === this.selected ? stimulus : one));
    this.change({ ...document, stimuli }, gesture && `${this.selected} ${gesture}`);
  }

  undo(): void {
    if (this.history.undo()) this.after_change();
  }

  redo(): void {
    if (this.history.redo()) this.after_change();
  }

  select(id: string): void {
    this.selected = id;
    this.tell("selection", "document");
    this.remake();
  }

  compare_with(name: string): void {
    this.against = name;
    this.tell("selection");
    this.remake();
  }

  show_on(figure: Json): void {
    this.shown_on = figure;
    this.remake();
  }

  /** The document with the figure that is chosen here in the place of its own. */
  private shown_document(): Document {
    return this.shown_on === null ? this.document() : with_figure(this.document(), this.shown_on);
  }

  /** The file of the figure that a stimulus or an example is shown on. */
  figure_of = (name: string, key: string): Promise<ArrayBuffer> => load_figure(this.shown_document(), name, key);

  /** What of the folders about may be chosen. */
  async find_places(): Promise<void> {
    this.places = await load_places();
    this.tell("places");
  }

  private after_change(): void {
    if (!this.stimulus()) this.selected = this.document().stimuli[0]?.id ?? "";
    this.tell("document");
    this.remake();
  }

  /** The motions as the document has them now; what was asked meanwhile is asked once, when the last
      answer has come. */
  remake(): void {
    this.is_stale = true;
    if (!this.is_making) void this.make_all();
  }

  private async make_all(): Promise<void> {
    this.is_making = true;
    while (this.is_stale) {
      this.is_stale = false;
      const from = performance.now();
      this.tell("asked");
      try {
        await this.load_choices();
        await this.make_shown();
        this.took = performance.now() - from;
        this.set_faults([]);
      } catch (error) {
        this.set_faults(error instanceof Refusal ? error.faults
          : [{ path: "", wrong: String(error), remedy: "load the page again" }]);
      }
    }
    this.is_making = false;
  }

  private async load_choices(): Promise<void> {
    const { examples, seed } = this.document();
    const key = JSON.stringify([examples, seed]);
    if (key === this.examples) return;
    this.choices = await load_choices(this.document());
    this.examples = key;
    if (this.against && !this.names().includes(this.against)) this.against = "";
    this.tell("choices");
  }

  private async make_shown(): Promise<void> {
    const document = this.shown_document();
    const against = this.against === this.selected ? "" : this.against;
    const made = await make(document, this.selected, against);
    const key = against && JSON.stringify([find(document, against) ?? against, document["examples"],
      document["interpolation"], document["output"], document["recipes"], document["look"]]);
    if (key !== this.other_key) this.other = against ? await make(document, against, "") : null;
    this.other_key = key;
    this.made = made;
    this.tell("motion");
  }

  /** What a motion may be held against. */
  names(): string[] {
    return [...this.document().stimuli.map((stimulus) => stimulus.id), ...this.choices.examples];
  }

  private set_faults(faults: Fault[]): void {
    const is_other = faults.map(sentence_of).join() !== this.faults.map(sentence_of).join();
    this.faults = faults;
    if (is_other) this.tell("faults");
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
    this.after_change();
    this.tell("saved");
  }
}
