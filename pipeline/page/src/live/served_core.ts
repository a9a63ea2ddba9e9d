import type { LiveCore } from "./core";

/** The motion core behind a server: `base` is the address of its live routes, ending in "/". */
export async function open_served(_base: string): Promise<LiveCore> {
  throw new Error("the motion core is not served yet");
}
