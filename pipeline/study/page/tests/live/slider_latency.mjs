// How long moved sliders take until what comes of them is drawn.

/**
 * Moves the sliders of `sliders` (CSS) one after the other, `most` times, until there is `over` (CSS): for each change
 * the milliseconds from the slider's event to the end of the frame after each attribute of `seen` has changed, as
 * { name: [CSS, attribute] }.
 */
export const sliderLatencies = (page, how) => page.evaluate(async ({ sliders, over, seen, most }) => {
  const rows = [...document.querySelectorAll(sliders)];
  const isOver = () => document.querySelector(over) !== null;
  const frame = () => new Promise((drawn) => requestAnimationFrame(() => {
    const channel = new MessageChannel();
    channel.port1.onmessage = drawn;  // once the frame is drawn
    channel.port2.postMessage(0);
  }));
  const changed = (element, attribute) => new Promise((known) => {
    const watch = new MutationObserver(() => { watch.disconnect(); known(true); });
    watch.observe(element, { attributes: true, attributeFilter: [attribute] });
    setTimeout(() => { watch.disconnect(); known(false); }, 5000);  // the trial is over, or nothing answers
  });
  const took = [];
  for (let i = 0; i < most + 2 && !isOver(); i += 1) {
    const slider = rows[i % rows.length];
    slider.value = String(((Number(slider.value) * 100 + 37) % 100) / 100);
    const before = performance.now();
    const waits = Object.entries(seen).map(async ([name, [css, attribute]]) =>
      [name, await changed(document.querySelector(css), attribute) && (await frame(), performance.now() - before)]);
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    const times = Object.fromEntries(await Promise.all(waits));
    if (Object.values(times).some((time) => !time)) break;
    if (i >= 2) took.push(times);  // the first ones still compile
    await new Promise((done) => setTimeout(done, 30));
  }
  return { took, sliders: rows.length };
}, how);

/** "median 33.1 ms, 90 % below 41.0 ms" of what is called so. */
export function summaryOf(took, name) {
  const sorted = took.map((one) => one[name]).sort((a, b) => a - b);
  const at = (share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))].toFixed(1);
  return `median ${at(0.5)} ms, 90 % below ${at(0.9)} ms`;
}
