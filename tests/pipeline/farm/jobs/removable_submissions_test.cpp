#include <fstream>

#include <gtest/gtest.h>

#include "pipeline/farm/jobs/job_status.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using Numbers = std::vector<std::string>;

/// Six submissions of a study, each of which was to make one film of its own, and what was left.
class SpentSubmissions : public testing::Test {
 protected:
  SpentSubmissions() {
    for (int i = 1; i <= 6; ++i) {
      const std::string number = "000" + std::to_string(i);
      add(number, "2-frames", 1);
      add(number, "6-rest", 0);
      fs::create_directories(at(number) / "log");
      std::ofstream(at(number) / "2-frames.tasks")
          << "film:" << i << "[1/2] film:" << i << "[2/2]\n";
    }
    fs::create_directories(at("failures"));
  }

  void add(const std::string& number, const std::string& name, int elements) {
    JournalJob job;
    job.submission = number;
    job.name = name;
    job.comment = "mien:now:" + number + ":" + name;
    job.job = "17";
    job.elements = elements;
    journal.jobs.push_back(job);
  }

  fs::path at(const std::string& number) const { return temporary.path() / "farm" / number; }

  Numbers removable(const std::set<std::string>& due, const std::string& queue = "") const {
    return removable_submissions(job_statuses(journal, queue_rows(queue), temporary.path()), due,
                                 temporary.path());
  }

  test::TemporaryFolder temporary;
  JournalContent journal;
};

TEST_F(SpentSubmissions, AreAllButTheNewestOnceAllIsMade) {
  EXPECT_EQ(removable({}), (Numbers{"0001", "0002", "0003"}));
}

TEST_F(SpentSubmissions, AreNoneThatWereToMakeWhatIsMissingStill) {
  EXPECT_EQ(removable({"film:2"}), (Numbers{"0001", "0003"}));
  EXPECT_EQ(removable({"film:22"}), (Numbers{"0001", "0002", "0003"}));
}

TEST_F(SpentSubmissions, AreNoneOfWhichAJobWaitsRunsOrEnds) {
  for (const char* state : {"PENDING", "RUNNING", "COMPLETING", "SPECIAL_EXIT"}) {
    EXPECT_EQ(
        removable({}, std::string("17|17|N/A|") + state + "|None||0:00|mien:now:0003:6-rest\n"),
        (Numbers{"0001", "0002"}))
        << state;
  }
  EXPECT_EQ(removable({}, "17|17|N/A|COMPLETED|None||0:00|mien:now:0003:6-rest\n").size(), 3u);
}

TEST_F(SpentSubmissions, AreRemovedAndNothingBesideThem) {
  const fs::path elsewhere = temporary.path() / "elsewhere";
  fs::create_directories(elsewhere);
  std::ofstream(elsewhere / "kept") << "x";
  fs::remove_all(at("0002"));
  fs::create_directory_symlink(elsewhere, at("0002"));
  add("failures", "2-frames", 1);
  add("a", "2-frames", 1);
  EXPECT_EQ(remove_submissions(removable({}), temporary.path()), 3);
  EXPECT_TRUE(fs::exists(at("failures")));
  EXPECT_TRUE(fs::exists(elsewhere / "kept"));
  EXPECT_FALSE(fs::exists(at("0001")));
  EXPECT_TRUE(fs::exists(at("0006")));
  EXPECT_EQ(remove_submissions(removable({}), temporary.path()), 0);
}

}  // namespace
}  // namespace mien::pipeline
