#pragma once

#include <string_view>
#include <vector>

#include "motion/lint/finding.h"

namespace mien::motion {

/// Change of a fault between two motions.
struct LintChange {
  enum class Kind { gone, appeared, worse, better };
  Kind kind = Kind::appeared;
  Finding finding;  ///< of the second motion; one that is gone, of the first
};

/// "gone", "new", "worse", "better".
std::string_view name_of(LintChange::Kind kind);

/// The findings in which two motions differ. Two are one fault when check and
/// joint are the same and their frames touch by time; it is worse or better when its severity
/// changed. Findings of the second come first, in their order, then those that are gone.
std::vector<LintChange> lint_changes(const std::vector<Finding>& before, double rate_before,
                                     const std::vector<Finding>& now, double rate_now);

}  // namespace mien::motion
