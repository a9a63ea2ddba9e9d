// What is measured of a walker from the joints that a page shows: [{ t, positions, rotations, planted }], seconds.

const scaled = (v, k) => v.map((x) => k * x);
const sum = (a, b) => a.map((x, i) => x + b[i]);
const less = (a, b) => a.map((x, i) => x - b[i]);
const length = (v) => Math.hypot(...v);

/** A vector turned by a unit quaternion (x, y, z, w). */
function turned(v, [x, y, z, w]) {
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const axis = [x, y, z];
  const t = scaled(cross(axis, v), 2);
  return sum(sum(v, scaled(t, w)), cross(axis, t));
}

/** Where the back edge of a heel and the joint of the toes are (motion/skeleton/sole.h). */
function footPoints(frame, body, side) {
  const ankle = body.names.indexOf(`${side}Ankle`);
  const toe = body.names.indexOf(`${side}Toe`);
  const [x, y] = body.offsets[toe];
  const at = (joint) => [...frame.positions.slice(3 * joint, 3 * joint + 3)];
  const rotation = [...frame.rotations.slice(4 * ankle, 4 * ankle + 4)];
  return { heel: sum(at(ankle), turned([x, y - 0.02, -0.045], rotation)), toe: at(toe) };
}

/** Farthest that a standing foot moves on what it turns on, heel or toe joint, over a stance; metres. */
export function largestSlide(frames, body) {
  let largest = 0;
  ["Left", "Right"].forEach((side, s) => {
    let slid = 0;
    let before = null;
    for (const frame of frames) {
      const now = frame.planted[s] === 1 ? footPoints(frame, body, side) : null;
      if (now && before) slid += Math.min(length(less(now.heel, before.heel)), length(less(now.toe, before.toe)));
      else slid = 0;
      largest = Math.max(largest, slid);
      before = now;
    }
  });
  return largest;
}

/** Largest acceleration of a joint, m/s², of frames that are evenly spaced. */
export function largestAcceleration(frames, seconds) {
  let largest = 0;
  for (let i = 1; i + 1 < frames.length; i += 1) {
    const [a, b, c] = [frames[i - 1].positions, frames[i].positions, frames[i + 1].positions];
    for (let k = 0; k < b.length; k += 3) {
      const bend = [0, 1, 2].map((d) => a[k + d] - 2 * b[k + d] + c[k + d]);
      largest = Math.max(largest, length(bend) / seconds ** 2);
    }
  }
  return largest;
}

/** Farthest that a joint of one frame is from that of another, metres. */
export function largestDistance(a, b) {
  let largest = 0;
  for (let k = 0; k < a.positions.length; k += 3)
    largest = Math.max(largest, length([0, 1, 2].map((d) => a.positions[k + d] - b.positions[k + d])));
  return largest;
}

export function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)] ?? 0;
}

export const quantile = (values, share) => {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? 0;
};
