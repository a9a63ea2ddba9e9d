// Whether a stimulus has the signal. The study asks its own question.

import { twoChoices } from "./two_choices";

export const yesNo = twoChoices("yes_no", (texts) => texts.answerWanted,
  (texts) => [["yes", texts.yes], ["no", texts.no]]);
