import { readDistance, readMotion } from "./answers";
import type { LiveCore, LiveInfo } from "./core";

/** Why a request was refused, as the server says it. */
async function refusalOf(response: Response): Promise<Error> {
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
export async function openServed(base: string): Promise<LiveCore> {
  const told = await fetch(`${base}info`);
  if (!told.ok) throw await refusalOf(told);
  const info = (await told.json()) as LiveInfo;

  const send = async (what: string, body: unknown): Promise<ArrayBuffer> => {
    const response = await fetch(base + what, {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify(body),
    });
    if (!response.ok) throw await refusalOf(response);
    return response.arrayBuffer();
  };
  // One after the other, so that answers come in the order asked; no motion waits for a distance.
  const inOrder = () => {
    let last: Promise<unknown> = Promise.resolve();
    return (what: string, body: unknown): Promise<ArrayBuffer> => {
      const answer = last.then(() => send(what, body));
      last = answer.catch(() => undefined);
      return answer;
    };
  };
  const ask = inOrder();
  const measure = inOrder();

  return {
    info,
    example: async (name) => readMotion(await ask("example", { name })),
    target: async (name) => readMotion(await ask("target", { name })),
    make: async (setting) => readMotion(await ask("make", setting)),
    distance: async (target, setting) => readDistance(await measure("distance", { target, ...setting })),
  };
}
