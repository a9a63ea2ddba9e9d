// What was and what is: key frames, and videos where there are both, under a slider, by turns, as
// their difference, and as ꟻLIP's map of key frames.
import { element } from "../questionnaire/elements";
import type { Clock } from "./clock";
import { flipColour, flipShare } from "./flip_colours";
import { keyButton, type View } from "./painting";
import { editions, placeOf, type Edition, type KeyFrame, type Videos } from "./stimulus";
import { VideoPair } from "./video_pair";

const modeNames = { slider: "Slider", blink: "Blink", difference: "Difference", flip: "ꟻLIP" };
type Mode = keyof typeof modeNames;
const modes = Object.keys(modeNames) as Mode[];

const percent = (share: number): string => `${(100 * share).toFixed(0)} %`;
const doubled = (gain: number): number => (gain >= 64 ? 1 : 2 * gain);

/** The largest power of two, up to 64, by which a value stays within a limit. */
function fittingGain(value: number, limit: number): number {
  let gain = 1;
  while (gain < 64 && 2 * gain * value <= limit) gain *= 2;
  return gain;
}

/** The parts of the body that a change is seen at, the largest first. */
function sharesText(shares: KeyFrame["shares"]): string {
  const sum = (some: KeyFrame["shares"]): number => some.reduce((all, one) => all + one.share, 0);
  const parts = shares.filter((one) => one.part);
  if (parts.length === 0) return "";
  const words = parts.slice(0, 4).map((one) => `${one.part} ${percent(one.share)}`);
  const others = sum(parts.slice(4));
  if (others >= 0.005) words.push(`other parts ${percent(others)}`);
  words.push(`unexplained ${percent(sum(shares.filter((one) => !one.part)))}`);
  return ` What changed lies at: ${words.join(", ")}.`;
}

/** ꟻLIP's colours read back as errors, and drawn again as if these were larger. */
function drawFlip(canvas: HTMLCanvasElement, picture: HTMLImageElement, gain: number): void {
  [canvas.width, canvas.height] = [picture.naturalWidth, picture.naturalHeight];
  const context = canvas.getContext("2d", { willReadFrequently: true })!;
  context.drawImage(picture, 0, 0);
  if (gain === 1) return;
  const pixels = context.getImageData(0, 0, canvas.width, canvas.height);
  for (let i = 0; i < pixels.data.length; i += 4)
    pixels.data.set(flipColour(Math.min(1, gain * flipShare(pixels.data[i]!, pixels.data[i + 1]!))), i);
  context.putImageData(pixels, 0, 0);
}

function put(image: HTMLImageElement, address: string): void {
  if (image.getAttribute("src") !== address) image.src = address;
}

export class PictureView implements View {
  private readonly calm = matchMedia("(prefers-reduced-motion: reduce)");
  private readonly worst: number;
  private mode: Mode = "slider";
  private showsVideo: boolean;
  private split = 0.5;
  private blinking: ReturnType<typeof setInterval> | undefined;
  private shown: Edition = "now";
  private readonly gains: { difference: number; flip: number };
  private readonly pair: VideoPair | null;

  private readonly images = { before: element("img", { alt: "before" }), now: element("img", { alt: "now" }),
    flip: element("img", { alt: "" }) };
  private readonly above: HTMLElement;
  private readonly map = element("canvas", { class: "layer", "aria-label": "ꟻLIP" });
  private readonly layers: HTMLElement;
  private readonly edge = element("div", { class: "edge" });
  private readonly leftTag = element("span", { class: "tag left" });
  private readonly rightTag = element("span", { class: "tag right now" }, "now");
  private readonly stage: HTMLElement;
  private readonly caption = element("figcaption", { "aria-live": "polite" });
  private readonly legend = element("span", { class: "legend", hidden: "" });
  private readonly modeButtons: [Mode, HTMLButtonElement][];
  private readonly slide = element("input", { type: "range", min: "0", max: "100", value: "50",
    "aria-label": "where before ends and now begins" });
  private readonly gainButton = keyButton("Contrast", "G", () => this.gain());
  private readonly kindButton: HTMLButtonElement | null;
  readonly node: HTMLElement;

