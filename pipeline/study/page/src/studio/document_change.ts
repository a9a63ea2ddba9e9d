import { isMap, type Json, type JsonMap } from "./document";

/** A member's name, or an element's index. */
export type Step = string | number;

/** One change of a document: `set` a value or a member that was not there, `insert` an element before the
    one of that index or behind the last, `remove` a member or an element. */
export type DocumentChange =
  | { kind: "set" | "insert"; path: Step[]; value: Json }
  | { kind: "remove"; path: Step[] };

/** "stimuli[2].adjectives.quickness" */
export const pathText = (path: Step[]): string =>
  path.map((step, i) => (typeof step === "number" ? `[${step}]` : i > 0 ? `.${step}` : step)).join("");

/** Whether two documents say the same: the order of members counts for nothing. */
export function sayTheSame(one: Json | undefined, other: Json | undefined): boolean {
  if (Array.isArray(one) && Array.isArray(other))
    return one.length === other.length && one.every((value, i) => sayTheSame(value, other[i]));
  if (!isMap(one) || !isMap(other)) return one === other;
  const keys = Object.keys(one);
  return keys.length === Object.keys(other).length && keys.every((key) => key in other && sayTheSame(one[key], other[key]));
}

/** A document after a change; throws where there is no such place in it. */
export function changed(document: Json, change: DocumentChange, path = change.path): Json {
  const [step, ...rest] = path;
  if (step === undefined) return change.kind === "remove" ? null : change.value;
  const kind = rest.length > 0 ? "set" : change.kind;
  if (typeof step === "number" && Array.isArray(document)) {
    const old = kind === "insert" ? [] : document.slice(step, step + 1);
    const made = kind === "remove" ? [] : [changed(old[0] ?? null, change, rest)];
    return [...document.slice(0, step), ...made, ...document.slice(step + old.length)];
  }
  if (typeof step !== "string" || !isMap(document)) throw new RangeError(pathText(change.path));
  const { [step]: old, ...others } = document;
  return kind === "remove" ? others : { ...document, [step]: changed(old ?? null, change, rest) };
}

/** Elements that are the same one, changed or not. */
const correspond = (one: Json, other: Json): boolean =>
  isMap(one) && isMap(other) && "id" in one && "id" in other ? sayTheSame(one["id"], other["id"]) : sayTheSame(one, other);

/** Pairs of corresponding elements, ascending in both: as many as there are (longest common subsequence). */
function correspondences(from: Json[], to: Json[]): [number, number][] {
  const longest = Array.from({ length: from.length + 1 }, () => new Array<number>(to.length + 1).fill(0));
  for (let i = from.length - 1; i >= 0; i -= 1)
    for (let j = to.length - 1; j >= 0; j -= 1)
      longest[i]![j] = correspond(from[i]!, to[j]!) ? longest[i + 1]![j + 1]! + 1
        : Math.max(longest[i + 1]![j]!, longest[i]![j + 1]!);
  const pairs: [number, number][] = [];
  for (let i = 0, j = 0; i < from.length && j < to.length;) {
    if (correspond(from[i]!, to[j]!)) pairs.push([i++, j++]);
    else if (longest[i + 1]![j]! >= longest[i]![j + 1]!) i += 1;
    else j += 1;
  }
  return pairs;
}

const changesOfMaps = (from: JsonMap, to: JsonMap, path: Step[]): DocumentChange[] => [
  ...Object.entries(to).flatMap(([key, value]): DocumentChange[] =>
    key in from ? changesBetween(from[key]!, value, [...path, key]) : [{ kind: "set", path: [...path, key], value }]),
  ...Object.keys(from).filter((key) => !(key in to)).map((key): DocumentChange => ({ kind: "remove", path: [...path, key] })),
];

/** From the last element to the first, so that indices of what is yet to be changed stay. */
function changesOfLists(from: Json[], to: Json[], path: Step[]): DocumentChange[] {
  const changes: DocumentChange[] = [];
  let end = from.length, endTo = to.length;
  for (const [i, j] of [...correspondences(from, to).reverse(), [-1, -1] as const]) {
    const begin = i + 1, beginTo = j + 1;
    const common = Math.min(end - begin, endTo - beginTo);
    for (let k = end - 1; k >= begin + common; k -= 1) changes.push({ kind: "remove", path: [...path, k] });
    for (let k = endTo - 1; k >= beginTo + common; k -= 1)
      changes.push({ kind: "insert", path: [...path, begin + common], value: to[k]! });
    for (let k = common - 1; k >= 0; k -= 1)
      changes.push(...changesBetween(from[begin + k]!, to[beginTo + k]!, [...path, begin + k]));
    if (i >= 0) changes.push(...changesBetween(from[i]!, to[j]!, [...path, i]));
    end = i;
    endTo = j;
  }
  return changes;
}

/** What makes one document of another, in the order in which it is to be done; as little as possible.
    Elements that have an `id` are matched by it. */
export function changesBetween(from: Json, to: Json, path: Step[] = []): DocumentChange[] {
  if (isMap(from) && isMap(to)) return changesOfMaps(from, to, path);
  if (Array.isArray(from) && Array.isArray(to)) return changesOfLists(from, to, path);
  return sayTheSame(from, to) ? [] : [{ kind: "set", path, value: to }];
}
