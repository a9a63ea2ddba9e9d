import type { Destination, PageRecord, Planned, Session, SessionEnd } from "./experiment";

type Named = { participant: string };

/** Told that something takes long, and why: the connection is slow or lost, or a server waits for others. */
export type Wait = (why: "saving" | "failed" | "busy") => void;

/** Where the records of a session are kept while it lasts. */
export interface Store<Own extends Named = Session> {
  session: Own;
  /** Random name of this browser session; a reload keeps it. */
  name: string;
  /** What was kept before the page was opened, by name. */
  records: Record<string, PageRecord>;
  /** Names of all that is kept, also where the records themselves cannot be seen again. */
  kept: Set<string>;
  /** Returns once the record is safe. `wait` is told when that takes long, and why. */
  keep(record: PageRecord, wait: Wait): Promise<void>;
  /** After the last record; once more after a reload where `mustFinish` says so. */
  finish(wait: Wait): Promise<void>;
  mustFinish?(): boolean;
  /** Where the participant is sent to, once a server has told it. */
  destination?(): Destination | undefined;
  /** How a server ended the session early. */
  ended?(): SessionEnd | undefined;
  /** Deletes all that was stored of the session; where the participant is sent to then. */
  withdraw?(): Promise<Destination | undefined>;
  /** Ends the session where another program around the page does that, and leads to the address. */
  leave?(address: string | undefined): void;
  /** Forgets the session, where the next participant may sit down at the same browser, or nobody has agreed. */
  clear?(): void;
  /** Whether the files of the session were saved once; in folders. */
  isSaved?(): boolean;
  noteSaved?(): void;
}

/** Why no further answers are accepted from this window. */
export class SessionClosed extends Error {
  constructor(readonly why: "elsewhere" | "enough" | SessionEnd) { super(why); }
}

/** What a server says that does not take a record, or has no step to give, while the session goes on. */
export class Declined extends Error {
  constructor(readonly why: "taken" | "finished") { super(why); }
}

export const pause = (milliseconds: number): Promise<void> =>
  new Promise((done) => setTimeout(done, milliseconds));

export function randomName(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(8));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
}

/** A random one of those that were taken least. */
export function leastTaken<Own extends Named>(sessions: Own[], taken: Record<string, number>): Own {
  const times = (session: Own) => taken[session.participant] ?? 0;
  const least = Math.min(...sessions.map(times));
  const free = sessions.filter((session) => times(session) === least);
  const drawn = crypto.getRandomValues(new Uint32Array(1))[0]! / 2 ** 32;
  return free[Math.floor(drawn * free.length)]!;
}

/** The plan of that name. Throws, with those that there are. */
export function namedSession<Own extends Named>(sessions: Own[], participant: string): Own {
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
  is_saved?: boolean;
  /** Of a complete session on JATOS: its files were handed in, or cannot be. */
  is_handed_in?: boolean;
}

/**
 * A text under a name in this browser; where the browser keeps nothing, in the name of this window,
 * which outlives a reload.
 */
export class Drawer {
  constructor(private key: string) {}

  read<T>(): T | null {
    // Only what could not be kept otherwise is in the window, and it is newer then.
    let text: string | null = textsOfWindow()[this.key] ?? null;
    try {
      text ??= localStorage.getItem(this.key);
    } catch { /* in the window alone */ }
    return text === null ? null : (JSON.parse(text) as T);
  }
  write(value: unknown): void {
    const text = JSON.stringify(value);
    try {
      localStorage.setItem(this.key, text);
      this.forgetInWindow();
    } catch {
      window.name = JSON.stringify({ ...textsOfWindow(), [this.key]: text });
    }
  }
  clear(): void {
    this.forgetInWindow();
    try {
      localStorage.removeItem(this.key);
    } catch { /* nothing was kept */ }
  }
  private forgetInWindow(): void {
    const { [this.key]: forgotten, ...others } = textsOfWindow();
    if (forgotten !== undefined) window.name = JSON.stringify(others);
  }
}

/** The keys of all drawers that hold something. */
function keysInBrowser(): string[] {
  const inWindow = Object.keys(textsOfWindow());
  try {
    return [...new Set([...Object.keys(localStorage), ...inWindow])];
  } catch {
    return inWindow;
  }
}