  constructor(private readonly frames: KeyFrame[], videos: Videos | undefined, private readonly clock: Clock) {
    this.worst = frames.reduce((most, frame, i) => (frame.flip_mean > frames[most]!.flip_mean ? i : most), 0);
    const worst = frames[this.worst];
    this.showsVideo = !worst;
    this.gains = { difference: worst ? fittingGain(worst.largest, 255) : 4, flip: worst ? fittingGain(worst.flip_most, 1) : 1 };
    const pair = this.pair = videos ? new VideoPair(videos, clock, () => this.paint()) : null;
    const layer = (name: Edition): HTMLElement =>
      element("div", { class: `layer ${name}` }, this.images[name], ...(pair ? [pair.players[name]] : []));
    this.above = layer("now");
    this.layers = element("div", { class: "layers" }, layer("before"), this.above, this.map);
    this.stage = element("div", { class: "stage", tabindex: "0", role: "group" }, this.layers, this.edge, this.leftTag, this.rightTag);
    this.modeButtons = modes.filter((name) => name !== "flip" || worst)
      .map((name, i) => [name, keyButton(modeNames[name], String(i + 1), () => this.choose(name))]);
    this.kindButton = pair && worst ? keyButton("Video", "V", () => this.turnOver()) : null;
    const keyButtons = frames.length < 2 ? []
      : [keyButton("Previous", "[", () => this.stepKey(-1)), keyButton("Next key frame", "]", () => this.stepKey(1))];
    const bar = element("div", { class: "bar" }, ...this.modeButtons.map(([, button]) => button),
      ...(this.kindButton ? [this.kindButton] : []), ...keyButtons, this.slide, this.gainButton, this.legend);
    this.node = element("figure", {}, this.stage, bar, this.caption);
    this.listen();
  }

  private listen(): void {
    const { stage, slide, images, clock, pair } = this;
    const divideAt = (event: PointerEvent): void => {
      const box = stage.getBoundingClientRect();
      this.divide((event.clientX - box.left) / box.width);
    };
    slide.addEventListener("input", () => this.divide(slide.valueAsNumber / 100));
    images.flip.addEventListener("load", () => this.drawMap());
    stage.addEventListener("pointerdown", (event) => {
      if (this.mode === "slider") divideAt(event);
    });
    stage.addEventListener("pointermove", (event) => {
      if (this.mode === "slider" && (event.buttons & 1 || event.pointerType === "mouse")) divideAt(event);
    });
    clock.onFrame(() => {
      if (pair && !pair.isRunning()) pair.seek();
      this.paint();
    });
    if (!pair) return;
    const play = (): void => {
      if (this.mode !== "flip") this.showsVideo = true;
      pair.play();
      this.paint();
    };
    clock.driver = { play, stop: () => pair.stop() };
  }

  private nearest(): number {
    const far = (frame: KeyFrame): number => Math.abs(placeOf(frame, this.clock.fps) - this.clock.frame);
    return this.frames.reduce((best, frame, i) => (far(frame) < far(this.frames[best]!) ? i : best), 0);
  }

  private drawMap(): void {
    const { flip } = this.images;
    if (this.mode === "flip" && flip.complete && flip.naturalWidth) drawFlip(this.map, flip, this.gains.flip);
  }

  paint(): void {
    const { mode, images, pair, above, gains } = this;
    const at = this.nearest(), frame = this.frames[at];
    const isVideo = this.showsVideo && mode !== "flip";
    if (frame) for (const name of editions) put(images[name], frame[name]);
    if (frame && mode === "flip") put(images.flip, frame.flip);
    for (const name of editions) {
      images[name].hidden = isVideo;
      if (pair) pair.players[name].hidden = !isVideo;
    }
    this.map.hidden = mode !== "flip";
    this.drawMap();
    above.style.mixBlendMode = mode === "difference" ? "difference" : "normal";
    above.style.clipPath = mode === "slider" ? `inset(0 0 0 ${100 * this.split}%)` : "none";
    above.style.visibility = mode === "blink" && this.shown === "before" ? "hidden" : "visible";
    this.layers.style.filter = mode === "difference" ? `brightness(${gains.difference})` : "none";
    this.edge.hidden = this.slide.hidden = this.rightTag.hidden = mode !== "slider";
    this.edge.style.left = `calc(${100 * this.split}% - 1px)`;
    this.gainButton.hidden = mode !== "difference" && mode !== "flip";
    this.tell(isVideo, at, frame);
  }

