#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "motion/rig/mapped_joint.h"
#include "motion/skeleton/clip.h"
#include "motion/skeleton/recording.h"
#include "motion/skeleton/skeleton.h"

namespace mien::motion {

/// Mapping of a rig to the canonical body (body.h), made by `recognise`.
struct BodyMapping {
  std::string rig;      ///< "cmu-bvh", "acclaim", "bandai-namco", …, "by names", "by topology"
  MappedJoints joints;  ///< the rig joints of each canonical joint, with confidence
  std::array<Quat, body_joint_count> calibration;  ///< A_j: G_canonical = G_rig · A_j
  Skeleton body;                    ///< canonical body with the performer's bone lengths, metres
  Quat to_y_up = Quat::Identity();  ///< the file's axes → +Y up
  std::string up = "+Y";            ///< the file's up axis: "+Y", "+Z", "-X", …
  double metres_per_unit = 1.0;
  double confidence = 0.0;            ///< mean over the joints, 0–1
  std::vector<std::string> warnings;  ///< plain sentences
};

/// Recognises a human rig by joint names, else by topology (rig_topology.h), and calibrates it.
/// Throws Error when it is no human rig that could be followed, saying what is missing.
BodyMapping recognise(const Recording& recording);

/// As above, calibrated over several recordings of one rig together, so that measured quantities
/// (twist of the limbs, flat feet) are the same for all. All must have the skeleton of the first
/// (`same_rig`); throws Error naming one that has not.
BodyMapping recognise(std::span<const Recording> recordings);

/// The recording as a motion of the canonical body: +Y up, metres, the floor at y = 0; where it is
/// and where it heads stay as recorded. Joint positions are those of the rig, exactly where rig
/// joints correspond one to one and keep their offsets.
///
/// The floor is the level on which the lower foot stands (floor.h), so that a few frames of noise
/// or toes that dip do not move it. A floor that slopes in the recording is levelled first. Toes
/// that would go through it as a foot rolls off bend (toe_bend.h). Throws Error when the recording
/// has another rig than the mapping.
Clip to_body(const Recording& recording, const BodyMapping& mapping);

/// Floor of a recording mapped to the canonical body, as `to_body` removes it.
struct RecordedFloor {
  Quat levelling = Quat::Identity();  ///< turns a floor that slopes level
  double height = 0.0;                ///< metres, after that
};

RecordedFloor recorded_floor(const Recording& recording, const BodyMapping& mapping);

/// As above, with a known floor.
Clip to_body(const Recording& recording, const BodyMapping& mapping, const RecordedFloor& floor);

/// `to_body` with the recording's own `recognise` mapping.
Clip to_body(const Recording& recording);

/// Analysis of any recording, human or not, so that it can be drawn as a stick figure.
struct RigAnalysis {
  std::optional<BodyMapping> human;   ///< empty when it was not recognised
  std::string rejection;              ///< why it was not recognised, a sentence
  std::vector<std::string> warnings;  ///< of the mapping, or the rejection; and notes of the reader
  Quat to_y_up = Quat::Identity();
  std::string up = "+Y";
  double metres_per_unit = 1.0;  ///< 1 if not human: the unit is unknown
  double floor = 0.0;            ///< height of the lowest point, metres, after the turn to +Y
};

RigAnalysis analyse_rig(const Recording& recording);

}  // namespace mien::motion
