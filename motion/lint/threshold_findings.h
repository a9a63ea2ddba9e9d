#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/biomechanics/subject.h"
#include "motion/lint/finding.h"
#include "motion/lint/lint_options.h"

namespace mien::motion {

/// Value of a frame without a measurement.
inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// A quantity that is measured in every frame, with its thresholds.
struct MeasuredFault {
  std::string_view check;
  std::string joint;
  std::string unit;
  Levels levels;
  double shortest_seconds = 0.0;  ///< shorter intervals are ignored; a frame is enough…
  int shortest_frames = 1;        ///< …but for this
  std::function<std::string(double worst)> sentence;
};

/// Adds a finding for every interval in which `values` (one for each frame of the subject's clip,
/// in the fault's unit; `no_value` if not measured) are above the warning level; gaps of up to 0.1
/// s are bridged. It is an error if the values exceed the error level for the shortest duration.
void add_threshold_findings(std::vector<Finding>& findings, const LintSubject& subject,
                            const MeasuredFault& fault, std::span<const double> values);

/// A finding with a measured value, without frames and sentence: an error above the error level,
/// else a warning.
Finding graded_finding(std::string_view check, double measured, const std::string& unit,
                       const Levels& levels);

/// Adds a finding whose frames are those of the subject's clip, unless it lies in another lap of a
/// loop than the middle one.
void add_finding(std::vector<Finding>& findings, const LintSubject& subject, Finding finding);

/// The levels, raised to the largest value of the original (one for each frame, NaN if not
/// measured), with the same distance between them.
Levels raised_levels(const Levels& levels, std::span<const double> of_original);

/// A number with that many decimals: "12.3".
std::string rounded(double value, int decimals);

/// A joint's name for sentences: of the canonical body in words, "left knee"; any other as in the
/// file, "DEF_BN_Leg_L_02".
std::string display_name(std::string_view joint_name);

}  // namespace mien::motion
