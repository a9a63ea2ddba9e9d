import { read_distance, read_motion } from "./answers";
import type { LiveCore, LiveInfo } from "./core";

/** Why a request was refused, as the server says it. */
async function refusal_of(response: Response): Promise<Error> {
  const text = await response.text();
  try {
    const told = JSON.parse(text) as { wrong?: string; remedy?: string };
    if (told.wrong) return new Error(told.remedy ? `${told.wrong}; ${told.remedy}` : told.wrong);
  } catch {
    // Not of the server itself: its status says enough.
  }
  return new Error(`the motion core's server answered ${response.status}`);
}

/** The motion core behind a server: `base` is the address of its live routes, ending in "/". */
export async function open_served(base: string): Promise<LiveCore> {
  const told = await fetch(`${base}info`);
  if (!told.ok) throw await refusal_of(told);
  const info = (await told.json()) as LiveInfo;

  const send = async (what: string, body: unknown): Promise<ArrayBuffer> => {
    const response = await fetch(base + what, {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify(body),
    });
    if (!response.ok) throw await refusal_of(response);
    return response.arrayBuffer();
  };
  // One after the other, so that answers come in the order asked; no motion waits for a distance.
  const in_order = () => {
    let last: Promise<unknown> = Promise.resolve();
    return (what: string, body: unknown): Promise<ArrayBuffer> => {
      const answer = last.then(() => send(what, body));
      last = answer.catch(() => undefined);
      return answer;
    };
  };
  const ask = in_order();
  const measure = in_order();

  return {
    info,
    example: async (name) => read_motion(await ask("example", { name })),
    target: async (name) => read_motion(await ask("target", { name })),
    make: async (setting) => read_motion(await ask("make", setting)),
    distance: async (target, setting) => read_distance(await measure("distance", { target, ...setting })),
  };
}
