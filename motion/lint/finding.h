#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mien::motion {

/// How bad a finding is.
enum class Severity {
  warning,  ///< worth a look; captures show it too
  error,    ///< broken: no body moves so, or the clip is not what it claims to be
};

/// "warning", "error".
std::string_view name_of(Severity severity);

/// A fault of a motion and its position.
struct Finding {
  std::string check;  ///< which rule: one of `lint_checks()` (lint.h)
  std::string
      joint;      ///< "LeftKnee"; parts of two joints as "LeftWrist/Chest"; empty: the whole body
  int first = 0;  ///< frames of the clip
  int last = 0;   ///< included; of a loop it may lie beyond the end, where frame n is frame 0
  double measured = 0.0;   ///< the worst value in these frames, in `unit`
  double threshold = 0.0;  ///< the threshold of this severity that it exceeds, in `unit`
  std::string unit;        ///< "m", "m/s", "°", "rad/s", "N·m", "s", …; empty: a ratio
  Severity severity = Severity::warning;
  std::string sentence;  ///< description for readers who do not know the thresholds
};

/// Whether one of the findings is an error.
bool has_errors(const std::vector<Finding>& findings);

}  // namespace mien::motion
