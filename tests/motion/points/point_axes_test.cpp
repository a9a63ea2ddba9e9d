#include "motion/points/point_axes.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "motion/fitting/virtual_points.h"
#include "motion/points/marker_sets.h"

namespace mien::motion {
namespace {

using namespace mien::motion::test;

/// The recording with its axes exchanged so that its +Y becomes the axis `up` of the file.
PointRecording with_up(PointRecording recording, const std::string& up) {
  for (Vec3& p : recording.positions) {
    const double x = p.x(), y = p.y(), z = p.z();
    if (up == "+X") p = Vec3(y, -x, z);
    if (up == "-X") p = Vec3(-y, x, z);
    if (up == "-Y") p = Vec3(x, -y, -z);
    if (up == "+Z") p = Vec3(x, -z, y);
    if (up == "-Z") p = Vec3(x, z, -y);
  }
  return recording;
}

PointRecording unnamed(PointRecording recording) {
  for (std::size_t i = 0; i < recording.points.size(); ++i) {
    recording.points[i] = "p" + std::to_string(i);
  }
  return recording;
}

TEST(PointAxes, UpIsFoundByNamesAndByShape) {
  const PointRecording walked = recorded(truth(), plug_in_gait_markers());
  for (const std::string up : {"+X", "-X", "+Y", "-Y", "+Z", "-Z"}) {
    EXPECT_EQ(point_axes(with_up(walked, up)).up, up);
    EXPECT_EQ(point_axes(unnamed(with_up(walked, up))).up, up) << "without names";
  }
}

TEST(PointAxes, UpIsFoundFromLegsAlone) {
  std::vector<VirtualPoint> legs = plug_in_gait_markers();
  std::erase_if(legs, [](const VirtualPoint& point) {
    return point.joint == Chest || point.joint == Head || point.joint == LeftClavicle ||
           (point.joint >= LeftClavicle && point.joint <= RightWrist);
  });
  for (const std::string up : {"+Y", "-Z", "+X"}) {
    EXPECT_EQ(point_axes(with_up(recorded(truth(), legs), up)).up, up);
  }
}

/// Someone who stands still, turned about the left-right axis so that `+Y` of the body becomes
/// the direction (0, cos, sin), with the lowest point 2 cm above the floor, away from the origin.
PointRecording still(double degrees) {
  Clip clip = truth();
  Pose upright = clip.poses.front();
  for (Quat& rotation : upright.rotations) rotation = Quat::Identity();
  clip.poses.assign(30, upright);
  PointRecording recording = recorded(clip, plug_in_gait_markers());
  const Quat turn = exp(Vec3(degrees * radians_per_degree, 0, 0));
  double lowest = 1e9;
  for (Vec3& p : recording.positions) {
    p = turn * p;
    lowest = std::min(lowest, p.y());
  }
  for (Vec3& p : recording.positions) p += Vec3(0.5, 0.02 - lowest, 2.5);
  return recording;
}

TEST(PointAxes, WhoLiesOnTheFloorIsNotMadeToStand) {
  for (const double degrees : {90.0, -90.0}) {  // on the face, on the back
    const PointRecording lying = still(degrees);
    const PointAxes axes = point_axes(lying);
    EXPECT_EQ(axes.up, "+Y");
    EXPECT_NE(axes.note.find("lies or is upside down"), std::string::npos);
    EXPECT_EQ(point_axes(with_up(lying, "+Z")).up, "+Z");
  }
  EXPECT_EQ(point_axes(still(0.0)).up, "+Y");
  EXPECT_EQ(point_axes(still(0.0)).note, "");
}

TEST(PointAxes, WhoWalksAwayFromTheOriginDoesNotLie) {
  // A walk along +Z whose root is at the origin in the first frame: its feet are below zero.
  PointRecording walk = recorded(truth(), plug_in_gait_markers());
  const Vec3 first = walk.positions.front();
  const Quat turn(Eigen::AngleAxisd(-0.65, Vec3::UnitY()));
  for (Vec3& p : walk.positions) p = turn * (p - first) + Vec3(0, 0.5, 0.1);
  EXPECT_EQ(point_axes(walk).up, "+Y");
  EXPECT_EQ(point_axes(with_up(walk, "+Z")).up, "+Z");
}

TEST(PointAxes, WhoStandsOnTheHandsIsToldByTheFloorOfALaboratory) {
  PointRecording upside_down = still(180.0);
  EXPECT_EQ(point_axes(upside_down).up, "-Y") << "as of a camera at the height of the head";
  upside_down.format = "c3d";
  EXPECT_EQ(point_axes(upside_down).up, "+Y");
  EXPECT_EQ(point_axes(with_up(upside_down, "+Z")).up, "+Z");
  PointRecording y_down = with_up(recorded(truth(), plug_in_gait_markers()), "-Y");
  y_down.format = "c3d";
  EXPECT_EQ(point_axes(y_down).up, "-Y") << "no floor at 0 above";
}

/// Some points of the left leg and the pelvis under names that belong to no set, at a height at
/// which no floor is at 0.
PointRecording one_leg() {
  PointRecording leg = recorded(truth(), {{"toe", LeftToe, {0, 0.01, 0}},
                                          {"heel", LeftAnkle, {0, -0.05, -0.06}},
                                          {"latAnkle", LeftAnkle, {0.03, 0, 0}},
                                          {"medKnee", LeftKnee, {-0.05, 0, 0}},
                                          {"rASIS", Pelvis, {-0.12, 0.08, 0.1}},
                                          {"lPSIS", Pelvis, {0.04, 0.09, -0.1}}});
  for (Vec3& place : leg.positions) place.y() -= 0.4;
  leg.format = "trc";
  return leg;
}

TEST(PointAxes, WordsInNamesTellUpWithoutAKnownSet) {
  ASSERT_EQ(recognised_marker_set(one_leg().points).name, "");
  for (const std::string up : {"+X", "-X", "+Y", "-Y", "+Z", "-Z"}) {
    const PointAxes axes = point_axes(with_up(one_leg(), up));
    EXPECT_EQ(axes.up, up);
    EXPECT_FALSE(axes.is_up_assumed);
  }
}

TEST(PointAxes, ABodyAlongTheUsualAxisIsNotTakenToLieBecauseOfAZeroBesideIt) {
  PointRecording leg = one_leg();
  for (int frame = 0; frame < leg.frame_count(); ++frame) {
    double nearest = 1e9;
    for (int point = 0; point < leg.point_count(); ++point)
      nearest = std::min(nearest, leg.positions[leg.at(frame, point)].z());
    for (int point = 0; point < leg.point_count(); ++point)
      leg.positions[leg.at(frame, point)].z() += 0.02 - nearest;
  }
  EXPECT_EQ(point_axes(leg).up, "+Y");
  leg.format = "csv";
  EXPECT_NE(point_axes(leg).up, "+Y") << "the zero of +Z looks like a floor";
}

/// Three points that tell nothing, one below the others.
PointRecording rigid_body(const std::string& format) {
  PointRecording body = recorded(truth(), {{"marker1", Chest, {0.3, -0.6, 0}},
                                           {"marker2", Chest, {0.2, 0, 0.1}},
                                           {"marker3", Chest, {0, 0.1, -0.1}}});
  body.format = format;
  return body;
}

TEST(PointAxes, UpIsAssumedToBeThatOfTheFormatIfNothingTellsIt) {
  for (const auto& [format, up] : {std::pair{"trc", "+Y"}, std::pair{"c3d", "+Z"}}) {
    const PointAxes axes = point_axes(rigid_body(format));
    EXPECT_EQ(axes.up, up);
    EXPECT_TRUE(axes.is_up_assumed);
    EXPECT_NE(axes.note.find(std::string(up) + " is assumed, as is usual in "), std::string::npos);
  }
  const PointAxes axes = point_axes(rigid_body("bids"));
  EXPECT_TRUE(axes.is_up_assumed);
  EXPECT_NE(axes.note.find(axes.up + " is assumed."), std::string::npos);
}

TEST(PointAxes, UpIsAsTheFileStatesIfNoPointsTellIt) {
  PointRecording body = rigid_body("c3d");
  for (const std::string up : {"+X", "-X", "+Y", "-Y", "+Z", "-Z"}) {
    body.stated_up = up;
    const PointAxes axes = point_axes(body);
    EXPECT_EQ(axes.up, up);
    EXPECT_TRUE(axes.is_up_stated);
    EXPECT_FALSE(axes.is_up_assumed);
    EXPECT_EQ(axes.note, "");
    const PointRecording turned = in_metres_y_up(body);
    EXPECT_EQ(point_axes(turned).up, "+Y") << up;
  }
}

TEST(PointAxes, PointsThatContradictTheFileAreBelievedWithANote) {
  const PointRecording walked = recorded(truth(), plug_in_gait_markers());
  for (PointRecording one : {walked, unnamed(walked), one_leg()}) {
    one.format = "c3d";
    for (const std::string up : {"+X", "-X", "+Y", "-Y", "+Z", "-Z"}) {
      PointRecording turned = with_up(one, up);
      turned.stated_up = "+Y";
      const PointAxes axes = point_axes(turned);
      EXPECT_EQ(axes.up, up);
      EXPECT_FALSE(axes.is_up_stated);
      const bool is_told =
          axes.note.find("The file states that +Y is up, but its points show that " + up + " is") !=
          std::string::npos;
      EXPECT_EQ(is_told, up != "+Y") << axes.note;
    }
  }
}

TEST(PointAxes, AWalkerWithoutNamesTellsUpAgainstTheFormatAndOneWhoLiesDoesNot) {
  PointRecording walked = with_up(unnamed(recorded(truth(), plug_in_gait_markers())), "-Y");
  walked.format = "c3d";
  EXPECT_EQ(point_axes(walked).up, "-Y");
  EXPECT_FALSE(point_axes(walked).is_up_assumed);
  Clip still_walker = truth();
  still_walker.poses.assign(30, still_walker.poses.front());
  PointRecording lying = with_up(unnamed(recorded(still_walker, plug_in_gait_markers())), "+X");
  lying.format = "c3d";
  EXPECT_EQ(point_axes(lying).up, "+Z");
  EXPECT_TRUE(point_axes(lying).is_up_assumed);
}

TEST(PointAxes, BringPointsToYUpInMetresWithTheirHeading) {
  const PointRecording walked = recorded(truth(), plug_in_gait_markers());
  PointRecording turned = z_up_in_mm(walked);
  turned.seen[5] = false;
  turned.positions[5].setZero();
  const PointRecording back = in_metres_y_up(turned);
  EXPECT_EQ(back.unit, "m");
  EXPECT_EQ(back.metres_per_unit, 1.0);
  for (std::size_t at = 0; at < walked.positions.size(); ++at) {
    if (at == 5) continue;
    EXPECT_LT((back.positions[at] - walked.positions[at]).norm(), 1e-9);
  }
  EXPECT_EQ(back.positions[5], Vec3::Zero());  // missing points do not move
}

TEST(PointAxes, GuessTheUnitOfABodyOfHumanHeight) {
  for (const double metres : {1.0, 0.01, 0.001, 0.0254}) {
    PointRecording walked = recorded(truth(), plug_in_gait_markers());
    for (Vec3& place : walked.positions) place /= metres;
    walked.unit = "";
    walked.metres_per_unit = 0.0;
    const PointAxes axes = point_axes(walked);
    EXPECT_TRUE(axes.is_unit_guessed);
    EXPECT_DOUBLE_EQ(axes.metres_per_unit, metres);
    EXPECT_EQ(axes.note, "");
  }
}

TEST(PointAxes, SayThatNoUnitFits) {
  PointRecording walked = recorded(truth(), plug_in_gait_markers());
  for (Vec3& place : walked.positions) place *= 0.02;
  walked.metres_per_unit = 0.0;
  EXPECT_NE(point_axes(walked).note, "");
}

TEST(PointAxes, KeepTheFloorOfTheFileIfTheFeetAreNearIt) {
  PointRecording walked = recorded(truth(), plug_in_gait_markers());
  EXPECT_EQ(point_axes(walked).floor, 0.0);
  for (Vec3& place : walked.positions) place.y() -= 0.9;
  EXPECT_NEAR(point_axes(walked).floor, -0.9, 0.06);
  double lowest = 1.0;
  for (const Vec3& place : in_metres_y_up(walked).positions) lowest = std::min(lowest, place.y());
  EXPECT_NEAR(lowest, 0.0, 0.02);
}

TEST(PointAxes, OfNothingAreTheUsualOnes) {
  PointRecording empty;
  empty.points = {"A", "B"};
  EXPECT_EQ(point_axes(empty).up, "+Y");
  empty.positions.assign(4, Vec3::Zero());
  empty.seen.assign(4, false);
  EXPECT_EQ(point_axes(empty).up, "+Y");
}

}  // namespace
}  // namespace mien::motion
