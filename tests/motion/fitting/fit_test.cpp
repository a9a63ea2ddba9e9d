#include "motion/fitting/fit.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/fitting/virtual_marker_sets.h"
#include "motion/gait/contact.h"
#include "motion/procedural/expressive_walks.h"
#include "motion/refusal.h"
#include "motion/skeleton/sole.h"

namespace mien::motion {
namespace {

using namespace mien::motion::test;
using mien::test::refusal_of;

const std::vector<BodyJoint>& limb_joints() {
  static const std::vector<BodyJoint> joints = {LeftHip,    LeftKnee,      LeftAnkle,  LeftShoulder,
                                                LeftElbow,  LeftWrist,     RightHip,   RightKnee,
                                                RightAnkle, RightShoulder, RightElbow, RightWrist};
  return joints;
}

/// Root mean square distance of a joint between two clips, millimetres.
double joint_error_mm(const Clip& fitted, const Clip& truth, BodyJoint joint) {
  const auto a = joint_paths(fitted);
  const auto b = joint_paths(truth);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i][joint] - b[i][joint]).squaredNorm();
  return 1000.0 * std::sqrt(sum / static_cast<double>(a.size()));
}

/// Root mean square angle between world rotations, degrees.
double turn_error_deg(const Clip& fitted, const Clip& truth, BodyJoint joint) {
  double sum = 0.0;
  for (std::size_t i = 0; i < fitted.poses.size(); ++i) {
    const Quat a = world_transforms(fitted.body, fitted.poses[i]).rotations[joint];
    const Quat b = world_transforms(truth.body, truth.poses[i]).rotations[joint];
    const double angle = angle_between(a, b) / radians_per_degree;
    sum += angle * angle;
  }
  return std::sqrt(sum / static_cast<double>(fitted.poses.size()));
}

/// The largest turn of a joint from one frame to the next, degrees; toes, which straighten at once
/// when they leave the floor, do not count.
double largest_jump_deg(const Clip& clip) {
  double most = 0.0;
  for (std::size_t i = 1; i < clip.poses.size(); ++i) {
    for (int joint = 0; joint < body_joint_count; ++joint) {
      if (joint == LeftToe || joint == RightToe) continue;
      most = std::max(
          most, angle_between(clip.poses[i - 1].rotations[joint], clip.poses[i].rotations[joint]) /
                    radians_per_degree);
    }
  }
  return most;
}

void expect_joints_near(const Clip& fitted, const Clip& truth, double mm) {
  ASSERT_EQ(fitted.frame_count(), truth.frame_count());
  for (const BodyJoint joint : limb_joints()) {
    EXPECT_LT(joint_error_mm(fitted, truth, joint), mm) << name_of(joint);
  }
}

void expect_same_motion(const Clip& a, const Clip& b, double mm, double degrees) {
  ASSERT_EQ(a.frame_count(), b.frame_count());
  for (int joint = 0; joint < body_joint_count; ++joint) {
    EXPECT_LT(joint_error_mm(a, b, BodyJoint(joint)), mm) << name_of(BodyJoint(joint));
    EXPECT_LT(turn_error_deg(a, b, BodyJoint(joint)), degrees) << name_of(BodyJoint(joint));
  }
}

bool mentions(const std::vector<std::string>& sentences, const std::string& words) {
  return std::any_of(sentences.begin(), sentences.end(), [&](const std::string& sentence) {
    return sentence.find(words) != std::string::npos;
  });
}

struct KnownSet {
  const char* name;
  std::vector<VirtualPoint> points;
  double mm;
};

std::vector<KnownSet> all_sets() {
  return {{"canonical body", canonical_joints(), 5.0},
          {"SMPL joints", smpl_joints(), 5.0},
          {"Human3.6M joints", human36m_joints(), 15.0},
          {"BODY_25 keypoints", body_25_keypoints(), 15.0},
          {"Kinect joints", kinect_joints(), 15.0},
          {"MediaPipe landmarks", media_pipe_landmarks(), 15.0},
          {"Plug-in Gait", plug_in_gait_markers(), 30.0},
          {"CMU 41 markers", cmu_markers(), 30.0},
          {"IOR (Leardini 2007)", rizzoli_markers(), 30.0},
          {"OpenSim gait", cluster_markers(), 30.0},
          {"OptiTrack markers", optitrack_markers(), 30.0},
          {"Qualisys markers", qualisys_markers(), 30.0},
          {"OpenCap", opencap_markers(), 30.0},
          {"HALPE_26 keypoints", halpe_26_keypoints(), 15.0}};
}