/** Forgets what this browser keeps of a browser session beside its records: attempts at trials, answers. */
export function forgetDrawers(design: string, session: string): void {
  for (const key of keysInBrowser())
    if (key.startsWith(`mien/${design}/${session}/`)) new Drawer(key).clear();
}

function textsOfWindow(): Record<string, string> {
  try {
    const texts: unknown = JSON.parse(window.name);
    return typeof texts === "object" && texts !== null ? (texts as Record<string, string>) : {};
  } catch {
    return {};
  }
}

const sessionKey = (design: string): string => `mien/${design}/session`;

/** A session that this browser holds of a page without a server. */
export interface KeptSession {
  kept: Remembered;
  forget(): void;
}

/** All sessions that this browser holds: that of links that name nobody, and one of each person. */
export function keptSessions(design: string): KeptSession[] {
  const key = sessionKey(design);
  return keysInBrowser().filter((one) => one === key || one.startsWith(`${key}/`)).sort().flatMap((one) => {
    const drawer = new Drawer(one);
    const kept = drawer.read<Remembered>();
    return kept ? [{ kept, forget: () => drawer.clear() }] : [];
  });
}

/** Forgets the session of links that name nobody. */
export const forgetSharedSession = (design: string): void => new Drawer(sessionKey(design)).clear();

/** Which plan: ?participant=p003, else a random one of those taken least in this browser. People whom their links tell
    apart (`person`) have a session each. Nothing is kept, and no plan is taken, before the first record: the consent. */
export function folderStore<Own extends Named>(
  experiment: Planned<Own>, wanted: string | null, person = ""): Store<Own> {
  const current = new Drawer(sessionKey(experiment.design) + (person && `/${person}`));
  const counts = new Drawer(`mien/${experiment.design}/taken`);
  const taken = () => counts.read<Record<string, number>>() ?? {};
  const former = current.read<Remembered>();
  const own = former && wanted && former.participant !== wanted ? null : former;
  const kept: Remembered = own ?? { name: randomName(), records: {},
    participant: (wanted ? namedSession(experiment.sessions, wanted) : leastTaken(experiment.sessions, taken())).participant };
  let isCounted = own !== null;
  const count = ({ participant }: Remembered) => {
    counts.write({ ...taken(), [participant]: (taken()[participant] ?? 0) + 1 });
    isCounted = true;
  };
  return {
    session: namedSession(experiment.sessions, kept.participant),
    name: kept.name,
    records: kept.records,
    kept: new Set(Object.keys(kept.records)),
    async keep(record) {
      if (!isCounted) count(kept);
      kept.records[record.record] = record;
      this.kept.add(record.record);
      current.write(kept);
    },
    async finish() {},
    clear: () => current.clear(),
    async withdraw() {
      current.clear();
      return undefined;
    },
    isSaved: () => kept.is_saved === true,
    noteSaved() {
      kept.is_saved = true;
      current.write(kept);
    },
  };
}

/** Errors of a server that say that no further answers are accepted from this window. */
const closing: Record<string, SessionClosed["why"]> = {
  elsewhere: "elsewhere",
  other: "elsewhere",  // another window of this browser was first
  refused: "refused",
  screened_out: "screened_out",
  withdrawn: "withdrawn",
  failed_attention: "failed_attention",
  enough: "enough",
};

interface Answered {
  /** Of those who join: where their session is. */
  session?: string;
  ended?: SessionEnd;
  destination?: Destination;
}

/** Whether a server that answers with that status may answer otherwise later. */
export const isPassing = (status: number): boolean => [408, 429, 500, 502, 503, 504, 507].includes(status);

const posted = (address: string, value: unknown): Promise<Response> =>
  fetch(address, {
    method: "POST",
    headers: { "Content-Type": "application/json" },
    body: JSON.stringify(value),
    cache: "no-store",
  });

