import type { Media, PlayFault, Settings } from "./experiment";
import { screenOf, type Screen, type ScreenEvents } from "./screen";
import { button, element } from "./elements";
import type { Played, TrialAttempt } from "./attempts";
import { leaveOutOffer, patienceMs, stopsOfFault, waitForFilmMs } from "./leave_out";
import type { Texts } from "./texts";
import { fixedWidth, shownSize, type ShownSize } from "./display";
import { pairNames } from "./trials/pair";

export interface ShownMedia {
  token: string;
  /** Undefined where it could not be loaded. */
  url: string | undefined;
  /** Of the figures that it shows. */
  figures: string[];
  media: Media;
  /** A member of a set has its number. */
  role: "alone" | "to_rate" | "reference" | "left" | "right" | "member";
}

/** What was seen, in milliseconds from when the trial began. */
export interface Seen {
  replays: number;
  attempt: number;
  plays_before: number;
  watched_before_ms: number;
  play_start_ms: number | null;
  ended_ms: number | null;
  stalls: number;
  stall_ms: number;
  dropped_frames: number | null;
  volume_events: string;
}

/** What shows the stimuli of a trial. */
export interface TrialStage {
  root: HTMLElement;
  /** From the beginning, if that is allowed now. */
  play(): void;
  /** Focuses what begins to play. */
  focus(): void;
  /** Whether the film at this place is playing; where that matters. */
  isPlaying?(place: number): boolean;
  /** The size of the first of the stimuli, if one can be shown. */
  shownSize(): ShownSize | undefined;
  /** Whether answers may be given at once: since before a reload as much was seen as is asked for, or where it is the
      answers that begin to play. */
  isWatched(): boolean;
  seen(): Seen;
  release(): void;
}

/** More changes of the volume than these are not kept. */
const mostVolumeEvents = 50;

const colours = { alone: "#3d3d3d", to_rate: "#2e7d4f", reference: "#b3403a", left: "#3d3d3d", right: "#3d3d3d",
  member: "#3d3d3d" };

/** Of a figure that is turned. */
export const stageColour = (role: ShownMedia["role"]): string => colours[role];

/** Between two stimuli that are shown one after the other (questionnaire/session_duration.cpp). */
const betweenMs = 500;

/**
 * One stimulus, several beside each other, or two one after the other, covered until they are played and after they have
 * ended. Those beside each other begin together. They have been seen when the last has ended.
 */
export class Stage implements TrialStage {
  readonly root: HTMLElement;
  protected screens: Screen[] = [];
  private cover: HTMLElement;
  private playButton: HTMLButtonElement;
  private note: HTMLElement;
  private frames: HTMLElement;
  private isInTurn: boolean;
  /** Of those that are shown one after the other, the one that is shown. */
  private current = 0;
  protected state: "loading" | "covered" | "playing" = "loading";
  private firstStart: number | null = null;
  private firstEnd: number | null = null;
  private stalls = 0;
  private stall_ms = 0;
  private stalledAt: number | null = null;
  private watchDog = 0;
  private volumeEvents: string[] = [];
  protected played: Played = { begun: 0, ended: 0, longest_ms: 0 };
  private playedAt: number | null = null;
  private stops = 0;
  private waiting = 0;
  private longestMs: number;
  private offer = element("div", { class: "play-fault" });

  constructor(
    shown: ShownMedia[], private settings: Settings, private texts: Texts, private attempt: TrialAttempt,
    private beganAt: number,
    private told: { began(): void; ended(): void; leftOut(fault: PlayFault): void },
  ) {
    this.isInTurn = settings.pairs === "in_turn" && shown.some(({ role }) => role === "left");
    const look = this.isInTurn ? "one in-turn" : shown.length > 2 ? `set of-${shown.length}`
      : shown.length > 1 ? "two" : "one";
    this.root = element("div", { class: `stage ${look}` });
    if (settings.display) this.root.classList.add("fixed");
    this.frames = element("div", { class: "frames" });
    this.longestMs = 1000 * Math.max(...shown.map(({ media }) => media.seconds));
    const isLoaded = shown.every(({ url }) => url !== undefined);
    if (isLoaded) for (const one of shown) this.frames.append(this.frameOf(one));
    this.showFrame(0);
    this.playButton = button("", () => this.play(), "play");
    this.note = element("p", { class: "stage-note", role: "status" });
    this.cover = element("div", { class: "cover" }, this.playButton, this.note, this.offer);
    this.root.append(this.frames, this.cover);
    this.showCover();
    if (isLoaded) this.load();
    else this.fail("not_loaded");
  }

