#include <fstream>
#include <memory>
#include <regex>

#include "end_to_end/farm_study.h"
#include "end_to_end/slurm_cluster.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;

/// With the two-node cluster.
class FarmOnSlurm : public Farm {
 protected:
  void SetUp() override { start(SlurmCluster::Requeue::by_site); }

  void start(SlurmCluster::Requeue requeue) {
    cluster.reset();
    if (const std::string obstacle = SlurmCluster::obstacle(); !obstacle.empty()) {
      GTEST_SKIP() << "Slurm cannot run here: " << obstacle;
    }
    try {
      cluster = std::make_unique<SlurmCluster>(requeue);
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << "Slurm cannot run here: " << error.what();
    }
  }

  fs::path submission(const std::string& number = "0001") const {
    return out / "tiny" / "farm" / number;
  }

  /// A batch file whose jobs run another program, as a person might change it. Gives its job.
  std::string submit_changed(const fs::path& script, const fs::path& program,
                             const std::vector<std::string>& more = {}) const {
    const std::string text = std::regex_replace(text_of(script), std::regex("\nmien='[^\n]*'\n"),
                                                "\nmien='" + program.string() + "'\n");
    std::ofstream(script) << text;
    std::vector<std::string> words = {"sbatch", "--parsable"};
    words.insert(words.end(), more.begin(), more.end());
    words.push_back(script.string());
    const std::string job = must_run(words);
    return job.substr(0, job.find('\n'));
  }

  fs::path stand_in(const std::string& script) const {
    const std::string name = "stand-in-" + std::to_string(std::hash<std::string>()(script));
    const fs::path file = scratch.write(name, "#!/bin/bash\n" + script + "\n");
    fs::permissions(file, fs::perms::owner_all);
    return file;
  }

  /// Submits and takes all of it back, for the files.
  void write_files() const {
    ASSERT_EQ(farm({"submit"}, {"--chunk", "4"}).code, 0);
    ASSERT_EQ(farm({"cancel"}).code, 0);
    ASSERT_TRUE(cluster->wait_until_empty(30.0));
  }

  std::string log_of(const std::string& name, const std::string& element) const {
    return text_of(submission() / "log" / ("tiny-" + name + "-" + element + ".log"));
  }

  /// The state in which an element of a job ended or is, "" when Slurm has it not.
  std::string state_of(const std::string& job, const std::string& index) const {
    for (const std::string& row : cluster->queue()) {
      if (row.starts_with(job + "|" + index + "|")) {
        const std::string rest = row.substr(job.size() + index.size() + 2);
        return rest.substr(0, rest.find('|'));
      }
    }
    return "";
  }

  /// A job that ends each time as if it had better be tried again.
  std::string submit_transient() const {
    write_files();
    return submit_changed(submission() / "2-frames.sbatch", stand_in("echo tried; exit 75"),
                          {"--array=2"});
  }

  int tries_of(const std::string& job) const {
    const std::string log = log_of("2-frames", job + "_2");
    int tries = 0;
    for (auto at = log.find("tried\n"); at != std::string::npos; at = log.find("tried\n", at + 1))
      ++tries;
    return tries;
  }

  std::unique_ptr<SlurmCluster> cluster;
};

TEST_F(FarmOnSlurm, MakesAStudyAndKnowsIt) {
  const Ended refused = farm({"submit"}, {"--program", (scratch.path() / "none").string()});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.errors.find("is not a program"), std::string::npos) << refused.errors;
  // As where nodes have no mien: a script starts it, as one would in a container.
  const fs::path used = scratch.path() / "used";
  const fs::path program = stand_in("echo \"$SLURMD_NODENAME\" >>'" + used.string() + "'; exec '" +
                                    MIEN_PROGRAM + "' \"$@\"");
  const Ended submitted = farm({"submit"}, {"--chunk", "4", "--program", program.string()});
  ASSERT_EQ(submitted.code, 0) << submitted.errors;
  EXPECT_NE(submitted.output.find("2-frames"), std::string::npos);
  EXPECT_TRUE(status()["active"]);

  const Ended second = farm({"submit"});
  EXPECT_EQ(second.code, 2);
  EXPECT_NE(second.errors.find("has been submitted already"), std::string::npos) << second.errors;

  ASSERT_TRUE(cluster->wait_until_empty(120.0));
  EXPECT_TRUE(status()["complete"]) << farm({"logs"}).output;
  EXPECT_NE(text_of(used).find("n1\n"), std::string::npos);
  EXPECT_NE(farm({"submit"}).output.find("nothing to do"), std::string::npos);
  EXPECT_NE(farm({"resume"}).output.find("nothing to do"), std::string::npos);
}

