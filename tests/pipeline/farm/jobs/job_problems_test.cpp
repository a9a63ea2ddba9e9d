#include "pipeline/farm/jobs/job_problems.h"

#include <fstream>

#include <gtest/gtest.h>

#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

/// Two submissions: 0001 of seven elements, and 0002, which has the first of them again.
class JobProblems : public testing::Test {
 protected:
  JobProblems() {
    std::string list;
    for (const char* film : {"a", "b", "c", "d", "e", "f", "g"})
      list += std::string("film:") + film + "[1/2]\n";
    write("farm/0001/2-frames.tasks", list);
    write("farm/0002/2-frames.tasks", "film:a[1/9] film:a[2/9]\n");
    add("0001", "2-frames", "17", 7);
    add("0001", "6-rest", "18", 0);
    add("0002", "2-frames", "27", 1);
    state.folder = temporary.path();
    state.graph_key = "now";
    state.words = "my.yaml";
  }

  void add(const std::string& submission, const std::string& name, const std::string& number,
           int elements) {
    JournalJob job;
    job.submission = submission;
    job.name = name;
    job.comment = "mien:now:" + submission + ":" + name;
    job.job = number;
    job.elements = elements;
    journal.jobs.push_back(job);
  }

  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((temporary.path() / name).parent_path());
    std::ofstream(temporary.path() / name) << text;
  }

  void end(int element, const std::string& told) const {
    write("farm/0001/ends/2-frames." + std::to_string(element), told);
  }

  /// Of elements of the first submission: "3 PENDING JobHeldUser".
  static std::string row(int index, const std::string& state, const std::string& reason) {
    const std::string number = std::to_string(index);
    return number + "|17|" + number + "|" + state + "|" + reason +
           "||0:00|mien:now:0001:2-frames\n";
  }

  std::vector<JobProblem> problems(const std::string& queue) const {
    return job_problems(job_statuses(journal, queue_rows(queue), temporary.path()), state);
  }

  std::string text(const std::string& queue) const { return problems_text(problems(queue)); }

  test::TemporaryFolder temporary;
  JournalContent journal;
  StudyState state;
};

TEST_F(JobProblems, ThatHaveOneCauseAreToldTogetherWithTheCommandThatGoesOn) {
  std::string queue;
  for (int i = 1; i <= 6; ++i) {
    end(i, "78 0 n1\n");
    queue += row(i, "SPECIAL_EXIT", "JobHeldUser");
  }
  queue += row(7, "PENDING", "JobHeldUser");
  EXPECT_EQ(text(queue),
            "held by Slurm: 1 job (17_7)\n"
            "  held by the user\n"
            "  scontrol release releases it; mien farm resume my.yaml submits it again\n"
            "held by Slurm: 6 jobs (17_1, 17_2, 17_3, 17_4 and 2 more)\n"
            "  wrong configuration: manifest or list missing, or a different version of mien or "
            "kind of processor than at submission (exit code 78)\n"
            "  mien farm logs my.yaml shows the error; fix it, then mien farm resume my.yaml\n");
}

TEST_F(JobProblems, OfAStudyThatWasEditedAreOfTheEdit) {
  end(1, "78 0 n1\n");
  end(4, "65 0 n1\n");
  state.graph_key = "another";
  const auto found = problems(row(1, "SPECIAL_EXIT", "JobHeldUser") + row(2, "RUNNING", "None") +
                              row(3, "PENDING", "Priority") +
                              "8|18|N/A|PENDING|Dependency||0:00|mien:now:0001:6-rest\n");
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].kind, JobProblem::Kind::held);
  EXPECT_EQ(found[1].kind, JobProblem::Kind::outdated);
  EXPECT_EQ(found[2].job, "17_3");
  for (const JobProblem& one : found) {
    EXPECT_TRUE(one.cause.starts_with("the manifest was edited after submission")) << one.cause;
  }
}

