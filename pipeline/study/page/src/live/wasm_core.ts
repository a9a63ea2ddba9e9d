import { read_distance, read_motion } from "./answers";
import type { LiveCore, LiveInfo } from "./core";
import { wasm_instance, type WasmAnswer, type WasmRequest } from "./wasm_instance";

function from_base64(text: string): ArrayBuffer {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes.buffer;
}

/** What a worker runs: answers each message with { id, bytes } or { id, error }. */
function worker_script(): string {
  return `"use strict";
const answer = (${wasm_instance.toString()})();
let last = Promise.resolve();
onmessage = ({ data: { id, request } }) => {
  last = last.then(() => answer(request)).then(
    (bytes) => postMessage({ id, bytes }, [bytes]),
    (error) => postMessage({ id, error: String(error && error.message || error) }));
};`;
}

/** Answers from a worker; rejects when there cannot be one, or it cannot run the module. */
async function in_worker(open: WasmRequest): Promise<{ answer: WasmAnswer; info: ArrayBuffer }> {
  const address = URL.createObjectURL(new Blob([worker_script()], { type: "text/javascript" }));
  const worker = new Worker(address);
  const waiting = new Map<number, { resolve(bytes: ArrayBuffer): void; reject(error: Error): void }>();
  let asked = 0;
  worker.onmessage = ({ data }: MessageEvent<{ id: number; bytes?: ArrayBuffer; error?: string }>) => {
    const asker = waiting.get(data.id);
    waiting.delete(data.id);
    if (data.bytes) asker?.resolve(data.bytes);
    else asker?.reject(new Error(data.error));
  };
  worker.onerror = (event) => {
    for (const asker of waiting.values()) asker.reject(new Error(event.message || "no worker"));
    waiting.clear();
  };
  const answer: WasmAnswer = (request) =>
    new Promise((resolve, reject) => {
      const id = ++asked;
      waiting.set(id, { resolve, reject });
      worker.postMessage({ id, request });
    });
  try {
    return { answer, info: await answer(open) };
  } catch (error) {
    worker.terminate();
    throw error;
  } finally {
    URL.revokeObjectURL(address);
  }
}

/** On the page itself, one request after the other. */
async function on_page(open: WasmRequest): Promise<{ answer: WasmAnswer; info: ArrayBuffer }> {
  const instance = wasm_instance();
  const info = await instance(open);
  let last: Promise<unknown> = Promise.resolve();
  const answer: WasmAnswer = (request) => {
    const made = last.then(() => instance(request));
    last = made.catch(() => undefined);
    return made;
  };
  return { answer, info };
}

/** As given, but not before it is first asked for anything. */
function when_asked(start: () => Promise<WasmAnswer>): WasmAnswer {
  let started: Promise<WasmAnswer> | undefined;
  return async (request) => (await (started ??= start()))(request);
}

/**
 * The motion core inside the browser: in workers where workers can be had, else on the page. Distances,
 * which take longer, are measured in a worker of their own, so that no motion waits for them.
 * `module`: the WebAssembly module, `bundle`: what it blends; bytes or base64 (globalThis.mien_live_files).
 */
export async function open_wasm(module: ArrayBuffer | string, bundle: ArrayBuffer | string): Promise<LiveCore> {
  const bytes_of = (given: ArrayBuffer | string) => (typeof given === "string" ? from_base64(given) : given);
  const open: WasmRequest = { what: "open", module: bytes_of(module), bundle: bytes_of(bundle) };
  const start = () => in_worker(open);
  // What fails in a worker and on the page alike is told as the page has it.
  const can_work = typeof Worker !== "undefined";
  const { answer, info, is_worker } = await (can_work
    ? start().then((worker) => ({ ...worker, is_worker: true }))
    : Promise.reject(new Error("no workers"))
  ).catch(() => on_page(open).then((page) => ({ ...page, is_worker: false })));
  const measure = is_worker ? when_asked(() => start().then((worker) => worker.answer, () => answer)) : answer;
  return {
    info: JSON.parse(new TextDecoder().decode(info)) as LiveInfo,
    example: async (name) => read_motion(await answer({ what: "example", name })),
    target: async (name) => read_motion(await answer({ what: "target", name })),
    make: async (setting) => read_motion(await answer({ what: "make", setting })),
    distance: async (target, setting) => read_distance(await measure({ what: "distance", target, setting })),
  };
}
