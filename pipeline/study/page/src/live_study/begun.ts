import { Drawer } from "../questionnaire/store";

/**
 * How often a trial, or a part of it that is made by itself, was begun in this browser session, this time counted:
 * more than once after a reload.
 */
export function attemptAt({ design }: { design: string }, session: string, trial: string | number): number {
  const drawer = new Drawer(`mien/${design}/${session}/begun`);
  const begun = drawer.read<Record<string, number>>() ?? {};
  const attempt = (begun[trial] ?? 0) + 1;
  drawer.write({ ...begun, [trial]: attempt });
  return attempt;
}
