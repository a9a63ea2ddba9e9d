#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "motion/modify/posture.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Representation of rotations while their frequency bands are weighted.
enum class RotationSignal {
  direction_vectors,  ///< two columns of its matrix (the thesis' way; swings saturate towards 90°)
  quaternions,        ///< its logarithm about the joint's mean rotation (angles scale exactly)
};

/// Gains of the bands of a motion by their frequency.
struct PathGains {
  double low = 1.0;           ///< below 1 Hz, and the mean
  double middle = 1.0;        ///< 1–12.5 Hz
  double high = 1.0;          ///< above 12.5 Hz
  std::vector<double> bands;  ///< when given, of single bands instead, finest first (pyramid.h, at
                              ///< the clip's own frame rate); those left out have the low gain
};

/// Where acceleration applies.
enum class AccelerationPlace {
  pauses,    ///< at the limb's slow moments, all along
  contacts,  ///< only within 0.2 s of when a foot comes to the floor; nowhere where no foot comes
             ///< down
};

/// The parts of the body whose timing is changed, each by itself: arms with their clavicles, legs.
/// The trunk keeps time with the hips.
struct Limbs {
  bool head = true;  ///< and neck
  bool left_hand = true;
  bool right_hand = true;
  bool left_foot = false;
  bool right_foot = false;
};

/// How foot plants are restored after a modification.
enum class FootRepair {
  plants,     ///< hip shift, then every plant held in its place by bent legs (default)
  hip_shift,  ///< the root moves so that the planted foot stands (the emotion thesis)
  none,
};

/// A change of the emotional content of a motion (after the emotion thesis). The default changes
/// nothing.
struct Modification {
  double paths = 1.0;              ///< length of motion paths, 0 very short … 1 as is … 2 long
  std::optional<PathGains> gains;  ///< instead of `paths`
  RotationSignal signal = RotationSignal::direction_vectors;
  double acceleration = 0.0;  ///< −1 constant speed … 0 as is … 1 accelerated
  AccelerationPlace acceleration_place = AccelerationPlace::pauses;
  Limbs limbs;  ///< that acceleration and variation apply to
  std::vector<PostureChange> posture;
  std::optional<PoseDifference> pose_difference;
  double tempo = 1.0;      ///< speed of the whole; the duration is divided by it; 0.25–4
  double variation = 0.0;  ///< 0–1: path lengths and timing of the limbs wander at random, smoothly
  std::uint64_t seed = 1;  ///< of the variation
  FootRepair repair = FootRepair::plants;
  bool soft_joint_limits = true;
};

/// Effects of a modification, for the report.
struct ModificationReport {
  double tempo = 1.0;                ///< effective tempo: a clip lasts a whole number of frames
  int plants = 0;                    ///< number of foot plants, detected on the original
  double drift_before_repair = 0.0;  ///< metres, largest over the plants (planted_drift)
  double drift_after_repair = 0.0;   ///< metres
  double travel_ratio = 1.0;  ///< distance travelled relative to the original; 1 if it stands
  double largest_limit_excess = 0.0;  ///< radians that a joint was bent back by its soft limit
  std::vector<std::string> remarks;   ///< sentences
};

struct ModifiedClip {
  Clip clip;
  ModificationReport report;
};

/// Whether the modification changes nothing.
bool is_identity(const Modification& modification);

/// The modification at a strength: 0 is the identity, 1 the modification itself; above 1 it is
/// exaggerated as far as the ranges go. Angles, logarithms of tempo, and distances from 1 or 0 are
/// multiplied.
Modification scaled(const Modification& modification, double strength);

/// Throws mien::Error for a number outside its range.
void check(const Modification& modification);

/// The clip of the canonical body, modified: paths, the hips carried along by the feet, speed, and
/// the mix of what lies around the place on the nine-motion grid (order of the emotion thesis);
/// then variation, tempo, posture, joint limits and the repair of the feet. Bone lengths never
/// change; a loop stays a loop. Clips may travel or walk in place. Throws as `check`, and for a
/// skeleton that is not the canonical body.
ModifiedClip modify(const Clip& clip, const Modification& modification);

/// As `modify`, without the report.
Clip modified(const Clip& clip, const Modification& modification);

}  // namespace mien::motion
