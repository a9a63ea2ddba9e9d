#include <algorithm>

#include "motion/biomechanics/collision_shapes.h"
#include "motion/lint/checks.h"
#include "motion/lint/threshold_findings.h"

namespace mien::motion {

namespace {

std::vector<std::vector<RoundCone>> shapes_of(const LintMotion& motion) {
  std::vector<std::vector<RoundCone>> frames;
  frames.reserve(motion.world.size());
  for (const JointTransforms& world : motion.world) {
    frames.push_back(collision_shapes(motion.clip.body, world));
  }
  return frames;
}

double deepest(const std::vector<std::vector<RoundCone>>& frames, const CollisionPair& pair) {
  double most = 0.0;
  for (const auto& parts : frames)
    most = std::max(most, penetration_depth(parts[pair.a], parts[pair.b]));
  return most;
}

}  // namespace

Findings find_self_intersections(const LintMotion& motion, const LintOptions& options,
                                 const LintMotion* original) {
  Findings findings;
  const auto frames = shapes_of(motion);
  const auto before = original ? shapes_of(*original) : std::vector<std::vector<RoundCone>>();
  for (const CollisionPair& pair : collision_pairs(motion.clip.body)) {
    const double allowed = std::max(pair.allowed, deepest(before, pair));
    std::vector<double> values;
    for (const auto& parts : frames) {
      values.push_back((penetration_depth(parts[pair.a], parts[pair.b]) - allowed) / motion.scale);
    }
    const CollisionPart& a = collision_parts()[pair.a];
    const CollisionPart& b = collision_parts()[pair.b];
    const auto sentence = [&](double worst) {
      return "The " + std::string(b.name) + " is " + rounded(100.0 * worst, 1) +
             " cm deep in the " + std::string(a.name) + ".";
    };
    const std::string joints = std::string(name_of(b.joint)) + "/" + std::string(name_of(a.joint));
    add_threshold_findings(findings, motion,
                           {"self-intersection", joints, "m", options.intersection_metres,
                            options.intersection_seconds, 2, sentence},
                           values);
  }
  return findings;
}

}  // namespace mien::motion
