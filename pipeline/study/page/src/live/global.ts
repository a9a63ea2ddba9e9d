// The live core for scripts that are not bundled with it: tests and measurements.

import { openServed } from "./served_core";
import { openWasm } from "./wasm_core";
import { wasmInstance } from "./wasm_instance";

Object.assign(globalThis, { mien_live: { openWasm, openServed, wasmInstance } });
