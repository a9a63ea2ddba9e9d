#pragma once

#include <string>
#include <vector>

#include "motion/gait/gait.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// How one canonical joint was recognised.
struct JointSummary {
  std::string joint;                    ///< canonical name, "LeftKnee"
  std::vector<std::string> rig_joints;  ///< names in the file, from root to tip; empty when missing
  double confidence = 0.0;              ///< 0–1
  std::string found_by;                 ///< "name", "topology", "end site", "missing"
};

/// The contents of `mien motion info`.
struct MotionSummary {
  int frames = 0;
  double frames_per_second = 0.0;
  double duration_seconds = 0.0;
  std::vector<std::string> joint_names;  ///< of the file
  std::vector<std::string> takes;        ///< motions that the file names; empty where it names none
  std::string take;                      ///< the one of them that this is
  bool is_human = false;                 ///< whether the figure was recognised
  std::string rig;                       ///< rig family, "unknown" when not human
  double confidence = 0.0;
  std::vector<JointSummary> joints;  ///< of the canonical body; empty when not human
  double height_m = 0.0;             ///< standing height of the skeleton; 0 when not human
  double unit_m = 1.0;               ///< metres in one unit of the file
  std::string up;                    ///< "+Y", "+Z", …
  double speed_m_s = 0.0;            ///< mean horizontal speed of the pelvis without its sway
  std::vector<GaitCycle> cycles;
  int steadiest = -1;                 ///< index of the cycle that an example would use; −1: none
  std::vector<std::string> warnings;  ///< plain sentences
};

MotionSummary summarise(const Recording& recording);

}  // namespace mien::motion
