#pragma once

#include <string>
#include <vector>

#include "pipeline/study/results/answer_set.h"
#include "pipeline/study/results/participants.h"

namespace mien::pipeline {

// Whose the rows of a table of participants are. An id alone is not enough: without a server, two
// browsers may have received the same plan, and one of them may have left before any answer.

/// For each row of the table, the participant as named in the answer set (separate_participants):
/// the one whose answers have the row's id and session, or the row's id, if either has no session
/// and no other people have that id. Empty for rows of visitors who gave no answers, if somebody
/// else with their id gave some, and if it is not known whose the row is.
std::vector<std::string> people_of_rows(const ParticipantTable& participants,
                                        const AnswerSet& answer_set);

/// The same for publication: rows that are nobody's are named "p003/<session>", so that no answers
/// seem to be theirs.
std::vector<std::string> published_names(const ParticipantTable& participants,
                                         const AnswerSet& answer_set);

}  // namespace mien::pipeline
