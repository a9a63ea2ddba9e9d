#pragma once

#include <string>
#include <vector>

#include "pipeline/study/results/answer_set.h"
#include "pipeline/study/results/participants.h"

namespace mien::pipeline {

/// A stage of participation, and how many reached it or left there.
struct FlowStage {
  std::string stage;  ///< "consented", "turned away by the screening: age", …
  int sessions = 0;
};

/// How many sessions were begun, ended early and for which reason, finished, and were analysed:
/// what the flow diagram of a study report states. Counted are the rows of the table of
/// participants, and the participants of the answers. Empty if the table does not state how
/// sessions ended. Sessions that were refused or withdrawn are not in it, as nothing is kept of
/// them.
std::vector<FlowStage> participant_flow(const AnswerSet& answer_set,
                                        const ParticipantTable& participants);

}  // namespace mien::pipeline
