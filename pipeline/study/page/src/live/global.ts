// The live core for scripts that are not bundled with it: tests and measurements.

import { open_served, open_wasm } from "./core";
import { wasm_instance } from "./wasm_instance";

Object.assign(globalThis, { mien_live: { open_wasm, open_served, wasm_instance } });
