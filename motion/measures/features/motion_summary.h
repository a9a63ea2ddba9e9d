#pragma once

#include <string>
#include <vector>

#include "motion/gait/gait.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// The recognition of one canonical joint in a rig.
struct JointSummary {
  std::string joint;                    ///< canonical name, "LeftKnee"
  std::vector<std::string> rig_joints;  ///< names in the file, from root to tip; empty if missing
  double confidence = 0.0;              ///< 0–1
  std::string found_by;                 ///< "name", "topology", "end site", "missing"
};

/// A finger joint (hand.h) and the joint of the file that it follows.
struct FingerJointSummary {
  std::string joint;      ///< "LeftIndex1"
  std::string rig_joint;  ///< name in the file
};

/// The recognition of one hand in a rig.
struct HandSummary {
  bool is_left = false;
  std::vector<FingerJointSummary> joints;  ///< recognised, in the order of hand.h
  std::vector<std::string> missing;        ///< canonical names; empty if the rig has no such hand
  bool is_recorded = false;  ///< whether fingers move or are bent; else hands are shown at ease
};

/// The contents of `mien motion info`.
struct MotionSummary {
  int frames = 0;
  double frames_per_second = 0.0;
  double duration_seconds = 0.0;
  std::vector<std::string> joint_names;  ///< of the file
  std::vector<std::string> takes;        ///< names of the animations; empty unless a glTF file
  std::string take;                      ///< name of the summarised motion
  bool is_human = false;                 ///< whether the figure was recognised
  std::string rig;                       ///< rig family; "unknown" if not human
  double confidence = 0.0;
  std::vector<JointSummary> joints;  ///< of the canonical body; empty if not human
  std::vector<HandSummary> hands;    ///< those that the rig has, the left one first
  double height_m = 0.0;             ///< standing height of the skeleton; 0 if not human
  double unit_m = 1.0;               ///< metres per unit of the file
  std::string up;                    ///< "+Y", "+Z", …
  double speed_m_s = 0.0;            ///< mean horizontal speed of the pelvis, excluding sway
  std::vector<GaitCycle> cycles;
  int steadiest = -1;  ///< index of the cycle from which an example would be made; −1: none
  std::vector<std::string> warnings;  ///< plain sentences
};

MotionSummary summarise(const Recording& recording);

}  // namespace mien::motion
