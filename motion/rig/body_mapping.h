#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "motion/rig/hand_mapping.h"
#include "motion/rig/mapped_joint.h"
#include "motion/skeleton/clip.h"
#include "motion/skeleton/recording.h"
#include "motion/skeleton/skeleton.h"

namespace mien::motion {

/// Mapping of a rig to the canonical body (body.h), made by `recognise`.
struct BodyMapping {
  std::string rig;      ///< "cmu-bvh", "acclaim", "bandai-namco", …, "by names", "by topology"
  MappedJoints joints;  ///< the rig joints of each canonical joint, with confidence
  /// A_j (calibration.h): global rotation of canonical joint = that of the rig joint · A_j.
  std::array<Quat, body_joint_count> calibration;
  HandMapping hands = no_hands();   ///< the rig's fingers, where it has any
  Skeleton body;                    ///< canonical body with the subject's bone lengths, metres
  Quat to_y_up = Quat::Identity();  ///< rotation from the file's axes to +Y up
  std::string up = "+Y";            ///< the file's up axis: "+Y", "+Z", "-X", …
  double metres_per_unit = 1.0;
  double confidence = 0.0;  ///< mean over the joints, 0–1; halved for a figure on all fours
  std::vector<std::string> warnings;  ///< plain sentences
};

/// Recognises a human rig by joint names, else by topology (rig_topology.h), and calibrates it.
/// Throws Error if the recording has no frames or its rig is not recognised as human.
BodyMapping recognise(const Recording& recording);

/// As above, calibrated over several recordings of one rig together, so that measured quantities
/// (twist of the limbs, flat feet) are the same for all. All must have the same skeleton as the
/// first (`same_rig`); throws Error naming a recording that differs.
BodyMapping recognise(std::span<const Recording> recordings);

/// The recording as a motion of the canonical body: +Y up, metres, the floor at y = 0; horizontal
/// position and heading stay as recorded. Joint positions are those of the rig; exactly so where
/// rig joints correspond one to one and have constant offsets. The poses have fingers if the rig
/// has a hand (hand_mapping.h) whose fingers leave its zero pose in some frame.
///
/// The floor is the level on which the lower foot stands (floor.h), so that a few noisy frames or
/// dipping toes do not affect it. A sloping floor is levelled first. Toes that would penetrate the
/// floor at toe off are bent (toe_bend.h). The recording must have the rig of the mapping. Throws
/// Error if it has no frames, or fewer joints than the mapping refers to.
Clip to_body(const Recording& recording, const BodyMapping& mapping);

/// Floor of a recording mapped to the canonical body, for which `to_body` corrects.
struct RecordedFloor {
  Quat levelling = Quat::Identity();  ///< rotation that levels a sloping floor
  double height = 0.0;                ///< metres above y = 0, after levelling
};

RecordedFloor recorded_floor(const Recording& recording, const BodyMapping& mapping);

/// As `to_body` above, with a known floor.
Clip to_body(const Recording& recording, const BodyMapping& mapping, const RecordedFloor& floor);

/// `to_body` with the recording's own `recognise` mapping.
Clip to_body(const Recording& recording);

/// Analysis of any recording, human or not, so that it can be drawn as a stick figure.
struct RigAnalysis {
  std::optional<BodyMapping> human;  ///< empty if the figure was not recognised as human
  std::string rejection;             ///< a sentence on why `human` is empty; else empty
  /// Notes of the file reader; then the warnings of the mapping or, for a figure that was not
  /// recognised, the rejection and how it is shown.
  std::vector<std::string> warnings;
  Quat to_y_up = Quat::Identity();
  std::string up = "+Y";
  double metres_per_unit = 1.0;  ///< 1 if not human: the unit is unknown
  double floor = 0.0;  ///< lowest height of a joint in any frame after rotation to +Y up, metres
};

/// Throws Error if the recording has no frames.
RigAnalysis analyse_rig(const Recording& recording);

}  // namespace mien::motion
