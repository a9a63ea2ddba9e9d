#pragma once

#include <string>
#include <utility>
#include <vector>

namespace mien::pipeline {

/// One line for each thing that is said of stimuli, with the names of those that it is said of:
/// "sad-walk, happy-walk and 41 more: the left foot slides". `said` has names and what is said of
/// them; lines stand in the order in which things are said first.
std::vector<std::string> told_warnings(
    const std::vector<std::pair<std::string, std::string>>& said);

}  // namespace mien::pipeline
