#include "pipeline/farm/farm_status.h"

#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pipeline/farm/film_progress.h"
#include "pipeline/farm/jobs/element_logs.h"
#include "pipeline/farm/submission.h"
#include "pipeline/farm/worker.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/run/run.h"
#include "pipeline/tasks/task_graph.h"
#include "pipeline/tasks/worker_record.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

constexpr const char* manifest_text = R"(mien: 1
study: tiny
examples: {set: "builtin:walks-10", ratings: builtin}
output: {size: [64, 36], fps: 10, cycles: 1, quality: draft, frames: png, video: [mp4]}
stimuli:
  - {id: one, weights: {normal: 1}}
  - {id: two, weights: {sad: 1}}
)";

class FarmStatusOfAStudy : public testing::Test {
 protected:
  FarmStatusOfAStudy() { write_manifest(manifest_text); }

  void write_manifest(const std::string& text) {
    std::ofstream(temporary.path() / "tiny.yaml") << text;
    ProductionOptions options;
    options.jobs = 2;
    production.emplace(load_manifest(temporary.path() / "tiny.yaml", process_environment()),
                       options);
  }

  void make(const std::vector<std::string>& items) const {
    const TaskGraph& graph = production->graph();
    ASSERT_EQ(work(graph_of_items(graph, items), items, folder, 2, {}, {}, "").code(), 0);
  }

  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder / name).parent_path());
    std::ofstream(folder / name) << text;
  }

  void write_record(const WorkerRecord& record) const {
    write(".mien/workers/" + record.name + ".json", to_json(record));
  }

  /// Where frames of a film are kept whose motion is made, in the study's folder.
  std::string frames_of(const std::string& film) const {
    const TaskGraph& graph = production->graph();
    const StoredSequence kept = stored_sequence(graph.task(film), graph, quick_plan(graph, folder));
    return ".mien/partial/" + kept.path + "/" + kept.key + "/frames/";
  }

  /// The comment of a job of the first submission of the study as it is.
  std::string named(const std::string& job) const {
    return "mien:" + graph_key(production->graph(), folder) + ":0001:" + job;
  }

  FarmStatus status(const std::string& queue = "") const {
    return farm_status(*production, folder, queue_rows(queue), "", "tiny.yaml");
  }

  test::TemporaryFolder temporary;
  fs::path folder = temporary.path() / "out" / "tiny";
  std::optional<Production> production;
};

TEST_F(FarmStatusOfAStudy, TellsNothingOfWhatIsNotThere) {
  const FarmStatus empty = status();
  EXPECT_EQ(empty.stages.front().name, "motions");
  EXPECT_EQ(empty.stages.front().done, 0);
  EXPECT_EQ(empty.stages.front().total, 2);
  EXPECT_GT(empty.frames.total, 10);
  EXPECT_FALSE(empty.is_complete);
  EXPECT_FALSE(empty.is_active());
  EXPECT_FALSE(fs::exists(folder));
}

TEST_F(FarmStatusOfAStudy, TellsThatAllIsDoneAsPlanDoes) {
  run(*production, folder, 2, {}, {});
  const FarmStatus done = status();
  EXPECT_TRUE(done.is_complete);
  EXPECT_EQ(done.frames.done, done.frames.total);
  const auto planned = plan(production->graph(), folder);
  const auto seen = quick_plan(production->graph(), folder);
  for (std::size_t i = 0; i < planned.size(); ++i) EXPECT_EQ(planned[i].state, seen[i].state);

  EXPECT_NE(status_text(done).find("judging by receipts and sizes; mien verify"),
            std::string::npos);

  fs::remove(folder / "videos" / "one.mp4");
  const FarmStatus one_less = status();
  EXPECT_FALSE(one_less.is_complete);
  for (const StageProgress& share : one_less.stages) {
    if (share.name == "films") {
      EXPECT_EQ(share.done, share.total - 1);
    } else if (share.name == "study") {
      EXPECT_LT(share.done, share.total);
    }
  }
}