  private load(): void {
    addEventListener("pagehide", this.noteWatched);
    this.waiting = window.setTimeout(() => this.fail("not_loaded"), waitForFilmMs);
    Promise.all(this.screens.map(({ ready }) => ready)).then(
      () => { clearTimeout(this.waiting); this.state = "covered"; this.showCover(); },
      () => { clearTimeout(this.waiting); this.fail("not_decoded"); });
  }

  private fail(fault: PlayFault): void {
    this.root.classList.add("failed");
    this.note.textContent = this.texts.cannotPlay;
    this.offerToLeaveOut(fault);
  }

  private offerToLeaveOut(fault: PlayFault): void {
    this.offer.replaceChildren(...leaveOutOffer(this.texts, () => this.told.leftOut(fault)));
  }

  isWatched(): boolean {
    const { begun, ended } = this.attempt.before;
    return this.settings.watch === "full" ? ended > 0 : begun > 0;
  }

  /** Notes what is played, so that it is known after a reload. */
  private noteWatched = (): void => {
    if (this.playedAt !== null)
      this.played.longest_ms = Math.max(this.played.longest_ms, Math.round(this.now() - this.playedAt));
    this.attempt.note(this.played);
  };

  private frameOf({ url = "", figures, media, role }: ShownMedia): HTMLElement {
    const [left, right] = pairNames({ settings: this.settings }, this.texts);
    const label = { alone: "", to_rate: this.texts.toRate, reference: this.texts.reference, left, right,
      member: String(this.screens.length + 1) }[role];
    const events: ScreenEvents = {
      began: (at) => this.began(at),
      stalled: () => this.stalled(),
      wentOn: () => this.wentOn(),
      ended: () => this.ended(),
      volumeChanged: (volume) => this.volumeChanged(volume),
    };
    const screen = screenOf(url, figures, media, label || this.texts.figure, colours[role], events);
    this.screens.push(screen);
    screen.element.classList.add("screen");
    const width = fixedWidth(this.settings.display, media);
    if (width !== null) {
      screen.element.style.width = `${width}px`;
      screen.element.style.height = `${(width * media.height) / media.width}px`;
    }
    if (screen.element instanceof HTMLVideoElement)
      screen.element.setAttribute("aria-label", label || this.texts.video);
    const frame = element("figure", { class: `frame ${role}` }, screen.element);
    if (label) frame.append(element("figcaption", {}, label));
    return frame;
  }

  shownSize(): ShownSize | undefined {
    const [first] = this.screens;
    return first && shownSize(this.settings.display, first.element);
  }

  private now = (): number => performance.now() - this.beganAt;

  /** Whether a participant may start it now. */
  canPlay(): boolean {
    if (this.state !== "covered") return false;
    const { replays } = this.settings;
    const { before } = this.attempt;
    const ended = before.ended + this.played.ended;
    if (ended === 0 || replays === "counted") return true;
    return typeof replays === "number" && ended <= replays;
  }

  play(): void {
    if (!this.canPlay()) return;
    this.played.begun += 1;
    this.playedAt = this.now();
    this.attempt.note(this.played);
    this.state = "playing";
    this.showCover();
    if (this.isInTurn) this.playFrame(0);
    else for (const screen of this.screens) screen.play();
    // Arrow keys turn what is turned.
    if (this.settings.view === "turn") this.screens[0]?.element.focus({ preventScroll: true });
    this.watch();
  }

  /** Of those that are shown one after the other, shows this one; none with −1. */
  private showFrame(current: number): void {
    if (!this.isInTurn) return;
    this.current = current;
    [...this.frames.children].forEach((frame, index) => frame.classList.toggle("current", index === current));
  }

  private playFrame(current: number): void {
    this.showFrame(current);
    this.screens[current]!.play();
    this.watch();
  }

  /** What does not go on, or does not end long after it should have, may be started again. */
  private watch(longestMs = 0): void {
    clearTimeout(this.watchDog);
    this.watchDog = window.setTimeout(() => this.offerRestart(), longestMs + patienceMs);
  }

  private began(at: number): void {
    if (this.firstStart !== null) return;
    this.firstStart = at - this.beganAt;
    this.told.began();
  }

