// Viewing distances from readings of the blind spot.

/** Between the line of sight and the edge of the blind spot, degrees (Li et al. 2020). */
const blindSpotDegrees = 13.5;

/** Distances beyond these are no measurement, centimetres. */
const plausible = [20, 200] as const;

/** The distance at which a dot disappears that far from the square; both in the same unit. */
export const viewingDistance = (apart: number): number => apart / Math.tan((blindSpotDegrees * Math.PI) / 180);

/** The median; null where it is not plausible. */
export function measuredDistance(distancesCm: number[]): number | null {
  const sorted = [...distancesCm].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  const median = sorted.length % 2 ? sorted[middle]! : (sorted[middle - 1]! + sorted[middle]!) / 2;
  return median >= plausible[0] && median <= plausible[1] ? Math.round(10 * median) / 10 : null;
}
