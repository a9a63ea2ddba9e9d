
#include "motion/lint/checks.h"
#include "motion/lint/stretches.h"
#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

constexpr double least_excess_seconds = 0.05;

bool is_leg(int joint) { return joint >= LeftHip; }

/// Toes flick at toe off, wrists and toes have little to move.
bool is_end(int joint) {
  return joint == LeftToe || joint == RightToe || joint == LeftWrist || joint == RightWrist;
}

/// rad/s in every frame: of the step that leads there.
std::vector<double> speeds(const LintSubject& subject, int joint) {
  std::vector<double> values(subject.world.size(), 0.0);
  for (int t = 1; t < subject.frame_count(); ++t) {
    const Quat& before = subject.clip.poses[t - 1].rotations[joint];
    values[t] = angle_between(before, subject.clip.poses[t].rotations[joint]) * subject.rate();
  }
  return values;
}

}  // namespace

Findings find_fast_joints(const LintSubject& subject, const LintOptions& options,
                          const LintSubject* original) {
  Findings findings;
  for (int j = 0; j < body_joint_count; ++j) {
    if (is_end(j)) continue;
    const std::string name(name_of(BodyJoint(j)));
    const auto sentence = [&](double worst) {
      return "The " + spoken(name) + " turns at " + rounded(worst, 0) +
             " rad/s, faster than people can.";
    };
    const Levels levels = raised(is_leg(j) ? options.leg_speed : options.arm_speed,
                                 original ? speeds(*original, j) : std::vector<double>());
    add_stretches(findings, subject,
                  {"joint-speed", name, "rad/s", levels, least_excess_seconds, 2, sentence},
                  speeds(subject, j));
  }
  return findings;
}

}  // namespace mien::motion
