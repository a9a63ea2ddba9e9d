#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "motion/gait/foot_lock.h"
#include "motion/lint/lint.h"
#include "motion/math/rotation.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/clip.h"
#include "motion/skeleton/two_bone_ik.h"

namespace mien::test {

using namespace mien::motion;

/// All built-in walks, as loops that travel.
inline std::vector<Clip> builtin_walks() {
  std::vector<Clip> walks;
  for (const char* set : {"walks-10", "walks-27"}) {
    for (const Example& example : builtin_examples(set).examples) {
      walks.push_back(example.clip);
      walks.back().name = example.name;
    }
  }
  return walks;
}

inline Clip three_cycles(const Clip& loop) { return repeated(loop, 3); }

/// Whether a finding of `check` and `joint` (any, when empty; a part of it is enough) touches the
/// frames.
inline const Finding* find(const std::vector<Finding>& findings, const std::string& check,
                           const std::string& joint = "", int first = 0,
                           int last = std::numeric_limits<int>::max()) {
  for (const Finding& finding : findings) {
    const bool overlaps = finding.first <= last && finding.last >= first;
    const bool is_joint = finding.joint.find(joint) != std::string::npos;
    if (finding.check == check && is_joint && overlaps) return &finding;
  }
  return nullptr;
}

/// Like `find`, for errors only.
inline const Finding* find_error(const std::vector<Finding>& findings, const std::string& check,
                                 const std::string& joint = "", int first = 0,
                                 int last = std::numeric_limits<int>::max()) {
  for (const Finding& finding : findings) {
    if (finding.severity != Severity::error) continue;
    if (find({finding}, check, joint, first, last)) return &finding;
  }
  return nullptr;
}

inline std::string all_of(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings) {
    text += finding.check + " " + finding.joint + " " + std::to_string(finding.first) + "-" +
            std::to_string(finding.last) + " " + finding.sentence + "\n";
  }
  return text;
}

/// From 0 to 1 and back over the frames `first` to `last`, smoothly, flat in the middle half.
inline double bump(int frame, int first, int last) {
  if (frame < first || frame > last) return 0.0;
  const double share = static_cast<double>(frame - first) / std::max(last - first, 1);
  const double edge = std::min({1.0, share / 0.25, (1.0 - share) / 0.25});
  return edge * edge * (3.0 - 2.0 * edge);
}

inline int frames_of(const Clip& clip, double seconds) {
  return static_cast<int>(std::lround(seconds * clip.frames_per_second));
}

/// The knee bends by `degrees` the wrong way.
inline void bend_knee_backwards(Clip& clip, bool left, int first, int last, double degrees) {
  const BodyJoint knee = left ? LeftKnee : RightKnee;
  for (int t = first; t <= last; ++t) {
    Quat& rotation = clip.poses[t].rotations[knee];
    const Quat wrong(Eigen::AngleAxisd(-degrees * radians_per_degree, Vec3::UnitX()));
    rotation = slerp(rotation, wrong, bump(t, first, last));
  }
}

/// The whole figure slides by `way` while the foot is planted, and stays there.
inline void slide(Clip& clip, const FootPlant& plant, const Vec3& way) {
  const int ends = frames_of(clip, 0.07);
  const double duration = std::max(plant.last - plant.first - 2 * ends, 1);
  for (int t = 0; t < clip.frame_count(); ++t) {
    const double share = std::clamp((t - plant.first - ends) / duration, 0.0, 1.0);
    clip.poses[t].root_position += share * way;
  }
}

/// The hand goes into the middle of the belly.
inline void put_hand_through_torso(Clip& clip, bool left, int first, int last) {
  const auto on_side = [left](BodyJoint joint) { return left ? joint : mirrored(joint); };
  for (int t = first; t <= last; ++t) {
    Pose& pose = clip.poses[t];
    const JointTransforms world = world_transforms(clip.body, pose);
    const Vec3 belly = 0.5 * (world.positions[Spine] + world.positions[Chest]);
    const Vec3 back = world.rotations[Chest] * -Vec3::UnitZ();
    const TwoBoneLimb limb = {world.positions[on_side(LeftShoulder)],
                              world.positions[on_side(LeftElbow)],
                              world.positions[on_side(LeftWrist)]};
    const TwoBoneSolution solution = solve_two_bone(limb, belly, back);
    const BodyJoint shoulder = on_side(LeftShoulder);
    const BodyJoint elbow = on_side(LeftElbow);
    const Quat above = world.rotations[on_side(LeftClavicle)];
    const Quat upper = solution.upper_turn * world.rotations[shoulder];
    const Quat lower = solution.lower_turn * world.rotations[elbow];
    const double share = bump(t, first, last);
    pose.rotations[shoulder] = slerp(pose.rotations[shoulder], above.conjugate() * upper, share);
    pose.rotations[elbow] = slerp(pose.rotations[elbow], upper.conjugate() * lower, share);
  }
}

/// From `frame` on the joint is turned by `degrees` about `axis`.
inline void leap(Clip& clip, BodyJoint joint, int frame, double degrees, const Vec3& axis) {
  const Quat turn(Eigen::AngleAxisd(degrees * radians_per_degree, axis.normalized()));
  for (int t = frame; t < clip.frame_count(); ++t) {
    Quat& rotation = clip.poses[t].rotations[joint];
    rotation = (rotation * turn).normalized();
  }
}

/// The figure is raised over the frames.
inline void raise(Clip& clip, int first, int last, double metres) {
  for (int t = first; t <= last; ++t) {
    clip.poses[t].root_position.y() += metres * bump(t, first, last);
  }
}

/// A joint turns more and more over a loop, which then does not close.
inline void break_seam(Clip& loop, BodyJoint joint, double degrees) {
  for (int t = 0; t < loop.frame_count(); ++t) {
    const double angle = degrees * radians_per_degree * t / loop.frame_count();
    Quat& rotation = loop.poses[t].rotations[joint];
    rotation = (rotation * Quat(Eigen::AngleAxisd(angle, Vec3::UnitX()))).normalized();
  }
}

/// The joints that carry an arm or a leg.
inline std::vector<BodyJoint> limb(BodyJoint end) {
  switch (end) {
    case LeftWrist:
      return {LeftClavicle, LeftShoulder, LeftElbow, LeftWrist};
    case RightWrist:
      return {RightClavicle, RightShoulder, RightElbow, RightWrist};
    case LeftAnkle:
      return {LeftHip, LeftKnee, LeftAnkle, LeftToe};
    default:
      return {RightHip, RightKnee, RightAnkle, RightToe};
  }
}

/// The limb of a loop moves as at other times of it: `source` gives the time, seconds.
inline void retime(Clip& loop, BodyJoint end, const std::function<double(double)>& source) {
  const Clip before = loop;
  for (int t = 0; t < loop.frame_count(); ++t) {
    const Pose pose = pose_at(before, source(t / loop.frames_per_second));
    for (const BodyJoint joint : limb(end)) loop.poses[t].rotations[joint] = pose.rotations[joint];
  }
}

inline BodyJoint random_of(std::mt19937_64& random, const std::vector<BodyJoint>& joints) {
  return joints[std::uniform_int_distribution<size_t>(0, joints.size() - 1)(random)];
}

/// First frame of a stretch of `length` frames somewhere within the clip, not at its very ends.
inline int random_start(std::mt19937_64& random, const Clip& clip, int length) {
  return std::uniform_int_distribution<int>(3, clip.frame_count() - length - 4)(random);
}

}  // namespace mien::test
