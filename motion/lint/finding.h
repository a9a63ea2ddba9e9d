#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mien::motion {

/// Severity of a finding.
enum class Severity {
  warning,  ///< suspicious; also occurs in motion capture
  error,    ///< a fault: impossible for a human body, or invalid data
};

/// "warning", "error".
std::string_view name_of(Severity severity);

/// What a check found in a motion, and where.
struct Finding {
  std::string check;  ///< identifier of the check: one of `lint_checks()` (lint.h)
  /// "LeftKnee"; two parts: "LeftWrist/Chest"; a recorded point: "LASI"; empty: the whole body.
  std::string joint;
  int first = 0;  ///< first frame of the finding, an index into the clip
  int last = 0;   ///< its last frame, inclusive; in a loop of n frames it may be n or more: frame n
                  ///< is frame 0 again
  double measured = 0.0;   ///< the worst value in these frames, in `unit`
  double threshold = 0.0;  ///< the exceeded threshold of this severity, in `unit`
  std::string unit;        ///< "m", "m/s", "°", "rad/s", "N·m", "s", …; empty: no unit
  Severity severity = Severity::warning;
  std::string sentence;  ///< description for readers who do not know the thresholds
};

/// Whether one of the findings is an error.
bool has_errors(const std::vector<Finding>& findings);

}  // namespace mien::motion