  private tell(isVideo: boolean, at: number, frame?: KeyFrame): void {
    const { mode, gains, shown, leftTag, legend, caption, clock } = this;
    leftTag.textContent = { slider: "before", blink: shown, difference: `difference × ${gains.difference}`,
      flip: `ꟻLIP of key frame ${frame?.frame}` }[mode];
    leftTag.className = `tag left ${mode === "blink" ? shown : mode === "slider" ? "before" : ""}`;
    legend.hidden = mode !== "flip";
    if (mode === "flip") legend.replaceChildren("0 ", element("i"), ` ${(1 / gains.flip).toFixed(gains.flip > 4 ? 3 : 2)}`);
    for (const [name, button] of this.modeButtons) button.setAttribute("aria-pressed", String(name === mode));
    this.kindButton?.setAttribute("aria-pressed", String(isVideo));
    caption.setAttribute("aria-live", clock.isPlaying() ? "off" : "polite");
    const calmly = mode === "blink" && this.calm.matches ? " Press 2 to change." : "";
    caption.textContent = (isVideo || !frame ? `Videos, frame ${clock.frame}.` : this.frameText(frame, at)) + calmly;
    this.stage.setAttribute("aria-label",
      `${mode === "flip" ? "ꟻLIP" : mode}: ${isVideo ? "videos" : "key frames"} before and now`);
  }

  private frameText(frame: KeyFrame, at: number): string {
    const count = this.frames.length;
    const place = `${at + 1} of ${count}${at === this.worst && count > 1 ? ", the worst" : ""}`;
    return `Key frame ${frame.frame} (${place}): ꟻLIP ${frame.flip_mean.toFixed(4)} on average, `
      + `${frame.flip_most.toFixed(2)} at most; SSIM ${frame.ssim.toFixed(3)}; `
      + `${frame.is_bias ? "more than noise" : "no more than noise"}.${sharesText(frame.shares)}`;
  }

  private choose(name: Mode): void {
    if (name === "flip" && this.frames.length === 0) return;
    const isAgain = name === this.mode;
    this.mode = name;
    this.quiet();
    if (name !== "blink") this.shown = "now";
    else if (this.calm.matches) this.shown = isAgain && this.shown === "now" ? "before" : "now";
    else this.blinking = setInterval(() => {
      this.shown = this.shown === "now" ? "before" : "now";
      this.paint();
    }, 600);
    this.paint();
  }

  /** Blinks no more. */
  quiet(): void {
    clearInterval(this.blinking);
  }

  focus(): void {
    this.stage.focus({ preventScroll: true });
  }

  private divide(at: number): void {
    this.split = Math.min(1, Math.max(0, at));
    this.slide.value = String(100 * this.split);
    this.paint();
  }

  private gain(): void {
    if (this.mode !== "difference" && this.mode !== "flip") return;
    this.gains[this.mode] = doubled(this.gains[this.mode]);
    this.paint();
  }

  /** From key frames to videos, or back. */
  private turnOver(): void {
    this.clock.stop();
    this.showsVideo = !this.showsVideo;
    if (this.showsVideo && this.mode === "flip") this.mode = "slider";
    this.paint();
  }

  stepKey(by: number): void {
    const { frames, clock } = this;
    if (frames.length > 0) clock.go(placeOf(frames[(this.nearest() + by + frames.length) % frames.length]!, clock.fps));
  }

  keys(event: KeyboardEvent): boolean {
    const key = event.key.toLowerCase();
    const mode = modes[Number(key) - 1];
    if (mode) this.choose(mode);
    else if (key === "[") this.stepKey(-1);
    else if (key === "]") this.stepKey(1);
    else if (key === "g") this.gain();
    else if (key === "v" && this.kindButton) this.turnOver();
    else if (event.shiftKey && key === "arrowleft") this.divide(this.split - 0.05);
    else if (event.shiftKey && key === "arrowright") this.divide(this.split + 0.05);
    else return false;
    return true;
  }
}
