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

/// The value of a frame of which nothing can be said.
inline constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// A value that is measured in every frame, and when it is a fault.
struct MeasuredFault {
  std::string_view check;
  std::string joint;
  std::string unit;
  Levels levels;
  double shortest_seconds = 0.0;  ///< shorter stretches are let pass; one frame is always enough…
  int shortest_frames = 1;        ///< …but for this
  std::function<std::string(double worst)> sentence;
};

/// One finding for every stretch of frames in which `values` (one for each frame of the subject's
/// clip, in the fault's unit; `nothing` where it cannot be said) lie above the warning level; gaps
/// of up to 0.1 s are bridged. A stretch is an error when its values pass the error level for as
/// long as a stretch must last.
void add_stretches(std::vector<Finding>& findings, const LintSubject& subject,
                   const MeasuredFault& fault, std::span<const double> values);

/// A finding of what was measured, without frames and words: an error beyond the error level, else
/// a warning.
Finding graded(std::string_view check, double measured, const std::string& unit,
               const Levels& levels);

/// Adds a finding whose frames are those of the subject's clip, unless it lies in another lap of a
/// loop than the middle one.
void add_finding(std::vector<Finding>& findings, const LintSubject& subject, Finding finding);

/// The levels, raised to what the original (a value a frame, NaN for nothing) did already, and no
/// less room between them.
Levels raised(const Levels& levels, std::span<const double> of_original);

/// "12.3", with so many decimals.
std::string rounded(double value, int decimals);

/// A joint's name in a sentence: that of the canonical body in words, "left knee"; any other as the
/// file has it, "DEF_BN_Leg_L_02".
std::string spoken(std::string_view joint_name);

}  // namespace mien::motion
