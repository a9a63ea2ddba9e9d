#include <fmt/format.h>

#include "motion/measures/differences/motion_tolerance.h"
#include "motion/measures/distance/body_part.h"
#include "pipeline/manifest/own_seed.h"
#include "pipeline/regression/approved_frames.h"
#include "pipeline/regression/regression.h"

namespace mien::pipeline {

namespace {

constexpr double planted_turn_degrees = 1.0;
constexpr float planted_factor = 1.5f;
constexpr float planted_light = 0.01f;  // where it is black

/// A number below `count` that the baseline's last decision chooses.
std::size_t chosen(const Baseline& baseline, const std::string& what, std::size_t count) {
  const std::string decision = baseline.approvals.empty() ? "" : baseline.approvals.back().when;
  return own_seed(baseline.approvals.size(), what + decision) % count;
}

void plant_in_motion(const ComparedStudy& study, Gate& gate) {
  const motion::Clip& clip = study.now.clip_of(gate.id);
  const std::size_t joint =
      1 + chosen(study.baseline, "joint", clip.body.joints.size() - 1);  // not the root
  motion::Clip planted = clip;
  const double turn = planted_turn_degrees * motion::radians_per_degree;
  for (motion::Pose& pose : planted.poses)
    pose.rotations[joint] =
        pose.rotations[joint] * motion::Quat(Eigen::AngleAxisd(turn, motion::Vec3::UnitX()));
  gate.motion_defect =
      fmt::format("{} turned by {:g}°", motion::part_name(static_cast<motion::BodyJoint>(joint)),
                  planted_turn_degrees);
  const motion::MotionDifference difference = motion::motion_difference(clip, planted);
  const std::vector<int> causes = motion::causes(difference);
  gate.motion_caught = causes.size() == 1 && causes.front() == static_cast<int>(joint) &&
                       !motion::excesses(difference, {}).empty();
}

void plant_in_picture(const ComparedStudy& study, int frame, Gate& gate) {
  const BlockStatistics approved = approved_blocks(study.baseline, gate.id, frame);
  BlockStatistics planted = approved;
  const std::size_t block = chosen(study.baseline, "block", approved.count() / 3);
  for (std::size_t c = 0; c < 3; ++c) {
    float& light = planted.mean[3 * block + c];
    light = planted_factor * light + planted_light;
  }
  gate.picture_defect = fmt::format("a block of {0} x {0} pixels 50 % brighter", block_pixels);
  gate.picture_caught = noise_test(approved, planted, 1).is_bias;
}

}  // namespace

Gate plant_defects(const ComparedStudy& study) {
  Gate gate;
  std::vector<const StimulusFacts*> shared;
  for (const StimulusFacts& facts : study.baseline.stimuli)
    if (find_stimulus(study.now.manifest(), facts.id) != nullptr) shared.push_back(&facts);
  if (shared.empty()) return gate;
  const StimulusFacts& facts = *shared[chosen(study.baseline, "stimulus", shared.size())];
  gate.id = facts.id;
  plant_in_motion(study, gate);
  if (!facts.key_frames.empty()) plant_in_picture(study, facts.key_frames.front().frame, gate);
  return gate;
}

}  // namespace mien::pipeline
