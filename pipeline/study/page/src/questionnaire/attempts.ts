// What happened in a trial before its page was reloaded: the participant may have watched its stimuli already.

import { Drawer } from "./store";

/** What was played in the earlier attempts at a trial. */
export interface Played {
  /** Playings that were begun, and those of them that reached the end. */
  begun: number;
  ended: number;
  /** Of the longest playing, in milliseconds. */
  longest_ms: number;
  /** Of a grid: which of its stimuli were seen, as their places. */
  seen?: number[];
}

interface Attempt {
  trial: number;
  /** How often the page of the trial was opened. */
  attempt: number;
  played: Played;
}

type Of = { design: string };

const drawerOf = ({ design }: Of, session: string): Drawer => new Drawer(`mien/${design}/${session}/trial`);

/** The attempt at a trial that is being made: it survives a reload. */
export class TrialAttempt {
  readonly number: number;
  /** In earlier attempts. */
  readonly before: Played;
  private drawer: Drawer;

  constructor(experiment: Of, session: string, private trial: number) {
    this.drawer = drawerOf(experiment, session);
    const kept = this.drawer.read<Attempt>();
    const earlier = kept?.trial === trial ? kept : null;
    this.number = (earlier?.attempt ?? 0) + 1;
    this.before = earlier?.played ?? { begun: 0, ended: 0, longest_ms: 0 };
    this.note({ begun: 0, ended: 0, longest_ms: 0 });
  }

  /** Notes what has been played in this attempt. */
  note({ begun, ended, longest_ms: longest, seen = [] }: Played): void {
    const { before } = this;
    const played = { begun: before.begun + begun, ended: before.ended + ended,
      longest_ms: Math.max(before.longest_ms, longest), seen: [...new Set([...before.seen ?? [], ...seen])] };
    this.drawer.write({ trial: this.trial, attempt: this.number, played } satisfies Attempt);
  }

  end(): void {
    this.drawer.clear();
  }
}