TEST_F(FarmOnSlurm, PutsBackWhatIsTransient) {
  start(SlurmCluster::Requeue::by_job);
  if (IsSkipped()) return;
  const std::string job = submit_transient();
  EXPECT_TRUE(wait_until(60.0, [&] { return tries_of(job) == 2; })) << state_of(job, "2");
}

TEST_F(FarmOnSlurm, PutsBackWhatIsTransientThreeTimesWhoeverDoesIt) {
  for (const auto requeue : {SlurmCluster::Requeue::by_site, SlurmCluster::Requeue::by_job}) {
    if (requeue == SlurmCluster::Requeue::by_job) start(requeue);
    if (IsSkipped()) return;
    fs::remove_all(out);
    const std::string job = submit_transient();
    EXPECT_TRUE(wait_until(120.0, [&] { return state_of(job, "2") == "FAILED"; }))
        << state_of(job, "2");
    const std::string log = log_of("2-frames", job + "_2");
    EXPECT_EQ(tries_of(job), 4) << log;
    EXPECT_NE(log.find("ended with 75 on n"), std::string::npos) << log;
  }
}

TEST_F(FarmOnSlurm, HoldsAWrongSetUpUntilItIsResumed) {
  write_files();
  const std::string job =
      submit_changed(submission() / "2-frames.sbatch", stand_in("exit 78"), {"--array=1"});
  EXPECT_TRUE(wait_until(60.0, [&] { return !status()["held"].empty(); }));
  EXPECT_EQ(status()["held"][0]["job"], job + "_1");
  EXPECT_NE(farm({"logs"}).output.find("ended with 78"), std::string::npos);
  const std::string told = farm({"status"}).output;
  EXPECT_NE(told.find("held by Slurm: 1 job (" + job + "_1)\n  wrong configuration"),
            std::string::npos)
      << told;
  const Ended dry = farm({"resume"}, {"--dry-run"});
  EXPECT_NE(dry.errors.find("is to be cancelled"), std::string::npos) << dry.errors;
  EXPECT_NE(dry.output.find("0002/6-rest.sbatch"), std::string::npos) << dry.output;
  EXPECT_FALSE(fs::exists(submission("0002")));
  EXPECT_FALSE(status()["held"].empty());
  ASSERT_EQ(farm({"resume"}).code, 0);
  ASSERT_TRUE(cluster->wait_until_empty(120.0));
  EXPECT_TRUE(status()["complete"]);
}

TEST_F(FarmOnSlurm, TellsWhatCrashed) {
  write_files();
  submit_changed(submission() / "2-frames.sbatch", stand_in("kill -SEGV $$"), {"--array=1-2"});
  EXPECT_TRUE(wait_until(60.0, [&] { return status()["ended"].size() == 2; })) << status().dump();
  const std::string told = farm({"status"}).output;
  EXPECT_NE(told.find("\n  crashed (exit code 139: "), std::string::npos) << told;
  EXPECT_NE(farm({"logs"}).output.find("0001/2-frames.2, crashed"), std::string::npos);
}

TEST_F(FarmOnSlurm, PassesScancelOnToTheWorker) {
  write_files();
  const fs::path trace = scratch.path() / "trace";
  const std::string job = submit_changed(
      submission() / "2-frames.sbatch",
      stand_in("trap 'trap \"\" TERM; echo stopped >>" + trace.string() +
               "; exit 75' TERM\necho begun >>" + trace.string() + "\nwhile :; do sleep 0.1; done"),
      {"--array=1"});
  ASSERT_TRUE(wait_until(30.0, [&] { return text_of(trace) == "begun\n"; }));
  ASSERT_EQ(farm({"cancel"}).code, 0);
  ASSERT_TRUE(cluster->wait_until_empty(30.0));
  EXPECT_EQ(text_of(trace), "begun\nstopped\n");
  EXPECT_EQ(state_of(job, "1"), "CANCELLED");
  const std::string logs = farm({"logs"}).output;
  EXPECT_EQ(logs.find("==>"), std::string::npos) << logs;
  EXPECT_NE(logs.find("cancelled jobs are not shown"), std::string::npos) << logs;
}

