#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/fitting/feet_without_points.h"
#include "motion/fitting/hip_origin.h"
#include "motion/fitting/recorded_points.h"
#include "motion/fitting/virtual_points.h"
#include "motion/rig/body_mapping.h"
#include "motion/rig/recording_clip.h"
#include "motion/skeleton/floor.h"
#include "motion/skeleton/sole.h"

namespace mien::motion {
namespace {

using namespace mien::motion::test;

/// The points with the middle of the hips at the origin in every frame.
PointRecording relative_to_hips(PointRecording recording, const Clip& clip) {
  const std::vector<std::vector<Vec3>> paths = joint_paths(clip);
  for (int frame = 0; frame < recording.frame_count(); ++frame) {
    const std::vector<Vec3>& joints = paths[static_cast<std::size_t>(frame)];
    const Vec3 hips = 0.5 * (joints[LeftHip] + joints[RightHip]);
    for (int point = 0; point < recording.point_count(); ++point)
      recording.positions[recording.at(frame, point)] -= hips;
  }
  return recording;
}

/// Largest difference of the heights of the pelvis, metres, less the steady one.
double largest_difference_of_heights(const Clip& a, const Clip& b) {
  std::vector<double> differences;
  for (std::size_t frame = 0; frame < a.poses.size(); ++frame)
    differences.push_back(a.poses[frame].root_position.y() - b.poses[frame].root_position.y());
  const auto [least, most] = std::minmax_element(differences.begin(), differences.end());
  return *most - *least;
}

double lowest_sole(const Clip& clip) {
  double lowest = 1.0;
  for (const std::vector<double>& heights : sole_heights(clip))
    lowest = std::min(lowest, *std::min_element(heights.begin(), heights.end()));
  return lowest;
}

bool has_note(const FittedMotion& fitted, const std::string& words) {
  return std::any_of(fitted.notes.begin(), fitted.notes.end(), [&](const std::string& note) {
    return note.find(words) != std::string::npos;
  });
}

TEST(PointsRelativeToTheHips, StandOnTheFloorInEveryFrame) {
  const Clip clip = truth();
  for (const auto& set : {media_pipe_landmarks(), smpl_joints(), human36m_joints()}) {
    SCOPED_TRACE(set.front().name);
    const PointRecording walked = recorded(clip, set);
    const FittedMotion absolute = fit_body(walked);
    const FittedMotion relative = fit_body(relative_to_hips(walked, clip));
    EXPECT_FALSE(absolute.is_relative_to_hips);
    EXPECT_FALSE(has_note(absolute, "relative to the hips"));
    EXPECT_TRUE(relative.is_relative_to_hips);
    EXPECT_TRUE(has_note(relative, "the motion is in place"));
    EXPECT_LT(largest_difference_of_heights(relative.clip, absolute.clip), 0.02);
    EXPECT_GT(lowest_sole(relative.clip), -0.01);
    for (const std::vector<double>& heights : sole_heights(relative.clip))
      EXPECT_LT(*std::min_element(heights.begin(), heights.end()), 0.01);
  }
}

TEST(PointsRelativeToTheHips, AreRaisedWithTheBodyFrameByFrame) {
  const Clip clip = truth();
  const RecordedPoints result =
      recorded_points(relative_to_hips(recorded(clip, canonical_joints()), clip));
  ASSERT_TRUE(result.fit);
  ASSERT_TRUE(result.fit->is_relative_to_hips);
  const auto paths = joint_paths(clip_of(result.recording));
  const Markers& markers = *result.recording.markers;
  for (std::size_t frame = 0; frame < paths.size(); ++frame)
    EXPECT_NEAR(markers.positions[markers.at(static_cast<int>(frame), LeftKnee)].y(),
                paths[frame][LeftKnee].y(), 0.01);
}

TEST(PointsRelativeToTheHips, AreNotThoseOfSomeoneWhoStartsAtTheOrigin) {
  PointRecording walked = recorded(truth(), canonical_joints());
  const Vec3 first = walked.positions.front();
  for (Vec3& place : walked.positions) place -= first;
  EXPECT_FALSE(fit_body(walked).is_relative_to_hips);
}

TEST(FittedMotions, StayWhereTheyAreWhenTheyAreReadAsSkeletons) {
  const Clip clip = truth();
  for (const auto& set : {plug_in_gait_markers(), media_pipe_landmarks(), human36m_joints()}) {
    SCOPED_TRACE(set.front().name);
    PointRecording points = recorded(clip, set);
    for (int frame = 0; frame < points.frame_count(); ++frame)  // as of inexact keypoints
      for (int point = 0; point < points.point_count(); ++point)
        points.positions[points.at(frame, point)].y() += 0.03 + 0.01 * std::sin(0.15 * frame);
    const FittedMotion fitted = fit_body(points);
    EXPECT_NEAR(floor_height(fitted.clip), 0.0, 2e-5);
    const Clip again = to_body(to_recording(fitted.clip));
    const auto before = joint_paths(fitted.clip);
    const auto after = joint_paths(again);
    for (std::size_t frame = 0; frame < before.size(); ++frame)
      for (const BodyJoint joint : {Pelvis, Head, LeftWrist, RightAnkle})
        EXPECT_LT((after[frame][joint] - before[frame][joint]).norm(), 1e-4);
  }
}

TEST(SmoothLifts, DoNotJerkByASingleFrame) {
  std::vector<std::vector<double>> heights(100, {-0.9, -0.5});
  heights[50] = {-1.0, -0.5};
  const std::vector<double> lifts = smooth_lifts(heights, 60.0);
  EXPECT_NEAR(lifts[20], 0.9, 0.005);
  for (std::size_t frame = 1; frame < lifts.size(); ++frame)
    EXPECT_LT(std::abs(lifts[frame] - lifts[frame - 1]), 0.02);
}

/// Pitch of a foot in each frame, degrees; 0: as flat on the floor.
std::vector<double> pitches(const Clip& clip, bool left) {
  std::vector<double> result;
  for (const SolePoints& sole : sole_paths(clip, left)) {
    const Vec3 along = sole.ball - sole.heel;
    result.push_back(std::asin(along.y() / along.norm()) / radians_per_degree);
  }
  return result;
}

TEST(FeetWithoutToes, LieFlatInStanceAndAreNeverInTheFloor) {
  const Clip clip = truth();
  const FittedMotion fitted = fit_body(recorded(clip, human36m_joints()));
  EXPECT_LT(std::abs(fitted.raised), 0.015);
  EXPECT_GT(lowest_sole(fitted.clip), -0.01);
  for (const bool left : {true, false}) {
    const std::vector<double> fitted_pitch = pitches(fitted.clip, left);
    const std::vector<SolePoints> soles = sole_paths(clip, left);
    int flat = 0;
    for (std::size_t frame = 0; frame < soles.size(); ++frame) {
      if (std::max(soles[frame].heel.y(), soles[frame].ball.y()) > 0.005) continue;
      EXPECT_NEAR(fitted_pitch[frame], 0.0, 4.0) << frame;
      ++flat;
    }
    EXPECT_GT(flat, 10);
  }
}

TEST(FeetWithoutToes, TurnSmoothly) {
  const FittedMotion fitted = fit_body(recorded(truth(), human36m_joints()));
  for (const bool left : {true, false}) {
    const std::vector<double> pitch = pitches(fitted.clip, left);
    double fastest = 0.0;
    for (std::size_t frame = 1; frame < pitch.size(); ++frame)
      fastest = std::max(fastest, std::abs(pitch[frame] - pitch[frame - 1]));
    EXPECT_LT(fastest, 10.0);  // degrees in a sixtieth of a second
  }
}

TEST(FeetWithoutToes, AreAsHighAsTheAnkleIsAboveTheFloorOfTheFile) {
  PointRecording walked = recorded(truth(), human36m_joints());
  for (Vec3& place : walked.positions) place.y() -= 0.02;
  const FittedMotion fitted = fit_body(walked);
  EXPECT_LT(std::abs(fitted.raised), 0.01);
  EXPECT_LT(ankle_height_on_floor(fitted.clip.body, true),
            ankle_height_on_floor(standard_body(), true) - 0.01);
}

TEST(FeetWithoutToes, OfSomeoneWhoKneelsArePointed) {
  Clip clip = truth();
  clip.poses.resize(30, clip.poses.front());
  for (Pose& pose : clip.poses) {
    for (Quat& rotation : pose.rotations) rotation = Quat::Identity();
    for (const BodyJoint knee : {LeftKnee, RightKnee})
      pose.rotations[knee] = exp(Vec3(95.0 * radians_per_degree, 0, 0));
    pose.root_position.y() = 0.55;
  }
  const double ankle = world_transform(clip.body, clip.poses.front(), LeftAnkle).position.y();
  for (Pose& pose : clip.poses) pose.root_position.y() += 0.06 - ankle;
  turn_foot_by_floor(clip, true);
  for (const SolePoints& sole : sole_paths(clip, true)) {
    EXPECT_GT(sole.ball.y(), -0.03);
    EXPECT_GT((sole.heel - sole.ball).z(), 0.0) << "the toes point backwards";
  }
}

}  // namespace
}  // namespace mien::motion
