#include "motion/modify/posture.h"

#include <algorithm>
#include <cmath>

#include "motion/math/filter.h"
#include "motion/math/rotation.h"
#include "motion/modify/posture_units.h"
#include "motion/skeleton/sole.h"

namespace mien::motion {

namespace {

constexpr double full_until = 0.35;   // of the limb's length, away from where it hangs
constexpr double gone_from = 0.8;     // likewise
constexpr double fade_cutoff_hz = 4;  // of the strength over time

/// A limb whose posture fades as its end goes away from the body.
struct FadingLimb {
  std::array<BodyJoint, 4> joints;  ///< its end at `end`
  BodyJoint end;
};

constexpr std::array<FadingLimb, 4> fading_limbs = {
    {{{LeftClavicle, LeftShoulder, LeftElbow, LeftWrist}, LeftWrist},
     {{RightClavicle, RightShoulder, RightElbow, RightWrist}, RightWrist},
     {{LeftHip, LeftKnee, LeftAnkle, LeftToe}, LeftAnkle},
     {{RightHip, RightKnee, RightAnkle, RightToe}, RightAnkle}}};

double fade(double share) {
  const double x = std::clamp((share - full_until) / (gone_from - full_until), 0.0, 1.0);
  return 1.0 - x * x * (3.0 - 2.0 * x);
}

/// From the joint that swings the limb to its end, metres.
double limb_length(const Skeleton& body, const FadingLimb& limb) {
  const auto bone = [&](int joint) {
    return body.joints[static_cast<size_t>(joint)].offset.norm();
  };
  return bone(limb.end) + bone(body_parents[static_cast<size_t>(limb.end)]);
}

Vec3 seen_from_pelvis(const Pose& pose, const JointTransforms& world, BodyJoint joint) {
  return pose.rotations[Pelvis].conjugate() *
         (world.positions[static_cast<size_t>(joint)] - pose.root_position);
}

using Strengths = std::array<std::vector<double>, fading_limbs.size()>;

/// How much of its posture each limb takes, frame by frame.
Strengths limb_strengths(const Clip& clip) {
  const Pose standing = standing_pose(clip.body);
  const JointTransforms neutral = world_transforms(clip.body, standing);
  Strengths strengths;
  for (const Pose& pose : clip.poses) {
    const JointTransforms world = world_transforms(clip.body, pose);
    for (size_t l = 0; l < fading_limbs.size(); ++l) {
      const FadingLimb& limb = fading_limbs[l];
      const Vec3 away =
          seen_from_pelvis(pose, world, limb.end) - seen_from_pelvis(standing, neutral, limb.end);
      strengths[l].push_back(fade(away.norm() / limb_length(clip.body, limb)));
    }
  }
  const SignalEnds ends = clip.loops ? SignalEnds::periodic : SignalEnds::open;
  for (std::vector<double>& strength : strengths) {
    strength = low_pass(strength, fade_cutoff_hz, clip.frames_per_second, ends);
    for (double& s : strength) s = std::clamp(s, 0.0, 1.0);
  }
  return strengths;
}

/// The limb that a joint belongs to; the number of limbs for trunk and head.
size_t limb_of(BodyJoint joint) {
  for (size_t l = 0; l < fading_limbs.size(); ++l) {
    const auto& joints = fading_limbs[l].joints;
    if (std::find(joints.begin(), joints.end(), joint) != joints.end()) return l;
  }
  return fading_limbs.size();
}

void turn(Quat& rotation, const Vec3& by, TurnFrame frame) {
  rotation = (frame == TurnFrame::own ? rotation * exp(by) : exp(by) * rotation).normalized();
}

Quat without_heading(const Quat& rotation) {
  return heading(rotation * Vec3::UnitZ()).conjugate() * rotation;
}

}  // namespace

Pose standing_pose(const Skeleton& body) {
  constexpr double hanging = 82.0 * radians_per_degree;  // below the horizontal
  constexpr double bent = 12.0 * radians_per_degree;     // of the elbows
  Pose pose;
  pose.rotations.assign(body_joint_count, Quat::Identity());
  pose.rotations[LeftShoulder] = exp(Vec3(0, 0, -hanging));
  pose.rotations[RightShoulder] = exp(Vec3(0, 0, hanging));
  pose.rotations[LeftElbow] = exp(Vec3(0, -bent, 0));
  pose.rotations[RightElbow] = exp(Vec3(0, bent, 0));
  const std::vector<Vec3> places = world_positions(body, pose);
  pose.root_position.y() = sole_depth(body) - std::min(places[LeftToe].y(), places[RightToe].y());
  return pose;
}

PoseDifference pose_difference(const Pose& neutral, const Pose& posed) {
  PoseDifference difference;
  for (size_t j = 0; j < difference.turns.size(); ++j) {
    const bool root = j == Pelvis;
    const Quat from = root ? without_heading(neutral.rotations[j]) : neutral.rotations[j];
    const Quat to = root ? without_heading(posed.rotations[j]) : posed.rotations[j];
    difference.turns[j] = in_hemisphere_of(Quat::Identity(), (from.conjugate() * to).normalized());
  }
  return difference;
}

Clip with_posture(const Clip& clip, const std::vector<PostureChange>& changes,
                  const std::optional<PoseDifference>& difference) {
  Clip result = clip;
  Strengths strengths = limb_strengths(clip);
  const auto strength = [&](BodyJoint joint, size_t frame) {
    const size_t limb = limb_of(joint);
    return limb < strengths.size() ? strengths[limb][frame] : 1.0;
  };
  for (const PostureChange& change : changes) {
    const double angle = change.degrees * radians_per_degree;
    for (const UnitTurn& part : turns_of(change.unit)) {
      for (size_t f = 0; f < result.poses.size(); ++f) {
        // Legs that only stay where they are while the pelvis tilts do not fade.
        const double share =
            change.unit == PostureUnit::pelvis_tilt ? 1.0 : strength(part.joint, f);
        turn(result.poses[f].rotations[part.joint], share * angle * part.turn, part.frame);
      }
    }
  }
  if (!difference) return result;
  for (int j = 0; j < body_joint_count; ++j) {
    const Vec3 by = log(difference->turns[static_cast<size_t>(j)]);
    if (by.isZero(0.0)) continue;
    for (size_t f = 0; f < result.poses.size(); ++f) {
      turn(result.poses[f].rotations[static_cast<size_t>(j)], strength(BodyJoint(j), f) * by,
           TurnFrame::own);
    }
  }
  return result;
}

}  // namespace mien::motion
