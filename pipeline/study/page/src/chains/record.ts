/** A step of a chain as it is kept: what was shown, and what a person did. */
export interface ChainRecord {
  word: string;
  /** Of the word, from 1. */
  chain: number;
  /** Of the chain, from 0 or 1 as the plan counts. */
  step: number;
  /** Of those who answer the step, as a server counts them; 0 without a server. */
  person: number;
  /** Before the step. */
  point: number[];
  /** Of Gibbs sampling: what is free, its place among the dimensions. */
  dimension?: number;
  /** Where the slider stood at first, a share of the range. */
  start?: number;
  /** Whether the high end was on the left. */
  reversed?: boolean;
  /** The coordinate that was chosen. */
  value?: number;
  /** Of MCMC with people. */
  proposal?: number[];
  /** Or on the left. */
  proposal_first?: boolean;
  chose_proposal?: boolean;
  /** Changes of the slider. */
  moves: number;
  /** How often the trial was begun: more than once after a reload. */
  attempt: number;
}
