import type { LiveCore } from "../live/core";
import { openServed } from "../live/served_core";
import { openWasm } from "../live/wasm_core";
import { runScript } from "../questionnaire/media";
import { base, type Mode } from "../questionnaire/surroundings";

/** The motion core behind the server, or in this browser from a script that brings the module. */
export async function coreOf(mode: Mode): Promise<LiveCore> {
  if (mode === "served") return openServed(`${base()}live/`);
  await runScript("live_core.js");
  const files = (globalThis as { mien_live_files?: { module: string; bundle: string } }).mien_live_files;
  if (!files) throw new Error("live_core.js contains no motion core.");
  return openWasm(files.module, files.bundle);
}
