#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/design/design_warning.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// Two levels of a factor whose motions are alike.
struct CloseLevels {
  std::string first;
  std::string second;
  int pairs = 0;            ///< compared pairs of stimuli
  double greatest_m = 0.0;  ///< largest distance D of a pair, metres
};

/// The pairs of levels of a factor that are alike.
struct FactorLevels {
  std::string factor;
  int compared = 0;                ///< compared pairs of levels
  std::vector<CloseLevels> close;  ///< the closest first
};

/// Finds pairs of levels between which no two motions differ by a distance D
/// (motion/measures/distance/distance.h) of `manifest.design.threshold_m` or more. Compared are
/// stimuli that have the same levels of all other factors, at most 200 pairs of each two levels and
/// about 5000 pairs for a factor; factors with more than 100 levels are not compared. Returns the
/// factors that have such levels, except those that leave the motion as it is, such as the kind of
/// figure, and those of `design.alike`. Motions that cannot be compared are left out. Makes the
/// motions. Throws Error.
std::vector<FactorLevels> close_levels(const Manifest& manifest, Motions& motions);

/// A warning for each factor, with its three closest pairs.
std::vector<DesignWarning> close_level_warnings(const Manifest& manifest,
                                                const std::vector<FactorLevels>& factors);

extern const TableForm close_levels_form;
std::string close_levels_csv(const std::vector<FactorLevels>& factors);

}  // namespace mien::pipeline
