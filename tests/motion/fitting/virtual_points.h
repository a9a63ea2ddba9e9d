#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "motion/math/random_number.h"
#include "motion/math/rotation.h"
#include "motion/points/point_recording.h"
#include "motion/procedural/walker.h"
#include "motion/skeleton/mirror.h"

namespace mien::motion::test {

/// A point fixed in the frame of a joint of the body, metres.
struct VirtualPoint {
  std::string name;
  BodyJoint joint;
  Vec3 place = Vec3::Zero();
};

/// Two cycles of a walk, heading somewhere between the axes and away from the origin.
inline Clip truth(const WalkStyle& style = {}, double frames_per_second = 60.0,
                  const Skeleton& body = standard_body()) {
  Clip clip = repeated(walk(style, frames_per_second, body).clip, 2);
  const Quat turn(Eigen::AngleAxisd(0.65, Vec3::UnitY()));
  for (Pose& pose : clip.poses) {
    pose.root_position = turn * pose.root_position + Vec3(1.3, 0.0, -0.4);
    pose.rotations[Pelvis] = turn * pose.rotations[Pelvis];
  }
  return clip;
}

inline PointRecording recorded(const Clip& clip, const std::vector<VirtualPoint>& points) {
  PointRecording recording;
  recording.name = "take";
  recording.format = "test";
  recording.frames_per_second = clip.frames_per_second;
  recording.unit = "m";
  recording.metres_per_unit = 1.0;
  for (const VirtualPoint& point : points) recording.points.push_back(point.name);
  for (const Pose& pose : clip.poses) {
    const JointTransforms world = world_transforms(clip.body, pose);
    for (const VirtualPoint& point : points) {
      recording.positions.push_back(world.positions[point.joint] +
                                    world.rotations[point.joint] * point.place);
      recording.seen.push_back(true);
    }
  }
  return recording;
}

/// Adds a point of the left side and its mirror image; `*` in the name is replaced.
inline void add_both(std::vector<VirtualPoint>& points, const std::string& name,
                     const std::string& left, const std::string& right, BodyJoint joint,
                     const Vec3& place = Vec3::Zero()) {
  const auto named = [&](const std::string& side) {
    std::string result = name;
    return result.replace(name.find('*'), 1, side);
  };
  points.push_back({named(left), joint, place});
  points.push_back({named(right), mirrored(joint), mirrored_place(place)});
}

/// Limb joints as nearly every set has them.
inline void add_limbs(std::vector<VirtualPoint>& points, const std::string& prefix,
                      const std::string& suffix, const std::string& left, const std::string& right,
                      const std::string& ankle = "Ankle") {
  const std::pair<const char*, BodyJoint> joints[] = {
      {"Shoulder", LeftShoulder}, {"Elbow", LeftElbow}, {"Wrist", LeftWrist},
      {"Hip", LeftHip},           {"Knee", LeftKnee},   {ankle.c_str(), LeftAnkle}};
  for (const auto& [word, joint] : joints) {
    add_both(points, prefix + word + suffix, left, right, joint);
  }
}

inline std::vector<VirtualPoint> canonical_joints() {
  std::vector<VirtualPoint> points;
  for (int joint = 0; joint < body_joint_count; ++joint) {
    points.push_back({std::string(name_of(BodyJoint(joint))), BodyJoint(joint)});
  }
  return points;
}

inline std::vector<VirtualPoint> smpl_joints() {
  std::vector<VirtualPoint> points = {{"pelvis", Pelvis}, {"spine1", Spine},
                                      {"spine2", Chest},  {"spine3", Chest, {0, 0.05, 0}},
                                      {"neck", Neck},     {"head", Head}};
  add_limbs(points, "*_", "", "left", "right");
  add_both(points, "*_foot", "left", "right", LeftToe);
  add_both(points, "*_collar", "left", "right", LeftClavicle);
  return points;
}

inline std::vector<VirtualPoint> human36m_joints() {
  std::vector<VirtualPoint> points = {{"Hip", Pelvis, {0, -0.03, 0}},
                                      {"Spine", Chest},
                                      {"Thorax", Chest, {0, 0.18, 0}},
                                      {"Neck/Nose", Head, {0, 0.03, 0.10}},
                                      {"Head", Head, {0, 0.17, 0}}};
  add_limbs(points, "*", "", "L", "R", "Foot");
  return points;
}

/// Nose, eyes and ears.
inline void add_face(std::vector<VirtualPoint>& points, const std::string& nose,
                     const std::string& eye, const std::string& ear, const std::string& left,
                     const std::string& right) {
  points.push_back({nose, Head, {0, 0.03, 0.105}});
  add_both(points, eye, left, right, Head, {0.03, 0.065, 0.09});
  add_both(points, ear, left, right, Head, {0.07, 0.045, 0.0});
}

inline std::vector<VirtualPoint> body_25_keypoints() {
  std::vector<VirtualPoint> points = {{"Neck", Chest, {0, 0.18, 0}},
                                      {"MidHip", Pelvis, {0, -0.03, 0}}};
  add_face(points, "Nose", "*Eye", "*Ear", "L", "R");
  add_limbs(points, "*", "", "L", "R");
  add_both(points, "*BigToe", "L", "R", LeftToe, {0, 0, 0.06});
  add_both(points, "*SmallToe", "L", "R", LeftToe, {0.04, 0, 0.02});
  add_both(points, "*Heel", "L", "R", LeftAnkle, {0, -0.06, -0.045});
  return points;
}

inline std::vector<VirtualPoint> kinect_joints() {
  std::vector<VirtualPoint> points = {{"SpineBase", Pelvis, {0, -0.03, 0}},
                                      {"SpineMid", Chest},
                                      {"SpineShoulder", Chest, {0, 0.18, 0}},
                                      {"Neck", Neck},
                                      {"Head", Head, {0, 0.07, 0}}};
  add_limbs(points, "", "*", "Left", "Right");
  add_both(points, "Foot*", "Left", "Right", LeftToe);
  add_both(points, "Hand*", "Left", "Right", LeftWrist, {0.08, 0, 0});
  return points;
}

inline std::vector<VirtualPoint> media_pipe_landmarks() {
  std::vector<VirtualPoint> points;
  add_face(points, "nose", "*_eye", "*_ear", "left", "right");
  add_limbs(points, "*_", "", "left", "right");
  add_both(points, "mouth_*", "left", "right", Head, {0.02, -0.01, 0.09});
  add_both(points, "*_heel", "left", "right", LeftAnkle, {0, -0.06, -0.045});
  add_both(points, "*_foot_index", "left", "right", LeftToe, {0, 0, 0.06});
  add_both(points, "*_index", "left", "right", LeftWrist, {0.09, 0, 0.03});
  add_both(points, "*_pinky", "left", "right", LeftWrist, {0.08, 0, -0.03});
  return points;
}

/// Trunk, head and arm markers shared by the clinical sets; names by the caller.
struct MarkerSpelling {
  std::string front_spine, back_spine, thigh, knee, shank, ankle, heel, toe;
};

inline std::vector<VirtualPoint> markers(const MarkerSpelling& spelling) {
  std::vector<VirtualPoint> points = {{"C7", Chest, {0, 0.22, -0.06}},
                                      {"T10", Chest, {0, 0.0, -0.11}},
                                      {"CLAV", Chest, {0, 0.17, 0.07}},
                                      {"STRN", Chest, {0, 0.02, 0.12}}};
  const auto add = [&](const std::string& name, BodyJoint joint, const Vec3& place) {
    add_both(points, "*" + name, "L", "R", joint, place);
  };
  add(spelling.front_spine, Pelvis, {0.125, 0.04, 0.07});
  add(spelling.back_spine, Pelvis, {0.045, 0.07, -0.095});
  add(spelling.thigh, LeftHip, {0.09, -0.22, 0.02});
  add(spelling.knee, LeftHip, {0.058, -0.43, 0.0});
  add(spelling.shank, LeftKnee, {0.07, -0.20, 0.02});
  add(spelling.ankle, LeftKnee, {0.042, -0.42, 0.0});
  add(spelling.heel, LeftAnkle, {0.0, -0.045, -0.06});
  add(spelling.toe, LeftAnkle, {0.0, -0.04, 0.13});
  add("SHO", LeftClavicle, {0.165, 0.055, 0.0});
  add("ELB", LeftShoulder, {0.285, 0.045, 0.0});
  add("WRA", LeftElbow, {0.265, 0.0, 0.035});
  add("WRB", LeftElbow, {0.265, 0.0, -0.035});
  add("FIN", LeftWrist, {0.08, 0.015, 0.0});
  add("FHD", Head, {0.07, 0.10, 0.08});
  add("BHD", Head, {0.065, 0.10, -0.09});
  return points;
}

inline std::vector<VirtualPoint> plug_in_gait_markers() {
  return markers({"ASI", "PSI", "THI", "KNE", "TIB", "ANK", "HEE", "TOE"});
}

inline std::vector<VirtualPoint> cmu_markers() {
  return markers({"FWT", "BWT", "THI", "KNE", "SHN", "ANK", "HEE", "TOE"});
}

inline std::vector<VirtualPoint> rizzoli_markers() {
  std::vector<VirtualPoint> points = {{"CV7", Chest, {0, 0.22, -0.06}},
                                      {"TV10", Chest, {0, 0.0, -0.11}},
                                      {"SJN", Chest, {0, 0.17, 0.07}},
                                      {"SXS", Chest, {0, 0.02, 0.12}}};
  const auto add = [&](const std::string& name, BodyJoint joint, const Vec3& place) {
    add_both(points, "*_" + name, "L", "R", joint, place);
  };
  add("IAS", Pelvis, {0.125, 0.04, 0.07});
  add("IPS", Pelvis, {0.045, 0.07, -0.095});
  add("FTC", LeftHip, {0.08, -0.02, 0.0});
  add("FLE", LeftHip, {0.055, -0.43, 0.0});
  add("FME", LeftHip, {-0.055, -0.43, 0.0});
  add("FAX", LeftKnee, {0.06, -0.04, -0.01});
  add("TTC", LeftKnee, {0.0, -0.05, 0.05});
  add("FAL", LeftKnee, {0.038, -0.42, 0.0});
  add("TAM", LeftKnee, {-0.038, -0.42, 0.0});
  add("FCC", LeftAnkle, {0.0, -0.045, -0.06});
  add("FM1", LeftAnkle, {-0.03, -0.045, 0.135});
  add("FM2", LeftAnkle, {0.0, -0.04, 0.13});
  add("FM5", LeftAnkle, {0.04, -0.05, 0.11});
  add("SAE", LeftClavicle, {0.165, 0.055, 0.0});
  add("HLE", LeftShoulder, {0.285, 0.04, 0.0});
  add("HME", LeftShoulder, {0.285, -0.04, 0.0});
  add("RSP", LeftElbow, {0.265, 0.0, 0.03});
  add("USP", LeftElbow, {0.265, 0.0, -0.03});
  return points;
}

/// Three markers on each thigh, shank and foot; none at the knees and ankles.
inline std::vector<VirtualPoint> cluster_markers() {
  std::vector<VirtualPoint> points = {{"V.Sacral", Pelvis, {0, 0.07, -0.1}},
                                      {"Sternum", Chest, {0, 0.1, 0.1}},
                                      {"Top.Head", Head, {0, 0.18, 0}}};
  const auto add = [&](const std::string& name, BodyJoint joint, const Vec3& place) {
    add_both(points, "*." + name, "L", "R", joint, place);
  };
  add("ASIS", Pelvis, {0.125, 0.04, 0.07});
  add("Thigh.Upper", LeftHip, {0.08, -0.20, 0.02});
  add("Thigh.Front", LeftHip, {0.02, -0.28, 0.08});
  add("Thigh.Rear", LeftHip, {0.07, -0.32, -0.03});
  add("Shank.Upper", LeftKnee, {0.06, -0.13, 0.02});
  add("Shank.Front", LeftKnee, {0.0, -0.20, 0.06});
  add("Shank.Rear", LeftKnee, {0.05, -0.25, -0.03});
  add("Heel", LeftAnkle, {0.0, -0.045, -0.06});
  add("Midfoot.Sup", LeftAnkle, {0.0, -0.01, 0.08});
  add("Midfoot.Lat", LeftAnkle, {0.04, -0.05, 0.06});
  add("Toe.Tip", LeftAnkle, {0.0, -0.05, 0.19});
  add("Acromium", LeftClavicle, {0.165, 0.055, 0.0});
  add("Elbow", LeftShoulder, {0.285, 0.045, 0.0});
  add("Wrist.Med", LeftElbow, {0.265, 0.0, 0.03});
  add("Wrist.Lat", LeftElbow, {0.265, 0.0, -0.03});
  add("Temple", Head, {0.075, 0.07, 0.02});
  return points;
}

/// As a laboratory writes it: millimetres, +Z up.
inline PointRecording z_up_in_mm(PointRecording recording) {
  for (Vec3& place : recording.positions) place = 1000.0 * Vec3(place.x(), -place.z(), place.y());
  recording.unit = "mm";
  recording.metres_per_unit = 0.001;
  return recording;
}

/// Random displacement with a standard deviation of about `metres` along each axis.
inline PointRecording with_noise(PointRecording recording, double metres) {
  std::uint64_t index = 0;
  for (Vec3& place : recording.positions) {
    for (int axis = 0; axis < 3; ++axis) {
      double sum = 0.0;  // of three uniform numbers: variance 1
      for (int i = 0; i < 3; ++i) sum += random_number(7, "noise", index++);
      place[axis] += metres * sum;
    }
  }
  return recording;
}

/// The same take of the mirrored person: places mirrored in x = 0, names of the sides exchanged.
inline PointRecording mirrored_points(PointRecording recording,
                                      const std::vector<VirtualPoint>& points) {
  for (Vec3& place : recording.positions) place = mirrored_place(place);
  std::vector<std::string> names = recording.points;
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = 0; b < points.size(); ++b) {
      const bool is_counterpart = a != b && points[b].joint == mirrored(points[a].joint) &&
                                  (points[b].place - mirrored_place(points[a].place)).norm() < 1e-9;
      if (is_counterpart) names[a] = points[b].name;
    }
  }
  recording.points = names;
  return recording;
}

}  // namespace mien::motion::test
