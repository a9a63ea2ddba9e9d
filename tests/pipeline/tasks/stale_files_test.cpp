#include "pipeline/tasks/stale_files.h"

#include <chrono>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/tasks/store.h"
#include "pipeline/tasks/worker_record.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

class Remains : public testing::Test {
 protected:
  test::TemporaryFolder temporary;
  fs::path folder = temporary.path() / "study";
  fs::path now = temporary.path() / "now";

  void SetUp() override { write_file(now, ""); }

  /// Makes a file, and says where.
  fs::path file(const std::string& path, const std::string& text) const {
    make_folder((folder / path).parent_path());
    write_file(folder / path, text);
    return folder / path;
  }

  /// A process with this record has an attempt, a claim and frames in the making.
  std::vector<fs::path> work_of(const WorkerRecord& record) const {
    file(".mien/workers/" + record.name + ".json", to_json(record));
    return {file(".mien/attempts/" + record.name + "/1/a.mp4", "half"),
            file(".mien/claims/" + record.name, record.name + "\n"),
            file(".mien/partial/frames/a/key/notes/" + record.name, "")};
  }

  static WorkerRecord of_the_dead() {
    WorkerRecord record = record_of_this_process();
    record.process_start += "1";
    return record;
  }

  static WorkerRecord of_another_machine() {
    WorkerRecord record = of_the_dead();
    record.boot = "another boot";
    return record;
  }

  void let_be_silent(const WorkerRecord& record, std::chrono::hours since) const {
    fs::last_write_time(worker_record_path(folder, record.name),
                        fs::file_time_type::clock::now() - since);
  }
};

TEST_F(Remains, OfTheDeadAreRemovedAndOfTheLivingStay) {
  const auto dead = work_of(of_the_dead());
  const auto living = work_of(record_of_this_process());
  remove_stale_files(folder, now);
  EXPECT_FALSE(fs::exists(dead[0]));
  EXPECT_FALSE(fs::exists(dead[1]));
  EXPECT_TRUE(fs::exists(living[0]));
  EXPECT_TRUE(fs::exists(living[1]));
}

TEST_F(Remains, OfALivingProcessOfThisMachineStayWhateverTheClockSays) {
  const WorkerRecord self = record_of_this_process();
  const auto work = work_of(self);
  for (const int hours : {-1000, 1000}) {
    let_be_silent(self, std::chrono::hours(hours));
    remove_stale_files(folder, now);
    EXPECT_TRUE(fs::exists(work[0]) && fs::exists(work[1])) << hours;
  }
}

TEST_F(Remains, OfAnotherMachineAreRemovedAfterADay) {
  const WorkerRecord other = of_another_machine();
  const auto work = work_of(other);
  for (const int hours : {-1000, 0, 23, 25}) {
    let_be_silent(other, std::chrono::hours(hours));
    remove_stale_files(folder, now);
    EXPECT_EQ(fs::exists(work[0]), hours < 24) << hours;
  }
}

TEST_F(Remains, KeepTheNewestRecordsOfWhoDrewFrames) {
  constexpr int more = 3;
  std::vector<fs::path> records;
  for (int i = 0; i < static_cast<int>(retained_records) + more; ++i) {
    WorkerRecord record = i % 2 == 0 ? of_another_machine() : of_the_dead();
    record.name = "host-" + std::to_string((37 * i) % 101);
    record.frames = 5;
    record.ended = i % 2 == 0;
    records.push_back(file(".mien/workers/" + record.name + ".json", to_json(record)));
    let_be_silent(record, std::chrono::hours(i));
  }
  WorkerRecord living = of_another_machine();
  living.name = "living";
  living.frames = 5;
  work_of(living);
  let_be_silent(living, std::chrono::hours(20));
  remove_stale_files(folder, now);
  for (std::size_t i = 0; i < records.size(); ++i)
    EXPECT_EQ(fs::exists(records[i]), i < retained_records) << i;
  EXPECT_TRUE(fs::exists(worker_record_path(folder, living.name)));
}

TEST_F(Remains, OfNobodyAreRemoved) {
  const fs::path unsigned_claim = file(".mien/claims/1", "");
  const fs::path folder_as_claim = file(".mien/claims/2/inside", "");
  const WorkerRecord dead = of_the_dead();
  work_of(dead);
  const fs::path unfinished = file(".mien/workers/" + dead.name + ".json.new", "{");
  const fs::path first = file(".mien/workers/host-1-2.json.new", "{");
  remove_stale_files(folder, now);
  EXPECT_FALSE(fs::exists(unsigned_claim));
  EXPECT_FALSE(fs::exists(folder_as_claim));
  EXPECT_FALSE(fs::exists(unfinished));
  EXPECT_TRUE(fs::exists(first)) << "it may be that of a process that begins";
}

TEST_F(Remains, OfAMadeStudyAreRemovedUnlessAnotherProcessDraws) {
  const WorkerRecord self = record_of_this_process();
  const WorkerRecord other = of_another_machine();
  work_of(of_the_dead());
  work_of(self);
  work_of(other);
  remove_intermediates(folder, now, self.name);
  EXPECT_FALSE(fs::exists(folder / ".mien/claims"));
  EXPECT_TRUE(fs::exists(folder / ".mien/partial"));
  let_be_silent(other, std::chrono::hours(1));
  remove_intermediates(folder, now, self.name);
  EXPECT_FALSE(fs::exists(folder / ".mien/partial"));
}

TEST_F(Remains, OfAProcessThatIsCalledAsAFileElsewhereAreNotLookedFor) {
  const fs::path elsewhere = temporary.path() / "settings.json";
  WorkerRecord planted = of_the_dead();
  for (const std::string& name :
       {std::string("../../../settings"), (temporary.path() / "settings").string()}) {
    planted.name = name;
    write_file(elsewhere, to_json(planted));
    const fs::path record = file(".mien/workers/planted.json", to_json(planted));
    const fs::path claim = file(".mien/claims/1", name + "\n");
    remove_stale_files(folder, now);
    EXPECT_TRUE(fs::exists(elsewhere)) << name;
    EXPECT_FALSE(fs::exists(claim)) << name;
    EXPECT_FALSE(read_worker_record(folder, name));
    EXPECT_FALSE(read_worker_record(folder, "planted"));
    fs::remove(record);
  }
}

}  // namespace
}  // namespace mien::pipeline