TEST_F(FarmStatusOfAStudy, IsNotCompleteWhileItsRecordIsOfAnEarlierState) {
  run(*production, folder, 2, {}, {});
  std::string edited = manifest_text;
  edited.replace(edited.find("{sad: 1}"), 8, "{sad: 0.5, normal: 0.5}");
  write_manifest(edited);
  std::vector<std::string> items;
  for (const Task& task : production->graph().tasks) items.push_back(task.id);
  make(items);
  const FarmStatus made = status();
  for (const StageProgress& share : made.stages) EXPECT_EQ(share.done, share.total) << share.name;
  EXPECT_FALSE(made.is_complete);
  EXPECT_NE(status_text(made).find("describes an earlier state of the study; mien run tiny.yaml"),
            std::string::npos)
      << status_text(made);
  run(*production, folder, 2, {}, {});
  EXPECT_TRUE(status().is_complete);
  EXPECT_EQ(status_text(status()).find("earlier state"), std::string::npos);
  fs::remove(folder / "provenance.json");
  EXPECT_FALSE(status().is_complete);
}

/// A worker of another machine that has drawn 20 frames.
WorkerRecord worker(const std::string& name) {
  WorkerRecord record;
  record.name = name;
  record.host = "n1";
  record.boot = "of n1";
  record.pid = 1;
  record.frames = 20;
  record.frame_seconds = 1;
  return record;
}

TEST_F(FarmStatusOfAStudy, TellsWhoWorksWhatWaitsAndWhatFailed) {
  WorkerRecord at_work = worker("n1-1-a");
  at_work.tasks = {{"film:one[1/3]", 0.5}};
  at_work.frame_seconds = 10;
  write_record(at_work);
  WorkerRecord ended = worker("n1-2-b");
  ended.ended = true;
  write_record(ended);
  write(".mien/workers/n1-3-c.json", R"({"host":"n1","pid)");
  make({"motion:one"});
  write(frames_of("film:one") + "00000.png", "x");
  write(frames_of("film:one") + "00001.png", "x");
  write(frames_of("film:one") + "../notes/n1-1-a", "x");
  write("farm/failures/film_two.json",
        R"({"item":"film:two","error":"no space left","code":75,"host":"n2","when":"noon",)"
        R"("attempts":3,"command":"mien farm worker tiny.yaml --tasks film:two"})");
  write("farm/journal.jsonl",
        R"({"event":"intent","submission":"0001","name":"2-frames","comment":")" +
            named("2-frames") +
            R"(","elements":9})"
            "\n");
  const std::string comment = named("2-frames") + "\n";
  const FarmStatus now =
      status("1|1|1|RUNNING|None|n1|0:01|" + comment + "2|1|2|PENDING|Priority||0:00|" + comment +
             "3|1|3|PENDING|Priority||0:00|" + comment + "4|1|4|SPECIAL_EXIT|JobHeldUser||0:00|" +
             comment + "5|1|5|RUNNING|None|n1|0:01|another's\n");
  ASSERT_EQ(now.nodes.size(), 1u);
  EXPECT_EQ(now.nodes[0].elements, 1);
  EXPECT_EQ(now.nodes[0].workers, 1);
  EXPECT_DOUBLE_EQ(now.nodes[0].frames_per_second, 2.0);
  EXPECT_EQ(now.frames.done, 2);
  EXPECT_EQ(now.waiting.at("Priority"), 2);
  ASSERT_EQ(now.problems.size(), 1u);
  EXPECT_EQ(now.problems[0].job, "1_4");
  EXPECT_NEAR(now.seconds_left.value(), (now.frames.total - 2) / 2.0, 1e-9);

  const std::string text = status_text(now);
  for (const char* words :
       {"n1: 1 job, 1 worker, 2.00 frames/s: film:one[1/3]", "waiting: 2 (2 Priority)",
        "held by Slurm: 1 job (1_4)", "film:two: no space left", "on n2, noon, tried 3 times",
        "again: mien farm worker tiny.yaml --tasks film:two", "left at this pace"}) {
    EXPECT_NE(text.find(words), std::string::npos) << words << " in\n" << text;
  }
  const auto told = status_json(now);
  EXPECT_EQ(told["waiting"]["Priority"], 2);
  EXPECT_EQ(told["failed"][0]["item"], "film:two");
}

