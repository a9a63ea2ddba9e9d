import type { TrialAttempt } from "./attempts";
import { fixedWidth, shownSize, type ShownSize } from "./display";
import { element } from "./elements";
import type { PlayFault, Settings } from "./experiment";
import { leaveOutOffer, patienceMs, stopsOfFault, waitForFilmMs } from "./leave_out";
import { screenOf, type Screen } from "./screen";
import { stageColour, type Seen, type ShownMedia, type TrialStage } from "./stage";
import type { Texts } from "./texts";
import type { GridFilms } from "./trials/trial_kind";

/** A film of a grid. */
interface Film {
  screen: Screen;
  frame: HTMLElement;
  isReady: boolean;
  /** Played to its end, or begun where that is enough. */
  isSeen: boolean;
  plays: number;
  ended: number;
}

/**
 * The films of a grid, of which one is played at a time, as often as wanted: those to rate in the same place, and the
 * open reference, if there is one, beside them. Covered while none is played.
 */
export class GridStage implements TrialStage, GridFilms {
  readonly root: HTMLElement;
  /** Whether two films are beside each other. */
  readonly isWide: boolean;
  private films: Film[] = [];
  private playing: number | null = null;
  private listeners: (() => void)[] = [];
  private note = element("p", { class: "stage-note", role: "status" });
  private caption = element("figcaption", {}, "–");
  private firstStart: number | null = null;
  private allSeen: number | null = null;
  private stalls = 0;
  private stallMs = 0;
  private stalledAt: number | null = null;
  private volumeEvents: string[] = [];
  private longestMs = 0;
  private playedAt: number | null = null;
  private stops = 0;
  private watchDog = 0;
  private waiting = 0;
  /** Places of those that cannot be played. */
  private failed: number[] = [];
  private fault: PlayFault = "not_loaded";
  private offer = element("div", { class: "play-fault" });

  constructor(
    private shown: ShownMedia[], private settings: Settings, private texts: Texts, private attempt: TrialAttempt,
    private beganAt: number, private leftOut: (fault: PlayFault) => void,
  ) {
    this.isWide = shown.some(({ role }) => role === "reference");
    const rated = element("figure", { class: "frame to_rate" });
    const frames = element("div", { class: "frames" }, rated);
    for (const one of shown) {
      const film = this.filmOf(one, this.films.length);
      this.films.push(film);
      if (one.role === "reference")
        frames.prepend(element("figure", { class: "frame reference" }, film.frame,
          element("figcaption", {}, texts.gridReference)));
      else rated.append(film.frame);
    }
    rated.append(this.caption);
    this.note.textContent = texts.waitForVideo;
    this.root = element("div", { class: `stage grid-stage ${this.isWide ? "two" : "one"}` }, frames,
      element("div", { class: "cover" }, this.note, this.offer));
    if (settings.display) this.root.classList.add("fixed");
    for (const index of attempt.before.seen ?? []) if (this.films[index]) this.films[index].isSeen = true;
    addEventListener("pagehide", this.noteWatched);
    shown.forEach(({ url }, index) => { if (url === undefined) this.fail(index, "not_loaded"); });
    if (!this.failed.length)
      this.waiting = window.setTimeout(() => this.films.forEach(({ isReady }, index) => {
        if (!isReady) this.fail(index, "not_loaded");
      }), waitForFilmMs);
  }

  /** The others can be played, but the trial cannot be completed. What is left out has the fault of the first. */
  private fail(index: number, fault: PlayFault): void {
    clearTimeout(this.waiting);
    if (this.failed.includes(index)) return;
    this.failed.push(index);
    this.note.textContent = "";
    const names = this.failed.sort((one, other) => one - other).map((one) => this.labelOf(one)).join(", ");
    if (this.failed.length === 1) this.fault = fault;
    this.offerToLeaveOut(this.fault, `${names}: ${this.texts.cannotPlay}`);
  }

  private labelOf = (index: number): string =>
    (index === this.reference() ? this.texts.gridReference : String(index + 1));

  private offerToLeaveOut(fault: PlayFault, said = ""): void {
    this.offer.replaceChildren(...(said ? [element("p", { class: "failed-films" }, said)] : []),
      ...leaveOutOffer(this.texts, () => this.leftOut(fault)));
  }

  /** Notes what is played, so that it is known after a reload. */
  private noteWatched = (): void => {
    if (this.playedAt !== null) this.longestMs = Math.max(this.longestMs, Math.round(this.now() - this.playedAt));
    const sum = (of: (film: Film) => number) => this.films.reduce((all, film) => all + of(film), 0);
    this.attempt.note({ begun: sum(({ plays }) => plays), ended: sum(({ ended }) => ended), longest_ms: this.longestMs,
      seen: this.films.flatMap(({ isSeen }, index) => (isSeen ? [index] : [])) });
  };

  isWatched = (): boolean => true;

