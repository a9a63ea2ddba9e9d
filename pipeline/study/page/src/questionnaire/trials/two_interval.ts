// Which of two stimuli, shown one after the other, has the signal. The study asks its own question.

import { twoChoices } from "./two_choices";
import type { CheckedKind } from "./trial_kind";

export const twoInterval: CheckedKind = {
  ...twoChoices("two_interval", (texts) => texts.answerWanted,
    (texts) => [["first", texts.first], ["second", texts.second]]),

  meaning: ({ media: [first, second] }, _response, raw, _experiment, stimulus) =>
    ({ value: stimulus(raw === "first" ? first : second), pole_left: "" }),
};