TEST(Fit, FindsTheJointsOfAWalkInEverySet) {
  const Clip walked = truth();
  for (const KnownSet& set : all_sets()) {
    SCOPED_TRACE(set.name);
    const FittedMotion fitted = fit_body(recorded(walked, set.points));
    EXPECT_EQ(fitted.marker_set, set.name);
    expect_joints_near(fitted.clip, walked, set.mm);
    EXPECT_LT(std::abs(fitted.raised), 0.03);
    EXPECT_LT(fitted.residual_mm, 15.0);
    for (const FittedPoint& point : fitted.points) {
      const bool is_keypoint =
          std::string_view(set.name) == "OpenCap" && !point.name.ends_with("_study");
      EXPECT_EQ(point.use, is_keypoint ? PointUse::unknown : PointUse::used) << point.name;
    }
  }
}

TEST(Fit, FindsTheRotationsOfAWalk) {
  const Clip walked = truth();
  for (const KnownSet& set : all_sets()) {
    SCOPED_TRACE(set.name);
    const bool is_whole = set.mm < 10.0;  // spine and neck are there, so that nothing is assumed
    const FittedMotion fitted = fit_body(recorded(walked, set.points));
    const auto expect_turn = [&](BodyJoint joint, double degrees) {
      EXPECT_LT(turn_error_deg(fitted.clip, walked, joint), degrees) << name_of(joint);
    };
    expect_turn(Pelvis, is_whole ? 1.0 : 8.0);
    expect_turn(Chest, is_whole ? 2.0 : 6.0);
    for (const BodyJoint joint : {LeftHip, RightHip, LeftKnee, RightKnee}) {
      expect_turn(joint, is_whole ? 4.0 : 8.0);
    }
    for (const BodyJoint joint : {LeftShoulder, RightShoulder}) expect_turn(joint, 12.0);
    if (std::string(set.name) == "Human3.6M joints") continue;  // no feet
    for (const BodyJoint joint : {LeftAnkle, RightAnkle}) expect_turn(joint, 10.0);
  }
}

TEST(Fit, MeasuresResidualsOnSeenPointsOnly) {
  PointRecording points = recorded(truth(), canonical_joints());
  for (int frame = 0; frame < points.frame_count(); ++frame) {
    const bool is_hidden = (frame >= 20 && frame < 26) || (frame >= 40 && frame < 90);
    if (!is_hidden) continue;
    points.seen[points.at(frame, LeftWrist)] = false;
    points.positions[points.at(frame, LeftWrist)] = Vec3::Zero();
  }
  const FittedMotion fitted = fit_body(points);
  const FittedPoint& wrist = fitted.points[LeftWrist];
  EXPECT_EQ(wrist.gaps, (std::vector<PointGap>{{20, 26, true}, {40, 90, false}}));
  EXPECT_EQ(fitted.points[RightWrist].gaps, std::vector<PointGap>());
  EXPECT_DOUBLE_EQ(wrist.filled_share, 6.0 / points.frame_count());
  EXPECT_DOUBLE_EQ(wrist.missing_share, 56.0 / points.frame_count());
  // The root mean square of all frames is that of all points, each with its number of frames.
  ASSERT_EQ(fitted.frame_residual_mm.size(), fitted.clip.poses.size());
  double by_frames = 0.0, by_points = 0.0;
  int count = 0;
  for (std::size_t frame = 0; frame < fitted.clip.poses.size(); ++frame) {
    int seen = 0;
    for (std::size_t point = 0; point < points.points.size(); ++point)
      seen += points.seen[points.at(static_cast<int>(frame), static_cast<int>(point))] ? 1 : 0;
    by_frames += seen * std::pow(fitted.frame_residual_mm[frame].value_or(0.0), 2);
    count += seen;
  }
  for (const FittedPoint& point : fitted.points) {
    const double frames = (1.0 - point.missing_share) * points.frame_count();
    by_points += frames * std::pow(point.residual_mm, 2);
  }
  EXPECT_NEAR(std::sqrt(by_frames / count), fitted.residual_mm, 1e-9);
  EXPECT_NEAR(std::sqrt(by_points / count), fitted.residual_mm, 1e-9);
}

