#include "pipeline/farm/film_progress.h"

#include <algorithm>
#include <fstream>
#include <optional>

#include <gtest/gtest.h>

#include "pipeline/farm/film_lengths.h"
#include "pipeline/farm/worker.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/run/run.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

constexpr const char* pieces_manifest = R"(mien: 1
study: tiny
examples: {set: "builtin:walks-10", ratings: builtin}
output: {size: [48, 32], fps: 8, cycles: 1, quality: draft, video: [gif]}
stimuli:
  - {id: kept, weights: {normal: 1}, output: {frames: png}}
  - {id: bare, weights: {sad: 1}}
)";

class Pieces : public testing::Test {
 protected:
  Pieces() {
    std::ofstream(temporary.path() / "tiny.yaml") << pieces_manifest;
    ProductionOptions options;
    options.jobs = 2;
    production.emplace(load_manifest(temporary.path() / "tiny.yaml", process_environment()),
                       options);
  }

  void make(const std::vector<std::string>& items) const {
    const TaskGraph& graph = production->graph();
    ASSERT_EQ(work(graph_of_items(graph, items), items, folder, 2, {}, {}, "").code(), 0);
  }

  std::vector<bool> kept(const std::string& film) const {
    const TaskGraph& graph = production->graph();
    return stored_film_progress(graph, plan(graph, folder), film_lengths(*production, folder),
                                folder)
        .at(film)
        .has_frame;
  }

  test::TemporaryFolder temporary;
  fs::path folder = temporary.path() / "out" / "tiny";
  std::optional<Production> production;
};

TEST_F(Pieces, AreTheFramesThatWorkersHaveDrawn) {
  for (const char* film : {"film:kept", "film:bare"}) {
    make({std::string(film) + "[2/2]"});
    const std::vector<bool> has_frame = kept(film);
    const auto [first, end] = range_of({2, 2}, static_cast<int>(has_frame.size()));
    for (int i = 0; i < end; ++i)
      EXPECT_EQ(has_frame[static_cast<std::size_t>(i)], i >= first) << film << " " << i;
  }
}

TEST_F(Pieces, AreAllFramesWhereTheVideoAloneIsMissing) {
  run(*production, folder, 2, {}, {});
  std::ofstream(folder / "videos/kept.gif") << "damaged";
  EXPECT_EQ(std::ranges::count(kept("film:kept"), false), 0);
  std::ofstream(folder / "frames/kept/00003.png") << "damaged";
  EXPECT_EQ(std::ranges::count(kept("film:kept"), false), 1);
}

TEST(LivePieces, AreTheFramesThatJobsDrawAndTheirCut) {
  const test::TemporaryFolder temporary;
  const fs::path folder = temporary.path();
  fs::create_directories(folder / "farm/0001");
  std::ofstream(folder / "farm/0001/2-frames.tasks") << "film:a[1/4]\nfilm:a[2/4]\n";
  std::ofstream(folder / "farm/0001/3-films.tasks") << "film:a\nfilm:b\n";
  JournalContent journal;
  for (const char* name : {"2-frames", "3-films"}) {
    JournalJob job;
    job.submission = "0001";
    job.name = name;
    job.comment = std::string("mien:abc:0001:") + name;
    job.elements = 2;
    job.job = "7";
    journal.jobs.push_back(job);
  }
  const auto statuses =
      job_statuses(journal,
                   queue_rows("9|7|2|PENDING|Priority||0:00|mien:abc:0001:2-frames\n"
                              "10|8|2|PENDING|Priority||0:00|mien:abc:0001:3-films\n"),
                   folder);
  ProgressByFilm film_progress;
  add_frames_of_live_jobs(statuses, {{"film:a", 8}, {"film:b", 5}}, folder, film_progress);
  EXPECT_EQ(film_progress.at("film:a").chunks, 4);
  EXPECT_EQ(film_progress.at("film:a").has_frame,
            (std::vector<bool>{false, false, true, true, false, false, false, false}));
  EXPECT_EQ(film_progress.at("film:b").chunks, 1) << "one job makes all of it";
}

}  // namespace
}  // namespace mien::pipeline
