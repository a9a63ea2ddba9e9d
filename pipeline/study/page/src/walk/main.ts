import { openWalker } from "../live/walker";
import { element } from "../questionnaire/elements";
import { mountWalk } from "./mount_walk";

declare global {
  // Beside the page, or before it in a script: live_core.js.
  // eslint-disable-next-line no-var
  var mien_live_files: { module: string } | undefined;
}

/** The motion core: of a script that came before, else from beside the page. */
async function moduleBytes(): Promise<ArrayBuffer | string> {
  const files = globalThis.mien_live_files;
  if (files?.module) return files.module;
  const answer = await fetch("live_core.wasm");
  if (!answer.ok) throw new Error(`live_core.wasm is not there (${answer.status})`);
  return answer.arrayBuffer();
}

/** A walker that the studio opened leads back to it. */
function studioLink(): HTMLElement {
  return element("a", { class: "to-studio", href: "./" }, "Studio");
}

async function start(): Promise<void> {
  const place = document.querySelector<HTMLElement>("main")!;
  try {
    const module = await moduleBytes();
    const walk = await mountWalk(place, { module });
    if (document.querySelector('meta[name="mien-mode"][content="served"]')) place.append(studioLink());
    // For measurements from outside: what is shown, and a walker that nobody sees.
    Object.assign(globalThis, { mien_walk: walk, mien_walk_alone: () => openWalker(module) });
  } catch (error) {
    place.textContent = `The walker cannot walk here: ${error instanceof Error ? error.message : String(error)}`;
  }
}

void start();
