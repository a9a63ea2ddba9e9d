#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/production/synthesis/repertoire.h"
#include "pipeline/production/synthesis/slider_interface.h"

namespace mien::pipeline {

struct MethodTrialOptions {
  int settings = 50;  ///< of the sliders: how many are tried
  int steps = 100;    ///< of the way from each setting to the next
  std::uint64_t seed = 0;
};

/// What a method of interpolation does with settings that the examples allow: the measures of Feng,
/// Huang, Kallmann and Shapiro (2012), and D.
struct MethodTrial {
  motion::InterpolationMethod method = motion::InterpolationMethod::reach;
  int settings = 0;
  double mean_error = 0.0;   ///< |reached − requested|, of the parameter that is missed most
  double worst_error = 0.0;  ///< likewise, the largest over all settings
  double jump = 0.0;  ///< largest change of one weight in one step of the ways between settings
  double mean_examples = 0.0;  ///< effective number of examples mixed, 1 / Σ w²
  double mean_distance = 0.0;  ///< D to the motion that has what is asked for, metres
  double seconds = 0.0;        ///< to find the weights of one setting; of this machine
};

/// Tries every method with sliders for `parameters` (rows of the ratings). Settings are what
/// random blends of three examples have, so that each can be met; D is measured to that blend.
/// Throws Error when a method cannot take so many parameters.
std::vector<MethodTrial> compare_methods(const Repertoire& repertoire,
                                         const std::vector<std::string>& parameters,
                                         const std::vector<motion::InterpolationMethod>& methods,
                                         const Interpolation& interpolation,
                                         const MethodTrialOptions& options);

/// A row a method, without the seconds, which no other run would repeat.
WrittenTable method_trials_table(const std::vector<MethodTrial>& trials, bool simulated_ratings);

}  // namespace mien::pipeline
