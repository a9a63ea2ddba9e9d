#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mien::motion {

/// A known order of joints, as of a data set or a tracker.
struct JointOrder {
  std::string_view name;  ///< as in `joints:`: "kinect"
  std::span<const std::string_view> joints;
  /// Pairs of joints with a bone between them, by index.
  std::span<const std::pair<int, int>> bones;
};

/// All known orders: "humanml3d" (22), "smpl" (24), "h36m" (17), "kinect" and "body_25" (25),
/// "mediapipe" (33). Sources: SMPL (Loper 2015), Human3.6M as reordered by VideoPose3D, Kinect for
/// Windows SDK 2.0 `JointType`, OpenPose `BODY_25`, MediaPipe Pose landmarks.
std::span<const JointOrder> joint_orders();

/// The order of that name; null if there is none.
const JointOrder* joint_order(std::string_view name);

/// Names of points as users give them: those of a known order if its name alone is given.
std::vector<std::string> given_point_names(const std::vector<std::string>& given);

}  // namespace mien::motion
