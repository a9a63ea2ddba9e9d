#include "motion/points/marker_sets.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

using Names = std::vector<std::string>;

const Names plug_in_gait = {"LASI", "RASI", "LPSI", "RPSI", "LTHI", "LKNE", "LTIB", "LANK",
                            "LHEE", "LTOE", "RTHI", "RKNE", "RTIB", "RANK", "RHEE", "RTOE"};

TEST(MarkerSets, AreRecognisedByName) {
  EXPECT_EQ(recognised_marker_set(plug_in_gait).name, "Plug-in Gait");
  EXPECT_EQ(recognised_marker_set(Names{"R.ASIS", "L.ASIS", "V.Sacral", "R.Thigh.Upper"}).name,
            "OpenSim gait");
  EXPECT_EQ(recognised_marker_set(Names{"LFWT", "RFWT", "LBWT", "RBWT", "LKNE", "RKNE"}).name,
            "CMU 41 markers");
  EXPECT_EQ(recognised_marker_set(Names{"L_IAS", "R_IAS", "L_FTC", "L_FLE", "L_TAM"}).name,
            "IOR (Leardini 2007)");
  EXPECT_EQ(recognised_marker_set(Names{"LHJC", "RHJC", "LKJC", "RKJC", "LAJC", "RAJC"}).name,
            "joint centres");
  EXPECT_EQ(recognised_marker_set(Names{"SpineBase", "HipLeft", "KneeLeft", "FootLeft"}).name,
            "Kinect joints");
  EXPECT_EQ(recognised_marker_set(Names{"Hip", "Ab", "LThigh", "RThigh", "LShin", "RShin"}).name,
            "OptiTrack bones");
  EXPECT_EQ(recognised_marker_set(Names{"a", "b", "c", "d", "e"}).name, "");
  EXPECT_EQ(recognised_marker_set(Names{}).name, "");
}

TEST(MarkerSets, IgnoreCaseSeparatorsAndSubject) {
  for (const std::string before : {"Anna:", "Anna_", "Anna Smith: "}) {
    Names names;
    for (std::string name : plug_in_gait) {
      std::transform(name.begin(), name.end(), name.begin(),
                     [](char c) { return static_cast<char>(c - 'A' + 'a'); });
      names.push_back(before + name.substr(0, 1) + "_" + name.substr(1));
    }
    const MarkerSet set = recognised_marker_set(names);
    EXPECT_EQ(set.name, "Plug-in Gait") << before;
    EXPECT_EQ(set.points_of(Landmark::outer_knee, Side::left), std::vector<int>{5});
  }
}

TEST(MarkerSets, GiveEachPointItsRole) {
  const MarkerSet set =
      recognised_marker_set(Names{"LASI", "RASI", "SACR", "LKNE", "LMKNE", "LHJC", "T10", "x"});
  EXPECT_EQ(set.roles[0], (Role{Landmark::front_iliac_spine, Side::left}));
  EXPECT_EQ(set.roles[1], (Role{Landmark::front_iliac_spine, Side::right}));
  EXPECT_EQ(set.roles[2], (Role{Landmark::sacrum, Side::middle}));
  EXPECT_EQ(set.roles[3], (Role{Landmark::outer_knee, Side::left}));
  EXPECT_EQ(set.roles[4], (Role{Landmark::inner_knee, Side::left}));
  EXPECT_EQ(set.roles[5], (Role{Landmark::hip, Side::left}));
  EXPECT_EQ(set.roles[6], (Role{Landmark::back, Side::middle}));
  EXPECT_FALSE(set.roles[7].has_value());
  EXPECT_EQ(words_for(*set.roles[3]), "left outer knee");
}

TEST(MarkerSets, SayWhatIsMissing) {
  Names names = plug_in_gait;
  std::erase(names, "RKNE");
  const MarkerSet set = recognised_marker_set(names);
  EXPECT_EQ(set.missing_parts, Names{"right knee"});
  EXPECT_NE(std::find(set.missing_points.begin(), set.missing_points.end(), "RKNE"),
            set.missing_points.end());
  EXPECT_TRUE(recognised_marker_set(plug_in_gait).missing_parts.empty());
}

TEST(MarkerSets, AHipOfTheSameNameMeansWhatTheSetSays) {
  // The foot of Human3.6M is the ankle; that of SMPL is the ball of the foot.
  const MarkerSet human36m = recognised_marker_set(
      Names{"Hip", "RHip", "RKnee", "RFoot", "LHip", "LKnee", "LFoot", "Thorax", "Neck/Nose"});
  EXPECT_EQ(human36m.name, "Human3.6M joints");
  EXPECT_EQ(human36m.roles[3], (Role{Landmark::ankle, Side::right}));
  const MarkerSet smpl = recognised_marker_set(
      Names{"pelvis", "left_hip", "left_knee", "left_ankle", "left_foot", "spine1", "spine2"});
  EXPECT_EQ(smpl.name, "SMPL joints");
  EXPECT_EQ(smpl.roles[4], (Role{Landmark::toe, Side::left}));
}

}  // namespace
}  // namespace mien::motion
