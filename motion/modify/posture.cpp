#include "motion/modify/posture.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "motion/math/rotation.h"
#include "motion/skeleton/sole.h"

namespace mien::motion {

namespace {

/// In which frame a joint is turned.
enum class TurnFrame {
  own,     ///< q' = q · turn
  parent,  ///< q' = turn · q
};

/// What a unit difference of posture does to one joint: so many radians about each axis for a
/// radian of the unit.
struct UnitTurn {
  BodyJoint joint;
  Vec3 turn;
  TurnFrame frame;
};

const std::vector<UnitTurn>& turns_of(PostureUnit unit) {
  using enum PostureUnit;
  constexpr auto own = TurnFrame::own;
  constexpr auto parent = TurnFrame::parent;
  const Vec3 x = Vec3::UnitX();
  const Vec3 y = Vec3::UnitY();
  const Vec3 z = Vec3::UnitZ();
  // A turn of the upper joint in its own frame and of the lower in its parent's is one turn between
  // the two, shared out.
  const auto shared = [](BodyJoint upper, BodyJoint lower, const Vec3& axis) {
    return std::vector<UnitTurn>{{upper, 0.5 * axis, own}, {lower, 0.5 * axis, parent}};
  };
  const auto both_sides = [](BodyJoint left, const Vec3& axis, TurnFrame frame) {
    return std::vector<UnitTurn>{{left, axis, frame},
                                 {mirrored(left), Vec3(axis.x(), -axis.y(), -axis.z()), frame}};
  };
  static const std::map<PostureUnit, std::vector<UnitTurn>> turns = {
      {head_flexion, shared(Neck, Head, x)},
      {head_lateral, shared(Neck, Head, -z)},
      {head_turn, shared(Neck, Head, y)},
      {chest_flexion, std::vector<UnitTurn>{{Chest, x, own}}},
      {spine_flexion, shared(Spine, Chest, x)},
      {spine_lateral, shared(Spine, Chest, -z)},
      {spine_turn, shared(Spine, Chest, y)},
      {pelvis_tilt,
       std::vector<UnitTurn>{{Pelvis, x, own}, {LeftHip, -x, parent}, {RightHip, -x, parent}}},
      {shoulder_elevation, both_sides(LeftClavicle, z, parent)},
      {shoulder_protraction, both_sides(LeftClavicle, -y, parent)},
      {shoulder_abduction, both_sides(LeftShoulder, z, parent)},
      {shoulder_flexion, both_sides(LeftShoulder, -x, parent)},
      {shoulder_internal_rotation, both_sides(LeftShoulder, x, own)},
      {elbow_flexion, both_sides(LeftElbow, -y, own)},
      {wrist_flexion, both_sides(LeftWrist, -z, own)},
      {hip_abduction, both_sides(LeftHip, z, parent)},
      {hip_flexion, both_sides(LeftHip, -x, parent)},
      {hip_internal_rotation, both_sides(LeftHip, -y, own)},
      {knee_flexion, both_sides(LeftKnee, x, own)},
      {ankle_dorsiflexion, both_sides(LeftAnkle, -x, own)},
  };
  return turns.at(unit);
}

constexpr double full_until = 0.35;   // of the limb's length, away from where it hangs
constexpr double gone_from = 0.8;     // likewise
constexpr double fade_cutoff_hz = 4;  // of the strength over time

/// A limb whose posture fades as its end goes away from the body.
struct FadingLimb {
  std::array<BodyJoint, 4> joints;  ///< its end at `end`
  BodyJoint end;
};

constexpr std::array<FadingLimb, fading_limb_count> fading_limbs = {
    {{{LeftClavicle, LeftShoulder, LeftElbow, LeftWrist}, LeftWrist},
     {{RightClavicle, RightShoulder, RightElbow, RightWrist}, RightWrist},
     {{LeftHip, LeftKnee, LeftAnkle, LeftToe}, LeftAnkle},
     {{RightHip, RightKnee, RightAnkle, RightToe}, RightAnkle}}};

double faded_in(double share) {
  return 1.0 - smooth_step((share - full_until) / (gone_from - full_until));
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

/// How much of its posture each limb takes, frame by frame.
std::vector<LimbStrengths> smooth_strengths(const Clip& clip) {
  const LimbFade fade(clip.body);
  std::vector<LimbStrengths> strengths;
  for (const Pose& pose : clip.poses) strengths.push_back(fade(pose));
  return smooth_strengths(strengths, clip.frames_per_second,
                          clip.loops ? SignalEnds::periodic : SignalEnds::open);
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

const std::vector<PostureUnitName>& posture_units() {
  using enum PostureUnit;
  static const std::vector<PostureUnitName> units = {
      {head_flexion, "head-flexion", "lowers the head, chin to the chest"},
      {head_lateral, "head-lateral", "tilts the head to the left shoulder"},
      {head_turn, "head-turn", "turns the face to the left"},
      {chest_flexion, "chest-flexion", "bends the chest forward"},
      {spine_flexion, "spine-flexion", "bends the whole back forward"},
      {spine_lateral, "spine-lateral", "bends the back to the left"},
      {spine_turn, "spine-turn", "turns the shoulders to the left"},
      {pelvis_tilt, "pelvis-tilt", "leans the pelvis and all above it forward"},
      {shoulder_elevation, "shoulder-elevation", "draws both shoulders up"},
      {shoulder_protraction, "shoulder-protraction", "draws both shoulders forward"},
      {shoulder_abduction, "shoulder-abduction", "spreads both upper arms from the body"},
      {shoulder_flexion, "shoulder-flexion", "lifts both upper arms forward"},
      {shoulder_internal_rotation, "shoulder-internal-rotation",
       "rotates both upper arms inwards about their axes"},
      {elbow_flexion, "elbow-flexion", "bends both elbows"},
      {wrist_flexion, "wrist-flexion", "bends both palms towards the forearms"},
      {hip_abduction, "hip-abduction", "spreads both thighs"},
      {hip_flexion, "hip-flexion", "lifts both thighs forward"},
      {hip_internal_rotation, "hip-internal-rotation", "turns both legs inwards, toes together"},
      {knee_flexion, "knee-flexion", "bends both knees"},
      {ankle_dorsiflexion, "ankle-dorsiflexion", "lifts the toes of both feet"},
  };
  return units;
}

std::string_view name_of(PostureUnit unit) {
  return posture_units()[static_cast<size_t>(unit)].name;
}

std::optional<PostureUnit> posture_unit(std::string_view name) {
  for (const PostureUnitName& unit : posture_units()) {
    if (unit.name == name) return unit.unit;
  }
  return std::nullopt;
}

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

LimbFade::LimbFade(const Skeleton& body) : body_(body) {
  const Pose standing = standing_pose(body);
  const JointTransforms world = world_transforms(body, standing);
  for (size_t l = 0; l < fading_limbs.size(); ++l) {
    rest_[l] = seen_from_pelvis(standing, world, fading_limbs[l].end);
    lengths_[l] = limb_length(body, fading_limbs[l]);
  }
}

LimbStrengths LimbFade::operator()(const Pose& pose) const {
  const JointTransforms world = world_transforms(body_, pose);
  LimbStrengths strengths;
  for (size_t l = 0; l < fading_limbs.size(); ++l) {
    const Vec3 away = seen_from_pelvis(pose, world, fading_limbs[l].end) - rest_[l];
    strengths[l] = faded_in(away.norm() / lengths_[l]);
  }
  return strengths;
}

std::vector<LimbStrengths> smooth_strengths(std::span<const LimbStrengths> strengths,
                                            double frames_per_second, SignalEnds ends) {
  std::vector<LimbStrengths> smooth(strengths.begin(), strengths.end());
  for (size_t l = 0; l < fading_limbs.size(); ++l) {
    std::vector<double> strength;
    for (const LimbStrengths& all : strengths) strength.push_back(all[l]);
    strength = low_pass(strength, fade_cutoff_hz, frames_per_second, ends);
    for (size_t f = 0; f < smooth.size(); ++f) smooth[f][l] = std::clamp(strength[f], 0.0, 1.0);
  }
  return smooth;
}

void apply_posture(Pose& pose, const std::vector<PostureChange>& changes,
                   const std::optional<PoseDifference>& difference,
                   const LimbStrengths& strengths) {
  const auto strength = [&](BodyJoint joint) {
    const size_t limb = limb_of(joint);
    return limb < strengths.size() ? strengths[limb] : 1.0;
  };
  for (const PostureChange& change : changes) {
    const double angle = change.degrees * radians_per_degree;
    for (const UnitTurn& part : turns_of(change.unit)) {
      // Legs that only stay where they are while the pelvis tilts do not fade.
      const double share = change.unit == PostureUnit::pelvis_tilt ? 1.0 : strength(part.joint);
      turn(pose.rotations[part.joint], share * angle * part.turn, part.frame);
    }
  }
  if (!difference) return;
  for (int j = 0; j < body_joint_count; ++j) {
    const Vec3 by = log(difference->turns[static_cast<size_t>(j)]);
    if (by.isZero(0.0)) continue;
    turn(pose.rotations[static_cast<size_t>(j)], strength(BodyJoint(j)) * by, TurnFrame::own);
  }
}

Clip with_posture(const Clip& clip, const std::vector<PostureChange>& changes,
                  const std::optional<PoseDifference>& difference) {
  Clip result = clip;
  const std::vector<LimbStrengths> strengths = smooth_strengths(clip);
  for (size_t f = 0; f < result.poses.size(); ++f) {
    apply_posture(result.poses[f], changes, difference, strengths[f]);
  }
  return result;
}

}  // namespace mien::motion
