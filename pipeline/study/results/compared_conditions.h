#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

/// What the pairs of a study compare: the combinations of levels of the factors that the analysis
/// plan names (FactorialPlan::factors), over all stimuli with these levels; single stimuli if it
/// names none.
struct ComparedConditions {
  std::vector<std::string> names;  ///< "acted, matched", or the id of a stimulus
  /// The condition of each of AnswerSet::stimuli.
  std::vector<std::size_t> of_stimulus;
  FactorTable factors;  ///< AnswerSet::factors for each condition, in the order of `names`
};

/// The conditions in the order in which their first stimuli occur in the manifest. A stimulus
/// without a level of one of the factors, such as one that is only for practice, is a condition of
/// its own.
ComparedConditions compared_conditions(const AnswerSet& answer_set);

}  // namespace mien::pipeline
