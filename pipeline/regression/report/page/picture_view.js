// What was and what is: key frames, and videos where there are both, under a slider, by turns, as
// their difference, and as ꟻLIP's map of key frames.

const percent = share => `${(100 * share).toFixed(0)} %`;
const doubled = gain => gain >= 64 ? 1 : 2 * gain;

/// The largest power of two, up to 64, by which a value stays within a limit.
function fittingGain(value, limit) {
  let gain = 1;
  while (gain < 64 && 2 * gain * value <= limit) gain *= 2;
  return gain;
}

/// The parts of the body that a change is seen at, the largest first.
function sharesText(shares) {
  const parts = shares.filter(one => one.part), rest = shares.filter(one => !one.part).reduce((sum, one) => sum + one.share, 0);
  if (parts.length === 0) return "";
  const few = parts.slice(0, 4), others = parts.slice(4).reduce((sum, one) => sum + one.share, 0);
  const words = few.map(one => `${one.part} ${percent(one.share)}`);
  if (others >= 0.005) words.push(`other parts ${percent(others)}`);
  words.push(`unexplained ${percent(rest)}`);
  return ` What changed lies at: ${words.join(", ")}.`;
}

/// ꟻLIP's colours read back as errors, and drawn again as if these were larger.
function drawFlip(canvas, picture, gain) {
  [canvas.width, canvas.height] = [picture.naturalWidth, picture.naturalHeight];
  const context = canvas.getContext("2d", {willReadFrequently: true});
  context.drawImage(picture, 0, 0);
  if (gain === 1) return;
  const data = context.getImageData(0, 0, canvas.width, canvas.height);
  for (let i = 0; i < data.data.length; i += 4) {
    const [red, green, blue] = heatPoints(Math.min(1, gain * heatShare(data.data[i], data.data[i + 1])));
    data.data[i] = red; data.data[i + 1] = green; data.data[i + 2] = blue;
  }
  context.putImageData(data, 0, 0);
}

/// Both videos of a stimulus, held together by its clock.
function videoPair(videos, clock, ready) {
  const players = {};
  for (const name of ["before", "now"]) {
    const player = element("video", {playsinline: "", preload: "auto", "aria-label": name});
    player.muted = true;
    player.src = blobAddress(videos[name].src);
    player.addEventListener("loadeddata", () => { if (Object.values(players).every(one => one.readyState >= 2)) { seek(); ready(); } });
    players[name] = player;
  }
  const frames = name => videos[name].frames - videos[name].first;
  const leader = frames("before") > frames("now") ? "before" : "now", follower = leader === "now" ? "before" : "now";
  /// The middle of a frame's time, so that no rounding leads to another.
  const time = (name, frame) => (videos[name].first + Math.min(frame, frames(name) - 1) + 0.5) / videos[name].fps;
  const seek = () => { for (const name of ["before", "now"]) players[name].currentTime = time(name, clock.frame); };
  let runs = false;
  function follow(_, shown) {
    if (!runs) return;
    const frame = Math.round(shown.mediaTime * videos[leader].fps) - videos[leader].first;
    clock.show(Math.max(0, frame));
    const late = players[follower].currentTime - players[leader].currentTime - (time(follower, 0) - time(leader, 0));
    if (frame < frames(follower) - 1 && Math.abs(late) > 0.6 / videos[leader].fps) players[follower].currentTime = time(follower, frame);
    players[leader].requestVideoFrameCallback(follow);
  }
  players[leader].addEventListener("ended", () => { if (runs) { clock.show(0); seek(); play(); } });
  function play() {
    runs = true;
    players[leader].requestVideoFrameCallback(follow);
    for (const player of Object.values(players)) player.play().catch(() => clock.stop());
  }
  function stop() {
    runs = false;
    for (const player of Object.values(players)) player.pause();
    seek();
  }
  return {players, seek, play, stop, runs: () => runs};
}

const viewNames = [["slider", "Slider"], ["blink", "Blink"], ["difference", "Difference"], ["flip", "ꟻLIP"]];

