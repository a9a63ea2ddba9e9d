// What the report shows of a stimulus is read and built when its line is opened.
import { element } from "../questionnaire/elements";
import { Clock, transport } from "./clock";
import { distanceChart } from "./distance_chart";
import { motionView, Poses } from "./motion_view";
import type { View } from "./painting";
import { PictureView } from "./picture_view";
import { editions, placeOf, type ComparedStimulus, type KeyFrame } from "./stimulus";

/** How many frames a stimulus has, how many a second, and which to begin with. */
function clockFor({ frames, motion, videos }: ComparedStimulus): Clock {
  const worst = frames.reduce<KeyFrame | null>((most, frame) => (!most || frame.flip_mean > most.flip_mean ? frame : most), null);
  const fps = videos?.now.fps ?? motion?.now.fps ?? 30;
  const first = worst ? placeOf(worst, fps) : Math.round((motion?.worst ?? 0) / (motion?.fps ?? 1) * fps);
  const counts = [worst ? first + 1 : 1];
  for (const name of editions) {
    if (videos) counts.push(videos[name].frames - videos[name].first);
    if (motion) counts.push(Math.ceil(new Poses(motion[name]).count / motion[name].fps * fps - 1e-6));
  }
  return new Clock(Math.max(...counts), fps, first);
}

interface Built {
  clock: Clock;
  pictures: PictureView | null;
  views: View[];
  moves: boolean;
}

const built = new Map<HTMLDetailsElement, Built>();

function build(card: HTMLDetailsElement): void {
  const { index } = card.dataset;
  if (built.has(card) || !index) return;
  const stimulus = JSON.parse(document.getElementById(`data-${index}`)!.textContent!) as ComparedStimulus;
  const { frames, motion, videos } = stimulus;
  const clock = clockFor(stimulus);
  const pictures = frames.length > 0 || videos ? new PictureView(frames, videos, clock) : null;
  const moves = Boolean(motion ?? videos);
  const views: View[] = [...(pictures ? [pictures] : []), ...(motion ? [motionView(motion, clock)] : []),
    ...(moves ? [transport(clock)] : []), ...(motion ? [distanceChart(motion, clock)] : [])];
  if (views.length === 0 && !card.querySelector(".lone"))
    card.append(element("p", { class: "quiet" }, "No picture of it was drawn, and its motion is as it was."));
  card.append(element("div", { class: "views" }, ...views.map((view) => view.node)));
  built.set(card, { clock, pictures, views, moves });
  repaint(card);
}

const repaint = (card: HTMLDetailsElement): void => built.get(card)?.views.forEach((view) => view.paint());

function rest(card: HTMLDetailsElement): void {
  built.get(card)?.clock.stop();
  built.get(card)?.pictures?.quiet();
}

const cards = [...document.querySelectorAll<HTMLDetailsElement>("details.card")];
for (const card of cards) {
  card.addEventListener("toggle", () => (card.open ? build(card) : rest(card)));
  if (card.open) build(card);
}

/** Shuts what is open and opens another. */
function turnTo(next: HTMLDetailsElement, current?: HTMLDetailsElement): void {
  if (current && current !== next) current.open = false;
  next.open = true;
  build(next);
  const pictures = built.get(next)?.pictures;
  if (pictures) pictures.focus();
  else next.querySelector("summary")!.focus({ preventScroll: true });
  next.scrollIntoView({ block: "start" });
}

function openNamed(): void {
  const named = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (named?.matches("details.card")) turnTo(named as HTMLDetailsElement);
}
addEventListener("hashchange", openNamed);
openNamed();

/** Keys that a control uses itself. */
function isOwnKey({ target, key }: KeyboardEvent): boolean {
  if (!(target instanceof Element)) return false;
  if (target.closest("button, summary, a") && [" ", "Enter"].includes(key)) return true;
  return target.closest("input") !== null && /^(Arrow|Home|End|Page)/.test(key);
}

/** Whether a key was for what is shown of a stimulus. */
function use(event: KeyboardEvent, { clock, pictures, views, moves }: Built): boolean {
  if (views.some((view) => view.keys?.(event))) return true;
  const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  if (by !== undefined && moves) clock.step(by);
  else if (by !== undefined) pictures?.stepKey(by);
  else if (event.key === " " && moves) clock.toggle();
  else return false;
  return true;
}

document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.altKey || event.metaKey || isOwnKey(event)) return;
  const open = cards.find((one) => one.open);
  const focused = event.target instanceof Element ? event.target.closest<HTMLDetailsElement>("details.card") : null;
  const current = focused ?? open;
  const key = event.key.toLowerCase();
  const shown = built.get(current?.open ? current : open!);
  if (key === "j" || key === "k") {
    const at = current ? cards.indexOf(current) + (key === "j" ? 1 : -1) : 0;
    const next = cards[Math.min(cards.length - 1, Math.max(0, at))];
    if (next) turnTo(next, current);
  } else if (!shown || !use(event, shown)) return;
  event.preventDefault();
});

const repaintOpen = (): void => {
  for (const card of built.keys()) if (card.open) repaint(card);
};
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", repaintOpen);
let resizing: ReturnType<typeof setTimeout> | undefined;
addEventListener("resize", () => {
  clearTimeout(resizing);
  resizing = setTimeout(repaintOpen, 100);
});
