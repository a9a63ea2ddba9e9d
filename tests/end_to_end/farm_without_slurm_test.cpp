// What the commands of a farm do where there is no Slurm, and where programs stand in for it.

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "pipeline/farm/fake_programs.h"

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

/// Programs that answer as those of Slurm. The jobs that they accept never run.
class StandInSlurm : public Farm {
 protected:
  StandInSlurm() {
    ::unsetenv("SLURM_CONF");
    const std::string at = programs.folder().string();
    for (const char* silent : {"scontrol", "sinfo", "squeue"}) programs.say(silent, "");
    programs.add("sbatch", "echo x >>" + at + "/count; wc -l <" + at + "/count");
    programs.add("scancel", "echo \"$@\" >>" + at + "/cancelled");
  }

  /// Lets squeue list the first job of the newest submission, as "17_1".
  void queue_a_job() const {
    std::istringstream journal(text_of(study / "farm/journal.jsonl"));
    std::string comment;
    for (std::string line; std::getline(journal, line);) {
      const auto entry = nlohmann::json::parse(line);
      if (entry["event"] == "intent" && entry["name"] == "1-motions")
        comment = entry["comment"].get<std::string>();
    }
    programs.say("squeue", "18|17|1|PENDING|Priority||0:00|" + comment + "\n");
  }

  FakePrograms programs;
  fs::path study = out / "tiny";
};

TEST_F(StandInSlurm, TheLastJobIsSubmittedAgainIfTheRecordIsNotOfTheStudy) {
  ASSERT_EQ(run_mien({"run", manifest.string(), "--out", out.string()}).code, 0);
  EXPECT_NE(farm({"submit"}).output.find("everything is done"), std::string::npos);
  std::ofstream(study / "provenance.json") << "{}\n";
  EXPECT_EQ(status()["complete"], false);
  const Ended submitted = farm({"submit"});
  EXPECT_EQ(submitted.code, 0) << submitted.errors;
  EXPECT_NE(submitted.output.find("6-rest       the rest"), std::string::npos) << submitted.output;
  EXPECT_EQ(submitted.output.find("1-motions"), std::string::npos) << submitted.output;
  EXPECT_NE(farm({"resume"}).output.find("6-rest"), std::string::npos);
}

TEST_F(StandInSlurm, ResumesWithTheQualityOfTheSubmission) {
  const auto motions = [&](const char* number) {
    return text_of(study / "farm" / number / "1-motions.sbatch");
  };
  ASSERT_EQ(farm({"submit"}, {"--quality", "standard"}).code, 0);
  EXPECT_NE(motions("0001").find("--quality 'standard'"), std::string::npos);
  const Ended resumed = farm({"resume"});
  ASSERT_EQ(resumed.code, 0) << resumed.errors;
  EXPECT_NE(motions("0002").find("--quality 'standard'"), std::string::npos) << motions("0002");
  EXPECT_NE(resumed.errors.find("note: --quality standard, as in submission 0001"),
            std::string::npos)
      << resumed.errors;
  EXPECT_NE(resumed.output.find("--quality standard shows the progress"), std::string::npos);
  ASSERT_EQ(farm({"resume"}, {"--quality", "final"}).code, 0);
  EXPECT_NE(motions("0003").find("--quality 'final'"), std::string::npos) << motions("0003");
}

TEST_F(StandInSlurm, CancelsJobsOfWhichTheFolderIsAway) {
  ASSERT_EQ(farm({"submit"}).code, 0);
  queue_a_job();
  fs::remove_all(study);
  const Ended cancelled = farm({"cancel"});
  EXPECT_EQ(cancelled.code, 0) << cancelled.errors;
  EXPECT_NE(cancelled.output.find("1 job cancelled"), std::string::npos) << cancelled.output;
  EXPECT_EQ(programs.text_of("cancelled"), "17_1\n");
  EXPECT_FALSE(fs::exists(study)) << "its disk may not be mounted";
}

}  // namespace
}  // namespace mien::test
