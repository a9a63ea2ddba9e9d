// What the page shows of a stimulus is read and built when its line is opened.

function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}

const colour = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/// A canvas of so many of the page's pixels, empty, whatever the screen makes of these.
function prepared(canvas, width, height) {
  const dense = window.devicePixelRatio || 1;
  if (canvas.width !== Math.round(width * dense)) canvas.width = Math.round(width * dense);
  if (canvas.height !== Math.round(height * dense)) canvas.height = Math.round(height * dense);
  const context = canvas.getContext("2d");
  context.setTransform(dense, 0, 0, dense, 0, 0);
  context.clearRect(0, 0, width, height);
  return context;
}

const isDark = () => matchMedia("(prefers-color-scheme: dark)").matches;

// The colours of ꟻLIP's maps: lighter is worse. The program draws them likewise.
const heatStops = [[0, 0, 4], [81, 18, 124], [183, 55, 121], [252, 137, 97], [252, 253, 191]];
function heatPoints(share) {
  const place = Math.min(1, Math.max(0, share)) * 4, below = Math.min(3, Math.floor(place));
  return heatStops[below].map((value, i) => value + (place - below) * (heatStops[below + 1][i] - value));
}
function heatShare(red, green) {
  if (green > 137) return 0.75 + 0.25 * (green - 137) / 116;
  const below = red < 81 ? 0 : red < 183 ? 1 : 2;
  return (below + (red - heatStops[below][0]) / (heatStops[below + 1][0] - heatStops[below][0])) / 4;
}
const heat = share => `rgb(${heatPoints(share).map(Math.round).join(" ")})`;

/// What the page holds as text, as something that players can seek in; other addresses as they are.
function blobAddress(address) {
  if (!address.startsWith("data:")) return address;
  const [head, text] = address.split(",");
  const bytes = Uint8Array.from(atob(text), letter => letter.charCodeAt(0));
  return URL.createObjectURL(new Blob([bytes], {type: head.slice(5, head.indexOf(";"))}));
}

/// The frame that all views of a stimulus show.
function clockOf(count, fps, start) {
  const listeners = [];
  let began = null;
  const clock = {frame: start, count, fps, driver: null,
    seconds: () => clock.frame / fps,
    frameAt: seconds => Math.min(count - 1, Math.max(0, Math.round(seconds * fps))),
    tell: listener => listeners.push(listener),
    show: frame => { clock.frame = Math.min(count - 1, frame); for (const listener of listeners) listener(); },
    go: frame => clock.show(Math.max(0, frame)),
    step: by => { clock.stop(); clock.go((clock.frame + by + count) % count); },
    isPlaying: () => began !== null,
    play: () => {
      const from = clock.frame;
      began = performance.now();
      if (clock.driver) clock.driver.play();
      else requestAnimationFrame(function next(now) {
        if (began === null) return;
        const frame = (from + Math.max(0, Math.floor((now - began) / 1000 * fps))) % count;
        if (frame !== clock.frame) clock.go(frame);
        requestAnimationFrame(next);
      });
      clock.show(clock.frame);
    },
    stop: () => {
      if (began === null) return;
      began = null;
      clock.driver?.stop();
      clock.show(clock.frame);
    }};
  clock.toggle = () => clock.isPlaying() ? clock.stop() : clock.play();
  return clock;
}

function transport(clock) {
  const play = element("button", {type: "button", onclick: clock.toggle, "aria-keyshortcuts": "Space"});
  const place = element("input", {type: "range", min: "0", max: String(clock.count - 1), step: "1", "aria-label": "frame",
    oninput: () => { clock.stop(); clock.go(place.valueAsNumber); }});
  const told = element("output");
  const step = (by, name, sign) => element("button", {type: "button", onclick: () => clock.step(by), "aria-label": name}, sign);
  const show = () => {
    play.textContent = clock.isPlaying() ? "Pause" : "Play";
    place.value = clock.frame;
    told.textContent = `frame ${clock.frame} of ${clock.count - 1} · ${clock.seconds().toFixed(2)} s`;
  };
  clock.tell(show);
  return {node: element("div", {class: "bar wide transport"}, play, step(-1, "previous frame", "←"), step(1, "next frame", "→"), place, told), paint: show};
}

/// Which of the clock's frames shows the moment of a key frame: the rate may be another now.
const placeOf = (frame, fps) => frame.seconds === undefined ? frame.frame : Math.round(frame.seconds * fps);

