// What the commands of a farm do where there is no Slurm.

#include <cstdlib>

#include "end_to_end/farm_study.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;

/// A Slurm that is not there: none of its commands is found.
class WithoutSlurm : public Farm {
 protected:
  WithoutSlurm() : path_(std::getenv("PATH")) { ::setenv("PATH", scratch.path().c_str(), 1); }
  ~WithoutSlurm() override { ::setenv("PATH", path_.c_str(), 1); }

 private:
  std::string path_;
};

TEST_F(WithoutSlurm, ADryRunPrintsJobsAndWritesNothing) {
  const Ended ended = farm({"submit"}, {"--dry-run", "--chunk", "4", "--mem", "1G"});
  EXPECT_EQ(ended.code, 0) << ended.errors;
  for (const char* words :
       {"1-motions    1 element", "2-frames", "film:one[1/", "6-rest       the rest",
        "#SBATCH --mem=\"1G\"", "tables films design report"}) {
    EXPECT_NE(ended.output.find(words), std::string::npos) << words;
  }
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(WithoutSlurm, SubmittingSaysWhatIsMissing) {
  const Ended ended = farm({"submit"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_NE(ended.errors.find("Slurm is not installed"), std::string::npos) << ended.errors;
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(WithoutSlurm, StatusTellsWhatTheStoreHas) {
  EXPECT_EQ(status()["complete"], false);
  ASSERT_EQ(run_mien({"run", manifest.string(), "--out", out.string()}).code, 0);
  EXPECT_EQ(status()["complete"], true);
  EXPECT_EQ(farm({"status"}, {"--watch", "0.5"}).code, 0);
}

TEST_F(WithoutSlurm, BadOptionsAreToldBeforeAnythingIsDone) {
  EXPECT_EQ(farm({"submit"}, {"--chunk", "many"}).code, 2);
  EXPECT_EQ(farm({"submit"}, {"--mem", "2 GB"}).code, 2);
  EXPECT_EQ(farm({"submit"}, {"--time", "an hour"}).code, 2);
  EXPECT_EQ(farm({"submit"}, {"--partition", "a\nb"}).code, 2);
  EXPECT_EQ(farm({"resume"}).code, 2);
  EXPECT_EQ(farm({"logs"}, {"film:nobody"}).code, 2);
  EXPECT_EQ(run_mien({"farm", "export", manifest.string(), "--format", "openjd", "-o",
                      (scratch.path() / "job.txt").string()})
                .code,
            2);
  EXPECT_FALSE(fs::exists(out));
  EXPECT_FALSE(fs::exists(scratch.path() / "job.txt"));
}

TEST_F(WithoutSlurm, SaysWhatAnOptionTakesAndWhatAnItemIsCalled) {
  const auto says = [](const Ended& ended, const char* words) {
    EXPECT_NE(ended.errors.find(words), std::string::npos) << ended.errors;
  };
  says(farm({"submit"}, {"--time", "1h"}), "\"1h\" is not a valid Slurm time limit; write minutes");
  says(farm({"submit"}, {"--mem", "2 GB"}), "\"2 GB\" is not a valid amount of memory");
  says(farm({"logs"}, {"film:oen"}), "did you mean \"film:one\"?");
  const Ended none = farm({"cancel"});
  EXPECT_EQ(none.code, 0) << none.errors;
  EXPECT_NE(none.output.find("no job of this study is queued or running"), std::string::npos);
}

TEST_F(WithoutSlurm, AWorkerPassesOverAnEmptyLineAndTellsOfEmptyParts) {
  const std::string list = scratch.write("some.tasks", "\nfilm:one[1/500]\n").string();
  const Ended empty = farm({"worker"}, {"--list", list, "--line", "1"});
  EXPECT_EQ(empty.code, 0);
  EXPECT_NE(empty.errors.find("some.tasks:1: the line is empty"), std::string::npos);
  const Ended part = farm({"worker"}, {"--list", list, "--line", "2"});
  EXPECT_EQ(part.code, 0) << part.errors;
  EXPECT_NE(part.errors.find("note: film:one[1/500]: the film has "), std::string::npos)
      << part.errors;
  const Ended beyond = farm({"worker"}, {"--tasks", "film:one[5/2]"});
  EXPECT_EQ(beyond.code, 65);
  EXPECT_NE(beyond.errors.find("none with the number 5"), std::string::npos) << beyond.errors;
}

TEST_F(WithoutSlurm, AnExportedJobIsTheSameEachTime) {
  const auto exported = [&] {
    return run_mien({"farm", "export", manifest.string(), "--format", "openjd", "--chunk", "4"});
  };
  const Ended first = exported();
  EXPECT_EQ(first.code, 0) << first.errors;
  EXPECT_NE(first.output.find("\"specificationVersion\": \"jobtemplate-2023-09\""),
            std::string::npos);
  EXPECT_EQ(first.output, exported().output);
}

}  // namespace
}  // namespace mien::test