function pictureView(frames, videos, clock) {
  const calm = matchMedia("(prefers-reduced-motion: reduce)");
  const worst = frames.reduce((most, frame, i) => frame.flip_mean > frames[most].flip_mean ? i : most, 0);
  let mode = "slider", kind = frames.length ? "frames" : "video", split = 0.5, blinking = null, shown = "now";
  const gains = {difference: frames.length ? fittingGain(frames[worst].largest, 255) : 4,
                 flip: frames.length ? fittingGain(frames[worst].flip_most, 1) : 1};
  const images = {before: element("img", {alt: "before"}), now: element("img", {alt: "now"}), flip: element("img", {alt: ""})};
  const pair = videos ? videoPair(videos, clock, () => show()) : null;
  const layer = name => element("div", {class: `layer ${name}`}, images[name], ...(pair ? [pair.players[name]] : []));
  const below = layer("before"), above = layer("now");
  const map = element("canvas", {class: "layer", "aria-label": "ꟻLIP"});
  const layers = element("div", {class: "layers"}, below, above, map), edge = element("div", {class: "edge"});
  const leftTag = element("span", {class: "tag left"}), rightTag = element("span", {class: "tag right"});
  const stage = element("div", {class: "stage", tabindex: "0", role: "group"}, layers, edge, leftTag, rightTag);
  const caption = element("figcaption", {"aria-live": "polite"});
  const legend = element("span", {class: "legend", hidden: ""});
  const button = (text, key, press) => element("button", {type: "button", onclick: press, "aria-keyshortcuts": key}, text, " ", element("kbd", {}, key));
  const modes = Object.fromEntries(viewNames.filter(([name]) => name !== "flip" || frames.length)
    .map(([name, text], i) => [name, button(text, String(i + 1), () => choose(name))]));
  const slide = element("input", {type: "range", min: "0", max: "100", value: "50", "aria-label": "where before ends and now begins",
    oninput: () => divide(slide.valueAsNumber / 100)});
  const gainButton = button("Contrast", "G", () => gain());
  const kindButton = pair && frames.length ? button("Video", "V", () => turnTo(kind === "video" ? "frames" : "video")) : null;
  const keyButtons = frames.length > 1 ? [button("Previous", "[", () => stepKey(-1)), button("Next key frame", "]", () => stepKey(1))] : [];
  const bar = element("div", {class: "bar"}, ...Object.values(modes), ...(kindButton ? [kindButton] : []), ...keyButtons, slide, gainButton, legend);

  const nearest = () => frames.reduce((best, frame, i) => Math.abs(placeOf(frame, clock.fps) - clock.frame) < Math.abs(placeOf(frames[best], clock.fps) - clock.frame) ? i : best, 0);
  images.flip.addEventListener("load", () => { if (mode === "flip") drawFlip(map, images.flip, gains.flip); });
  function put(image, address) { if (image.getAttribute("src") !== address) image.src = address; }

  function show() {
    const at = nearest(), frame = frames[at], film = kind === "video" && mode !== "flip";
    if (frame) { put(images.before, frame.before); put(images.now, frame.now); }
    if (frame && mode === "flip") put(images.flip, frame.flip);
    for (const name of ["before", "now"]) {
      images[name].hidden = film;
      if (pair) pair.players[name].hidden = !film;
    }
    map.hidden = mode !== "flip";
    if (mode === "flip" && images.flip.complete && images.flip.naturalWidth) drawFlip(map, images.flip, gains.flip);
    above.style.mixBlendMode = mode === "difference" ? "difference" : "normal";
    above.style.clipPath = mode === "slider" ? `inset(0 0 0 ${100 * split}%)` : "none";
    above.style.visibility = mode === "blink" && shown === "before" ? "hidden" : "visible";
    layers.style.filter = mode === "difference" ? `brightness(${gains.difference})` : "none";
    edge.hidden = slide.hidden = mode !== "slider";
    edge.style.left = `calc(${100 * split}% - 1px)`;
    gainButton.hidden = mode !== "difference" && mode !== "flip";
    tell(frame, at, film);
  }
  function tell(frame, at, film) {
    leftTag.textContent = {slider: "before", blink: shown, difference: `difference × ${gains.difference}`, flip: `ꟻLIP of key frame ${frame?.frame}`}[mode];
    leftTag.className = `tag left ${mode === "blink" ? shown : mode === "slider" ? "before" : ""}`;
    rightTag.textContent = "now";
    rightTag.className = "tag right now";
    rightTag.hidden = mode !== "slider";
    legend.hidden = mode !== "flip";
    if (mode === "flip") legend.replaceChildren("0 ", element("i", {}), ` ${(1 / gains.flip).toFixed(gains.flip > 4 ? 3 : 2)}`);
    for (const [name, one] of Object.entries(modes)) one.setAttribute("aria-pressed", String(name === mode));
    kindButton?.setAttribute("aria-pressed", String(film));
    const calmly = mode === "blink" && calm.matches ? " Press 2 to change." : "";
    caption.setAttribute("aria-live", clock.isPlaying() ? "off" : "polite");
    caption.textContent = film ? `Videos, frame ${clock.frame}.${calmly}` :
      `Key frame ${frame.frame} (${at + 1} of ${frames.length}${at === worst && frames.length > 1 ? ", the worst" : ""}): ꟻLIP ${frame.flip_mean.toFixed(4)} on average, ` +
      `${frame.flip_most.toFixed(2)} at most; SSIM ${frame.ssim.toFixed(3)}; ${frame.is_bias ? "more than noise" : "no more than noise"}.${sharesText(frame.shares)}${calmly}`;
    stage.setAttribute("aria-label", `${mode === "flip" ? "ꟻLIP" : mode}: ${film ? "videos" : "key frames"} before and now`);
  }
  function choose(name) {
    if (name === "flip" && !frames.length) return;
    const again = name === mode;
    mode = name;
    quiet();
    if (mode !== "blink") shown = "now";
    else if (calm.matches) shown = again && shown === "now" ? "before" : "now";
    else blinking = setInterval(() => { shown = shown === "now" ? "before" : "now"; show(); }, 600);
    show();
  }
  const quiet = () => { clearInterval(blinking); blinking = null; };
  function divide(at) { split = Math.min(1, Math.max(0, at)); slide.value = 100 * split; show(); }
  function gain() { if (mode in gains) { gains[mode] = doubled(gains[mode]); show(); } }
  function turnTo(other) { clock.stop(); kind = other; if (kind === "video" && mode === "flip") mode = "slider"; show(); }
  function stepKey(by) {
    if (!frames.length) return;
    clock.stop();
    clock.go(placeOf(frames[(nearest() + by + frames.length) % frames.length], clock.fps));
  }
  const divideAt = event => { const box = stage.getBoundingClientRect(); divide((event.clientX - box.left) / box.width); };
  stage.addEventListener("pointerdown", event => { if (mode === "slider") divideAt(event); });
  stage.addEventListener("pointermove", event => { if (mode === "slider" && (event.buttons & 1 || event.pointerType === "mouse")) divideAt(event); });
  clock.tell(() => { if (pair && !pair.runs()) pair.seek(); show(); });
  if (pair) clock.driver = {play: () => { if (mode !== "flip") kind = "video"; pair.play(); show(); }, stop: pair.stop};
  return {node: element("figure", {}, stage, bar, caption), paint: show, quiet, focus: () => stage.focus({preventScroll: true}), stepKey, keys: event => {
    const key = event.key.toLowerCase(), name = viewNames[Number(key) - 1]?.[0];
    if (name) choose(name);
    else if (key === "[") stepKey(-1);
    else if (key === "]") stepKey(1);
    else if (key === "g") gain();
    else if (key === "v" && kindButton) turnTo(kind === "video" ? "frames" : "video");
    else if (event.shiftKey && key === "arrowleft") divide(split - 0.05);
    else if (event.shiftKey && key === "arrowright") divide(split + 0.05);
    else return false;
    return true;
  }};
}