TEST_F(FarmStatusOfAStudy, CountsNoFramesOfAnEarlierState) {
  make({"motion:one"});
  for (const char* frame : {"00000.png", "00001.png", "00002.png"})
    write(std::string(".mien/partial/frames/one/before/frames/") + frame, "x");
  EXPECT_EQ(status().frames.done, 0);
  write(frames_of("film:one") + "00004.png", "x");
  EXPECT_EQ(status().frames.done, 1);
}

TEST_F(FarmStatusOfAStudy, ForgetsFailuresOfWhatIsMadeOrGone) {
  make({"film:one"});
  for (const char* item : {"film:one", "film:one[1/2]", "film:two[1/2]", "film:removed"})
    write(failure_path("", item).string(), "{\"item\":\"" + std::string(item) + "\"}");
  const FarmStatus now = status();
  ASSERT_EQ(now.failed.size(), 1u);
  EXPECT_EQ(now.failed[0].item, "film:two[1/2]");
}

TEST_F(FarmStatusOfAStudy, MeasuresSilenceByTheClockThatStampsTheFiles) {
  write_record(worker("n1-1-a"));
  write_record(worker("n1-2-b"));
  const auto ahead = fs::file_time_type::clock::now() + std::chrono::minutes(10);
  fs::last_write_time(folder / ".mien/workers/n1-1-a.json", ahead);
  fs::last_write_time(folder / ".mien/workers/n1-2-b.json", ahead - std::chrono::minutes(5));
  for (const WorkerReport& report : worker_reports(folder))
    EXPECT_EQ(report.is_alive(), report.name == "n1-1-a") << report.name;
  EXPECT_EQ(status().nodes.at(0).workers, 1);
}

TEST_F(FarmStatusOfAStudy, TellsThatItsFolderIsAwayWhereSlurmHasJobsOfIt) {
  EXPECT_EQ(status("1|1|1|RUNNING|None|n1|0:01|another's\n").disk, "");
  const FarmStatus away = status("1|1|1|RUNNING|None|n1|0:01|" + named("2-frames") + "\n");
  EXPECT_NE(status_text(away).find("tiny does not exist, but Slurm has jobs that work in it"),
            std::string::npos)
      << status_text(away);
  EXPECT_TRUE(status_json(away)["disk"].is_string());
  fs::create_directories(folder);
  EXPECT_TRUE(status_json(status())["disk"].is_null());
}

TEST_F(FarmStatusOfAStudy, DoesWithoutSlurm) {
  const FarmStatus without =
      farm_status(*production, folder, std::nullopt, "squeue is not there\n  its words", "m.yaml");
  const std::string text = status_text(without);
  EXPECT_NE(text.find("jobs unknown: squeue is not there\n"), std::string::npos);
  EXPECT_EQ(text.find("its words"), std::string::npos);
  EXPECT_NE(text.find("no worker is active"), std::string::npos);
  EXPECT_NE(text.find("mien run m.yaml makes what is missing"), std::string::npos) << text;
}

TEST_F(FarmStatusOfAStudy, DoesNotTakeASilentWorkerForALivingOne) {
  write_record(worker("n1-1-a"));
  EXPECT_TRUE(status().is_active());
  fs::last_write_time(folder / ".mien/workers/n1-1-a.json",
                      fs::file_time_type::clock::now() - std::chrono::minutes(5));
  EXPECT_FALSE(status().is_active());
}

WorkerReport drawing(double seconds, double estimated) {
  WorkerReport report;
  report.frames = 100;
  report.frame_seconds = seconds;
  report.estimated_seconds = estimated;
  return report;
}

