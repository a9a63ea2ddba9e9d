#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "motion/formats/bvh/bvh.h"
#include "motion/math/geometry.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/recording.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/production/report/tables.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/temporary_folder.h"
#include "render/scene/camera.h"
#include "scenes/cameras/camera_rig.h"

namespace mien::pipeline {
namespace {

using motion::Vec3;

constexpr double hands_meet_m = 0.02;

Vec3 on_floor(const Vec3& point) { return {point.x(), 0.0, point.z()}; }

Vec3 wrist_of(const motion::Clip& clip, std::size_t frame) {
  return motion::world_transforms(clip.body, clip.poses.at(frame)).positions[motion::RightWrist];
}

/// The clip turned by half a turn about the vertical through a point: whoever reaches for the point
/// meets himself there.
motion::Clip mirror_person(motion::Clip clip, const Vec3& point) {
  const motion::Quat turn(Eigen::AngleAxisd(M_PI, Vec3::UnitY()));
  for (motion::Pose& pose : clip.poses) {
    pose.root_position = point + turn * (pose.root_position - point);
    pose.rotations.front() = turn * pose.rotations.front();
  }
  return clip;
}

/// "ROOT Ann … ROOT Bo …": both in one file.
std::string of_two_roots(const std::string& first, const std::string& second) {
  const auto split = [](std::string text, const std::string& name) {
    const std::size_t root = text.find("ROOT "), line = text.find('\n', root);
    text.replace(root, line - root, "ROOT " + name);
    const std::size_t motion = text.find("MOTION\n");
    const std::size_t head = text.find('\n') + 1;
    const std::size_t frames = text.find('\n', text.find("Frame Time:")) + 1;
    return std::array{text.substr(head, motion - head), text.substr(motion, frames - motion),
                      text.substr(frames)};
  };
  const auto a = split(first, "Ann"), b = split(second, "Bo");
  std::string text = "HIERARCHY\n" + a[0] + b[0] + a[1];
  std::istringstream left(a[2]), right(b[2]);
  std::string one, other;
  while (std::getline(left, one) && std::getline(right, other)) text += one + " " + other + "\n";
  return text;
}

/// A recording of two people whose right hands are at one place in its middle, each in a file of
/// its own and both in one.
class PeopleShot : public testing::Test {
 protected:
  static constexpr int meeting_frame = 10;

  PeopleShot() {
    motion::Clip ann =
        motion::repeated(motion::builtin_examples("walks-10", 30.0).examples.front().clip, 1);
    for (motion::Pose& pose : ann.poses) pose.root_position += Vec3(3.0, 0.0, -2.0);
    const motion::Clip bo = mirror_person(ann, wrist_of(ann, meeting_frame));
    const std::string first = motion::to_bvh(motion::to_recording(ann));
    const std::string second = motion::to_bvh(motion::to_recording(bo));
    std::ofstream(folder_.path() / "ann.bvh") << first;
    std::ofstream(folder_.path() / "bo.bvh") << second;
    std::ofstream(folder_.path() / "both.bvh") << of_two_roots(first, second);
  }

  Manifest manifest_of(const std::string& people, const std::string& more = "") const {
    const std::string text =
        "mien: 1\nstudy: s\nexamples: {set: builtin:walks-10}\noutput: {fps: 30, cycles: 1}\n"
        "stimuli:\n  - id: greet\n    people: [" +
        people + "]\n" + more;
    ManifestReading reading = check_manifest_text(text, folder_.path() / "m.yaml",
                                                  [](const std::string&) { return std::nullopt; });
    EXPECT_TRUE(reading.faults.empty()) << Faults(reading.faults).what();
    return std::move(reading.manifest);
  }

