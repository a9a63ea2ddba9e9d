// Sessions that ended early, as this browser remembers them where no server does: whoever was turned away, or has
// withdrawn, sees the same page again. No answers are kept.

import { Drawer } from "./store";

/** How a session ended. */
export interface EarlyEnd {
  ended: "screened_out" | "withdrawn";
  /** Date and time, ISO 8601. */
  at: string;
  /** Columns of the table of participants: the plan and, of whoever was screened out, why. */
  row: Record<string, string>;
}

interface Noted extends EarlyEnd {
  /** Whom it concerns; "" for whoever sits at this browser. */
  who: string;
  /** The next participant may begin at this browser. */
  is_past?: boolean;
}

const drawerOf = (study: string): Drawer => new Drawer(`mien/${study}/ends`);
const notedOf = (study: string): Noted[] => drawerOf(study).read<Noted[]>() ?? [];

/** Those of one link. */
export class EarlyEnds {
  /** `who` is what tells the people apart who use this browser; "" where nothing does. */
  constructor(private study: string, private who: string) {}

  /** How the session of this link ended; undefined where one may begin. */
  former(): EarlyEnd | undefined {
    return notedOf(this.study).find(({ who, is_past: isPast }) => who === this.who && !isPast);
  }

  note(ended: EarlyEnd["ended"], row: Record<string, string>): void {
    if (this.former()) return;
    const at = new Date().toISOString();
    drawerOf(this.study).write([...notedOf(this.study), { who: this.who, ended, at, row } satisfies Noted]);
  }
}

/** All of a study, in their order. */
export const earlyEndsOf = (study: string): EarlyEnd[] => notedOf(study);

/** The next participant may sit down at this browser; people whom their links tell apart stay remembered. */
export function admitNext(study: string): void {
  const noted = notedOf(study);
  if (noted.length)
    drawerOf(study).write(noted.map((one) => (one.who === "" ? { ...one, is_past: true } : one)));
}

export const forgetEarlyEnds = (study: string): void => drawerOf(study).clear();
