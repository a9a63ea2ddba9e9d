#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/regression/approved_study.h"

namespace mien::test {

/// A change of a study and the expected report.
struct Mutation {
  std::string name;
  std::string stimulus;  ///< that is looked at
  pipeline::Cause cause = pipeline::Cause::unknown;
  std::string root;  ///< that the cause's root names
  std::function<void(ChangedStudy&)> change;
  std::optional<pipeline::Verdict> verdict;  ///< where it matters which
};

/// Changes of one thing each.
std::vector<Mutation> motion_mutations();
std::vector<Mutation> scene_mutations();
std::vector<Mutation> drawing_mutations();

/// Changes of the program, simulated by changing the baseline instead.
std::vector<Mutation> program_mutations();
std::vector<Mutation> video_mutations();

std::vector<Mutation> all_mutations();

}  // namespace mien::test
