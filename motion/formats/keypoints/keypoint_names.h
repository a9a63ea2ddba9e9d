#pragma once

#include <string>
#include <vector>

namespace mien::motion {

/// The 25 points of OpenPose's BODY_25, in order.
const std::vector<std::string>& body_25_names();
/// The 18 points of OpenPose's COCO model.
const std::vector<std::string>& coco_18_names();
/// The 33 landmarks of MediaPipe's pose (BlazePose).
const std::vector<std::string>& mediapipe_pose_names();

}  // namespace mien::motion
