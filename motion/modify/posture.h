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

/// Named elementary changes of posture. Each rotates certain joints of the canonical body by a
/// given angle; paired joints are rotated on both sides, mirrored. The comments describe a positive
/// angle.
enum class PostureUnit {
  head_flexion,          ///< chin to the chest; neck and head, half each
  head_lateral,          ///< left ear to the left shoulder; neck and head, half each
  head_turn,             ///< face to the left; neck and head, half each
  chest_flexion,         ///< chest bent forward
  spine_flexion,         ///< whole back bent forward; spine and chest, half each
  spine_lateral,         ///< back bent to the left; spine and chest, half each
  spine_turn,            ///< shoulders rotated to the left; spine and chest, half each
  pelvis_tilt,           ///< pelvis and everything above it leant forward; the legs do not move
  shoulder_elevation,    ///< shoulders drawn up (clavicles)
  shoulder_protraction,  ///< shoulders drawn forward (clavicles)
  shoulder_abduction,    ///< upper arms away from the body, sideways
  shoulder_flexion,      ///< upper arms forward
  shoulder_internal_rotation,  ///< upper arms rotated about their long axis, bent forearms inwards
  elbow_flexion,               ///< forearms towards the upper arms
  wrist_flexion,               ///< palms towards the forearms
  hip_abduction,               ///< thighs apart
  hip_flexion,                 ///< thighs forward
  hip_internal_rotation,       ///< thighs rotated about their long axis, toes inwards
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

/// The unit with that name, if any.
std::optional<PostureUnit> posture_unit(std::string_view name);

struct PostureChange {
  PostureUnit unit = PostureUnit::head_flexion;
  double degrees = 0.0;
};

/// Rotation of each joint from one standing pose to another, in the joint's own frame: q_neutral⁻¹
/// · q_posed. The pelvis' heading is excluded. Because it consists of rotations only, it applies to
/// bodies of any size.
struct PoseDifference {
  std::array<Quat, body_joint_count> turns;

  PoseDifference() { turns.fill(Quat::Identity()); }
};

/// The difference between two standing poses of the canonical body.
PoseDifference pose_difference(const Pose& neutral, const Pose& posed);

/// The canonical body standing at rest: arms hanging, legs straight, soles on the floor.
Pose standing_pose(const Skeleton& body);

/// Number of limbs whose posture change fades out as they move away from rest.
inline constexpr int fading_limb_count = 4;

/// Strength of the posture change per limb, 0–1: left arm, right arm, left leg, right leg.
using LimbStrengths = std::array<double, fading_limb_count>;

/// Computes the strengths for one pose, not yet smoothed over time; see `with_posture`.
class LimbFade {
 public:
  explicit LimbFade(const Skeleton& body);
  LimbStrengths operator()(const Pose& pose) const;

 private:
  Skeleton body_;
  std::array<Vec3, fading_limb_count> rest_;  ///< ends of the limbs at rest, in the pelvis' frame
  std::array<double, fading_limb_count> lengths_;
};

/// The strengths of a whole clip, low-pass filtered at 4 Hz.
std::vector<LimbStrengths> smooth_strengths(std::span<const LimbStrengths> strengths,
                                            double frames_per_second, SignalEnds ends);

/// Applies a posture change to one pose, with the given strengths of the limbs.
void apply_posture(Pose& pose, const std::vector<PostureChange>& changes,
                   const std::optional<PoseDifference>& difference, const LimbStrengths& strengths);

/// The clip in another posture: the `changes` first, then the captured `difference`, each at full
/// strength while a limb is close to its rest position, fading out as the hand or foot moves 35–80
/// % of the limb's length away from there (relative to the pelvis; low-pass filtered at 4 Hz).
/// Trunk and head do not fade. Foot plants are not restored (see foot_repair.h).
Clip with_posture(const Clip& clip, const std::vector<PostureChange>& changes,
                  const std::optional<PoseDifference>& difference = {});

}  // namespace mien::motion
