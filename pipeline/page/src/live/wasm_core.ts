import type { LiveCore } from "./core";

/**
 * The motion core inside the browser: in a worker where workers can be had, else on the page.
 * `module`: the WebAssembly module, or its base64; `bundle`: what it blends.
 */
export async function open_wasm(_module: ArrayBuffer | string, _bundle: ArrayBuffer): Promise<LiveCore> {
  throw new Error("the motion core does not run in the browser yet");
}