  private volumeChanged(volume: number): void {
    if (this.volumeEvents.length < mostVolumeEvents)
      this.volumeEvents.push(`${Math.round(this.now())}:${Math.round(100 * volume) / 100}`);
  }

  private stalled(): void {
    if (this.state !== "playing" || this.stalledAt !== null) return;
    this.stalls += 1;
    this.stalledAt = this.now();
    this.watch();
  }

  private wentOn(): void {
    this.watch(this.longestMs);
    if (this.stalledAt === null) return;
    this.stall_ms += this.now() - this.stalledAt;
    this.stalledAt = null;
  }

  /** A film that does not go on by itself may be started again without its counting as a replay. */
  private offerRestart(): void {
    if (this.state !== "playing") return;
    this.wentOn();
    this.played.begun -= 1;
    this.noteWatched();
    this.playedAt = null;
    this.stops += 1;
    this.state = "covered";
    this.showCover();
    this.note.textContent = this.texts.stalled;
    this.playButton.textContent = this.texts.restart;
    if (this.stops >= stopsOfFault) this.offerToLeaveOut("stalled");
  }

  private ended(): void {
    if (this.state !== "playing") return;
    if (this.isInTurn && this.current < this.screens.length - 1) return this.turn();
    if (!this.screens.every((screen) => screen.hasEnded())) return;
    this.wentOn();
    this.offer.replaceChildren();
    this.firstEnd ??= this.now();
    this.played.ended += 1;
    this.noteWatched();
    this.playedAt = null;
    this.state = "covered";
    this.showCover();
    this.showFrame(-1);
    this.told.ended();
  }

  /** After the one, an empty stage, and then the other. */
  private turn(): void {
    this.wentOn();
    const next = this.current + 1;
    this.showFrame(-1);
    setTimeout(() => {
      if (this.state === "playing") this.playFrame(next);
    }, betweenMs);
  }

  private showCover(): void {
    const { texts } = this;
    const plays = this.played.begun + this.attempt.before.begun;
    const ended = this.played.ended + this.attempt.before.ended;
    this.cover.hidden = this.state === "playing";
    this.root.classList.toggle("playing", this.state === "playing");
    // What is turned may be looked at from all sides when it stands still again.
    this.root.classList.toggle("open", this.settings.view === "turn" && plays > 0);
    this.playButton.hidden = this.state !== "covered" || !this.canPlay();
    this.playButton.replaceChildren(
      element("span", { class: "triangle", "aria-hidden": "true" }),
      this.isFirst() ? texts.play : texts.replay);
    // Once answers can be given the focus is there, and so is Space.
    if (this.isFirst()) this.playButton.append(element("kbd", {}, texts.playKey));
    const { replays } = this.settings;
    if (this.state === "loading") this.note.textContent = texts.waitForVideo;
    else if (ended > 0 && typeof replays === "number" && this.canPlay())
      this.note.textContent = texts.replaysLeft({ left: replays - ended + 1 });
    else this.note.textContent = "";
  }

  /** Whether playing it now is not a replay. */
  protected isFirst(): boolean {
    return this.played.begun + this.attempt.before.begun === 0;
  }

  focus(): void {
    if (!this.playButton.hidden) this.playButton.focus();
    else this.offer.querySelector<HTMLElement>(".main")?.focus();
  }

  seen(): Seen {
    const dropped = this.screens.map((screen) => screen.dropped_frames());
    const rounded = (time: number | null) => (time === null ? null : Math.round(time));
    return {
      replays: Math.max(0, this.attempt.before.begun + this.played.begun - 1),
      attempt: this.attempt.number,
      plays_before: this.attempt.before.begun,
      watched_before_ms: this.attempt.before.longest_ms,
      play_start_ms: rounded(this.firstStart),
      ended_ms: rounded(this.firstEnd),
      stalls: this.stalls,
      stall_ms: Math.round(this.stall_ms),
      dropped_frames: dropped.includes(null) ? null
        : (dropped as number[]).reduce((sum, one) => sum + one, 0),
      volume_events: this.volumeEvents.join(" "),
    };
  }

  release(): void {
    clearTimeout(this.watchDog);
    clearTimeout(this.waiting);
    removeEventListener("pagehide", this.noteWatched);
    for (const screen of this.screens) screen.release();
  }
}
