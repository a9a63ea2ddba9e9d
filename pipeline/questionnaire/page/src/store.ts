import type { Experiment, PageRecord, Session } from "./experiment";

/** Where the records of a session are kept while it lasts. */
export interface Store {
  session: Session;
  /** Random name of this browser session; a reload keeps it. */
  name: string;
  /** What was kept before the page was opened, by name. */
  records: Record<string, PageRecord>;
  /** Names of all that is kept, also where the records themselves cannot be seen again. */
  kept: Set<string>;
  /** Returns once the record is safe. `wait` is told when that takes long, and why. */
  keep(record: PageRecord, wait: (why: "saving" | "failed") => void): Promise<void>;
  /** After the last record. */
  finish(): Promise<void>;
  /** Forgets the session, where the next participant may sit down at the same browser. */
  clear?(): void;
}

export const pause = (milliseconds: number): Promise<void> =>
  new Promise((done) => setTimeout(done, milliseconds));

export function random_name(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(8));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
}

/** A random one of those that were taken least. */
export function least_taken(sessions: Session[], taken: Record<string, number>): Session {
  const times = (session: Session) => taken[session.participant] ?? 0;
  const least = Math.min(...sessions.map(times));
  const free = sessions.filter((session) => times(session) === least);
  const drawn = crypto.getRandomValues(new Uint32Array(1))[0]! / 2 ** 32;
  return free[Math.floor(drawn * free.length)]!;
}

/** The plan of that name. Throws, with those that there are. */
export function named_session(sessions: Session[], participant: string): Session {
  const found = sessions.find((session) => session.participant === participant);
  if (found) return found;
  const last = sessions[sessions.length - 1]!.participant;
  throw new Error(
    `There is no participant "${participant}"; there are ${sessions[0]!.participant} to ${last}.`);
}

/** What a browser remembers of a questionnaire. */
export interface Remembered {
  participant: string;
  name: string;
  records: Record<string, PageRecord>;
}

/** A text under a name in this browser; in this window's memory where the browser keeps nothing. */
class Drawer {
  private memory: string | null = null;
  constructor(private key: string) {}

  read<T>(): T | null {
    try {
      this.memory = localStorage.getItem(this.key) ?? this.memory;
    } catch { /* kept in memory alone */ }
    return this.memory === null ? null : (JSON.parse(this.memory) as T);
  }
  write(value: unknown): void {
    this.memory = JSON.stringify(value);
    try {
      localStorage.setItem(this.key, this.memory);
    } catch { /* kept in memory alone */ }
  }
  clear(): void {
    this.memory = null;
    try {
      localStorage.removeItem(this.key);
    } catch { /* nothing was kept */ }
  }
}

/** Which plan: ?participant=p003, else a random one of those taken least in this browser. */
export function folder_store(experiment: Experiment, wanted: string | null): Store {
  const current = new Drawer(`mien/${experiment.design}/session`);
  const counts = new Drawer(`mien/${experiment.design}/taken`);
  let own = current.read<Remembered>();
  if (own && wanted && own.participant !== wanted) own = null;
  if (!own) {
    const taken = counts.read<Record<string, number>>() ?? {};
    const { participant } = wanted ? named_session(experiment.sessions, wanted)
                                   : least_taken(experiment.sessions, taken);
    counts.write({ ...taken, [participant]: (taken[participant] ?? 0) + 1 });
    own = { participant, name: random_name(), records: {} };
    current.write(own);
  }
  const kept = own;
  return {
    session: named_session(experiment.sessions, kept.participant),
    name: kept.name,
    records: kept.records,
    kept: new Set(Object.keys(kept.records)),
    async keep(record) {
      kept.records[record.record] = record;
      this.kept.add(record.record);
      current.write(kept);
    },
    async finish() {},
    clear: () => current.clear(),
  };
}

/** Each record is posted beside the page until the server says that it has it. */
export function served_store(experiment: Experiment, base: string): Store {
  const session = experiment.sessions[0]!;
  const drawer = new Drawer(`mien/${experiment.design}/${base}`);
  const own = drawer.read<Remembered>() ??
    { participant: session.participant, name: random_name(), records: {} };
  drawer.write(own);
  const kept = new Set(experiment.kept ?? []);

  const post = async (record: PageRecord, wait: (why: "saving" | "failed") => void) => {
    for (let tries = 0; ; tries += 1) {
      const slow = setTimeout(() => wait("saving"), 400);
      try {
        const answer = await fetch(`${base}records/${record.record}`, {
          method: "POST",
          headers: { "Content-Type": "application/json" },
          body: JSON.stringify(record),
          cache: "no-store",
        });
        if (answer.ok) return;
        const said = (await answer.json().catch(() => ({}))) as { error?: string; wrong?: string };
        // Another window of the same participant was first, and what it gave stands.
        if (answer.status === 409 && said.error !== "order") return;
        if (![408, 429, 500, 502, 503, 504, 507].includes(answer.status))
          throw new RefusedRecord(said.wrong ?? `The server refused an answer (${answer.status}).`);
      } catch (error) {
        if (error instanceof RefusedRecord) throw error;
      } finally {
        clearTimeout(slow);
      }
      wait("failed");
      await pause(Math.min(500 * 1.6 ** tries, 10000));
    }
  };
  return {
    session,
    name: own.name,
    records: {},
    kept,
    async keep(record, wait) {
      own.records = { [record.record]: record };  // what a reload would send again
      drawer.write(own);
      await post(record, wait);
      own.records = {};
      drawer.write(own);
      kept.add(record.record);
    },
    async finish() {},
  };
}

class RefusedRecord extends Error {}

/** A record that was given and not yet acknowledged when the window was closed. */
export function unsent_record(experiment: Experiment, base: string): PageRecord | null {
  const own = new Drawer(`mien/${experiment.design}/${base}`).read<Remembered>();
  const record = own && Object.values(own.records)[0];
  return record && !(experiment.kept ?? []).includes(record.record) ? record : null;
}
