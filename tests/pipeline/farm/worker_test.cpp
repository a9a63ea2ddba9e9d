#include "pipeline/farm/worker.h"

#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/farm/slurm/worker_codes.h"
#include "pipeline/farm/work_item.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/run/run.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

constexpr char tiny_manifest[] = R"(mien: 1
study: tiny
seed: 7
examples: {set: "builtin:walks-10", ratings: builtin}
output: {size: [48, 32], fps: 8, cycles: 1, quality: draft, video: [gif]}
stimuli:
  - {id: none, weights: {sad: 1}}
  - {id: png, weights: {normal: 1}, output: {frames: png}}
  - {id: exr, weights: {normal: 1}, output: {frames: exr, video: [gif, mp4]}}
)";

class Worker : public testing::Test {
 protected:
  Worker() { write_file(file, tiny_manifest); }

  Production production() const {
    return {load_manifest(file, [](const std::string&) { return std::nullopt; }), {}};
  }

  WorkResult make(const std::vector<std::string>& items, const std::stop_token& stop = {}) const {
    Production study = production();
    return work(graph_of_items(study.graph(), items), items, folder, 2, stop, {}, "mien farm");
  }

  RunResult run_whole(const fs::path& into) const {
    Production study = production();
    return run(study, into, 2, {}, {});
  }

  std::map<std::string, std::string> files_of(const fs::path& study) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(study)) {
      const std::string path = entry.path().lexically_relative(study).generic_string();
      if (entry.is_regular_file() && !path.starts_with(".mien/")) files[path] = read_file(entry);
    }
    return files;
  }

  int frames_drawn() const {
    int frames = 0;
    for (const WorkerRecord& record : read_worker_records(folder))
      frames += static_cast<int>(record.frames);
    return frames;
  }

  test::TemporaryFolder temporary;
  fs::path file = temporary.path() / "m.yaml";
  fs::path folder = temporary.path() / "farm" / "tiny";
};

TEST_F(Worker, ChunksInAnyOrderMakeTheBytesOfAnUndisturbedRun) {
  const fs::path undisturbed = temporary.path() / "alone" / "tiny";
  EXPECT_TRUE(run_whole(undisturbed).is_complete());
  for (const char* film : {"film:none", "film:png", "film:exr"}) {
    for (const char* chunk : {"[3/3]", "[1/3]", "[2/3]", "[2/3]"})
      EXPECT_EQ(make({film + std::string(chunk)}).code(), 0);
  }
  const int drawn = frames_drawn();
  EXPECT_GE(drawn, 3 * 8);
  EXPECT_EQ(make({"film:none", "film:png", "film:exr"}).code(), 0);
  EXPECT_EQ(frames_drawn(), drawn) << "a film draws again what its chunks have drawn";
  const RunResult rest = run_whole(folder);
  EXPECT_TRUE(rest.is_complete());
  EXPECT_TRUE(rest.nondeterminism.empty());
  EXPECT_EQ(files_of(undisturbed), files_of(folder));
  EXPECT_FALSE(fs::exists(folder / ".mien/partial/frames/none"));
}

TEST_F(Worker, RecordsTheEstimateOfWhatItDraws) {
  for (const char* item : {"film:none", "film:exr[1/2]", "film:exr[2/2]"})
    EXPECT_EQ(make({item}).code(), 0);
  double estimated = 0.0;
  for (const WorkerRecord& record : read_worker_records(folder))
    estimated += record.estimated_seconds;
  const Production study = production();
  const double expected =
      study.graph().task("film:none").cost_seconds + study.graph().task("film:exr").cost_seconds;
  ASSERT_GT(expected, 0.0);
  EXPECT_NEAR(estimated / expected, 1.0, 1e-6);
}

TEST_F(Worker, OneBadFrameNeverDrawsTheOthersAgain) {
  EXPECT_EQ(make({"film:none[1/1]"}).code(), 0);
  const int drawn = frames_drawn();
  for (const auto& entry : fs::recursive_directory_iterator(folder / ".mien/partial"))
    if (entry.path().filename() == "00003.png") write_file(entry.path(), "damaged");
  const WorkResult result = make({"film:none[1/1]"});
  EXPECT_EQ(result.code(), 0);
  EXPECT_EQ(frames_drawn(), drawn + 1);
  ASSERT_EQ(result.repairs.size(), 1u);
  EXPECT_NE(result.repairs[0].find("00003.png"), std::string::npos);
}

