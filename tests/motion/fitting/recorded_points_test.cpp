#include "motion/fitting/recorded_points.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "motion/fitting/virtual_points.h"
#include "motion/refusal.h"
#include "motion/rig/body_mapping.h"
#include "motion/rig/recording_clip.h"
#include "motion/skeleton/clip_markers.h"

namespace mien::motion {
namespace {

using namespace mien::motion::test;
using mien::test::refusal_of;

/// The same points as a laboratory with Z up and millimetres stores them.
PointRecording in_mm_z_up(PointRecording recording) {
  for (Vec3& position : recording.positions)
    position = 1000.0 * Vec3(position.x(), -position.z(), position.y());
  recording.unit = "mm";
  recording.metres_per_unit = 0.001;
  return recording;
}

void hide(PointRecording& recording, int point, int first, int last) {
  for (int frame = first; frame <= last; ++frame) {
    recording.seen[recording.at(frame, point)] = false;
    recording.positions[recording.at(frame, point)] = Vec3::Zero();
  }
}

/// Largest distance of a seen marker, named as a joint, from this joint of the clip, metres.
double largest_distance(const Clip& clip, const Markers& markers) {
  const auto paths = joint_paths(clip);
  double largest = 0.0;
  for (int frame = 0; frame < markers.frame_count(); ++frame)
    for (int joint : {LeftHip, LeftKnee, LeftAnkle, RightElbow, RightWrist})
      largest = std::max(largest,
                         (markers.positions[markers.at(frame, joint)] -
                          paths[static_cast<std::size_t>(frame)][static_cast<std::size_t>(joint)])
                             .norm());
  return largest;
}

TEST(RecordedPoints, LieOnTheClipThatWasFittedToThem) {
  const PointRecording points = in_mm_z_up(recorded(truth(), canonical_joints()));
  const RecordedPoints result = recorded_points(points);
  ASSERT_TRUE(result.fit);
  const Clip clip = clip_of(result.recording);
  const Markers* markers = markers_of(clip);
  ASSERT_NE(markers, nullptr);
  EXPECT_EQ(markers->points, points.points);
  EXPECT_EQ(markers->frame_count(), clip.frame_count());
  EXPECT_LT(largest_distance(clip, *markers), 0.015);
  // Neither unit nor axes nor floor are found a second time.
  const BodyMapping mapping = recognise(result.recording);
  EXPECT_EQ(mapping.metres_per_unit, 1.0);
  EXPECT_EQ(mapping.up, "+Y");
  EXPECT_LT((joint_paths(clip)[7][LeftKnee] - joint_paths(result.fit->clip)[7][LeftKnee]).norm(),
            1e-9);
}

TEST(RecordedPoints, AreRaisedToTheFloorWithTheBody) {
  PointRecording points = recorded(truth(), canonical_joints());
  for (Vec3& position : points.positions) position.y() += 0.06;  // still about the file's floor
  const RecordedPoints result = recorded_points(points);
  ASSERT_TRUE(result.fit);
  ASSERT_NEAR(result.fit->raised, -0.06, 0.02);
  const auto paths = joint_paths(clip_of(result.recording));
  const Markers& markers = *result.recording.markers;
  double above = 0.0;
  for (std::size_t frame = 0; frame < paths.size(); ++frame)
    above += markers.positions[markers.at(static_cast<int>(frame), LeftHip)].y() -
             paths[frame][LeftHip].y();
  EXPECT_NEAR(above / static_cast<double>(paths.size()), 0.0, 0.005);
}

TEST(RecordedPoints, OfAChildKeepTheirSize) {
  const Clip child = truth({}, 60.0, standard_body(1.0));
  const Clip clip = clip_of(recorded_points(recorded(child, canonical_joints())).recording);
  EXPECT_NEAR(standing_height(clip.body), standing_height(child.body), 0.03);
}

TEST(RecordedPoints, AreFilledInShortGapsAndDarkInLongOnes) {
  PointRecording points = recorded(truth(), canonical_joints());
  hide(points, LeftWrist, 20, 25);
  hide(points, RightWrist, 20, 60);
  const Markers markers = *recorded_points(points).recording.markers;
  const std::size_t brief = markers.at(22, LeftWrist), long_one = markers.at(40, RightWrist);
  EXPECT_FALSE(markers.seen[brief]);
  EXPECT_TRUE(markers.filled[brief]);
  EXPECT_FALSE(markers.seen[long_one]);
  EXPECT_FALSE(markers.filled[long_one]);
  EXPECT_EQ(markers.positions[long_one], Vec3::Zero());
}

TEST(RecordedPoints, BeginWithTheClip) {
  PointRecording points = recorded(truth(), canonical_joints());
  for (const int joint : {Pelvis, LeftHip, RightHip, Spine}) hide(points, joint, 0, 9);
  const RecordedPoints result = recorded_points(points);
  ASSERT_TRUE(result.fit);
  EXPECT_EQ(result.fit->first_frame, 10);
  const Clip clip = clip_of(result.recording);
  ASSERT_NE(markers_of(clip), nullptr);
  EXPECT_LT(largest_distance(clip, *markers_of(clip)), 0.02);
}

TEST(RecordedPoints, ThatCannotBeFittedAreShownAlone) {
  PointRecording points = recorded(truth(), canonical_joints());
  for (std::size_t i = 0; i < points.points.size(); ++i)
    points.points[i] = "rigid body " + std::to_string(i);
  const RecordedPoints result = recorded_points(points);
  EXPECT_FALSE(result.fit);
  EXPECT_FALSE(result.rejection.empty());
  EXPECT_EQ(result.recording.skeleton.size(), 1);
  EXPECT_NE(result.recording.notes.back().find("cannot be fitted"), std::string::npos);
  const Clip clip = clip_of(result.recording);
  const Markers* markers = markers_of(clip);
  ASSERT_NE(markers, nullptr);
  EXPECT_EQ(markers->point_count(), points.point_count());
  EXPECT_NE(refusal_of([&] { recognise(result.recording); }), "");
}

// A body of the points of two people would be nobody's.
TEST(RecordedPoints, OfSeveralPeopleGiveTheBodyOfOne) {
  const PointRecording alone = recorded(truth(), canonical_joints());
  PointRecording both = alone;
  both.subjects = {"Cane", "Ann", "Bo"};
  both.points = {"Cane:tip"};
  both.positions.clear();
  for (const char* person : {"Ann:", "Bo:"})
    for (const std::string& point : alone.points) both.points.push_back(person + point);
  const auto count = static_cast<std::size_t>(alone.point_count());
  for (int frame = 0; frame < alone.frame_count(); ++frame) {
    both.positions.push_back(Vec3::UnitX());
    const auto first = alone.positions.begin() + static_cast<long>(alone.at(frame, 0));
    both.positions.insert(both.positions.end(), first, first + static_cast<long>(count));
    for (std::size_t i = 0; i < count; ++i)
      both.positions.push_back(*(first + static_cast<long>(i)) + Vec3(0.0, 0.0, 3.0));
  }
  both.seen.assign(both.positions.size(), true);
  const RecordedPoints result = recorded_points(both);
  ASSERT_TRUE(result.fit);
  EXPECT_LT(result.fit->residual_mm, 10.0);
  const Clip clip = clip_of(result.recording), of_ann = clip_of(recorded_points(alone).recording);
  EXPECT_LT((clip.poses[5].root_position - of_ann.poses[5].root_position).norm(), 1e-9);
  EXPECT_EQ(markers_of(clip)->points, both.points);
  ASSERT_EQ(result.fit->points.size(), both.points.size());
  EXPECT_EQ(result.fit->points[0].use, PointUse::unknown);
  EXPECT_EQ(result.fit->points[1].use, PointUse::used);
  EXPECT_EQ(result.fit->points[1].name, "Ann:" + alone.points[0]);
  const auto told = std::ranges::find_if(result.recording.notes, [](const std::string& note) {
    return note.find("The body is fitted to the points of \"Ann\", one of 3 people") !=
           std::string::npos;
  });
  EXPECT_NE(told, result.recording.notes.end());
}

TEST(RecordedPoints, WithoutFramesAreRefused) {
  PointRecording nothing;
  nothing.name = "empty";
  EXPECT_NE(refusal_of([&] { recorded_points(nothing); }).find("empty"), std::string::npos);
}

}  // namespace
}  // namespace mien::motion
