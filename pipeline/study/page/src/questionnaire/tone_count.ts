// How many tones the test of sound plays, and whether they were counted.

import type { Response } from "./experiment";

/** Who counts wrong this often is turned away. */
export const toneAttempts = 2;

/** The item under which a count is kept. */
export const toneItem = (attempt: number): string => `tones_${attempt}`;

/**
 * How many tones are played at an attempt, counted from 1: 3 to 7, which a server finds out by itself
 * (service/screening_record.cpp). The hash is FNV-1a of 32 bits.
 */
export function toneCount(session: string, attempt: number): number {
  let hash = 0x811c9dc5;
  for (const byte of new TextEncoder().encode(`${session}/${attempt}`))
    hash = Math.imul(hash ^ byte, 0x01000193) >>> 0;
  return 3 + ((hash >>> 8) % 5);
}

/** Whether one of the counts is right. */
export function hasCountedTones(session: string, responses: Response[]): boolean {
  return Array.from({ length: toneAttempts }, (_, index) => index + 1).some((attempt) =>
    responses.some(({ item, value_raw: value }) =>
      item === toneItem(attempt) && Number(value) === toneCount(session, attempt)));
}
