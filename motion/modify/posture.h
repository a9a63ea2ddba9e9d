#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "motion/math/filter.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Named unit differences of posture. Each turns some joints of the canonical body by a stated
/// angle; what lies on either side is turned on both sides, mirrored. Positive is:
enum class PostureUnit {
  head_flexion,                ///< chin to the chest; neck and head, half each
  head_lateral,                ///< left ear to the left shoulder; neck and head, half each
  head_turn,                   ///< face to the left; neck and head, half each
  chest_flexion,               ///< chest bent forward
  spine_flexion,               ///< whole back bent forward; spine and chest, half each
  spine_lateral,               ///< back bent to the left; spine and chest, half each
  spine_turn,                  ///< shoulders turned to the left; spine and chest, half each
  pelvis_tilt,                 ///< pelvis, and all above it, leant forward; the legs stay
  shoulder_elevation,          ///< shoulders drawn up (clavicles)
  shoulder_protraction,        ///< shoulders drawn forward (clavicles)
  shoulder_abduction,          ///< upper arms away from the body, sideways
  shoulder_flexion,            ///< upper arms forward
  shoulder_internal_rotation,  ///< upper arms turned about their length, bent forearms inwards
  elbow_flexion,               ///< forearms towards the upper arms
  wrist_flexion,               ///< palms towards the forearms
  hip_abduction,               ///< thighs apart
  hip_flexion,                 ///< thighs forward
  hip_internal_rotation,       ///< thighs turned about their length, toes inwards
  knee_flexion,                ///< heels towards the buttocks
  ankle_dorsiflexion,          ///< toes towards the shins
};

struct PostureUnitName {
  PostureUnit unit;
  std::string_view name;         ///< "head-flexion"
  std::string_view description;  ///< what a positive angle does, in plain words
};

/// All units in the order of the enumeration.
const std::vector<PostureUnitName>& posture_units();

std::string_view name_of(PostureUnit unit);

/// The unit of that name; none when there is no such unit.
std::optional<PostureUnit> posture_unit(std::string_view name);

struct PostureChange {
  PostureUnit unit = PostureUnit::head_flexion;
  double degrees = 0.0;
};

/// Rotation of each joint from one standing pose to another, in the joint's own frame:
/// q_neutral⁻¹ · q_posed. Of the pelvis only what is not heading. Holds angles alone, so that it
/// fits bodies of every size.
struct PoseDifference {
  std::array<Quat, body_joint_count> turns;

  PoseDifference() { turns.fill(Quat::Identity()); }
};

/// The difference between two standing poses of the canonical body.
PoseDifference pose_difference(const Pose& neutral, const Pose& posed);

/// The canonical body standing at rest: arms hanging, legs straight, soles on the floor.
Pose standing_pose(const Skeleton& body);

/// Number of limbs whose posture change fades as they move away from rest: arms, then legs.
inline constexpr int fading_limb_count = 4;

/// Strength of the posture change of each, 0–1: left arm, right arm, left leg, right leg.
using LimbStrengths = std::array<double, fading_limb_count>;

/// Computes the strengths for one pose, not yet smoothed over time; see `with_posture`.
class LimbFade {
 public:
  explicit LimbFade(const Skeleton& body);
  LimbStrengths operator()(const Pose& pose) const;

 private:
  Skeleton body_;
  std::array<Vec3, fading_limb_count> rest_;  ///< their ends at rest, seen from the pelvis
  std::array<double, fading_limb_count> lengths_;
};

/// The strengths of a whole clip, low-pass filtered at 4 Hz.
std::vector<LimbStrengths> smooth_strengths(std::span<const LimbStrengths> strengths,
                                            double frames_per_second, SignalEnds ends);

/// Applies a posture change to one pose, with the given strengths of the limbs.
void apply_posture(Pose& pose, const std::vector<PostureChange>& changes,
                   const std::optional<PoseDifference>& difference, const LimbStrengths& strengths);

/// The clip in another posture: unit differences first, then the captured difference, each at its
/// full strength while a limb is about where it hangs at rest, and fading out as the hand or foot
/// goes 35–80 % of the limb's length away from there (as seen from the pelvis; smooth below 4 Hz).
/// Trunk and head do not fade. Feet are not repaired.
Clip with_posture(const Clip& clip, const std::vector<PostureChange>& changes,
                  const std::optional<PoseDifference>& difference = {});

}  // namespace mien::motion
