#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "pipeline/base/statistics/t_test.h"
#include "pipeline/study/results/participants.h"

namespace mien::pipeline {

/// Two groups of participants with different answers to a demographic question, such as gender.
/// Members are indices into AnswerSet::people.
struct ParticipantGroups {
  std::string question;
  std::string one;    ///< the most frequent answer; ties alphabetically
  std::string other;  ///< the second most frequent
  std::vector<std::size_t> people_one, people_other;
};

/// Included participants by their answer to a question, with their rows (people_of_rows);
/// those for whom several rows have answers to the question are omitted, even if the answers are
/// equal. Empty if the table has no such column.
std::map<std::string, std::vector<std::size_t>> people_by_answer(
    const ParticipantTable& participants, const std::string& question, const AnswerSet& answer_set);

/// Names the included participants who are in no group, with the question and the reason: no row of
/// theirs, several with an answer to the question, or, of questions that the analysis compares, no
/// answer. States if there are no groups by the question that the manifest plans.
std::vector<std::string> ungrouped_sentences(const ParticipantTable& participants,
                                             const AnswerSet& answer_set);

/// The groups of the two most frequent answers to each demographic question whose answers are not
/// numbers, if at least two participants gave each answer. Participants for whom the table has
/// answers to the question in several rows are omitted, even if the answers are equal.
std::vector<ParticipantGroups> participant_groups(const ParticipantTable& participants,
                                                  const AnswerSet& answer_set);

/// The difference between two groups for a stimulus on a scale: Welch's test of participants'
/// means. Means are in scale units.
struct GroupComparison {
  std::string question, one, other;
  std::size_t stimulus = 0;
  std::size_t scale = 0;
  int people_one = 0;
  double mean_one = 0.0;
  int people_other = 0;
  double mean_other = 0.0;
  TTest welch;            ///< `one` − `other`; t, p and g are NaN if neither group varies
  double g = 0.0;         ///< Hedges' g
  double adjusted = 1.0;  ///< p adjusted over all comparisons of the question
};

/// Comparisons for all stimuli and scales with at least two participants in each group.
std::vector<GroupComparison> compare_groups(const ParticipantTable& participants,
                                            const AnswerSet& answer_set);

}  // namespace mien::pipeline
