#pragma once

#include <string>
#include <vector>

#include "pipeline/study/matching/experiment/matching_study.h"

namespace mien::pipeline {

/// How far a participant who moves nothing is from a target.
struct StartingDistance {
  std::string target;
  std::string interface;
  double metres = 0.0;  ///< D
};

/// Of every target that is matched, practice aside, with every interface, sliders standing where
/// the page lets them begin: the examples' average, or shares of none.
std::vector<StartingDistance> starting_distances(const Manifest& manifest,
                                                 const MatchingStudy& study);

/// A threshold by which something has to be done, metres: the paper's 0.06, or half of the median
/// starting distance, to the millimetre below, where that is less.
double fitting_threshold(const std::vector<StartingDistance>& distances);

/// What to tell of trials that are matched before anything is moved; empty where there are none.
std::string matched_at_start(const Manifest& manifest, const MatchingStudy& study);

}  // namespace mien::pipeline