/** Posts until the server says that it has what was posted; its answer. */
export async function post<Answer = Answered>(address: string, value: unknown, wait: Wait): Promise<Answer> {
  for (let tries = 0; ; tries += 1) {
    const slow = setTimeout(() => wait("saving"), 400);
    let isBusy = false;
    try {
      const answer = await posted(address, value);
      const said = (await answer.json().catch(() => ({}))) as Answer & { error?: string; wrong?: string };
      if (answer.ok) return said;
      const closed = answer.status === 409 ? closing[said.error ?? ""] : undefined;
      if (closed) throw new SessionClosed(closed);
      if (answer.status === 409 && (said.error === "taken" || said.error === "finished")) throw new Declined(said.error);
      if (!isPassing(answer.status))
        throw new RefusedRecord(said.wrong ?? `The server refused an answer (${answer.status}).`);
      isBusy = answer.status === 503 && said.error === "busy";
    } catch (error) {
      if (error instanceof RefusedRecord || error instanceof SessionClosed || error instanceof Declined) throw error;
    } finally {
      clearTimeout(slow);
    }
    wait(isBusy ? "busy" : "failed");
    await pause(isBusy ? 2000 : Math.min(500 * 1.6 ** tries, 10000));
  }
}

/** Posts a record beside the page. */
const postRecord = (base: string, record: PageRecord, wait: Wait): Promise<Answered> =>
  post(`${base}records/${record.record}`, record, wait);

const drawerOf = (experiment: { design: string }, base: string): Drawer =>
  new Drawer(`mien/${experiment.design}/${base}`);

/**
 * Tells the server once a minute that the page is open, since films and forms may take longer than it takes others for
 * gone, whose plans it gives to new people: until half an hour after the last record, and while the page can be seen.
 */
class SignsOfLife {
  private readonly timer = setInterval(() => this.give(), 60000);
  private since = Date.now();

  constructor(private readonly address: string) {}

  renew(): void {
    this.since = Date.now();
  }
  end(): void {
    clearInterval(this.timer);
  }
  private give(): void {
    if (Date.now() - this.since > 30 * 60000 || document.visibilityState === "hidden") return;
    void fetch(this.address, { method: "HEAD", cache: "no-store" }).catch(() => {});
  }
}

/** Each record is posted beside the page. */
export function servedStore<Own extends Named>(experiment: Planned<Own>, base: string): Store<Own> {
  const session = experiment.sessions[0]!;
  const drawer = drawerOf(experiment, base);
  const own = drawer.read<Remembered>() ??
    { participant: session.participant, name: randomName(), records: {} };
  const kept = new Set(experiment.kept ?? []);
  let { destination, ended } = experiment;
  const isOwn = !experiment.browser || experiment.browser === own.name;
  const signs = isOwn && !ended ? new SignsOfLife(`${base}session.json`) : undefined;
  return {
    session,
    name: own.name,
    records: {},
    kept,
    async keep(record, wait) {
      own.records = { [record.record]: record };  // what a reload would send again
      drawer.write(own);
      try {
        ({ destination, ended } = await postRecord(base, record, wait));
      } finally {
        own.records = {};
        drawer.write(own);
      }
      kept.add(record.record);
      signs?.renew();
      if (ended) signs?.end();
    },
    async finish() {
      signs?.end();
    },
    destination: () => destination,
    ended: () => ended,
    clear: () => drawer.clear(),
    async withdraw() {
      const answer = await posted(`${base}withdrawal`, { session: own.name });
      if (!answer.ok) throw new Error(`The server refused the withdrawal (${answer.status}).`);
      signs?.end();
      drawer.clear();
      return ((await answer.json()) as Answered).destination;
    },
  };
}

/**
 * Of somebody who has no session: who agrees is given one, and goes on at its own address under the
 * name of this window. Each time the page is opened somebody else may sit here.
 */
export function joiningStore<Own extends Named>(
  experiment: Planned<Own>, base: string, joined: (consent: PageRecord, path: string) => void): Store<Own> {
  const name = randomName();
  return {
    session: experiment.sessions[0]!,
    name,
    records: {},
    kept: new Set(),
    async keep(record, wait) {
      const { session } = await postRecord(base, record, wait);
      if (!session) return;
      const there = new URL(session, location.href);
      drawerOf(experiment, there.pathname).write({ participant: "", name, records: {} });
      joined(record, there.pathname);
      location.replace(there);
      await new Promise(() => {});  // the other page goes on
    },
    async finish() {},
  };
}

class RefusedRecord extends Error {}

/** A record that was given and not yet acknowledged when the window was closed. */
export function unsentRecord(experiment: { design: string; kept?: string[] }, base: string): PageRecord | null {
  const own = drawerOf(experiment, base).read<Remembered>();
  const record = own && Object.values(own.records)[0];
  return record && !(experiment.kept ?? []).includes(record.record) ? record : null;
}
