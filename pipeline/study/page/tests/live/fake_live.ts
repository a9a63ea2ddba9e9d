// In the place of src/live/core.ts when the page is tried without a motion core.
import { openFake } from "./fake_core";

const open = async () => openFake({ "target-1": [0.8, 0.6, 0.3, 0.7], "target-2": [0.3, 0.4, 0.7, 0.4] });
export const openWasm = open;
export const openServed = open;
