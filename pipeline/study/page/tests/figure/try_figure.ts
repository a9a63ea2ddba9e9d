// Two figures on a page of their own, for looking at them: node try_figure.mjs FOLDER.
import { openFake } from "../live/fake_core";
import { FigureView } from "../../src/figure/figure_view";

const core = openFake({ a: [0.8, 0.6, 0.3, 0.7] });
const view = new FigureView(core.info.body, ["#2e8b57", "#3465c8"], "two figures");
view.element.style.cssText = "display:block;width:100vw;height:100vh";
document.body.style.margin = "0";
document.body.append(view.element);
(async () => {
  view.show(0, await core.target("a"));
  view.show(1, await core.make({ kind: "features", sliders: ["stride", "bow"], values: [0.3, 0.1] }));
  Object.assign(globalThis, { view, core });
})();
