import { readDistance, readMotion } from "./answers";
import type { LiveCore, LiveInfo } from "./core";
import { wasmInstance, type WasmAnswer, type WasmRequest } from "./wasm_instance";

function fromBase64(text: string): ArrayBuffer {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes.buffer;
}

/** What a worker runs: answers each message with { id, bytes } or { id, error }. */
function workerScript(): string {
  return `"use strict";
const answer = (${wasmInstance.toString()})();
let last = Promise.resolve();
onmessage = ({ data: { id, request } }) => {
  last = last.then(() => answer(request)).then(
    (bytes) => postMessage({ id, bytes }, [bytes]),
    (error) => postMessage({ id, error: String(error && error.message || error) }));
};`;
}

/** Answers from a worker; rejects when there cannot be one, or it cannot run the module. */
async function inWorker(open: WasmRequest): Promise<{ answer: WasmAnswer; info: ArrayBuffer }> {
  const address = URL.createObjectURL(new Blob([workerScript()], { type: "text/javascript" }));
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
async function onPage(open: WasmRequest): Promise<{ answer: WasmAnswer; info: ArrayBuffer }> {
  const instance = wasmInstance();
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
function whenAsked(start: () => Promise<WasmAnswer>): WasmAnswer {
  let started: Promise<WasmAnswer> | undefined;
  return async (request) => (await (started ??= start()))(request);
}

/**
 * The motion core inside the browser: in workers where workers can be had, else on the page. Distances,
 * which take longer, are measured in a worker of their own, so that no motion waits for them.
 * `module`: the WebAssembly module, `bundle`: what it blends; bytes or base64 (globalThis.mien_live_files).
 */
export async function openWasm(module: ArrayBuffer | string, bundle: ArrayBuffer | string): Promise<LiveCore> {
  const bytesOf = (given: ArrayBuffer | string) => (typeof given === "string" ? fromBase64(given) : given);
  const open: WasmRequest = { what: "open", module: bytesOf(module), bundle: bytesOf(bundle) };
  const start = () => inWorker(open);
  // What fails in a worker and on the page alike is told as the page has it.
  const canWork = typeof Worker !== "undefined";
  const { answer, info, isWorker: isWorker } = await (canWork
    ? start().then((worker) => ({ ...worker, isWorker: true }))
    : Promise.reject(new Error("no workers"))
  ).catch(() => onPage(open).then((page) => ({ ...page, isWorker: false })));
  const measure = isWorker ? whenAsked(() => start().then((worker) => worker.answer, () => answer)) : answer;
  return {
    info: JSON.parse(new TextDecoder().decode(info)) as LiveInfo,
    example: async (name) => readMotion(await answer({ what: "example", name })),
    target: async (name) => readMotion(await answer({ what: "target", name })),
    make: async (setting) => readMotion(await answer({ what: "make", setting })),
    distance: async (target, setting) => readDistance(await measure({ what: "distance", target, setting })),
  };
}
