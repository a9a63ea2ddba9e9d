// The colours of ꟻLIP's maps: lighter is worse. The program draws them likewise.

type Colour = [red: number, green: number, blue: number];

const stops: Colour[] = [[0, 0, 4], [81, 18, 124], [183, 55, 121], [252, 137, 97], [252, 253, 191]];

/** Of an error, 0 to 1. */
export function flipColour(share: number): Colour {
  const place = Math.min(1, Math.max(0, share)) * 4;
  const below = Math.min(3, Math.floor(place));
  const next = stops[below + 1]!;
  return stops[below]!.map((value, i) => value + (place - below) * (next[i]! - value)) as Colour;
}

/** The error that a colour stands for. */
export function flipShare(red: number, green: number): number {
  if (green > 137) return 0.75 + 0.25 * (green - 137) / 116;
  const below = red < 81 ? 0 : red < 183 ? 1 : 2;
  return (below + (red - stops[below]![0]) / (stops[below + 1]![0] - stops[below]![0])) / 4;
}

export const flipText = (share: number): string => `rgb(${flipColour(share).map(Math.round).join(" ")})`;
