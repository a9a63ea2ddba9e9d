#pragma once

#include <vector>

#include "motion/fitting/virtual_points.h"

namespace mien::motion::test {

/// OptiTrack's Baseline of 41 markers, with one marker at the side of the head.
inline std::vector<VirtualPoint> optitrack_markers() {
  std::vector<VirtualPoint> points = {
      {"HeadTop", Head, {0, 0.18, 0}},        {"HeadFront", Head, {0, 0.11, 0.1}},
      {"HeadSide", Head, {-0.078, 0.07, 0}},  {"BackTop", Chest, {0, 0.2, -0.07}},
      {"BackLeft", Chest, {0.08, 0.1, -0.1}}, {"BackRight", Chest, {-0.08, 0.06, -0.1}},
      {"Chest", Chest, {0, 0.1, 0.1}}};
  const auto add = [&](const std::string& name, BodyJoint joint, const Vec3& place) {
    add_both(points, name, "L", "R", joint, place);
  };
  add("Waist*Front", Pelvis, {0.125, 0.04, 0.07});
  add("Waist*Back", Pelvis, {0.06, 0.07, -0.095});
  add("*Thigh", LeftHip, {0.09, -0.22, 0.02});
  add("*KneeOut", LeftHip, {0.058, -0.43, 0.0});
  add("*Shin", LeftKnee, {0.07, -0.20, 0.02});
  add("*AnkleOut", LeftKnee, {0.042, -0.42, 0.0});
  add("*Heel", LeftAnkle, {0.0, -0.045, -0.06});
  add("*ToeIn", LeftAnkle, {-0.03, -0.045, 0.135});
  add("*ToeOut", LeftAnkle, {0.04, -0.05, 0.11});
  add("*ToeTip", LeftAnkle, {0.0, -0.05, 0.19});
  add("*ShoulderTop", LeftClavicle, {0.165, 0.055, 0.0});
  add("*ShoulderBack", Chest, {0.12, 0.12, -0.09});
  add("*UArmHigh", LeftShoulder, {0.12, 0.05, 0.0});
  add("*ElbowOut", LeftShoulder, {0.285, 0.045, 0.0});
  add("*WristIn", LeftElbow, {0.265, 0.0, 0.035});
  add("*WristOut", LeftElbow, {0.265, 0.0, -0.035});
  add("*HandOut", LeftWrist, {0.08, 0.01, -0.03});
  return points;
}

/// The set of Qualisys for sports.
inline std::vector<VirtualPoint> qualisys_markers() {
  std::vector<VirtualPoint> points = {{"Q_HeadFront", Head, {0, 0.11, 0.1}},
                                      {"Q_SpineThoracic2", Chest, {0, 0.2, -0.07}},
                                      {"Q_SpineThoracic12", Chest, {0, -0.02, -0.1}},
                                      {"Q_Chest", Chest, {0, 0.16, 0.07}},
                                      {"Q_WaistBack", Pelvis, {0, 0.07, -0.1}}};
  const auto add = [&](const std::string& name, BodyJoint joint, const Vec3& place) {
    add_both(points, "Q_" + name, "L", "R", joint, place);
  };
  add("Head*", Head, {0.078, 0.07, 0.02});
  add("Waist*Front", Pelvis, {0.125, 0.04, 0.07});
  add("Waist*", Pelvis, {0.15, 0.06, 0.0});
  add("*ThighFrontLow", LeftHip, {0.0, -0.3, 0.07});
  add("*KneeOut", LeftHip, {0.058, -0.43, 0.0});
  add("*KneeIn", LeftHip, {-0.058, -0.43, 0.0});
  add("*ShinFrontHigh", LeftKnee, {0.0, -0.1, 0.05});
  add("*AnkleOut", LeftKnee, {0.042, -0.42, 0.0});
  add("*AnkleIn", LeftKnee, {-0.042, -0.42, 0.0});
  add("*HeelBack", LeftAnkle, {0.0, -0.045, -0.06});
  add("*Forefoot2", LeftAnkle, {0.0, -0.04, 0.13});
  add("*Forefoot5", LeftAnkle, {0.04, -0.05, 0.11});
  add("*ShoulderTop", LeftClavicle, {0.165, 0.055, 0.0});
  add("*Arm", LeftShoulder, {0.12, 0.05, 0.0});
  add("*ElbowOut", LeftShoulder, {0.285, 0.04, 0.0});
  add("*ElbowIn", LeftShoulder, {0.285, -0.04, 0.0});
  add("*WristIn", LeftElbow, {0.265, 0.0, 0.035});
  add("*WristOut", LeftElbow, {0.265, 0.0, -0.035});
  add("*Hand2", LeftWrist, {0.08, 0.015, 0.0});
  return points;
}

/// OpenCap's estimated markers, beside the keypoints of the same file, which have other names.
inline std::vector<VirtualPoint> opencap_markers() {
  std::vector<VirtualPoint> points = {{"Neck", Chest, {0, 0.18, 0}},
                                      {"midHip", Pelvis, {0, -0.03, 0}},
                                      {"C7_study", Chest, {0, 0.22, -0.06}}};
  add_limbs(points, "*", "", "L", "R");
  const auto add = [&](const std::string& name, BodyJoint joint, const Vec3& place) {
    add_both(points, "*" + name + "_study", "L", "r", joint, place);
  };
  add_both(points, "*HJC_study", "L", "R", LeftHip);
  add(".ASIS", Pelvis, {0.125, 0.04, 0.07});
  add(".PSIS", Pelvis, {0.045, 0.07, -0.095});
  add("_thigh1", LeftHip, {0.08, -0.20, 0.02});
  add("_thigh2", LeftHip, {0.02, -0.28, 0.08});
  add("_thigh3", LeftHip, {0.07, -0.32, -0.03});
  add("_knee", LeftHip, {0.055, -0.43, 0.0});
  add("_mknee", LeftHip, {-0.055, -0.43, 0.0});
  add("_sh1", LeftKnee, {0.06, -0.13, 0.02});
  add("_sh2", LeftKnee, {0.0, -0.20, 0.06});
  add("_sh3", LeftKnee, {0.05, -0.25, -0.03});
  add("_ankle", LeftKnee, {0.038, -0.42, 0.0});
  add("_mankle", LeftKnee, {-0.038, -0.42, 0.0});
  add("_calc", LeftAnkle, {0.0, -0.045, -0.06});
  add("_toe", LeftAnkle, {0.0, -0.04, 0.13});
  add("_5meta", LeftAnkle, {0.04, -0.05, 0.11});
  add("_shoulder", LeftClavicle, {0.165, 0.055, 0.0});
  add("_lelbow", LeftShoulder, {0.285, 0.04, 0.0});
  add("_melbow", LeftShoulder, {0.285, -0.04, 0.0});
  add("_lwrist", LeftElbow, {0.265, 0.0, 0.03});
  add("_mwrist", LeftElbow, {0.265, 0.0, -0.03});
  return points;
}

inline std::vector<VirtualPoint> halpe_26_keypoints() {
  std::vector<VirtualPoint> points = {
      {"Neck", Chest, {0, 0.18, 0}}, {"Hip", Pelvis, {0, -0.03, 0}}, {"Head", Head, {0, 0.17, 0}}};
  add_face(points, "Nose", "*Eye", "*Ear", "L", "R");
  add_limbs(points, "*", "", "L", "R");
  add_both(points, "*BigToe", "L", "R", LeftToe, {0, 0, 0.06});
  add_both(points, "*SmallToe", "L", "R", LeftToe, {0.04, 0, 0.02});
  add_both(points, "*Heel", "L", "R", LeftAnkle, {0, -0.06, -0.045});
  return points;
}

}  // namespace mien::motion::test