/// The walk in Plug-in Gait markers, the outer left knee's far away in some frames.
FittedMotion with_far_knee(int first, int last) {
  PointRecording points = recorded(truth(), plug_in_gait_markers());
  const auto knee =
      static_cast<int>(std::ranges::find(points.points, "LKNE") - points.points.begin());
  for (int frame = first; frame <= last; ++frame)
    points.positions[points.at(frame, knee)] += Vec3(0.15, 0.2, 0.15);
  return fit_body(points);
}

TEST(Fit, IsHardlyDrawnAwayByAPointThatJumps) {
  const Clip walked = truth();
  const auto paths = joint_paths(walked);
  const FittedMotion fitted = with_far_knee(40, 49);
  const auto found = joint_paths(fitted.clip);
  for (std::size_t frame = 40; frame < 50; ++frame) {
    for (const BodyJoint joint : {LeftHip, LeftAnkle, RightHip, RightKnee, RightAnkle})
      EXPECT_LT((found[frame][joint] - paths[frame][joint]).norm(), 0.05)
          << name_of(joint) << ' ' << frame;
  }
}

TEST(Fit, DoesNotRelyOnTheFirstFrame) {
  const FittedMotion fitted = with_far_knee(0, 0);
  EXPECT_LT(fitted.residual_mm, 15.0);
  expect_joints_near(fitted.clip, truth(), 35.0);
}

TEST(Fit, KeepsEveryStyleOfWalk) {
  for (const WalkStyle& style : {happy_walk(), sad_walk(), proud_walk(), tired_walk()}) {
    const Clip smaller = truth(style, 100.0, standard_female_body(1.62));
    expect_joints_near(fit_body(recorded(smaller, smpl_joints())).clip, smaller, 6.0);
    const Clip walked = truth(style, 100.0);
    expect_joints_near(fit_body(recorded(walked, plug_in_gait_markers())).clip, walked, 35.0);
  }
}

TEST(Fit, ReadsBoneLengthsFromThePoints) {
  const Clip walked = truth({}, 60.0, standard_body(1.60));
  const Skeleton body = fit_body(recorded(walked, smpl_joints())).clip.body;
  for (int joint = 1; joint < body_joint_count; ++joint) {
    EXPECT_NEAR(body.joints[joint].offset.norm(), walked.body.joints[joint].offset.norm(), 0.005)
        << body.joints[joint].name;
  }
}

TEST(Fit, DoesNotDependOnUnitAndAxes) {
  const PointRecording points = recorded(truth(), plug_in_gait_markers());
  const Clip expected = fit_body(points).clip;
  const FittedMotion fitted = fit_body(z_up_in_mm(points));
  EXPECT_EQ(fitted.axes.up, "+Z");
  expect_same_motion(fitted.clip, expected, 0.01, 0.01);
  PointRecording without_unit = z_up_in_mm(points);
  without_unit.unit = "";
  without_unit.metres_per_unit = 0.0;
  const FittedMotion guessed = fit_body(without_unit);
  EXPECT_TRUE(guessed.axes.is_unit_guessed);
  expect_same_motion(guessed.clip, expected, 0.01, 0.01);
}

TEST(Fit, TurnsWithThePoints) {
  const std::vector<VirtualPoint> points = plug_in_gait_markers();
  const Clip walked = truth();
  const Quat turn(Eigen::AngleAxisd(2.1, Vec3::UnitY()));
  const auto turned = [&](Clip clip) {
    for (Pose& pose : clip.poses) {
      pose.root_position = turn * pose.root_position;
      pose.rotations[Pelvis] = turn * pose.rotations[Pelvis];
    }
    return clip;
  };
  const Clip expected = turned(fit_body(recorded(walked, points)).clip);
  expect_same_motion(fit_body(recorded(turned(walked), points)).clip, expected, 0.01, 0.01);
}

