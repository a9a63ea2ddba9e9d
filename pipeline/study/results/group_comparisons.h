#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/base/statistics/t_test.h"
#include "pipeline/study/results/participants.h"

namespace mien::pipeline {

/// Two groups of participants by their answers to a demographic question (gender); members are
/// indices of AnswerSet::people.
struct ParticipantGroups {
  std::string question;
  std::string one;    ///< the most frequent answer; ties alphabetically
  std::string other;  ///< the second most frequent
  std::vector<std::size_t> people_one, people_other;
};

/// The two most frequent answers to each demographic question with answers in words, where at least
/// two participants gave each.
std::vector<ParticipantGroups> participant_groups(const ParticipantTable& participants,
                                                  const AnswerSet& answer_set);

/// The difference between two groups on a stimulus and scale: Welch's test of participants' means.
struct GroupComparison {
  std::string question, one, other;
  std::size_t stimulus = 0;
  std::size_t scale = 0;
  int people_one = 0;
  double mean_one = 0.0;
  int people_other = 0;
  double mean_other = 0.0;
  TTest welch;            ///< first less other; t and p are NaN where neither varies
  double g = 0.0;         ///< Hedges'
  double adjusted = 1.0;  ///< p corrected over all of the question
};

/// Comparisons on all stimuli and scales with at least two participants of each group.
std::vector<GroupComparison> compare_groups(const ParticipantTable& participants,
                                            const AnswerSet& answer_set);

}  // namespace mien::pipeline
