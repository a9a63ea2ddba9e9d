#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/base/statistics/t_test.h"
#include "pipeline/study/results/participants.h"

namespace mien::pipeline {

/// Two groups of participants, told apart by what they answered to a question about themselves
/// (gender), and who is in either: indices of Gathered::people.
struct ParticipantGroups {
  std::string question;
  std::string one;    ///< the answer that most gave; of equally many, the first by the alphabet
  std::string other;  ///< the second
  std::vector<std::size_t> people_one, people_other;
};

/// Of every question that is answered in words, where at least two people each gave two answers or
/// more; the two that most gave.
std::vector<ParticipantGroups> participant_groups(const ParticipantTable& participants,
                                                  const Gathered& gathered);

/// How differently two groups see a stimulus on a scale: Welch's test of the people's own means.
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

/// All that two people or more of either group judged.
std::vector<GroupComparison> compare_groups(const ParticipantTable& participants,
                                            const Gathered& gathered);

}  // namespace mien::pipeline
