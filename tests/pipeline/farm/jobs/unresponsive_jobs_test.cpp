#include "pipeline/farm/jobs/unresponsive_jobs.h"

#include <gtest/gtest.h>

#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

/// An array of three elements, 17, on nodes n1 and n2.
class SilentJobs : public testing::Test {
 protected:
  SilentJobs() {
    JournalJob job;
    job.submission = "0001";
    job.name = "2-frames";
    job.comment = "mien:now:0001:2-frames";
    job.job = "17";
    job.elements = 3;
    journal.jobs.push_back(job);
    evidence.nodes = node_states("n1|allocated\nn2|mixed\n");
  }

  /// Of an element whose job has the number 20 more than its index.
  static std::string row(int index, const std::string& state, const std::string& node,
                         const std::string& elapsed) {
    return std::to_string(20 + index) + "|17|" + std::to_string(index) + "|" + state + "|None|" +
           node + "|" + elapsed + "|mien:now:0001:2-frames\n";
  }

  static WorkerReport worker(const std::string& host, const std::string& job) {
    WorkerReport report;
    report.host = host;
    report.job = job;
    return report;
  }

  std::vector<JobProblem> unresponsive(const std::string& queue) const {
    return unresponsive_jobs(job_statuses(journal, queue_rows(queue), temporary.path()), evidence,
                             "my.yaml");
  }

  test::TemporaryFolder temporary;
  JournalContent journal;
  LivenessEvidence evidence;
};

TEST_F(SilentJobs, AreThoseWhoseNodeDoesNotAnswerAndAreToldWithTheCommands) {
  for (const char* state : {"allocated*", "down*", "down"}) {
    evidence.nodes["n1"] = state;
    const auto found =
        unresponsive(row(1, "RUNNING", "n1", "0:05") + row(2, "RUNNING", "n2", "0:05") +
                     row(3, "COMPLETING", "n1", "0:05"));
    EXPECT_EQ(problems_text(found),
              "unresponsive, although running according to Slurm: 2 jobs (17_1, 17_3)\n"
              "  n1 does not answer (" +
                  std::string(state) +
                  ")\n"
                  "  scontrol show node n1 shows its state; scancel 17_1 17_3, then mien farm "
                  "resume my.yaml submits what is missing. Jobs that remain nevertheless end when "
                  "an administrator takes the node down: scontrol update NodeName=n1 State=DOWN "
                  "Reason=silent\n");
  }
}

TEST_F(SilentJobs, AreThoseThatTheirNodeCannotEnd) {
  const std::string ending = row(1, "COMPLETING", "n1", "1:00:00");
  EXPECT_TRUE(unresponsive(ending).empty()) << "it has just come to its end";
  evidence.nodes["n1"] = "drained";
  ASSERT_EQ(unresponsive(ending).size(), 1u);
  EXPECT_EQ(unresponsive(ending)[0].cause, "n1 cannot end their processes (drained)");
  evidence.workers = {worker("n1", "21")};
  EXPECT_TRUE(unresponsive(row(1, "RUNNING", "n1", "1:00:00")).empty())
      << "a drained node ends its jobs";
}

TEST_F(SilentJobs, AreThoseOfWhichNoWorkerWasHeardOfForMinutes) {
  const auto count = [&](const char* elapsed) {
    return unresponsive(row(1, "RUNNING", "n1", elapsed)).size();
  };
  EXPECT_EQ(count("6:30"), 0u) << "it may have begun just now, by another clock";
  EXPECT_EQ(count("7:30"), 1u);
  EXPECT_EQ(count("1:00:00"), 1u);
  EXPECT_EQ(count("2-00:00:00"), 1u);
  EXPECT_EQ(count("INVALID"), 0u);
  evidence.workers = {worker("n1", "22")};
  EXPECT_EQ(count("7:30"), 1u) << "another job's";
  evidence.workers = {worker("n1", "21")};
  EXPECT_EQ(count("7:30"), 0u);
  evidence.workers[0].report_age_s = 430.0;
  EXPECT_EQ(count("7:30"), 1u);
  evidence.workers[0].report_age_s = 0.0;
  evidence.workers[0].has_ended = true;
  EXPECT_EQ(count("7:30"), 1u);
  evidence.workers = {worker("n1", "")};
  EXPECT_EQ(count("7:30"), 0u) << "it may be this job's";
  evidence.workers = {worker("n2", "")};
  EXPECT_EQ(count("7:30"), 1u);
  evidence.folder_is_usable = false;
  EXPECT_EQ(count("7:30"), 0u) << "it waits for the folder";
}

TEST_F(SilentJobs, AreNoneThatWaitOrAreOver) {
  evidence.nodes["n1"] = "down*";
  EXPECT_TRUE(unresponsive(row(1, "PENDING", "", "0:00") + row(2, "FAILED", "n1", "5:00") +
                           row(3, "COMPLETED", "n1", "5:00"))
                  .empty());
  evidence.nodes.clear();
  EXPECT_TRUE(unresponsive(row(1, "COMPLETING", "n1", "5:00")).empty()) << "Slurm does not tell";
}

}  // namespace
}  // namespace mien::pipeline
