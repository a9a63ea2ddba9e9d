#include "pipeline/farm/slurm/slurm.h"

#include <gtest/gtest.h>

#include "pipeline/farm/fake_programs.h"

namespace mien::pipeline {
namespace {

using test::FakePrograms;

// Recorded from Slurm 22.05.8: squeue -h -r -a -t all -o queue_format.
constexpr const char* recorded_queue =
    "6|1|4|RUNNING|None|n2|0:03|mien:abc:0001:2-frames\n"
    "5|1|3|FAILED|NonZeroExitCode|n1|0:00|mien:abc:0001:2-frames\n"
    "3|1|1|PENDING|BeginTime||0:00|mien:abc:0001:2-frames\n"
    "2|2|N/A|PENDING|Dependency||0:00|somebody's | own words\n"
    "4|1|2|SPECIAL_EXIT|JobHeldUser||0:00|mien:abc:0001:2-frames\n"
    "7|7|N/A|OUT_OF_MEMORY|OutOfMemory|n1|0:12|(null)\n"
    "slurm_load_jobs: some words that are no row\n";

TEST(QueueRows, AreReadAsSqueueWritesThem) {
  const std::vector<QueueRow> rows = queue_rows(recorded_queue);
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[0],
            (QueueRow{"6", "1", 4, "RUNNING", "None", "n2", "0:03", "mien:abc:0001:2-frames"}));
  EXPECT_EQ(rows[3].index, std::nullopt);
  EXPECT_EQ(rows[3].comment, "somebody's | own words");
  EXPECT_EQ(rows[5].state, "OUT_OF_MEMORY");
}

TEST(QueueRows, AreLiveWhenTheyWaitOrRun) {
  std::string live;
  std::string stuck;
  for (const QueueRow& row : queue_rows(recorded_queue)) {
    if (is_live(row)) live += row.job + " ";
    if (is_stuck(row)) stuck += row.job + " ";
  }
  EXPECT_EQ(live, "6 3 2 4 ");
  EXPECT_EQ(stuck, "4 ");
}

TEST(QueueRows, AreStuckWhenADependencyIsNeverSatisfied) {
  EXPECT_TRUE(is_stuck(queue_rows("2|2|N/A|PENDING|DependencyNeverSatisfied||0:00|x\n").at(0)));
  EXPECT_FALSE(is_stuck(queue_rows("2|2|N/A|PENDING|Priority||0:00|x\n").at(0)));
}

TEST(QueueRows, AreStuckWhenNoNodeHasWhatTheyAskFor) {
  for (const char* reason : {"PartitionConfig", "BadConstraints"}) {
    const QueueRow row = queue_rows(std::string("2|2|N/A|PENDING|") + reason + "||0:00|x\n").at(0);
    EXPECT_TRUE(exceeds_partition(row) && is_stuck(row)) << reason;
  }
}

TEST(QueueRows, TellHowLongTheyHaveRun) {
  const auto seconds = [](const char* elapsed) {
    QueueRow row;
    row.elapsed = elapsed;
    return seconds_run(row);
  };
  EXPECT_EQ(seconds("0:00"), 0.0);
  EXPECT_EQ(seconds("3:04"), 184.0);
  EXPECT_EQ(seconds("2:03:04"), 7384.0);
  EXPECT_EQ(seconds("1-02:03:04"), 86400.0 + 7384.0);
  for (const char* none : {"", "INVALID", "-", "1-", "3:x"}) EXPECT_EQ(seconds(none), 0.0) << none;
}

TEST(NodeShapes, TellTheMostProcessorsOfAPartition) {
  const auto nodes = node_shapes("main*|4\nmain*|16\nlong|64\nsinfo: some words\n");
  ASSERT_EQ(nodes.size(), 3u);
  EXPECT_EQ(most_processors(nodes, ""), 16);
  EXPECT_EQ(most_processors(nodes, "long"), 64);
  EXPECT_EQ(most_processors(nodes, "main,long"), 64);
  EXPECT_EQ(most_processors(nodes, "none"), std::nullopt);
  EXPECT_EQ(most_processors({}, ""), std::nullopt);
}

TEST(SlurmSite, IsReadFromTheConfiguration) {
  const SlurmSite site = parse_site(
      "Configuration data as of 2026-11-23T00:09:49\n"
      "MaxArraySize            = 10001\n"
      "MaxJobCount             = 20000\n"
      "RequeueExit             = 70-72,75\n"
      "RequeueExitHold         = 78\n"
      "SLURM_VERSION           = 22.05.8\n");
  EXPECT_EQ(site.max_array_size, 10001);
  EXPECT_EQ(site.max_job_count, 20000);
  EXPECT_TRUE(site.requeues_transient);
  EXPECT_TRUE(site.holds_wrong_setup);
  const SlurmSite plain = parse_site("RequeueExit             = (null)\nMaxArraySize = 1001\n");
  EXPECT_FALSE(plain.requeues_transient);
  EXPECT_EQ(plain.max_array_size, 1001);
}

TEST(Slurm, SubmitsWithArgumentsAndGivesTheJob) {
  const FakePrograms programs;
  programs.add("sbatch", "printf '<%s>' \"$@\" >" + (programs.folder() / "words").string() +
                             "; echo '17;cluster'");
  EXPECT_EQ(Slurm().submit("/a b/it's.sbatch", {"3", "4"}), "17");
  EXPECT_EQ(programs.text_of("words"), "<--parsable><--dependency=afterany:3:4></a b/it's.sbatch>");
}

std::string fault_of_submission(const std::string& errors) {
  const FakePrograms programs;
  programs.add("sbatch", "echo '" + errors + "' >&2; exit 1");
  try {
    Slurm().submit("a.sbatch", {});
  } catch (const SlurmFault& fault) {
    return fault.what();
  }
  return "nothing";
}

TEST(Slurm, TellsWhatSbatchSaysAndWhatToDo) {
  const std::string partition =
      fault_of_submission("sbatch: error: invalid partition specified: nope");
  EXPECT_NE(partition.find("invalid partition specified: nope"), std::string::npos);
  EXPECT_NE(partition.find("sinfo"), std::string::npos);
  const std::string down = fault_of_submission(
      "sbatch: error: Batch job submission failed: Unable to contact slurm controller (connect "
      "failure)");
  EXPECT_NE(down.find("try again later"), std::string::npos);
  EXPECT_NE(fault_of_submission(
                "sbatch: error: Batch job submission failed: Invalid job array specification")
                .find("MaxArraySize"),
            std::string::npos);
  EXPECT_NE(fault_of_submission("sbatch: error: something new").find("something new"),
            std::string::npos);
}

TEST(Slurm, SaysWhatToDoBeforeSlurmsOwnLines) {
  EXPECT_EQ(fault_of_submission("sbatch: error: first line\nsbatch: error: invalid partition: x"),
            "sbatch failed: there is no such partition: sinfo lists them\n"
            "  sbatch: error: first line\n"
            "  sbatch: error: invalid partition: x");
}

TEST(Slurm, DoesNotWaitForAConfigurationThatIsNotThere) {
  const FakePrograms programs;
  programs.add("squeue", "sleep 60");
  const char* before = std::getenv("SLURM_CONF");
  const std::string kept = before == nullptr ? "" : before;
  ::setenv("SLURM_CONF", "/nowhere/slurm.conf", 1);
  std::string why;
  EXPECT_EQ(Slurm().queue_if_any(why), std::nullopt);
  if (before == nullptr) {
    ::unsetenv("SLURM_CONF");
  } else {
    ::setenv("SLURM_CONF", kept.c_str(), 1);
  }
  EXPECT_NE(why.find("SLURM_CONF names /nowhere/slurm.conf, which does not exist: unset it"),
            std::string::npos)
      << why;
}

TEST(Slurm, DoesNotTakeSilenceForRefusal) {
  const FakePrograms programs;
  programs.add("sbatch",
               "echo 'sbatch: error: Batch job submission failed: Socket timed out on send/recv "
               "operation' >&2; exit 1");
  EXPECT_THROW(Slurm().submit("a.sbatch", {}), SlurmTimeout);
  programs.add("sbatch", "exec sleep 60");
  EXPECT_THROW(Slurm(std::chrono::milliseconds(200)).submit("a.sbatch", {}), SlurmTimeout);
}

// Recorded from Slurm 22.05.8 with MaxJobCount=30, which goes on for two minutes.
TEST(Slurm, TakesWhatSbatchRepeatsForARefusalInItsOwnWords) {
  const FakePrograms programs;
  programs.add("sbatch",
               "echo 'sbatch: error: Slurm temporarily unable to accept job, sleeping and "
               "retrying' >&2; exec sleep 60");
  try {
    Slurm(std::chrono::milliseconds(500)).submit("a.sbatch", {});
    FAIL() << "it was taken";
  } catch (const SlurmQueueFull& full) {
    const std::string told = full.what();
    EXPECT_NE(told.find("unable to accept job, sleeping and retrying"), std::string::npos) << told;
    EXPECT_NE(told.find("use a larger --chunk for fewer jobs"), std::string::npos) << told;
    EXPECT_EQ(told.find("did not answer"), std::string::npos) << told;
  }
}

TEST(Slurm, BelievesSbatchThatAJobWasTakenInTheEnd) {
  const FakePrograms programs;
  programs.add("sbatch", "echo 'sbatch: error: Socket timed out, retrying' >&2; echo 17");
  EXPECT_EQ(Slurm().submit("a.sbatch", {}), "17");
}

TEST(Slurm, PassesOnWhatAProgramSaidBeforeItsTimeWasUp) {
  const FakePrograms programs;
  programs.add("squeue", "echo 'squeue: error: some words' >&2; exec sleep 60");
  std::string why;
  EXPECT_EQ(Slurm(std::chrono::milliseconds(500)).queue_if_any(why), std::nullopt);
  EXPECT_NE(why.find("did not answer in time"), std::string::npos) << why;
  EXPECT_NE(why.find("some words"), std::string::npos) << why;
}

TEST(Slurm, SaysWhereThereIsNone) {
  const FakePrograms programs(FakePrograms::Others::hidden);
  std::string why;
  EXPECT_EQ(Slurm().queue_if_any(why), std::nullopt);
  EXPECT_NE(why.find("squeue was not found"), std::string::npos) << why;
}

TEST(Slurm, CancelsJobsThatAreOverWithoutComplaint) {
  const FakePrograms programs;
  programs.add("scancel",
               "echo 'scancel: error: Kill job error on job id 9: Invalid job id specified' >&2; "
               "exit 1");
  EXPECT_NO_THROW(Slurm().cancel({"9"}));
  programs.add("scancel",
               "echo 'scancel: error: Kill job error on job id 9: Access/permission denied' >&2; "
               "exit 1");
  EXPECT_THROW(Slurm().cancel({"9"}), SlurmFault);
}

}  // namespace
}  // namespace mien::pipeline
