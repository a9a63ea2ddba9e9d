#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "motion/formats/numpy/numpy_files.h"
#include "motion/skeleton/clip.h"

namespace mien::test {

using namespace mien::motion;

/// Joints 0 to 21 of the SMPL family with their parents (RECORDINGS.md), and the joint of the
/// canonical body at the same place; none for spine2.
inline constexpr std::array<std::string_view, 22> smpl_names = {
    "pelvis",     "left_hip",    "right_hip",    "spine1",     "left_knee",     "right_knee",
    "spine2",     "left_ankle",  "right_ankle",  "spine3",     "left_foot",     "right_foot",
    "neck",       "left_collar", "right_collar", "head",       "left_shoulder", "right_shoulder",
    "left_elbow", "right_elbow", "left_wrist",   "right_wrist"};
inline constexpr std::array<int, 22> smpl_parents = {-1, 0, 0, 0, 1,  2,  3,  4,  5,  6,  7,
                                                     8,  9, 9, 9, 12, 13, 14, 16, 17, 18, 19};
inline constexpr std::array<int, 22> smpl_to_body = {
    Pelvis,    LeftHip,      RightHip,      Spine,     LeftKnee,     RightKnee,
    -1,        LeftAnkle,    RightAnkle,    Chest,     LeftToe,      RightToe,
    Neck,      LeftClavicle, RightClavicle, Head,      LeftShoulder, RightShoulder,
    LeftElbow, RightElbow,   LeftWrist,     RightWrist};

/// The rotation matrix of an axis × angle (Rodrigues 1840).
inline Mat3 rodrigues(const Vec3& turn) {
  const double angle = turn.norm();
  if (angle == 0.0) return Mat3::Identity();
  const Vec3 k = turn / angle;
  Mat3 cross;
  cross << 0, -k.z(), k.y(), k.z(), 0, -k.x(), -k.y(), k.x(), 0;
  return Mat3::Identity() + std::sin(angle) * cross + (1 - std::cos(angle)) * cross * cross;
}

/// Where the joints of a frame are: each at its parent's place, plus its offset turned by all
/// rotations above it.
inline std::vector<Vec3> smpl_positions(const std::vector<Vec3>& offsets,
                                        const std::vector<int>& parents,
                                        const std::vector<Vec3>& turns, const Vec3& pelvis) {
  std::vector<Vec3> places;
  for (std::size_t j = 0; j < offsets.size(); ++j) {
    Vec3 place = offsets[j];
    if (parents[j] < 0) {
      places.push_back(pelvis);
      continue;
    }
    for (int above = parents[j]; above >= 0; above = parents[static_cast<std::size_t>(above)]) {
      place = rodrigues(turns[static_cast<std::size_t>(above)]) * place;
      if (parents[static_cast<std::size_t>(above)] >= 0)
        place += offsets[static_cast<std::size_t>(above)];
    }
    places.push_back(place + pelvis);
  }
  return places;
}

/// The motion of a clip of the canonical body as rotations of so many SMPL joints.
struct SmplMotion {
  std::size_t joints = 52;
  std::vector<double> poses;  ///< T × 3 · joints
  std::vector<double> trans;
  std::size_t frames = 0;
};

/// `to_file`: from +Y up to the axes of the file.
inline SmplMotion smpl_motion(const Clip& clip, std::size_t joints, const Mat3& to_file) {
  SmplMotion motion{joints, {}, {}, clip.poses.size()};
  for (const Pose& pose : clip.poses) {
    const Vec3 place = to_file * pose.root_position;
    motion.trans.insert(motion.trans.end(), place.begin(), place.end());
    for (std::size_t j = 0; j < joints; ++j) {
      const int own = j < 22 ? smpl_to_body[j] : -1;
      Mat3 turn = own < 0 ? Mat3(Mat3::Identity())
                          : pose.rotations[static_cast<std::size_t>(own)].toRotationMatrix();
      if (j == 0) turn = to_file * turn;
      const Eigen::AngleAxisd about(turn);
      const Vec3 numbers = about.angle() * about.axis();
      motion.poses.insert(motion.poses.end(), numbers.begin(), numbers.end());
    }
  }
  return motion;
}

inline std::string shape_of(std::size_t rows, std::size_t columns) {
  return "(" + std::to_string(rows) + ", " + std::to_string(columns) + ")";
}

/// As AMASS has it.
inline std::vector<ZipMember> amass_members(const SmplMotion& motion, double rate) {
  return {{"poses", npy_f8(shape_of(motion.frames, 3 * motion.joints), motion.poses), true},
          {"trans", npy_f8(shape_of(motion.frames, 3), motion.trans)},
          {"betas", npy_f8("(16,)", std::vector<double>(16, 0.3))},
          {"gender", npy_text({"female"}, 6, true)},
          {"mocap_framerate", npy_f8("()", {rate})}};
}

}  // namespace mien::test