TEST_F(FarmOnSlurm, WaitsForAFolderThatIsAwayAndTakesScancel) {
  write_files();
  const fs::path script = scratch.path() / "frames.sbatch";
  fs::copy_file(submission() / "2-frames.sbatch", script);
  const fs::path away = out.string() + "-away";
  fs::rename(out, away);
  const std::string answer = must_run({"sbatch", "--parsable", "--array=1", script.string()});
  const std::string number = answer.substr(0, answer.find('\n'));
  const std::string cancelled = submit_changed(script, stand_in("exit 0"), {"--array=2"});
  ASSERT_TRUE(wait_until(30.0, [&] {
    return state_of(number, "1") == "RUNNING" && state_of(cancelled, "2") == "RUNNING";
  })) << state_of(number, "1");
  const std::string told = farm({"status"}).output;
  EXPECT_NE(told.find("tiny does not exist, but Slurm has jobs that work in it"), std::string::npos)
      << told;
  const Ended submitted = farm({"submit"});
  EXPECT_NE(submitted.code, 0);
  EXPECT_NE(submitted.errors.find("check that its disk is mounted"), std::string::npos)
      << submitted.errors;
  EXPECT_FALSE(fs::exists(out)) << "it was made anew";
  must_run({"scancel", cancelled});
  EXPECT_TRUE(wait_until(8.0, [&] { return state_of(cancelled, "2") == "CANCELLED"; }))
      << state_of(cancelled, "2");
  fs::rename(away, out);
  ASSERT_TRUE(cluster->wait_until_empty(60.0));
  EXPECT_EQ(state_of(number, "1"), "COMPLETED");
  EXPECT_NE(log_of("2-frames", number + "_1").find("mien farm: continues after"), std::string::npos)
      << log_of("2-frames", number + "_1");
  EXPECT_NE(farm({"logs"}, {"film:one"}).output.find("continues after"), std::string::npos);
}

TEST_F(FarmOnSlurm, TellsOfJobsWhoseNodeDoesNotAnswer) {
  write_files();
  const std::string job =
      submit_changed(submission() / "2-frames.sbatch", stand_in("exec sleep 300"), {"--array=1-2"});
  ASSERT_TRUE(wait_until(30.0, [&] { return status()["running"] == 2; }));
  cluster->kill_node(1);
  std::string told;
  EXPECT_TRUE(wait_until(60.0, [&] {
    told = farm({"status"}).output;
    return told.find("\n  n1 does not answer (") != std::string::npos;
  })) << told;
  EXPECT_NE(told.find("scontrol show node n1"), std::string::npos) << told;
  EXPECT_NE(told.find("scancel " + job + "_"), std::string::npos) << told;
}

TEST_F(FarmOnSlurm, NoticesThatTheControllerForgotAllAndGoesOn) {
  ASSERT_EQ(farm({"submit"}, {"--chunk", "4"}).code, 0);
  cluster->kill_controller();
  cluster->kill_steps();
  cluster->start_controller(true);
  ASSERT_TRUE(wait_until(30.0, [&] { return run_program({"squeue", "-h"}, 10.0).code == 0; }));
  // Somebody else gets the numbers that our jobs had.
  scratch.write("other.sh", "#!/bin/sh\nsleep 300\n");
  for (int i = 0; i < 3; ++i) {
    must_run({"sbatch", "--hold", "--output=/dev/null", (scratch.path() / "other.sh").string()});
  }
  EXPECT_FALSE(status()["lost"].empty());
  const Ended resumed = farm({"resume"});
  ASSERT_EQ(resumed.code, 0) << resumed.errors;
  EXPECT_NE(resumed.errors.find("no longer has job"), std::string::npos) << resumed.errors;
  ASSERT_EQ(farm({"cancel"}).code, 0);
  int others = 0;
  for (const std::string& row : cluster->queue()) {
    if (row.find("|PENDING|JobHeldUser|") != std::string::npos) ++others;
  }
  EXPECT_EQ(others, 3) << "cancel has taken somebody else's jobs";
}

