#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "motion/dynamics/limb_dynamics.h"
#include "motion/dynamics/retiming.h"
#include "motion/dynamics/tempo_curve.h"
#include "motion/modify/gesture_change.h"
#include "motion/modify/posture.h"
#include "motion/modify/relative_change.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Representation of rotations while their frequency bands are weighted.
enum class RotationSignal {
  direction_vectors,  ///< two columns of the rotation matrix (as in the emotion thesis; swings
                      ///< saturate towards 90°)
  quaternions,  ///< the logarithm of the quaternion about the joint's mean rotation (angles scale
                ///< exactly)
};

/// Gains of the bands of a motion by their frequency.
struct PathGains {
  double low = 1.0;     ///< below 1 Hz, and the mean
  double middle = 1.0;  ///< 1–12.5 Hz
  double high = 1.0;    ///< above 12.5 Hz
  /// If given, gains of single bands instead, finest first (pyramid.h, at the clip's own frame
  /// rate); bands beyond the list have the gain `low`.
  std::vector<double> bands;
};

/// What a change of path lengths does to fingers.
enum class FingerPaths {
  kept,    ///< nothing: they move with their hand, as recorded (default)
  scaled,  ///< their frequency bands are weighted as those of the body's joints
};

/// Where acceleration applies.
enum class AccelerationPlace {
  pauses,    ///< at all slow moments of the limb
  contacts,  ///< hands that hit something: at their hits; other limbs: only at slow moments within
             ///< 0.2 s of a foot landing
  hits,      ///< only hands, at their hits
};

/// The limbs that are retimed, each independently. Arms include the clavicles, feet the whole leg;
/// the trunk keeps the timing of the hips.
struct Limbs {
  bool head = true;  ///< with the neck
  bool left_hand = true;
  bool right_hand = true;
  bool left_foot = false;
  bool right_foot = false;
};

/// How foot plants are restored after a modification.
enum class FootRepair {
  plants,     ///< hip shift, then every planted foot is held in position by leg inverse kinematics
              ///< (default)
  hip_shift,  ///< the root is moved so that the planted foot stands still (as in the emotion
              ///< thesis)
  none,
};

/// What a change of tempo does to heights and steps.
enum class TempoGravity {
  scaled,  ///< nothing, as when a film is played at another speed (default)
  kept,    ///< heights and steps become those of a body in the same gravity (tempo_forces.h)
};

/// A change of the emotional content of a motion (after the emotion thesis). The default changes
/// nothing.
struct Modification {
  double paths = 1.0;              ///< length of motion paths, 0 very short … 1 as is … 2 long
  std::optional<PathGains> gains;  ///< instead of `paths`
  RotationSignal signal = RotationSignal::direction_vectors;
  FingerPaths hands = FingerPaths::kept;  ///< of motions that have fingers
  double acceleration = 0.0;              ///< −1 constant speed … 0 as is … 1 accelerated
  AccelerationPlace acceleration_place = AccelerationPlace::pauses;
  Limbs limbs;  ///< to which acceleration and variation apply
  std::vector<PostureChange> posture;
  std::optional<PoseDifference> pose_difference;
  GestureChange gesture;    ///< of a hand that waves, knocks or the like; made first
  RelativeChange relative;  ///< in the actor's own terms, worked out from the motion modified
  Tempo tempo;              ///< overall speed factor, 0.25–4, or a curve of factors
  TempoGravity gravity = TempoGravity::scaled;
  Stiffness stiffness;     ///< below 1 slack, above 1 held (limb_dynamics.h)
  double weight = 1.0;     ///< factor on gravity, 0–3, that muscles must hold
  double variation = 0.0;  ///< 0–1: strength of smooth random changes of limb paths and timing
  std::uint64_t seed = 1;  ///< of the variation
  FootRepair repair = FootRepair::plants;
  bool soft_joint_limits = true;
};

/// Effects of a modification, for the report.
struct ModificationReport {
  double tempo = 1.0;  ///< effective tempo, after rounding the duration to whole frames
  Retiming retiming;   ///< of the original's frames; of an unchanged motion without frames
  int plants = 0;      ///< number of foot plants, detected on the original
  double drift_before_repair = 0.0;  ///< metres: largest drift of a planted foot (planted_drift)
  double drift_after_repair = 0.0;   ///< metres
  int hits = 0;  ///< number of hits of hands (hand_hits.h), detected on the original
  double hand_correction = 0.0;  ///< metres: largest distance by which a hit was moved back
  double travel_ratio = 1.0;     ///< distance travelled relative to the original; 1 without travel
  double largest_limit_excess = 0.0;  ///< radians: largest correction of a joint by its soft limit
  /// If the gesture changed: the frame (fractional) to which each frame of the original came by
  /// that, before the tempo.
  std::vector<double> gesture_frames;
  std::vector<std::string> remarks;  ///< sentences
};

struct ModifiedClip {
  Clip clip;
  ModificationReport report;
};

/// Whether the modification changes nothing.
bool is_identity(const Modification& modification);

/// The modification at a strength: 0 is the identity, 1 the modification itself; above 1 it is
/// exaggerated. Angles, logarithms of tempo, and distances from 1 or 0 are multiplied; paths,
/// acceleration, tempo and variation stay within their ranges.
Modification scaled(const Modification& modification, double strength);

/// Throws mien::Error for a number outside its range.
void check(const Modification& modification);

/// The modified clip of the canonical body. Relative changes are worked out from the clip first:
/// its swing is multiplied, and what they ask of its posture is added (relative_change.h). Then, in
/// the order of the emotion thesis: path lengths, hip shift, limb timing, and bilinear
/// interpolation on the grid of nine motions (nine_grid.h); then variation, tempo, posture, slack
/// and held parts, joint limits, foot repair, and heights in the same gravity and on slack legs;
/// with foot repair by plants, hands that hit something still do so at the same places
/// (held_hands.h), unless variation or acceleration elsewhere changes their timing. Hips are
/// adducted less than requested if steps would otherwise become narrower than a foot and than in
/// the original (feet_apart.h). Bone lengths never change; a loop stays a loop. Clips may walk in
/// place. Throws mien::Error as `check` does, and for a skeleton other than the canonical body.
ModifiedClip modify(const Clip& clip, const Modification& modification);

/// Like `modify`, without the report.
Clip modified(const Clip& clip, const Modification& modification);

}  // namespace mien::motion
