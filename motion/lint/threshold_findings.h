#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/biomechanics/lint_motion.h"
#include "motion/lint/finding.h"
#include "motion/lint/lint_options.h"

namespace mien::motion {

/// Value of a frame without a measurement.
inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// A quantity measured in every frame, with its thresholds.
struct MeasuredFault {
  std::string_view check;
  std::string joint;
  std::string unit;
  Levels levels;
  double shortest_seconds = 0.0;  ///< minimum duration of an exceedance, seconds
  int shortest_frames = 1;        ///< minimum duration of an exceedance, frames
  /// Returns the description of a finding from its largest value.
  std::function<std::string(double worst)> sentence;
};

/// Adds a finding for every interval in which `values` exceed the warning level; gaps of up to 0.1
/// s are bridged. `values` has one entry per frame of the motion's clip, in the unit of the fault,
/// `no_value` where not measured. An interval counts if the values exceed the warning level for the
/// minimum duration without a gap; it is an error if they exceed the error level for the minimum
/// duration.
void add_threshold_findings(std::vector<Finding>& findings, const LintMotion& motion,
                            const MeasuredFault& fault, std::span<const double> values);

/// A finding with a measured value but without frames and sentence: an error if the value is above
/// the error level, otherwise a warning.
Finding graded_finding(std::string_view check, double measured, const std::string& unit,
                       const Levels& levels);

/// Adds a finding whose frames are those of the motion's clip, converting them to frames of the
/// motion as given. For loops, findings are discarded that neither begin in the middle lap nor
/// cover all of it.
void add_finding(std::vector<Finding>& findings, const LintMotion& motion, Finding finding);

/// The levels raised so that the warning level is not below the largest value of the original,
/// keeping the difference between the two levels. `of_original` has one value per frame, NaN where
/// not measured.
Levels raised_levels(const Levels& levels, std::span<const double> of_original);

/// A number with the given number of decimals: "12.3".
std::string rounded(double value, int decimals);

/// A joint name for use in sentences: "left knee" for a joint of the canonical body; any other name
/// unchanged, "DEF_BN_Leg_L_02".
std::string display_name(std::string_view joint_name);

}  // namespace mien::motion
