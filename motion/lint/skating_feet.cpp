#include <algorithm>
#include <cmath>

#include "motion/biomechanics/weight_bearing.h"
#include "motion/lint/checks.h"
#include "motion/lint/planted_slip.h"
#include "motion/lint/threshold_findings.h"
#include "motion/skeleton/sole.h"

namespace mien::motion {

namespace {

constexpr double beyond_original_metres = 0.012;
constexpr double in_the_air = 0.1;  // m; a foot that stays higher touches nothing

/// Whether the foot comes near the floor in these frames.
bool is_on_floor(const LintMotion& motion, const FootPlant& plant) {
  for (int t = plant.first; t <= plant.last; ++t) {
    const SolePoints sole = sole_points(motion.clip.body, motion.world[t], plant.left);
    const double lowest = std::min({sole.heel.y(), sole.ball.y(), sole.tip.y()});
    if (lowest < in_the_air * motion.scale) return true;
  }
  return false;
}

/// The stretches in which a foot bears, on the floor.
std::vector<FootPlant> stances(const LintMotion& motion) {
  std::vector<FootPlant> found = weight_bearing_feet(weight_bearing_of(motion), motion.rate());
  std::erase_if(found, [&](const FootPlant& plant) { return !is_on_floor(motion, plant); });
  return found;
}

double largest_slip(const LintMotion& motion) {
  double largest = 0.0;
  for (const FootPlant& plant : stances(motion)) {
    largest = std::max(largest, planted_slip(motion, plant));
  }
  return largest / motion.scale;
}

/// Captures slide by some centimetres themselves; against an original, what it did not do counts
/// sooner.
Levels slip_levels(const LintOptions& options, const LintMotion* original) {
  if (!original) return options.skate_metres;
  const double before = largest_slip(*original);
  const double warning = std::max(options.skate_metres.warning, before + 0.005);
  return {warning, std::max(warning, before + beyond_original_metres)};
}

/// The part of a plant in which the original's same foot stands too, as far as it does: a slower or
/// smaller step makes feet that are still coming down, or leaving already, look planted.
FootPlant as_in_original(FootPlant plant, const LintMotion& motion,
                         const std::vector<FootPlant>& of_original, const LintMotion& original) {
  const double rate = static_cast<double>(motion.frame_count()) / original.frame_count();
  const int cycle = motion.clip.loops ? motion.frame_count() : 0;
  FootPlant best = plant;
  int most = 0;
  for (const FootPlant& other : of_original) {
    if (other.left != plant.left) continue;
    for (const int shift : {-cycle, 0, cycle}) {
      const int first =
          std::max(plant.first, static_cast<int>(std::ceil(other.first * rate)) + shift);
      const int last =
          std::min(plant.last, static_cast<int>(std::floor(other.last * rate)) + shift);
      if (last - first < most) continue;
      most = last - first + 1;
      best = {plant.left, first, last};
    }
  }
  return best;
}

/// The plants whose slip counts.
std::vector<FootPlant> judged_plants(const LintMotion& motion, const LintMotion* original) {
  std::vector<FootPlant> plants = stances(motion);
  if (!original) return plants;
  const std::vector<FootPlant> of_original = stances(*original);
  for (FootPlant& plant : plants) plant = as_in_original(plant, motion, of_original, *original);
  return plants;
}

}  // namespace

Findings find_skating_feet(const LintMotion& motion, const LintOptions& options,
                           const LintMotion* original) {
  Findings findings;
  const Levels levels = slip_levels(options, original);
  for (const FootPlant& plant : judged_plants(motion, original)) {
    const double slip = planted_slip(motion, plant) / motion.scale;
    if (!(slip > levels.warning)) continue;
    Finding finding = graded_finding("foot-skate", slip, "m", levels);
    finding.joint = name_of(plant.left ? LeftAnkle : RightAnkle);
    finding.first = plant.first;
    finding.last = plant.last;
    finding.sentence = std::string("The planted ") + (plant.left ? "left" : "right") +
                       " foot slides by " + rounded(100.0 * slip, 1) + " cm.";
    add_finding(findings, motion, std::move(finding));
  }
  return findings;
}

}  // namespace mien::motion
