// Experiments with chains for trying the page, and the page with a fake motion core.
import { fakeLivePage } from "../live/fake_page.mjs";

export const dimensions = [
  { name: "stride", low: 0, high: 1 }, { name: "arms", low: 0.1, high: 0.9 }, { name: "bow", low: 0, high: 0.8 },
];

/** The plan of a trial: of Gibbs sampling each dimension in turn, with sliders in both directions. */
function trialOf(method, number, word, chain, step, more = {}) {
  const fixed = { word, chain, step };
  const gibbs = { dimension: step % 3, slider: { start: (0.17 + 0.29 * number) % 1, reversed: number % 2 === 0 } };
  const mcmc = { normals: [0, 1, 2].map((d) => 3 * Math.sin(7 * number + 2 * d)), proposal_first: number % 2 === 1 };
  return { number, block: "main", kind: "chain", practice: false, media: [], ...fixed,
    ...(method === "gibbs" ? gibbs : mcmc), ...more };
}

/** Two trials of practice, and two chains of three steps of two words, in two blocks. */
export function chainExperiment(method, more = {}, chains = {}) {
  const practice = [1, 2].map((number) =>
    trialOf(method, number, "sad", 1, number - 1, { practice: true, block: "practice" }));
  const steps = [["sad", 1, 0], ["sad", 2, 0], ["sad", 1, 1], ["sad", 2, 1], ["sad", 1, 2], ["sad", 2, 2]];
  const of = (word, from) => steps.map(([, chain, step], at) => trialOf(method, from + at, word, chain, step, { block: word }));
  const starts = Object.fromEntries(["practice/1", "sad/1", "sad/2", "proud/1", "proud/2"].map((name, at) =>
    [name, dimensions.map(({ low, high }, d) => low + (high - low) * ((0.2 + 0.3 * at + 0.15 * d) % 1))]));
  return {
    format: "mien-chains-1", study: "chains", title: "Words for movements", language: "en", design: "c1", simulated: false,
    texts: { consent: ["Taking part is voluntary."], instructions: [], ending: ["Thank you for your help."] },
    settings: { phones: "served" }, demographics: [{ id: "age", ask: "How old are you?", answer: "number" }],
    chains: { method, across_participants: false, kind: "features", dimensions, words: { sad: "sad", proud: "proud" },
      colour: "#c9c9c9", deviation: 0.3, ...chains },
    sessions: ["p001", "p002"].map((participant) => ({ participant, seed: "9", starts,
      trials: [...practice, ...of("sad", 3), ...of("proud", 9)] })),
    ...more,
  };
}

/** Chains whose steps a server hands out. */
export function sharedExperiment(method) {
  const experiment = chainExperiment(method, {}, { across_participants: true });
  const bare = ({ number, block, kind, practice, media }) => ({ number, block, kind, practice, media });
  for (const session of experiment.sessions)
    session.trials = session.trials.map((trial) => (trial.practice ? trial : bare(trial)));
  return experiment;
}

export const fakePage = (folder, experiment) => fakeLivePage(folder, "chains", experiment);
