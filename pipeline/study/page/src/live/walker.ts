// A walker under control inside the browser: it is steered from frame to frame, on the page itself, for a
// frame of it takes less than a tenth of a millisecond (motion/live/browser/walker_module.cpp).

import type { LiveInfo } from "./core";

export interface WalkRequest {
  /** Share of the mood's own speed: 0 stops, 1 walks, at most 1.2. */
  pace: number;
  /** To face, degrees about +Y from +Z; turned to the shorter way. */
  heading_deg?: number;
  /** Degrees a second to the left, when no heading is wanted. */
  turn_deg_s?: number;
  /** A weight ≥ 0 for each of the walker's moods; the first alone where none is above 0. */
  moods: number[];
}

/** Valid until the walker goes on. */
export interface WalkFrame {
  /** joints × 3, world, metres, +Y up. */
  positions: Float64Array;
  /** joints × 4 (x, y, z, w), joint frame → world. */
  rotations: Float64Array;
  /** Left and right foot: 1 stands on the floor, 0 swings. */
  planted: Float64Array;
  /** Metres a second. */
  speed: number;
  /** Degrees about +Y from +Z. */
  heading: number;
}

export interface WalkerInfo {
  set: string;
  moods: string[];
  body: LiveInfo["body"];
}

export interface Walker {
  readonly info: WalkerInfo;
  /** So many seconds later; more than a quarter of a second counts as that. */
  advance(seconds: number, wish: WalkRequest): WalkFrame;
}

interface Exports {
  memory: WebAssembly.Memory;
  _initialize(): void;
  live_room(size: number): number;
  live_leave(place: number): void;
  walker_open(set: number, setSize: number, moods: number, moodsSize: number): number;
  walker_mood(mood: number, share: number): void;
  walker_steer(pace: number, headingDeg: number, turnDegS: number): void;
  walker_advance(seconds: number): number;
  walker_frame(): number;
  walker_frame_size(): number;
  walker_told(): number;
  walker_told_size(): number;
}

async function exportsOf(module: ArrayBuffer): Promise<Exports> {
  const stop = () => {
    throw new Error("the walker stopped");
  };
  const imports = {
    wasi_snapshot_preview1: new Proxy({}, { get: () => stop }),
    env: { emscripten_notify_memory_growth: () => undefined },
  };
  const { instance } = await WebAssembly.instantiate(module, imports as WebAssembly.Imports);
  const exports = instance.exports as unknown as Exports;
  exports._initialize();
  return exports;
}

function toldBy(exports: Exports): string {
  const bytes = new Uint8Array(exports.memory.buffer, exports.walker_told(), exports.walker_told_size());
  return new TextDecoder().decode(bytes.slice());
}

function openIn(exports: Exports, set: string, moods: string[]): WalkerInfo {
  const names = [set, moods.join(",")].map((text) => new TextEncoder().encode(text));
  const places = names.map((bytes) => {
    const place = exports.live_room(bytes.length + 1);
    new Uint8Array(exports.memory.buffer, place, bytes.length).set(bytes);
    return place;
  });
  const isOpen = exports.walker_open(places[0]!, names[0]!.length, places[1]!, names[1]!.length);
  for (const place of places) exports.live_leave(place);
  if (isOpen !== 1) throw new Error(toldBy(exports));
  return JSON.parse(toldBy(exports)) as WalkerInfo;
}

/** The frame as it lies in the module's memory, which may move when it grows. */
function frameIn(exports: Exports, joints: number): WalkFrame {
  const numbers = new Float64Array(exports.memory.buffer, exports.walker_frame(), exports.walker_frame_size());
  const planted = 7 * joints;
  return {
    positions: numbers.subarray(0, 3 * joints),
    rotations: numbers.subarray(3 * joints, planted),
    planted: numbers.subarray(planted, planted + 2),
    speed: numbers[planted + 2]!,
    heading: numbers[planted + 3]!,
  };
}

/**
 * A walker that stands at the origin and faces +Z. `module`: the motion core for browsers, as bytes or
 * base64; `set`: the built-in walks that moods are taken from, `moods`: which of them (all: some
 * tenths of a second to open). Rejects with an Error that says what is wrong.
 */
export async function openWalker(module: ArrayBuffer | string, set = "walks-10", moods: string[] = []): Promise<Walker> {
  const bytes = typeof module === "string" ? Uint8Array.from(atob(module), (c) => c.charCodeAt(0)).buffer : module;
  const exports = await exportsOf(bytes);
  const info = openIn(exports, set, moods);
  const joints = info.body.names.length;
  return {
    info,
    advance(seconds, wish) {
      const isAny = wish.moods.some((share) => share > 0);
      info.moods.forEach((_, mood) => exports.walker_mood(mood, isAny ? wish.moods[mood] ?? 0 : mood === 0 ? 1 : 0));
      exports.walker_steer(wish.pace, wish.heading_deg ?? NaN, wish.turn_deg_s ?? 0);
      if (exports.walker_advance(seconds) !== 1) throw new Error(toldBy(exports));
      return frameIn(exports, joints);
    },
  };
}
