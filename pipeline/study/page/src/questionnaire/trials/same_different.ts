// Whether two stimuli are the same.

import { twoChoices } from "./two_choices";

export const sameDifferent = twoChoices("same_different", (texts) => texts.sameOrDifferent,
  (texts) => [["same", texts.same], ["different", texts.different]]);