TEST(Fit, MirrorsWithThePoints) {
  for (const auto& points : {plug_in_gait_markers(), smpl_joints(), media_pipe_landmarks()}) {
    const PointRecording seen = recorded(truth(), points);
    const Clip expected = mirrored(fit_body(seen).clip);
    const FittedMotion fitted = fit_body(mirrored_points(seen, points));
    EXPECT_FALSE(mentions(fitted.warnings, "backwards"));
    expect_same_motion(fitted.clip, expected, 0.5, 0.5);
  }
}

TEST(Fit, SaysThatTheSidesAreExchanged) {
  PointRecording points = recorded(truth(), plug_in_gait_markers());
  EXPECT_FALSE(mentions(fit_body(points).warnings, "backwards"));
  for (Vec3& place : points.positions) place.x() = -place.x();
  EXPECT_TRUE(mentions(fit_body(points).warnings, "backwards"));
}

TEST(Fit, WithstandsNoise) {
  const Clip walked = truth();
  const PointRecording joints = with_noise(recorded(walked, smpl_joints()), 0.005);
  const FittedMotion fitted = fit_body(joints);
  expect_joints_near(fitted.clip, walked, 15.0);
  EXPECT_LT(largest_jump_deg(fitted.clip), 40.0);
  EXPECT_GT(fitted.residual_mm, 2.0);
  const PointRecording noisy = with_noise(recorded(walked, plug_in_gait_markers()), 0.005);
  expect_joints_near(fit_body(noisy).clip, walked, 35.0);
}

TEST(Fit, DoesNotFlipBetweenFrames) {
  for (const KnownSet& set : all_sets()) {
    SCOPED_TRACE(set.name);
    const Clip walked = truth(excited_walk());
    EXPECT_LT(largest_jump_deg(fit_body(recorded(walked, set.points)).clip),
              largest_jump_deg(walked) + 8.0);
  }
}

TEST(Fit, SurvivesGaps) {
  const Clip walked = truth();
  PointRecording points = recorded(walked, plug_in_gait_markers());
  for (int point = 0; point < points.point_count(); ++point) {
    // A gap of 0.15 s at a place of its own, and one of half a second for a few markers.
    const int length = point % 9 == 0 ? 30 : 9;
    const int start = 10 + (point * 17) % (points.frame_count() - 50);
    for (int frame = start; frame < start + length; ++frame) {
      points.positions[points.at(frame, point)].setZero();
      points.seen[points.at(frame, point)] = false;
    }
  }
  const FittedMotion fitted = fit_body(points);
  expect_joints_near(fitted.clip, walked, 40.0);
  EXPECT_LT(largest_jump_deg(fitted.clip), 25.0);
  EXPECT_GT(fitted.points[1].filled_share, 0.05);
  EXPECT_EQ(fitted.points[0].filled_share, 0.0);  // too long
}

TEST(Fit, LeavesOutFramesWithoutThePelvis) {
  const Clip walked = truth();
  PointRecording points = recorded(walked, smpl_joints());
  for (int frame = 0; frame < points.frame_count(); ++frame) {
    if (frame >= 12 && frame < points.frame_count() - 5) continue;
    for (int point = 0; point < points.point_count(); ++point) {
      points.positions[points.at(frame, point)].setZero();
      points.seen[points.at(frame, point)] = false;
    }
  }
  const FittedMotion fitted = fit_body(points);
  EXPECT_EQ(fitted.first_frame, 12);
  EXPECT_EQ(fitted.clip.frame_count(), points.frame_count() - 17);
  EXPECT_TRUE(mentions(fitted.notes, "frames 12 to"));
  const Vec3 root = fitted.clip.poses.front().root_position;
  EXPECT_LT((root - walked.poses[12].root_position).norm(), 0.01);
}

TEST(Fit, ArmsWithoutPointsHangWithAWarning) {
  const Clip walked = truth();
  std::vector<VirtualPoint> points = plug_in_gait_markers();
  std::erase_if(points, [](const VirtualPoint& point) {
    return point.joint == LeftShoulder || point.joint == LeftElbow || point.joint == LeftWrist;
  });
  const FittedMotion fitted = fit_body(recorded(walked, points));
  EXPECT_TRUE(mentions(fitted.warnings, "left arm"));
  EXPECT_FALSE(mentions(fitted.warnings, "right arm"));
  for (const std::vector<Vec3>& joints : joint_paths(fitted.clip)) {
    EXPECT_LT(joints[LeftWrist].y(), joints[LeftShoulder].y() - 0.4);
  }
  EXPECT_LT(joint_error_mm(fitted.clip, walked, RightWrist), 30.0);
}

