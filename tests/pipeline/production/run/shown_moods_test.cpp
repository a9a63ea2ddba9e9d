#include "pipeline/production/run/shown_moods.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

/// A study of these stimuli.
Manifest study_of(const std::string& stimuli, const std::string& more = "") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "m.yaml";
  write_file(file, "mien: 1\nstudy: s\noutput: {fps: 30}\n" + more + "stimuli:\n" + stimuli);
  return load_manifest(file, [](const std::string&) { return std::nullopt; });
}

std::vector<ShownMood> moods_of(const Manifest& manifest) {
  Motions motions(manifest);
  return shown_moods(motions, manifest.stimuli.front());
}

constexpr char brightens[] =
    "  - {id: a, path: [{stand: 0.5, mood: {sad: 1}}, {walk: 3}, {turn: 90}, "
    "{walk: 3, mood: {happy: 1}}, {walk: 1, mood: {happy: 1}}, {stand: 1}]";

/// The walker is the same up to the change, and another after it.
TEST(ShownMoods, BeginWhereTheWalkIsNoLongerThatWithoutTheChange) {
  const Manifest changing = study_of(brightens + std::string("}\n"));
  const Manifest sad = study_of(
      "  - {id: a, path: [{stand: 0.5, mood: {sad: 1}}, {walk: 3}, {turn: 90}, {walk: 3, mood: "
      "{sad: 1, happy: 0}}, {walk: 1}, {stand: 1}]}\n");
  const std::vector<ShownMood> moods = moods_of(changing);
  ASSERT_EQ(moods.size(), 2U);
  EXPECT_EQ(moods[0], (ShownMood{0.0, "sad"}));
  EXPECT_EQ(moods[1].mood, "happy");
  EXPECT_GT(moods[1].from_s, 3.6) << "standing, walking and a turn";
  Motions motions(changing), plain(sad);
  const motion::Clip &walk = motions.clip("a"), &other = plain.clip("a");
  const auto change = static_cast<std::size_t>(std::lround(30.0 * moods[1].from_s));
  const auto differ = [&](std::size_t frame) {
    double most = 0.0;
    for (std::size_t j = 0; j < walk.poses[frame].rotations.size(); ++j)
      most = std::max(
          most, walk.poses[frame].rotations[j].angularDistance(other.poses[frame].rotations[j]));
    return most;
  };
  EXPECT_LT(differ(change - 1), 1e-9);
  EXPECT_LT(differ(change), 1e-9);
  EXPECT_GT(differ(change + 10), 0.01);
}

TEST(ShownMoods, AlongPointsAreAtTheTimesThatAreStated) {
  const std::string points =
      "  - {id: a, path: {points: [[0, 0], [0, 6]], mood: {happy: 1}, moods: [{at: 2, mood: "
      "{happy: "
      "1}}, {at: 2.5, mood: {quickness: 0.2}}, {at: 20, mood: {tired: 1}}]}}\n";
  const std::vector<ShownMood> moods = moods_of(study_of(points));
  ASSERT_EQ(moods.size(), 2U) << "one of them is no change, and one comes after the end";
  EXPECT_EQ(moods[1], (ShownMood{2.5, "0.2 quickness"}));
  EXPECT_TRUE(moods_of(study_of("  - {id: a, path: [{walk: 3}, {stand: 1}]}\n")).empty());
}

TEST(ShownMoods, AreMovedByTempoAndByWhatTheVideoShowsBefore) {
  const double plain = moods_of(study_of(brightens + std::string("}\n")))[1].from_s;
  EXPECT_NEAR(moods_of(study_of(brightens + std::string(", modify: {tempo: 0.5}}\n")))[1].from_s,
              2.0 * plain, 0.04);
  EXPECT_NEAR(moods_of(study_of(brightens + std::string(", output: {presentation: {fixation: "
                                                        "{seconds: 0.5}, blank_before: 1}}}\n")))[1]
                  .from_s,
              plain + 1.5, 1e-9);
}

TEST(ShownMoods, OfAShortenedFilmEndWithIt) {
  const std::string shorter = brightens + std::string("}\n  - {id: b, path: [{walk: 2}]}\n");
  EXPECT_EQ(moods_of(study_of(shorter)).size(), 2U);
  EXPECT_TRUE(moods_of(study_of(shorter, "equalize: [duration]\n")).empty());
}

TEST(MoodStretches, AreTheWholeWalkAndEachLeadsAhead) {
  const Manifest manifest = study_of(brightens + std::string("}\n"));
  Motions motions(manifest);
  const std::vector<MoodStretch> stretches = mood_stretches(motions, manifest.stimuli.front());
  ASSERT_EQ(stretches.size(), 2U);
  EXPECT_DOUBLE_EQ(stretches[0].from_s, 0.0);
  EXPECT_NEAR(stretches[1].from_s, moods_of(manifest)[1].from_s, 1.0 / 30.0);
  EXPECT_EQ(stretches[0].motion.clip.frame_count() + stretches[1].motion.clip.frame_count(),
            motions.clip("a").frame_count() + 1);
  const motion::Clip& second = stretches[1].motion.clip;  // walked towards +X before
  const motion::Vec3 way = second.poses.back().root_position - second.poses.front().root_position;
  EXPECT_GT(way.z(), 3.0);
  EXPECT_LT(std::abs(way.x()), 0.5);
}

}  // namespace
}  // namespace mien::pipeline