  std::vector<motion::Clip> placed(const std::string& people) const {
    const Manifest manifest = manifest_of(people);
    Motions motions(manifest);
    return placed_people(manifest.stimuli.at(0), motions);
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(PeopleShot, OfOneRecordingMeetWhereTheyMet) {
  for (const char* people :
       {"{clip: {file: both.bvh, subject: Ann}}, {clip: {file: both.bvh, "
        "subject: Bo}}",
        "{clip: ann.bvh}, {clip: bo.bvh}",
        "{clip: ann.bvh}, {clip: bo.bvh}, {weights: {sad: 1}, place: {x: 2}}"}) {
    SCOPED_TRACE(people);
    const std::vector<motion::Clip> clips = placed(people);
    const Vec3 ann = wrist_of(clips[0], meeting_frame), bo = wrist_of(clips[1], meeting_frame);
    EXPECT_LT((ann - bo).norm(), hands_meet_m);
    // Around the stage's middle, wherever in the laboratory they were.
    const Vec3 middle = 0.5 * (on_floor(clips[0].poses[0].root_position) +
                               on_floor(clips[1].poses[0].root_position));
    EXPECT_LT(middle.norm(), 1e-9);
  }
}

TEST_F(PeopleShot, WithPlacesBeginThereAndGoWhereTheyAreTurned) {
  const std::vector<motion::Clip> clips = placed(
      "{weights: {sad: 1}, place: {x: -0.75, turn: 90}}, "
      "{clip: ann.bvh, place: {x: 0.75, z: 0.5, turn: -60}}");
  const Vec3 places[] = {{-0.75, 0.0, 0.0}, {0.75, 0.0, 0.5}};
  const double turns[] = {90.0, -60.0};
  for (int i = 0; i < 2; ++i) {
    const motion::Clip& clip = clips[static_cast<std::size_t>(i)];
    EXPECT_LT((on_floor(clip.poses[0].root_position) - places[i]).norm(), 1e-9) << i;
    const Vec3 forward = scenes::action_of(clip).forward;
    EXPECT_NEAR(std::atan2(forward.x(), forward.z()) / motion::radians_per_degree, turns[i], 1e-6)
        << i;
  }
}

TEST_F(PeopleShot, IsSeenFromWhereTheFirstIsToTheLeftOfTheSecond) {
  for (const char* people : {"{clip: ann.bvh}, {clip: bo.bvh}", "{clip: bo.bvh}, {clip: ann.bvh}",
                             "{weights: {sad: 1}, place: {x: -1}}, "
                             "{weights: {happy: 1}, place: {x: 1, turn: 180}}"}) {
    const Manifest manifest = manifest_of(people, "    look: {camera: front}\n");
    Motions motions(manifest);
    const scenes::Shot shot = shot_of(manifest.stimuli[0], motions, 0);
    const auto across = [&](int actor) {
      const Vec3& at = shot.actors[static_cast<std::size_t>(actor)].clip.poses[0].root_position;
      return render::project(camera_at(shot, 0), at.cast<float>())->x();
    };
    EXPECT_LT(across(0) + 20.0f, across(1)) << people;
  }
}

/// The value of a column in the row of a person.
double table_value(const CsvTable& table, std::size_t row, const char* column) {
  return std::stod(
      table.rows.at(row)[static_cast<std::size_t>(require_column(table, column))].text);
}

TEST_F(PeopleShot, IsDescribedInATableAsTheFrontCameraSeesIt) {
  const Manifest manifest = manifest_of("{clip: ann.bvh}, {clip: bo.bvh}");
  Motions motions(manifest);
  const CsvTable table = parse_csv(people_table.csv(manifest, motions), "people.csv");
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_LT(table_value(table, 0, "x_m"), -0.1);
  EXPECT_NEAR(table_value(table, 0, "x_m") + table_value(table, 1, "x_m"), 0.0, 2e-4);
  for (const std::size_t row : {0u, 1u}) {
    EXPECT_NEAR(table_value(table, row, "z_m"), 0.0, 2e-4);
    EXPECT_LT(table_value(table, row, "nearest_hand_m"), hands_meet_m);
  }
  // They go in opposite directions.
  const double between = table_value(table, 0, "turn_deg") - table_value(table, 1, "turn_deg");
  EXPECT_NEAR(std::abs(between), 180.0, 0.5);
}

TEST_F(PeopleShot, HasEverybodyInThePictureAtAllTimes) {
  std::string eight;
  for (int i = 0; i < 8; ++i)
    eight += "{weights: {happy: 1}, place: {x: " + std::to_string(0.7 * i - 2.45) +
             ", turn: " + std::to_string(45 * i - 180) + "}}, ";
  for (const char* figure : {"stick", "mannequin", "point-light"}) {
    const Manifest manifest =
        manifest_of(eight, std::string("    look: {figure: ") + figure + "}\n");
    Motions motions(manifest);
    const scenes::Shot shot = shot_of(manifest.stimuli[0], motions, 0);
    ASSERT_EQ(shot.actors.size(), 8u);
    for (int frame = 0; frame < shot.frame_count(); frame += 5) {
      const render::Camera& camera = camera_at(shot, frame);
      for (const scenes::Actor& actor : shot.actors) {
        const auto& pose = actor.clip.poses.at(static_cast<std::size_t>(frame));
        for (const Vec3& joint : motion::world_transforms(actor.clip.body, pose).positions) {
          const auto seen = render::project(camera, joint.cast<float>());
          ASSERT_TRUE(seen);
          EXPECT_GT(seen->minCoeff(), 0.0f);
          EXPECT_LT(seen->x(), static_cast<float>(camera.width));
          EXPECT_LT(seen->y(), static_cast<float>(camera.height));
        }
      }
    }
  }
}

TEST_F(PeopleShot, ShowsThemInDifferentColoursOrTheirOwn) {
  const Manifest manifest = manifest_of(
      "{weights: {sad: 1}, place: {}}, {weights: {sad: 1}, place: {x: 1}}, "
      "{weights: {sad: 1}, place: {x: 2}, look: {colour: \"#102030\", figure: mannequin}}");
  Motions motions(manifest);
  const scenes::Shot shot = shot_of(manifest.stimuli[0], motions, 0);
  EXPECT_GT((shot.actors[0].colours.middle - shot.actors[1].colours.middle).abs().maxCoeff(), 0.1f);
  EXPECT_TRUE(shot.actors[2].colours.middle.isApprox(scenes::colour_from_hex("#102030")));
  EXPECT_EQ(shot.actors[0].name, "a");
  const render::Scene scene = scene_at(shot, 0);
  EXPECT_EQ(scene.figures.size(), 3u);
  EXPECT_FALSE(scene.solids.meshes.empty());
}

TEST_F(PeopleShot, ScramblesTheDotsOfEachByItself) {
  const Manifest manifest =
      manifest_of("{weights: {sad: 1}, place: {}}, {weights: {sad: 1}, place: {}}",
                  "    look: {figure: {point-light: {scrambled: true}}}\n");
  Motions motions(manifest);
  const scenes::Shot shot = shot_of(manifest.stimuli[0], motions, 0);
  const auto& first = shot.actors[0].dots;
  const auto& second = shot.actors[1].dots;
  ASSERT_EQ(first.size(), second.size());
  int differing = 0;
  for (std::size_t d = 0; d < first.size(); ++d)
    differing += (first[d].path[0] - second[d].path[0]).norm() > 0.01 ? 1 : 0;
  EXPECT_GT(differing, static_cast<int>(first.size()) / 2);
}

}  // namespace
}  // namespace mien::pipeline