TEST_F(JobProblems, TellHowWhatEndedDid) {
  end(2, "137 0 n1\n");
  end(3, "139 0 n1\n");
  end(4, "75 3 n2\n");
  end(5, "70 0 n2\n");
  std::string causes;
  for (const JobProblem& one :
       problems(row(6, "FAILED", "RaisedSignal:9(Killed)") + row(7, "TIMEOUT", "TimeLimit"))) {
    EXPECT_EQ(one.kind, JobProblem::Kind::ended);
    causes += one.element + " " + one.cause + "\n";
  }
  EXPECT_EQ(causes,
            "2-frames.2 killed from outside (exit code 137, SIGKILL)\n"
            "2-frames.3 crashed (exit code 139: Segmentation fault)\n"
            "2-frames.4 stopped, or failed because of the machine, 4 times (exit code 70)\n"
            "2-frames.5 failed (exit code 70)\n"
            "2-frames.6 killed or not started, without an error message (RaisedSignal:9(Killed))\n"
            "2-frames.7 time limit reached\n");
}

TEST_F(JobProblems, AreOfMemoryOnlyWhereSlurmOrTheControlGroupCountsThat) {
  end(1, "137 0 n1\n");
  end(2, "137 0 n1 \n");
  end(3, "137 0 n1 memory\n");
  end(4, "137 0 n1\n");
  state.done = {"film:a"};
  std::string causes;
  for (const JobProblem& one : problems(row(2, "FAILED", "RaisedSignal:9(Killed)") +
                                        row(4, "OUT_OF_MEMORY", "OutOfMemory"))) {
    const bool is_of_memory = one.cause == "out of memory";
    EXPECT_EQ((one.cause + one.remedy).find("memory") != std::string::npos, is_of_memory)
        << one.cause << ": " << one.remedy;
    causes += one.element + (is_of_memory ? " memory\n" : " killed\n");
  }
  EXPECT_EQ(causes, "2-frames.2 killed\n2-frames.3 memory\n2-frames.4 memory\n");
}

TEST_F(JobProblems, OfAFolderThatWasNotWellSaySo) {
  end(1, "74 3 n1 \n");
  end(2, "");  // the disk was full
  const auto found =
      problems(row(1, "SPECIAL_EXIT", "JobHeldUser") + row(2, "SPECIAL_EXIT", "JobHeldUser") +
               row(3, "FAILED", "NonZeroExitCode"));
  ASSERT_EQ(found.size(), 3u);
  EXPECT_TRUE(found[0].cause.starts_with("gave up waiting for the study's folder"))
      << found[0].cause;
  EXPECT_TRUE(found[1].cause.starts_with("put itself on hold without a recorded reason"))
      << found[1].cause;
  EXPECT_TRUE(found[2].cause.starts_with("ended on its own without a recorded reason"))
      << found[2].cause;
  for (const JobProblem& one : found) {
    EXPECT_NE(one.cause.find("full, read-only or unavailable"), std::string::npos) << one.cause;
    EXPECT_TRUE(one.remedy.starts_with("free space in it or restore it, then mien farm resume"));
  }
}

TEST_F(JobProblems, AreNoneOnceItIsMadeOrSubmittedAgainOrTriedAgain) {
  end(1, "1 0 n1\n");  // the second submission has it, cut otherwise
  end(2, "1 0 n1\n");
  end(3, "75 1 n1\n");
  state.done = {"film:b"};
  EXPECT_EQ(text(row(3, "PENDING", "BeginTime")), "");
}

TEST_F(JobProblems, KnowWhatWasCancelled) {
  end(2, "75 0 n1\n");
  end(3, "1 0 n1\n");
  journal.jobs[0].was_cancelled = true;
  const auto found = problems(row(4, "CANCELLED", "None"));
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].kind, JobProblem::Kind::cancelled);
  EXPECT_EQ(found[1].kind, JobProblem::Kind::ended);
  EXPECT_EQ(found[2].kind, JobProblem::Kind::cancelled);
}

TEST_F(JobProblems, OfWhatNoNodeHasSayWhatToAskForInstead) {
  const std::string told = text(row(2, "PENDING", "PartitionConfig"));
  EXPECT_NE(told.find("no node of the partition satisfies the request"), std::string::npos) << told;
  EXPECT_NE(told.find("mien farm resume my.yaml --jobs 1"), std::string::npos) << told;
}

}  // namespace
}  // namespace mien::pipeline
