#include <algorithm>

#include <gtest/gtest.h>

#include "pipeline/csv.h"
#include "pipeline/film_presentation.h"
#include "pipeline/manifest_checks.h"
#include "pipeline/run.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

Stimulus stimulus(const std::string& id, const std::string& example, int cycles) {
  Stimulus result;
  result.path = "stimuli[0]";
  result.id = id;
  result.weights = {{example, 1.0}};
  result.output.size = {48, 32};
  result.output.fps = 10.0;
  result.output.cycles = cycles;
  result.output.quality = Quality::draft;
  result.output.frames = FrameFormat::none;
  return result;
}

Manifest study() {
  Manifest manifest;
  manifest.study = "alike";
  manifest.file = MIEN_SOURCE_DIR "/manifests/quickstart.yaml";
  manifest.examples.builtin = "walks-10";
  manifest.ratings.source = Ratings::Source::builtin;
  manifest.stimuli = {stimulus("short", "normal", 1), stimulus("long", "normal", 3)};
  manifest.stimuli[1].look.camera.view = "front";
  manifest.equalize = {.luminance = true, .duration = true};
  return manifest;
}

TEST(Equalize, MakesFilmsOfAStudyAlikeInLuminanceAndDuration) {
  const test::TemporaryFolder folder;
  Production production(study(), {.quality = {}, .only = {}, .jobs = 1});
  const RunResult result = run(production, folder.path() / "out", 1, {}, {});
  for (const TaskOutcome& outcome : result.outcomes) EXPECT_EQ(outcome.error, "");
  ASSERT_TRUE(result.is_complete());

  const CsvTable luminance = read_csv(folder.path() / "out/metrics/luminance.csv");
  const auto column = [](const CsvTable& table, const char* name) {
    return static_cast<std::size_t>(require_column(table, name));
  };
  const auto number = [&](const CsvTable& table, std::size_t row, const char* name) {
    return number_in(table, table.rows[row][column(table, name)]);
  };
  ASSERT_EQ(luminance.rows.size(), 2u);
  const double mean = number(luminance, 0, "mean_luminance");
  EXPECT_NEAR(number(luminance, 1, "mean_luminance"), mean, 0.01 * mean);
  EXPECT_NE(number(luminance, 0, "exposure_stops"), 0.0);

  const CsvTable videos = read_csv(folder.path() / "out/metrics/videos.csv");
  ASSERT_EQ(videos.rows.size(), 2u);
  EXPECT_EQ(number(videos, 0, "frames"), number(videos, 1, "frames"));
  EXPECT_GT(number(videos, 0, "worst_psnr_db"), 30.0);
}

TEST(Equalize, LeavesFilmsAloneOtherwise) {
  Manifest manifest = study();
  manifest.equalize = {};
  Motions motions(manifest);
  EXPECT_EQ(3 * motions.shown(manifest.stimuli[0]).frame_count(),
            motions.shown(manifest.stimuli[1]).frame_count());
}

TEST(VideoNames, OfTwoStimuliMustDiffer) {
  Manifest manifest = study();
  manifest.stimuli[0].id = "a.lossless";
  manifest.stimuli[1].id = "a";
  const auto is_told = [&] {
    const std::vector<Fault> faults = check_meaning(manifest);
    return std::any_of(faults.begin(), faults.end(), [](const Fault& fault) {
      return fault.wrong == "its video a.lossless.mp4 would be that of \"a.lossless\"";
    });
  };
  EXPECT_FALSE(is_told());
  manifest.stimuli[1].output.video = {render::VideoKind::mp4_lossless};
  EXPECT_TRUE(is_told());
}

}  // namespace
}  // namespace mien::pipeline
