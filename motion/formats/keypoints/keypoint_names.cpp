#include "motion/formats/keypoints/keypoint_names.h"

#include "motion/points/joint_orders.h"

namespace mien::motion {

const std::vector<std::string>& body_25_names() {
  static const std::vector<std::string> names = {
      "Nose",   "Neck",    "RShoulder", "RElbow", "RWrist", "LShoulder", "LElbow",
      "LWrist", "MidHip",  "RHip",      "RKnee",  "RAnkle", "LHip",      "LKnee",
      "LAnkle", "REye",    "LEye",      "REar",   "LEar",   "LBigToe",   "LSmallToe",
      "LHeel",  "RBigToe", "RSmallToe", "RHeel"};
  return names;
}

const std::vector<std::string>& coco_18_names() {
  static const std::vector<std::string> names = {
      "Nose",  "Neck",   "RShoulder", "RElbow", "RWrist", "LShoulder", "LElbow", "LWrist", "RHip",
      "RKnee", "RAnkle", "LHip",      "LKnee",  "LAnkle", "REye",      "LEye",   "REar",   "LEar"};
  return names;
}

const std::vector<std::string>& mediapipe_pose_names() {
  static const auto joints = joint_order("mediapipe")->joints;
  static const std::vector<std::string> names(joints.begin(), joints.end());
  return names;
}

}  // namespace mien::motion
