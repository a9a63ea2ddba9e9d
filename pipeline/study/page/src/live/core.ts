// Sliders in, motion out: what the matching experiment and the studio ask of the motion core, whether
// it runs in the browser as WebAssembly (wasm_core.ts) or behind a server (served_core.ts).

export type InterfaceKind = "adjectives" | "features" | "weights";

/** What sliders set: a blend, or modifications of one motion. */
export type SettingKind = InterfaceKind | "modifications";

export interface Slider {
  name: string;
  /** What its ends are called, 0 and 1, in English. */
  low?: string;
  high?: string;
  /** Shown at once; the others are added by who wants them. */
  primary: boolean;
  /** What it is called by language tag, where that is not its name: { en: "…", ja: "…" }. */
  labels?: Record<string, string>;
  /** The ends by language tag: { ja: ["…", "…"] }. */
  texts?: Record<string, [string, string]>;
  /** Of the examples: the neutral setting, 0 to 1. */
  mean: number;
}

export interface LiveInfo {
  /** Joints in order, parents before children (-1: none); offsets and tips in metres, tips of ends. */
  body: { names: string[]; parents: number[]; offsets: number[][]; tips: (number[] | null)[] };
  /** The sliders of the weights' interface. */
  examples: string[];
  sliders: { adjectives: Slider[]; features: Slider[] };
  targets: string[];
  foot_lock: boolean;
  method: string;
  fps: number;
}

export interface LiveMotion {
  frames: number;
  fps: number;
  loops: boolean;
  /** From one cycle to the next, metres. */
  displacement: [number, number, number];
  /** frames × joints × 3, world, metres, +Y up, travelling along +Z. */
  positions: Float32Array;
  /** frames × joints × 4 (x, y, z, w), joint frame → world. */
  rotations: Float32Array;
  /** Seconds. */
  keytimes: Float64Array;
  /** One an example; empty for what is no blend. */
  weights: Float64Array;
  /** frames × 2: left, right foot planted (1) or not (0). */
  contacts: Uint8Array;
}

/** What `mien motion compare` finds of the written clips. Metres. */
export interface LiveDistance {
  D: number;
  D_sum: number;
  /** 20 joints: the body's without its root. */
  by_joint: Float64Array;
  /** 11 times from start to end. */
  by_time: Float64Array;
}

/** Sliders of one interface, all of them that matter, and where they stand: 0 to 1; of modifications within the limits
    of their dimensions. */
export interface LiveSetting {
  kind: SettingKind;
  sliders: string[];
  values: number[];
}

/**
 * Every function rejects with an Error that says what is wrong. Motions come in the order asked, and so
 * do distances; motions do not wait for distances.
 */
export interface LiveCore {
  readonly info: LiveInfo;
  example(name: string): Promise<LiveMotion>;
  target(name: string): Promise<LiveMotion>;
  make(setting: LiveSetting): Promise<LiveMotion>;
  distance(target: string, setting: LiveSetting): Promise<LiveDistance>;
}
