import { element } from "../questionnaire/elements";
import type { Histogram } from "./status";

const width = 260, height = 110, base = 92, top = 16;

function drawn<Name extends keyof SVGElementTagNameMap>(
  name: Name, attributes: Record<string, string | number>, ...content: (Node | string)[]
): SVGElementTagNameMap[Name] {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  made.append(...content);
  return made;
}

function bars(bins: Histogram["bins"]): SVGSVGElement {
  const most = Math.max(1, ...bins.map(({ count }) => count));
  const step = width / bins.length;
  const letters = Math.floor(step / 6);
  const told = bins.map(({ label, count }) => `${label}: ${count}`).join(", ");
  const picture = drawn("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": told });
  bins.forEach(({ label, count }, index) => {
    const tall = (count / most) * (base - top);
    const middle = (index + 0.5) * step;
    picture.append(
      drawn("rect", { x: index * step + step * 0.1, y: base - tall, width: step * 0.8, height: Math.max(tall, 1), rx: 2 }),
      drawn("text", { x: middle, y: base - tall - 4 }, String(count)));
    const short = label.length > step / 6 ? `${label.slice(0, letters - 1)}…` : label;
    if (bins.length <= 10) picture.append(drawn("text", { x: middle, y: height - 4, class: "label" }, short));
  });
  return picture;
}

/** How often each answer of an item was given. */
export function histogramFigure({ item, is_pair: isPair, answers, mean, bins, low, high }: Histogram): HTMLElement {
  const about = `${answers} ${answers === 1 ? "answer" : "answers"}${mean === null ? "" : `, mean ${mean.toFixed(2)}`}`;
  const figure = element("figure", {},
    element("figcaption", {}, isPair ? `${item} (which of two)` : item, element("small", {}, about)));
  if (bins.length === 0) return figure;
  figure.append(bars(bins));
  if (low || high)
    figure.append(element("div", { class: "poles" }, element("span", {}, low ?? ""), element("span", {}, high ?? "")));
  return figure;
}
