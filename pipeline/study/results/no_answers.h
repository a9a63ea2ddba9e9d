#pragma once

#include <vector>

#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// Throws Error at the table of answers, none of which can be analysed: how many are left out for
/// each reason, and how to mend it. `answer_set` has the participants and their flags.
[[noreturn]] void refuse_without_answers(const std::vector<AnswerRow>& rows,
                                         const AnswerSet& answer_set);

}  // namespace mien::pipeline
