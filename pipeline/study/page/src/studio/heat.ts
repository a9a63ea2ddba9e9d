// Distances as colours: from a quiet grey-blue at 0 over yellow to dark red at 0.15 m and more.

const stops: [number, [number, number, number]][] = [
  [0, [126, 146, 168]], [0.03, [196, 204, 178]], [0.06, [240, 204, 96]], [0.1, [222, 116, 52]], [0.15, [150, 26, 32]],
];

/** Metres to "#rrggbb". */
export function heat(metres: number): string {
  const k = Math.max(1, stops.findIndex(([at], i) => i > 0 && metres <= at));
  const [from, low] = stops[k - 1]!;
  const [to, high] = metres > 0.15 ? stops[stops.length - 1]! : stops[k]!;
  const share = metres > 0.15 ? 1 : Math.min(1, Math.max(0, (metres - from) / (to - from)));
  const parts = low.map((one, i) => Math.round(one + share * (high[i]! - one)));
  return `#${parts.map((one) => one.toString(16).padStart(2, "0")).join("")}`;
}

/** Of all joints: the root has no distance of its own, for it is laid upon the other's. */
export const heatColours = (byJoint: number[]): string[] => [heat(0), ...byJoint.map(heat)];
