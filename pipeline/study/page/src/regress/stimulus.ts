// What the report says of a stimulus (pipeline/regression/report/report_pictures.h, report_videos.h).

/** A key frame, then and now; pictures are addresses. */
export interface KeyFrame {
  frame: number;
  /** Since the motion began, where it has one. */
  seconds?: number;
  flip_mean: number;
  flip_most: number;
  ssim: number;
  /** The largest difference of a channel, 0 to 255. */
  largest: number;
  is_bias: boolean;
  /** Of what changed, how much lies at a part of the body; "" is the rest. */
  shares: { part: string; share: number }[];
  before: string;
  now: string;
  flip: string;
}

/** World places of joints, 16 bits each, as a data address: frame, joint, axis. */
export interface PackedPoses {
  fps: number;
  joints: number;
  bones: [number, number][];
  step_mm: number;
  places: string;
}

export interface Part {
  name: string;
  /** Millimetres, a frame. */
  curve: number[];
}

export interface ComparedMotion {
  before: PackedPoses;
  now: PackedPoses;
  fps: number;
  /** The most of all parts, and where that is largest. */
  curve: number[];
  worst: number;
  parts: Part[];
}

export interface VideoSource {
  src: string;
  frames: number;
  /** The first that shows the motion. */
  first: number;
  fps: number;
}

export const editions = ["before", "now"] as const;
export type Edition = (typeof editions)[number];
export type Videos = Record<Edition, VideoSource>;

export interface ComparedStimulus {
  frames: KeyFrame[];
  motion?: ComparedMotion;
  videos?: Videos;
}

/** Which of a clock's frames shows the moment of a key frame: the rate may be another now. */
export const placeOf = (frame: KeyFrame, fps: number): number =>
  frame.seconds === undefined ? frame.frame : Math.round(frame.seconds * fps);

/** The part that is farthest apart at a moment. */
export const partAt = ({ parts }: ComparedMotion, moment: number): Part | undefined =>
  parts.reduce<Part | undefined>((most, part) => ((part.curve[moment] ?? 0) > (most?.curve[moment] ?? 0) ? part : most), parts[0]);

export const millimetres = (value: number): string =>
  `${value >= 100 ? value.toFixed(0) : value >= 10 ? value.toFixed(1) : value.toFixed(2)} mm`;