TEST(Fit, StandsOnTheFloor) {
  for (const auto& points : {plug_in_gait_markers(), smpl_joints(), rizzoli_markers()}) {
    PointRecording seen = recorded(truth(), points);
    for (Vec3& place : seen.positions) place.y() -= 0.93;  // as with the pelvis at the origin
    const FittedMotion fitted = fit_body(seen);
    double lowest = 1.0;
    for (const bool left : {true, false}) {
      for (const SolePoints& sole : sole_paths(fitted.clip, left)) {
        lowest = std::min(lowest, std::min(sole.heel.y(), sole.ball.y()));
      }
    }
    EXPECT_NEAR(lowest, 0.0, 0.04);
    EXPECT_GE(foot_plants(fitted.clip).size(), 3u);
  }
}

TEST(Fit, TellsWhichMarkerIsFarFromTheBody) {
  PointRecording points = recorded(truth(), plug_in_gait_markers());
  const int knee = 8;
  ASSERT_EQ(points.points[knee + 2], "LKNE");
  for (int frame = 0; frame < points.frame_count(); ++frame) {
    // As when the names of two markers are exchanged in every other second.
    if ((frame / 20) % 2 == 0) continue;
    points.positions[points.at(frame, knee)].y() += 0.20;
  }
  const FittedMotion fitted = fit_body(points);
  EXPECT_TRUE(mentions(fitted.warnings, points.points[knee]));
  EXPECT_GT(fitted.points[knee].residual_mm, 40.0);
}

TEST(Fit, ResidualsAreTheDistancesOfThePoints) {
  const FittedMotion exact = fit_body(recorded(truth(), smpl_joints()));
  EXPECT_LT(exact.residual_mm, 3.0);
  ASSERT_EQ(static_cast<int>(exact.frame_residual_mm.size()), exact.clip.frame_count());
  const FittedMotion noisy = fit_body(with_noise(recorded(truth(), smpl_joints()), 0.005));
  EXPECT_NEAR(noisy.residual_mm, 5.0 * std::sqrt(3.0), 4.0);
}

TEST(Fit, RefusesUnknownPoints) {
  PointRecording points = recorded(truth(), canonical_joints());
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    points.points[i] = "marker" + std::to_string(i);
  }
  const std::string words = refusal_of([&] { fit_body(points); });
  EXPECT_NE(words.find("marker0"), std::string::npos) << words;
  EXPECT_NE(words.find("figure: markers"), std::string::npos) << words;
}

TEST(Fit, RefusesPointsWithoutLegs) {
  std::vector<VirtualPoint> points = plug_in_gait_markers();
  std::erase_if(points, [](const VirtualPoint& point) { return point.name == "RKNE"; });
  const std::string words = refusal_of([&] { fit_body(recorded(truth(), points)); });
  EXPECT_NE(words.find("right knee"), std::string::npos) << words;
  EXPECT_NE(words.find("LKNE"), std::string::npos) << words;
}

TEST(Fit, RefusesPointsThatAreNeverSeen) {
  PointRecording points = recorded(truth(), plug_in_gait_markers());
  for (int frame = 0; frame < points.frame_count(); ++frame) {
    for (int point = 0; point < points.point_count(); ++point) {
      if (points.points[static_cast<std::size_t>(point)] != "LANK") continue;
      points.positions[points.at(frame, point)].setZero();
      points.seen[points.at(frame, point)] = false;
    }
  }
  const std::string words = refusal_of([&] { fit_body(points); });
  EXPECT_NE(words.find("LeftAnkle"), std::string::npos) << words;
}

TEST(Fit, FitsASingleFrame) {
  Clip still = truth();
  still.poses.resize(1);
  const FittedMotion fitted = fit_body(recorded(still, smpl_joints()));
  EXPECT_EQ(fitted.clip.frame_count(), 1);
  EXPECT_LT(joint_error_mm(fitted.clip, still, LeftKnee), 200.0);
}

}  // namespace
}  // namespace mien::motion