TEST_F(Worker, AStopKeepsWhatIsDone) {
  std::stop_source stop;
  stop.request_stop();
  const WorkResult result = make({"film:none"}, stop.get_token());
  EXPECT_TRUE(result.was_interrupted);
  EXPECT_EQ(result.code(), worker_transient);
  EXPECT_TRUE(result.failed.empty());
}

TEST_F(Worker, AFailureIsToldInAFileUntilItIsMade) {
  std::string text = tiny_manifest;
  const std::string small = "video: [gif]}";
  text.replace(text.find(small), small.size(), "video: [gif], presentation: {fade_in: 9}}");
  write_file(file, text);
  const WorkResult result = make({"film:none", "film:png[1/2]"});
  ASSERT_EQ(result.failed.size(), 2u);
  EXPECT_EQ(result.code(), worker_bad_input);
  const fs::path told = failure_path(folder, "film:png[1/2]");
  EXPECT_EQ(told.filename(), "film_png_1_2_.json");
  const auto failure = nlohmann::json::parse(read_file(told));
  EXPECT_EQ(failure["item"], "film:png[1/2]");
  EXPECT_EQ(failure["attempts"], 1);
  EXPECT_EQ(failure["command"], "mien farm --tasks 'film:png[1/2]'");
  write_file(file, tiny_manifest);
  EXPECT_EQ(make({"film:none", "film:png[1/2]"}).code(), 0);
  EXPECT_FALSE(fs::exists(told));
}

/// Clips and dots only wait for what equalizes all films; they do not read it.
TEST_F(Worker, AFailureOfWhatAnItemWaitsForIsNoInterruption) {
  TaskGraph graph;
  const auto add = [&](const char* id, std::vector<std::string> after) {
    Task task;
    task.id = id;
    task.after = std::move(after);
    task.make = [](TaskRun& run) {
      if (run.task.after.empty()) throw Error("no figure is seen", "move the camera");
    };
    graph.add(std::move(task));
  };
  add("exposure", {});
  add("sizes", {"exposure"});
  add("clip:a", {"sizes"});
  add("clip:b", {"sizes"});
  const WorkResult result = work(graph, {"clip:a", "clip:b"}, folder, 1, {}, {}, "mien farm");
  EXPECT_FALSE(result.was_interrupted);
  ASSERT_EQ(result.failed.size(), 2u);
  for (const FailedWork& failed : result.failed)
    EXPECT_NE(failed.error.find("no figure is seen"), std::string::npos) << failed.item;
  EXPECT_EQ(result.code(), worker_bad_input);
  EXPECT_TRUE(fs::exists(failure_path(folder, "clip:a")));
}

TEST(WorkResults, EndAsWhatMayGoBetterNextTime) {
  const auto code_of_all = [](const std::vector<int>& codes) {
    WorkResult result;
    for (const int code : codes) result.failed.push_back({"film:a", "", code});
    return result.code();
  };
  std::vector<int> codes = {worker_bad_input, worker_gave_up, worker_transient,
                            worker_disk_unavailable};
  while (!codes.empty()) {
    EXPECT_EQ(code_of_all(codes), codes.back());
    EXPECT_EQ(code_of_all({codes.rbegin(), codes.rend()}), codes.back());
    codes.pop_back();
  }
  EXPECT_EQ(code_of_all({}), 0);
}

TEST(WorkItems, AreReadAndWritten) {
  EXPECT_EQ(work_item("film:a").task, "film:a");
  EXPECT_EQ(work_item("film:a").chunks, 0);
  EXPECT_EQ(work_item(chunk_item("film:a", 3, 12)).chunk, 3);
  EXPECT_EQ(work_item(chunk_item("film:a", 3, 12)).chunks, 12);
  for (const char* wrong : {"", "film:a[0/2]", "film:a[3/2]", "film:a[1]", "film:a[1/2", "a b"})
    EXPECT_THROW(work_item(wrong), Error) << wrong;
}

TEST_F(Worker, KnowsNoItemThatTheStudyHasNot) {
  const Production study = production();
  EXPECT_THROW(graph_of_items(study.graph(), {"film:nine"}), Error);
  EXPECT_THROW(graph_of_items(study.graph(), {"motion:none[1/2]"}), Error);
  const TaskGraph graph = graph_of_items(study.graph(), {"film:png[2/2]", "film:png"});
  EXPECT_EQ(graph.tasks.front().id, "motion:png");
  EXPECT_EQ(graph.tasks.back().id, "film:png");
}

}  // namespace
}  // namespace mien::pipeline
