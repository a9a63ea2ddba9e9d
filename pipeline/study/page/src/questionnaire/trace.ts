// The trace of a marker that is moved while a film plays (pipeline/manifest/ratings/answers/trace.h).

/** Samples a second of the film's own time. */
const traceRate = 10;

/** Durations are not exact in binary: what is hardly longer than 3 s has no further sample. */
const slack = 1e-6;

/** Number of samples of a film's trace; the last one is at its end. */
const traceSamples = (seconds: number): number => Math.ceil(seconds * traceRate - slack) + 1;

interface Note {
  time: number;
  value: number;
}

/** Where the marker was at times of the film, in their order. */
export class TraceNotes {
  private notes: Note[] = [];

  clear(): void {
    this.notes = [];
  }

  /** Of several at the same time, where the film stood still, the last one is kept. */
  note(time: number, value: number): void {
    const last = this.notes[this.notes.length - 1];
    if (last && time < last.time) return;
    if (last && time === last.time) last.value = value;
    else this.notes.push({ time, value });
  }

  /** Sample k is the value at k / 10 s, interpolated between the notes before and after it, as text. */
  text(seconds: number): string {
    let after = 0;
    return Array.from({ length: traceSamples(seconds) }, (_, k) => {
      const time = k / traceRate;
      while (after < this.notes.length && this.notes[after]!.time <= time) after += 1;
      return String(Number(this.valueAt(time, after).toFixed(1)));
    }).join(" ");
  }

  /** `after` is the index of the first note that is later. */
  private valueAt(time: number, after: number): number {
    const before = this.notes[Math.max(0, after - 1)]!;
    const next = this.notes[Math.min(after, this.notes.length - 1)]!;
    if (next.time <= before.time) return before.value;
    return before.value + ((time - before.time) / (next.time - before.time)) * (next.value - before.value);
  }
}

/** Mean of the samples from `lead` seconds on; nothing where there are none. */
export function meanOfTrace(text: string, lead: number): number | null {
  const samples = text.split(" ").map(Number).slice(Math.ceil(lead * traceRate - slack));
  return samples.length ? samples.reduce((sum, one) => sum + one, 0) / samples.length : null;
}
