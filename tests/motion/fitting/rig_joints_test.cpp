#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "motion/fitting/fit.h"
#include "motion/fitting/virtual_points.h"
#include "motion/points/marker_sets.h"

namespace mien::motion {
namespace {

using namespace mien::motion::test;

/// The names of a rig for the joints of the body; "*" stands for the side.
struct RigNames {
  std::string rig;
  std::vector<std::pair<std::string, BodyJoint>> joints;
  std::string left;
  std::string right;
};

std::vector<RigNames> rigs() {
  return {{"Mixamo",
           {{"mixamorig:Hips", Pelvis},
            {"mixamorig:Spine", Spine},
            {"mixamorig:Spine1", Chest},
            {"mixamorig:Neck", Neck},
            {"mixamorig:Head", Head},
            {"mixamorig:*Shoulder", LeftClavicle},
            {"mixamorig:*Arm", LeftShoulder},
            {"mixamorig:*ForeArm", LeftElbow},
            {"mixamorig:*Hand", LeftWrist},
            {"mixamorig:*UpLeg", LeftHip},
            {"mixamorig:*Leg", LeftKnee},
            {"mixamorig:*Foot", LeftAnkle},
            {"mixamorig:*ToeBase", LeftToe}},
           "Left",
           "Right"},
          {"Bandai Namco",
           {{"Hips", Pelvis},
            {"Spine", Spine},
            {"Chest", Chest},
            {"Neck", Neck},
            {"Head", Head},
            {"Shoulder_*", LeftClavicle},
            {"UpperArm_*", LeftShoulder},
            {"LowerArm_*", LeftElbow},
            {"Hand_*", LeftWrist},
            {"UpperLeg_*", LeftHip},
            {"LowerLeg_*", LeftKnee},
            {"Foot_*", LeftAnkle},
            {"Toes_*", LeftToe}},
           "L",
           "R"},
          {"Acclaim",
           {{"lowerback", Spine},
            {"upperback", Chest},
            {"lowerneck", Neck},
            {"head", Head},
            {"*clavicle", LeftClavicle},
            {"*humerus", LeftShoulder},
            {"*radius", LeftElbow},
            {"*wrist", LeftWrist},
            {"*femur", LeftHip},
            {"*tibia", LeftKnee},
            {"*foot", LeftAnkle},
            {"*toes", LeftToe}},
           "l",
           "r"},
          {"Biped",
           {{"Bip01 Pelvis", Pelvis},
            {"Bip01 Spine", Spine},
            {"Bip01 Spine1", Chest},
            {"Bip01 Neck", Neck},
            {"Bip01 Head", Head},
            {"Bip01 * Clavicle", LeftClavicle},
            {"Bip01 * UpperArm", LeftShoulder},
            {"Bip01 * Forearm", LeftElbow},
            {"Bip01 * Hand", LeftWrist},
            {"Bip01 * Thigh", LeftHip},
            {"Bip01 * Calf", LeftKnee},
            {"Bip01 * Foot", LeftAnkle},
            {"Bip01 * Toe0", LeftToe}},
           "L",
           "R"},
          {"Xsens",
           {{"Hips", Pelvis},
            {"Chest", Spine},
            {"Chest2", Chest},
            {"Neck", Neck},
            {"Head", Head},
            {"*Collar", LeftClavicle},
            {"*Shoulder", LeftShoulder},
            {"*Elbow", LeftElbow},
            {"*Wrist", LeftWrist},
            {"*Hip", LeftHip},
            {"*Knee", LeftKnee},
            {"*Ankle", LeftAnkle},
            {"*Toe", LeftToe}},
           "Left",
           "Right"},
          {"Unreal",
           {{"pelvis", Pelvis},
            {"spine_01", Spine},
            {"spine_02", Chest},
            {"neck_01", Neck},
            {"head", Head},
            {"clavicle_*", LeftClavicle},
            {"upperarm_*", LeftShoulder},
            {"lowerarm_*", LeftElbow},
            {"hand_*", LeftWrist},
            {"thigh_*", LeftHip},
            {"calf_*", LeftKnee},
            {"foot_*", LeftAnkle},
            {"ball_*", LeftToe}},
           "l",
           "r"}};
}

std::vector<VirtualPoint> points_of(const RigNames& rig) {
  std::vector<VirtualPoint> points;
  for (const auto& [name, joint] : rig.joints) {
    if (name.find('*') == std::string::npos) {
      points.push_back({name, joint});
    } else {
      add_both(points, name, rig.left, rig.right, joint);
    }
  }
  return points;
}

std::vector<std::string> names_of(const std::vector<VirtualPoint>& points) {
  std::vector<std::string> names;
  for (const VirtualPoint& point : points) names.push_back(point.name);
  return names;
}

double largest_error_mm(const Clip& fitted, const Clip& walked) {
  const auto a = joint_paths(fitted);
  const auto b = joint_paths(walked);
  double most = 0.0;
  for (std::size_t frame = 0; frame < b.size(); ++frame) {
    for (int joint = 0; joint < body_joint_count; ++joint)
      most = std::max(most, 1000.0 * (a[frame][joint] - b[frame][joint]).norm());
  }
  return most;
}

TEST(RigJointPoints, AreFittedByTheNamesOfEveryRig) {
  const Clip walked = truth();
  for (const RigNames& rig : rigs()) {
    SCOPED_TRACE(rig.rig);
    const FittedMotion fitted = fit_body(recorded(walked, points_of(rig)));
    EXPECT_EQ(fitted.marker_set, "joints of a rig");
    EXPECT_LT(largest_error_mm(fitted.clip, walked), 20.0);
    for (const FittedPoint& point : fitted.points)
      EXPECT_EQ(point.use, PointUse::used) << point.name;
  }
}

TEST(RigJointPoints, OfBonesWithoutLengthDoNotTurnTheTrunk) {
  // As in the BVH files of CMU's database: the lower back begins at the hips, and the neck where
  // the uppermost joint of the spine is.
  std::vector<VirtualPoint> points = points_of(rigs().front());
  for (VirtualPoint& point : points) {
    if (point.name == "mixamorig:Spine") point = {"mixamorig:LowerBack", Pelvis};
    if (point.name == "mixamorig:Spine1") point.joint = Neck;
  }
  points.push_back({"mixamorig:Spine", Chest});
  const Clip walked = truth();
  const FittedMotion fitted = fit_body(recorded(walked, points));
  EXPECT_LT(fitted.residual_mm, 10.0);
  const auto a = joint_paths(fitted.clip);
  const auto b = joint_paths(walked);
  for (std::size_t frame = 0; frame < b.size(); ++frame) {
    for (const BodyJoint joint : {Neck, Head, LeftShoulder, RightWrist, LeftKnee, RightAnkle})
      ASSERT_LT((a[frame][joint] - b[frame][joint]).norm(), 0.03) << name_of(joint);
  }
}

TEST(RigJointPoints, KeepTheirMeaningWhereAShoulderIsAnUpperArm) {
  using Names = std::vector<std::string>;
  const Names legs = {"LeftUpLeg", "LeftLeg", "LeftFoot", "RightUpLeg", "RightLeg", "RightFoot"};
  const auto role_of = [&](Names names, const std::string& name) {
    names.insert(names.end(), legs.begin(), legs.end());
    const MarkerSet set = recognised_marker_set(names);
    EXPECT_EQ(set.name, "joints of a rig");
    return set.roles[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) -
                                              names.begin())];
  };
  const Names with_arm = {"LeftShoulder",  "LeftArm",  "LeftForeArm",
                          "RightShoulder", "RightArm", "RightForeArm"};
  EXPECT_EQ(role_of(with_arm, "LeftShoulder"), (Role{Landmark::clavicle, Side::left}));
  EXPECT_EQ(role_of(with_arm, "LeftArm"), (Role{Landmark::shoulder, Side::left}));
  const Names without_arm = {"LeftShoulder", "LeftForeArm", "RightShoulder", "RightForeArm"};
  EXPECT_EQ(role_of(without_arm, "RightShoulder"), (Role{Landmark::shoulder, Side::right}));
}

TEST(RigJointPoints, NeedTheLimbsOfBothSides) {
  for (const RigNames& rig : rigs()) {
    std::vector<std::string> names = names_of(points_of(rig));
    EXPECT_EQ(recognised_marker_set(names).name, "joints of a rig") << rig.rig;
    EXPECT_TRUE(recognised_marker_set(names).missing_parts.empty()) << rig.rig;
    const auto knee = std::find_if(rig.joints.begin(), rig.joints.end(), [](const auto& named) {
                        return named.second == LeftKnee;
                      })->first;
    std::string right = knee;
    right.replace(right.find('*'), 1, rig.right);
    std::erase(names, right);
    EXPECT_NE(recognised_marker_set(names).name, "joints of a rig") << rig.rig;
  }
}

}  // namespace
}  // namespace mien::motion