TEST(MeasuredPace, IsOfTheFramesThatWereDrawnWhateverTheirQuality) {
  const WorkerReport draft = drawing(2.0, 1.0);
  const WorkerReport final_quality = drawing(200.0, 100.0);
  const WorkerReport former = drawing(50.0, 0.0);
  EXPECT_DOUBLE_EQ(measured_pace({draft, former}), 2.0);
  EXPECT_DOUBLE_EQ(measured_pace({draft, final_quality}), 2.0);
  EXPECT_DOUBLE_EQ(measured_pace({}), 1.0);
  EXPECT_DOUBLE_EQ(measured_pace({former}), 1.0) << "its estimate is not known";
}

TEST(MeasuredPace, IsInTheRecordsOfWorkersButNotInThoseOfOlderVersions) {
  const auto read = worker_record_from_json(to_json(drawing(2.0, 1.5)));
  ASSERT_TRUE(read.has_value());
  EXPECT_DOUBLE_EQ(read->estimated_seconds, 1.5);
  nlohmann::json former = nlohmann::json::parse(to_json(drawing(2.0, 1.5)));
  former.erase("estimated_seconds");
  const auto read_former = worker_record_from_json(former.dump());
  ASSERT_TRUE(read_former.has_value());
  EXPECT_DOUBLE_EQ(read_former->estimated_seconds, 0.0);
}

class Logs : public testing::Test {
 protected:
  Logs() {
    for (const char* submission : {"0001", "0002"}) {
      write(std::string("farm/") + submission + "/2-frames.sbatch", "");
      write(std::string("farm/") + submission + "/2-frames.tasks",
            "film:a[1/2] film:b\nfilm:a[2/2]\nfilm:ab\n");
    }
    write("farm/0001/2-frames-2.sbatch", "");
    write("farm/0001/2-frames-2.tasks", "film:z\n");
    write("farm/0001/log/my-study-2-frames-7_1.log", "first\n");
    write("farm/0001/log/my-study-2-frames-2-8_1.log", "second array\n");
    write("farm/0002/log/my-study-2-frames-9_2.log", "1\n2\n3\n");
    write("farm/0002/ends/2-frames.2", "1 0 n1\n");
  }

  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((temporary.path() / name).parent_path());
    std::ofstream(temporary.path() / name) << text;
  }

  std::string log_names(const std::string& item) const {
    std::string names;
    for (const ElementLog& log : find_logs(item, temporary.path())) {
      names += log.file.filename().string() + " ";
    }
    return names;
  }

  test::TemporaryFolder temporary;
};

TEST_F(Logs, AreFoundByItem) {
  EXPECT_EQ(log_names("film:a[2/2]"), "my-study-2-frames-9_2.log ");
  EXPECT_EQ(log_names("film:a"), "my-study-2-frames-9_2.log ");
  EXPECT_EQ(log_names("film:b"), "my-study-2-frames-7_1.log ");
  EXPECT_EQ(log_names("film:z"), "my-study-2-frames-2-8_1.log ");
  EXPECT_EQ(log_names("film:none"), "");
}

TEST_F(Logs, OfTroublesAreTheNewestOfTheirElement) {
  JobProblem problem;
  problem.submission = "0002";
  problem.element = "2-frames.2";
  problem.cause = "failed (exit code 1)";
  JobProblem unresponsive = problem;
  unresponsive.element = "2-frames.1";
  const auto ended = find_logs({problem, unresponsive}, temporary.path());
  ASSERT_EQ(ended.size(), 1u);
  EXPECT_EQ(ended[0].item, "0002/2-frames.2, failed (exit code 1)");
  EXPECT_EQ(last_lines(ended[0].file, 2), "2\n3\n");
  EXPECT_EQ(last_lines(ended[0].file, 20), "1\n2\n3\n");
}

}  // namespace
}  // namespace mien::pipeline
