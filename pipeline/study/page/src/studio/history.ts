import type { Document } from "./document";

/** The states of a document, and the way back and forth between them. */
export class History {
  private past: Document[] = [];
  private future: Document[] = [];
  /** What is being changed without a pause, as a slider that is dragged: one step of the history. */
  private gesture = "";

  constructor(private now: Document) {}

  document(): Document {
    return this.now;
  }

  change(document: Document, gesture = ""): void {
    if (gesture === "" || gesture !== this.gesture) this.past.push(this.now);
    this.gesture = gesture;
    this.now = document;
    this.future = [];
  }

  /** What follows is a step of its own. */
  endGesture(): void {
    this.gesture = "";
  }

  undo(): boolean {
    const before = this.past.pop();
    if (!before) return false;
    this.future.push(this.now);
    this.now = before;
    this.endGesture();
    return true;
  }

  redo(): boolean {
    const after = this.future.pop();
    if (!after) return false;
    this.past.push(this.now);
    this.now = after;
    this.endGesture();
    return true;
  }

  canUndo = (): boolean => this.past.length > 0;
  canRedo = (): boolean => this.future.length > 0;

  /** Another document, with nothing before or after it. */
  begin(document: Document): void {
    this.past = [];
    this.future = [];
    this.now = document;
    this.endGesture();
  }
}