/// How many frames a stimulus has, how many a second, and which to begin with.
function clockFor({frames, motion, videos}) {
  const worst = frames.reduce((most, frame) => !most || frame.flip_mean > most.flip_mean ? frame : most, null);
  const fps = videos?.now.fps ?? motion?.now.fps ?? 30;
  const counts = [worst ? placeOf(worst, fps) + 1 : 1];
  for (const video of videos ? [videos.before, videos.now] : []) counts.push(video.frames - video.first);
  for (const one of motion ? [motion.before, motion.now] : []) counts.push(Math.ceil(posesOf(one).count / one.fps * fps - 1e-6));
  return clockOf(Math.max(...counts), fps, worst ? placeOf(worst, fps) : Math.round((motion?.worst ?? 0) / (motion?.fps ?? 1) * fps));
}

const built = new Map();

function build(details) {
  if (built.has(details) || !details.dataset.index) return;
  const stimulus = JSON.parse(document.getElementById(`data-${details.dataset.index}`).textContent);
  const {frames, motion, videos} = stimulus, clock = clockFor(stimulus), moves = motion || videos;
  const pictures = frames.length || videos ? pictureView(frames, videos, clock) : null;
  const viewers = pictures ? [pictures] : [];
  if (motion) viewers.push(motionView(motion, clock));
  if (moves) viewers.push(transport(clock));
  if (motion) viewers.push(distanceChart(motion, clock));
  if (viewers.length === 0 && !details.querySelector(".lone")) details.append(element("p", {class: "quiet"}, "No picture of it was drawn, and its motion is as it was."));
  details.append(element("div", {class: "views"}, ...viewers.map(viewer => viewer.node)));
  built.set(details, {clock, pictures, viewers, moves});
  repaint(details);
}
const repaint = details => built.get(details)?.viewers.forEach(viewer => viewer.paint());

function rest(details) {
  const {clock, pictures} = built.get(details) ?? {};
  clock?.stop();
  pictures?.quiet();
}

const cards = [...document.querySelectorAll("details.card")];
for (const details of cards) {
  details.addEventListener("toggle", () => { if (details.open) build(details); else rest(details); });
  if (details.open) build(details);
}

/// Shuts what is open and opens another.
function turnTo(next, current) {
  if (current && current !== next) current.open = false;
  next.open = true;
  build(next);
  const {pictures} = built.get(next) ?? {};
  if (pictures) pictures.focus(); else next.querySelector("summary").focus({preventScroll: true});
  next.scrollIntoView({block: "start"});
}

function openNamed() {
  const named = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (named?.matches("details.card")) turnTo(named, null);
}
window.addEventListener("hashchange", openNamed);
openNamed();

/// Keys that a control uses itself.
function isOwnKey(event) {
  if (event.target.closest?.("button, summary, a") && [" ", "Enter"].includes(event.key)) return true;
  return Boolean(event.target.closest?.("input")) && /^(Arrow|Home|End|Page)/.test(event.key);
}

document.addEventListener("keydown", event => {
  if (event.ctrlKey || event.altKey || event.metaKey || isOwnKey(event)) return;
  const current = event.target.closest?.("details.card") ?? cards.find(one => one.open);
  const key = event.key.toLowerCase();
  if (key === "j" || key === "k") {
    const at = current ? cards.indexOf(current) + (key === "j" ? 1 : -1) : 0;
    const next = cards[Math.min(cards.length - 1, Math.max(0, at))];
    if (next) turnTo(next, current);
    event.preventDefault();
    return;
  }
  const shown = built.get(current?.open ? current : cards.find(one => one.open));
  if (!shown) return;
  let used = shown.viewers.some(viewer => viewer.keys?.(event));
  if (!used && (key === "arrowleft" || key === "arrowright")) {
    const by = key === "arrowleft" ? -1 : 1;
    if (shown.moves) shown.clock.step(by); else shown.pictures?.stepKey(by);
    used = true;
  }
  if (!used && key === " " && shown.moves) { shown.clock.toggle(); used = true; }
  if (used) event.preventDefault();
});

const everywhere = () => { for (const details of built.keys()) if (details.open) repaint(details); };
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", everywhere);
let resizing = null;
window.addEventListener("resize", () => { clearTimeout(resizing); resizing = setTimeout(everywhere, 100); });
