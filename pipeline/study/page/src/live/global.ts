// The live core for scripts that are not bundled with it: tests and measurements.

import { open_served } from "./served_core";
import { open_wasm } from "./wasm_core";
import { wasm_instance } from "./wasm_instance";

Object.assign(globalThis, { mien_live: { open_wasm, open_served, wasm_instance } });
