#pragma once

#include <string>

#include "pipeline/regression/comparer.h"

namespace mien::pipeline {

/// Whether the comparison would have seen a small defect: one is planted in copies in each run.
struct Gate {
  std::string id;             ///< of the stimulus that was copied; empty: there was none to copy
  std::string motion_defect;  ///< "left forearm turned by 1°"
  bool motion_caught = true;
  std::string picture_defect;  ///< "a block of 8 x 8 pixels lighter by half"
  bool picture_caught = true;

  /// Both were seen.
  bool holds() const { return motion_caught && picture_caught; }
};

/// Turns a joint of an approved motion by 1° on its parent, and lightens a block of an approved
/// picture by half; which ones, the baseline's approvals decide. Throws Error when the baseline is
/// damaged.
Gate plant_defects(const ComparedStudy& study);

}  // namespace mien::pipeline