  private filmOf({ url, figures, media, role }: ShownMedia, index: number): Film {
    const isLoaded = url !== undefined;
    const label = this.labelOf(index);
    const screen = screenOf(url ?? "", figures, media, label, stageColour(role), {
      began: (at) => this.began(index, at),
      stalled: () => {
        this.stalledAt ??= this.now();
        this.watch(index);
      },
      wentOn: () => this.wentOn(),
      ended: () => this.ended(index),
      volumeChanged: (volume) => this.volumeEvents.push(`${Math.round(this.now())}:${Math.round(100 * volume) / 100}`),
    });
    screen.element.classList.add("screen");
    if (screen.element instanceof HTMLVideoElement) screen.element.setAttribute("aria-label", label);
    const width = fixedWidth(this.settings.display, media);
    if (width !== null) {
      screen.element.style.width = `${width}px`;
      screen.element.style.height = `${(width * media.height) / media.width}px`;
    }
    const frame = element("div", { class: "film" }, screen.element);
    if (media.width && media.height) frame.style.setProperty("--ratio", String(media.width / media.height));
    const film: Film = { screen, frame, isReady: false, isSeen: false, plays: 0, ended: 0 };
    screen.ready.then(
      () => { film.isReady = true; this.changed(); },
      () => this.fail(index, isLoaded ? "not_decoded" : "not_loaded"));
    return film;
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  private changed(): void {
    if (this.films.every(({ isReady }) => isReady) && this.note.textContent === this.texts.waitForVideo) {
      clearTimeout(this.waiting);
      this.note.textContent = "";
    }
    this.films.forEach(({ frame }, index) => frame.classList.toggle("current", index === this.playing));
    this.root.classList.toggle("playing", this.playing !== null);
    for (const listener of this.listeners) listener();
  }

  private now = (): number => performance.now() - this.beganAt;

  isReady = (index: number): boolean => this.films[index]!.isReady;
  isSeen = (index: number): boolean => this.films[index]!.isSeen;
  isPlaying = (index: number): boolean => this.playing === index;
  reference = (): number => this.shown.findIndex(({ role }) => role === "reference");

  playFilm(index: number): void {
    const film = this.films[index]!;
    if (!film.isReady) return;
    this.wentOn();
    if (this.playing !== null) this.films[this.playing]!.screen.stop();
    film.plays += 1;
    this.noteWatched();
    this.playedAt = this.now();
    this.note.textContent = "";
    this.playing = index;
    this.watch(index);
    if (index !== this.reference()) this.caption.textContent = String(index + 1);
    film.screen.play();
    this.changed();
  }

  /** A film that does not go on by itself may be started again without its counting as a replay. */
  private watch(index: number, longestMs = 0): void {
    clearTimeout(this.watchDog);
    this.watchDog = window.setTimeout(() => {
      if (this.playing !== index) return;
      this.wentOn();
      this.films[index]!.screen.stop();
      this.films[index]!.plays -= 1;
      this.noteWatched();
      this.playedAt = null;
      this.playing = null;
      this.note.textContent = this.texts.stalled;
      this.stops += 1;
      if (this.stops >= stopsOfFault) this.offerToLeaveOut("stalled");
      this.changed();
    }, longestMs + patienceMs);
  }

  /** Plays a film by its number, from 1, if there is one. */
  playNumber(number: number): void {
    if (number <= this.films.length && number - 1 !== this.reference()) this.playFilm(number - 1);
  }

  private began(index: number, at: number): void {
    this.firstStart ??= at - this.beganAt;
    if (this.settings.watch === "free" && this.playing === index) this.saw(index);
  }

  private wentOn(): void {
    clearTimeout(this.watchDog);
    if (this.playing !== null) this.watch(this.playing, 1000 * this.shown[this.playing]!.media.seconds);
    if (this.stalledAt === null) return;
    this.stalls += 1;
    this.stallMs += this.now() - this.stalledAt;
    this.stalledAt = null;
  }

  private ended(index: number): void {
    if (this.playing !== index) return;
    this.wentOn();
    this.films[index]!.ended += 1;
    this.playing = null;
    if (!this.failed.length) this.offer.replaceChildren();
    this.saw(index);
    this.noteWatched();
    this.playedAt = null;
  }

  private saw(index: number): void {
    this.films[index]!.isSeen = true;
    if (this.films.every(({ isSeen }) => isSeen)) this.allSeen ??= this.now();
    this.changed();
  }

  /** The last one again, or the first. */
  play(): void {
    this.playFilm(this.playing ?? 0);
  }

  focus(): void {
    // Its films are played by buttons beside their sliders.
  }

  shownSize(): ShownSize | undefined {
    const [first] = this.films;
    return first && shownSize(this.settings.display, first.screen.element);
  }

  seen(): Seen {
    const dropped = this.films.map(({ screen }) => screen.dropped_frames());
    const rounded = (time: number | null) => (time === null ? null : Math.round(time));
    return {
      replays: this.films.reduce((sum, { plays }, index) =>
        sum + Math.max(0, plays - (this.wasSeen(index) ? 0 : 1)), 0),
      attempt: this.attempt.number,
      plays_before: this.attempt.before.begun,
      watched_before_ms: this.attempt.before.longest_ms,
      play_start_ms: rounded(this.firstStart),
      ended_ms: rounded(this.allSeen),
      stalls: this.stalls,
      stall_ms: Math.round(this.stallMs),
      dropped_frames: dropped.includes(null) ? null : (dropped as number[]).reduce((sum, one) => sum + one, 0),
      volume_events: this.volumeEvents.slice(0, 50).join(" "),
    };
  }

  /** Before the page was reloaded. */
  private wasSeen = (index: number): boolean => !!this.attempt.before.seen?.includes(index);

  release(): void {
    clearTimeout(this.watchDog);
    clearTimeout(this.waiting);
    removeEventListener("pagehide", this.noteWatched);
    for (const { screen } of this.films) screen.release();
  }
}
