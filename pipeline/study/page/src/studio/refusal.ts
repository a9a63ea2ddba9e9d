export interface Fault {
  path: string;
  wrong: string;
  remedy: string;
}

export const sentenceOf = ({ path, wrong, remedy }: Fault): string =>
  `${path ? `${path}: ` : ""}${wrong}${remedy ? `; ${remedy}` : ""}`;

/** What cannot be done, in words for people. */
export class Refusal extends Error {
  /** `status`: of the server's answer, if it is one; `answer`: what else stands in that. */
  constructor(readonly faults: Fault[], readonly status = 0, readonly answer: unknown = {}) {
    super(faults.map(sentenceOf).join("\n"));
  }
}