TEST_F(FarmOnSlurm, TakesAJobThatTheJournalDoesNotKnowForItsOwn) {
  ASSERT_EQ(farm({"submit"}, {"--chunk", "4"}).code, 0);
  const fs::path journal = out / "tiny/farm/journal.jsonl";
  std::string text = text_of(journal);
  text.resize(text.rfind("{\"event\":\"submitted\"") + 20);  // the client was killed just then
  std::ofstream(journal) << text;
  const Ended resumed = farm({"resume"});
  ASSERT_EQ(resumed.code, 0) << resumed.errors;
  ASSERT_TRUE(cluster->wait_until_empty(120.0));
  EXPECT_TRUE(status()["complete"]);
}

TEST_F(FarmOnSlurm, LeavesNoJobWaitingForWhatCannotHappen) {
  write_files();
  const std::string failing =
      submit_changed(submission() / "2-frames.sbatch", stand_in("exit 65"), {"--array=1"});
  const std::string waiting = submit_changed(submission() / "3-films.sbatch", stand_in("exit 0"),
                                             {"--array=1", "--dependency=afterok:" + failing});
  ASSERT_TRUE(cluster->wait_until_empty(60.0)) << status().dump();
  EXPECT_EQ(state_of(waiting, "1"), "CANCELLED");
}

TEST_F(FarmOnSlurm, RefusesWhatNoNodeHasAndForgetsIt) {
  const Ended many = farm({"submit"}, {"--jobs", "64"});
  EXPECT_EQ(many.code, 2);
  EXPECT_NE(many.errors.find("has more than 1 processor"), std::string::npos) << many.errors;
  EXPECT_FALSE(fs::exists(submission()));
  EXPECT_EQ(farm({"submit"}, {"--mem", "900T"}).code, 1);
  EXPECT_FALSE(fs::exists(submission()));
  const Ended nothing = farm({"resume"});
  EXPECT_NE(
      nothing.errors.find("nothing has been submitted yet (Slurm refused earlier submissions)"),
      std::string::npos)
      << nothing.errors;
  ASSERT_EQ(farm({"submit"}, {"--chunk", "4"}).code, 0);
  EXPECT_TRUE(fs::exists(submission("0002")));
  ASSERT_EQ(farm({"cancel"}).code, 0);
  ASSERT_TRUE(cluster->wait_until_empty(30.0));
  const Ended resumed = farm({"resume"});
  EXPECT_EQ(resumed.code, 0) << resumed.errors;
  EXPECT_EQ(text_of(submission("0003") / "2-frames.sbatch").find("900T"), std::string::npos);
}

TEST_F(FarmOnSlurm, KeepsTheCutOfWhatWaitsAndSubmitsTheRestAlone) {
  write_files();
  const std::string before = text_of(submission() / "2-frames.tasks");
  ASSERT_TRUE(before.starts_with("film:one[1/3]\nfilm:one[2/3]\nfilm:one[3/3]\n")) << before;
  must_run({"sbatch", "--parsable", "--begin=now+1hour", "--array=2-3",
            (submission() / "2-frames.sbatch").string()});
  const Ended resumed = farm({"resume"}, {"--chunk", "2"});
  ASSERT_EQ(resumed.code, 0) << resumed.errors;
  const std::string list = text_of(submission("0002") / "2-frames.tasks");
  EXPECT_TRUE(list.starts_with("film:one[1/3]\nfilm:two[1/")) << list;
}

TEST_F(FarmOnSlurm, ResumesWhatKilledJobsLeft) {
  ASSERT_EQ(farm({"submit"}, {"--chunk", "4"}).code, 0);
  ASSERT_TRUE(wait_until(30.0, [&] { return status()["running"] > 0; }));
  // Where a node's daemon lives, Slurm takes a minute to see that a job is gone.
  for (const int node : {1, 2}) cluster->kill_node(node);
  cluster->kill_steps();
  for (const int node : {1, 2}) cluster->restart_node(node);
  ASSERT_TRUE(cluster->wait_until_empty(180.0));
  ASSERT_EQ(farm({"resume"}).code, 0);
  ASSERT_TRUE(cluster->wait_until_empty(180.0));
  EXPECT_TRUE(status()["complete"]);
}

}  // namespace
}  // namespace mien::test
