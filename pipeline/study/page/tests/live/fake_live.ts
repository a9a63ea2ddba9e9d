// In the place of src/live/core.ts when the page is tried without a motion core.
import type { LiveSetting } from "../../src/live/core";
import { openFake } from "./fake_core";

/** Of all motions, for tests that look at what is shown. */
const mienMade: LiveSetting[] = [];
Object.assign(globalThis, { mienMade });

const open = async () => {
  const core = openFake({ "target-1": [0.8, 0.6, 0.3, 0.7], "target-2": [0.3, 0.4, 0.7, 0.4] });
  return { ...core, make: (setting: LiveSetting) => {
    mienMade.push(setting);
    return core.make(setting);
  } };
};
export const openWasm = open;
export const openServed = open;
