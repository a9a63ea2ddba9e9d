#pragma once

#include <string>
#include <vector>

#include "motion/skeleton/clip.h"
#include "pipeline/manifest/stimulus.h"

namespace mien::pipeline {

/// Returns a sentence for each time at which two of a stimulus's people are more than 3 cm deep in
/// each other, hands and forearms aside: "\"a\" and \"b\" are up to 12 cm deep in each other from
/// 1.20 to 1.80 s (left thigh, pelvis)". `clips` are those of the people where the film shows them.
std::vector<std::string> people_warnings(const Stimulus& stimulus,
                                         const std::vector<motion::Clip>& clips);

}  // namespace mien::pipeline
