#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/manifest/ratings/answers/answers.h"

namespace mien::pipeline {

/// The number in the name of a film that was chosen for a round: 2 of "round2-01".
std::optional<int> round_in_name(const std::string& stimulus);

/// The round of each stimulus with answers. If any has a number in its name, it is that number, or
/// 1 for those without. Otherwise it follows from the files: those that share stimuli, directly or
/// through others, are of one round, and rounds are numbered from 1 in the order of their first
/// files.
std::map<std::string, int> round_numbers(const std::vector<Answers>& files);

}  // namespace mien::pipeline
