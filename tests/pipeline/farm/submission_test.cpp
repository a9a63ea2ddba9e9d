#include "pipeline/farm/submission.h"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "pipeline/farm/fake_programs.h"
#include "pipeline/farm/memory_amount.h"
#include "pipeline/farm/resumption.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using test::FakePrograms;

Stage stage_of_elements(const std::string& name, int count) {
  Stage stage{name, {}};
  for (int i = 1; i <= count; ++i) {
    const std::string film = "film:" + std::to_string(i);
    stage.elements.push_back({{name == "frames" ? chunk_item(film, 1, 1) : film}, 60.0, 10});
  }
  return stage;
}

class Submitting : public testing::Test {
 protected:
  test::TemporaryFolder temporary;
  fs::path folder = temporary.path() / "out" / "walks";
  SlurmSite site;
  ItemNeeds needs;

  Submission planned(const std::vector<Stage>& stages) const {
    JournalSubmission requested;
    requested.number = next_submission(folder);
    requested.request.memory = "2G";
    const StudyCall call{"/bin/mien", "/walks.yaml", folder.parent_path(), "/tmp", "walks", ""};
    return submission_of(stages, needs, "abc", requested, folder, call, site);
  }

  static std::string names(const Submission& submission) {
    std::string text;
    for (const SubmissionStage& stage : submission.stages) {
      for (const SubmissionJob& job : stage.jobs) {
        text += job.job.name + ":" + std::to_string(job.job.elements) + " ";
      }
    }
    return text;
  }

  std::string text_of(const std::string& name) const {
    std::ifstream file(folder / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

/// sbatch that counts jobs from 1 and records its arguments in calls; the number in `refused` is
/// that of a call that it refuses.
void add_sbatch(const FakePrograms& programs, const std::string& refused = "none") {
  const std::string at = programs.folder().string();
  programs.add("sbatch", "echo x >>" + at + "/count; n=$(wc -l <" + at + "/count)\n" +
                             "echo \"$@\" >>" + at + "/calls\n" + "if [ $n = " + refused +
                             " ]; then echo 'sbatch: error: no more of that' >&2; exit 1; fi\n" +
                             "echo $n");
  programs.add("scancel", "echo \"$@\" >>" + at + "/cancelled");
}

TEST_F(Submitting, SplitsArraysAsTheSiteAllows) {
  site.max_array_size = 5;
  const Submission submission =
      planned({stage_of_elements("frames", 9), stage_of_elements("films", 4)});
  EXPECT_EQ(names(submission), "2-frames:4 2-frames-2:4 2-frames-3:1 3-films:4 6-rest:0 ");
  EXPECT_EQ(list_text(submission.stages[0].jobs[2]), "film:9[1/1]\n");
  EXPECT_EQ(submission.elements(), 13);
}

TEST_F(Submitting, LeavesOutWhatLiveJobsMake) {
  needs.covered = {"film:1", "film:2"};
  EXPECT_EQ(names(planned({stage_of_elements("films", 3)})), "3-films:1 6-rest:0 ");
  EXPECT_EQ(names(planned({stage_of_elements("films", 2)})), "6-rest:0 ");
}

TEST_F(Submitting, GivesMoreMemoryToThoseThatRanOutOfIt) {
  needs.memory = {{"film:2", "4G"}, {"film:3", "4G"}};
  const Submission submission = planned({stage_of_elements("frames", 3)});
  EXPECT_EQ(names(submission), "2-frames:1 2-frames-2:2 6-rest:0 ");
  EXPECT_NE(script_text(submission, submission.stages[0].jobs[0]).find("--mem=\"2G\""),
            std::string::npos);
  EXPECT_NE(script_text(submission, submission.stages[0].jobs[1]).find("--mem=\"4G\""),
            std::string::npos);
}

TEST_F(Submitting, GivesTheLargestMemoryToElementsAndTheLastJob) {
  needs.memory = {{"film:1", "512M"}, {"film:2", "4G"}, {"film:3", "3000M"}};
  Stage stage{"films", {}};
  stage.elements.push_back({{"film:1", "film:2", "film:3"}, 60.0, 30});
  Submission submission = planned({stage});
  EXPECT_EQ(submission.stages[0].jobs[0].request.memory, "4G");
  EXPECT_EQ(submission.stages[1].jobs[0].request.memory, "4G");
  needs.rest_memory = "8G";
  submission = planned({stage});
  EXPECT_EQ(submission.stages[0].jobs[0].request.memory, "4G");
  EXPECT_EQ(submission.stages[1].jobs[0].request.memory, "8G");
  needs = {};
  needs.memory = {{"film:1", "512M"}};
  EXPECT_EQ(planned({stage}).stages[0].jobs[0].request.memory, "2G") << "more than it needs";
  needs = {};
  EXPECT_EQ(planned({}).stages[0].jobs[0].request.memory, "2G") << "as requested";
}

TEST_F(Submitting, WritesFilesOnceAndNumbersSubmissions) {
  const Submission first = planned({stage_of_elements("films", 2)});
  const SubmissionJournal journal(folder);
  write_submission(first, journal);
  EXPECT_EQ(text_of("farm/0001/3-films.tasks"), "film:1\nfilm:2\n");
  EXPECT_TRUE(fs::is_directory(folder / "farm/0001/log"));
  EXPECT_THROW(write_submission(first, journal), std::runtime_error);
  EXPECT_EQ(text_of("farm/0001/3-films.tasks"), "film:1\nfilm:2\n") << "the other client's";
  EXPECT_EQ(next_submission(folder), "0002");
}

TEST_F(Submitting, NotesAllThatIsToBeSubmittedBeforeSlurmIsAsked) {
  const SubmissionJournal journal(folder);
  write_submission(planned({stage_of_elements("frames", 2), stage_of_elements("films", 2)}),
                   journal);
  const JournalContent content = journal.read();
  ASSERT_EQ(content.submissions.size(), 1u);
  std::string names;
  for (const JournalJob& job : content.jobs) names += job.name + job.job + " ";
  EXPECT_EQ(names, "2-frames 3-films 6-rest ");
}

TEST_F(Submitting, LeavesNothingOfWhatCannotBeWrittenWhole) {
  fs::create_directories(folder / "farm/journal.jsonl");
  EXPECT_THROW(
      write_submission(planned({stage_of_elements("films", 2)}), SubmissionJournal(folder)),
      std::runtime_error);
  EXPECT_FALSE(fs::exists(folder / "farm/0001"));
}

TEST_F(Submitting, GoesOnWhereTheJournalCannotBeWrittenAnyMore) {
  const FakePrograms programs;
  const Submission submission = planned({stage_of_elements("films", 2)});
  const SubmissionJournal journal(folder);
  write_submission(submission, journal);
  const std::string file = "'" + journal.file().string() + "'";
  programs.add("sbatch", "mv " + file + " " + file + ".kept; mkdir -p " + file + "; echo 17");
  const Submitted submitted = submit(submission, Slurm(), journal, {});
  EXPECT_EQ(submitted.jobs.size(), 2u);
  EXPECT_NE(submitted.unrecorded.find("journal.jsonl: cannot be written"), std::string::npos)
      << submitted.unrecorded;
}

TEST_F(Submitting, LetsStagesFollowEachOtherAndTheLastJobAll) {
  const FakePrograms programs;
  add_sbatch(programs);
  const Submission submission =
      planned({stage_of_elements("frames", 2), stage_of_elements("films", 2)});
  const SubmissionJournal journal(folder);
  write_submission(submission, journal);
  const auto jobs = submit(submission, Slurm(), journal, {"90"});
  ASSERT_EQ(jobs.jobs.size(), 3u);
  const std::string at = (folder / "farm" / "0001").string();
  EXPECT_EQ(programs.text_of("calls"),
            "--parsable " + at + "/2-frames.sbatch\n" + "--parsable --dependency=afterany:1:90 " +
                at + "/3-films.sbatch\n" + "--parsable --dependency=afterany:1:2:90 " + at +
                "/6-rest.sbatch\n");
  const JournalContent content = journal.read();
  ASSERT_EQ(content.jobs.size(), 3u);
  EXPECT_EQ(content.jobs[2].job, "3");
}

TEST_F(Submitting, TakesBackWhatWasAcceptedWhenSlurmRefusesTheRest) {
  const FakePrograms programs;
  add_sbatch(programs, "3");
  const Submission submission =
      planned({stage_of_elements("frames", 2), stage_of_elements("films", 2)});
  const SubmissionJournal journal(folder);
  write_submission(submission, journal);
  EXPECT_THROW(submit(submission, Slurm(), journal, {}), SlurmFault);
  EXPECT_EQ(programs.text_of("cancelled"), "1 2\n");
  for (const JournalJob& job : journal.read().jobs) EXPECT_TRUE(job.was_refused) << job.name;
  EXPECT_FALSE(fs::exists(submission.folder));
  EXPECT_EQ(next_submission(folder), "0002") << "its jobs have names of the first";
}

TEST_F(Submitting, TellsWhatCouldNotBeTakenBack) {
  const FakePrograms programs;
  add_sbatch(programs, "2");
  programs.add("scancel", "echo 'scancel: error: Access/permission denied' >&2; exit 1");
  const Submission submission = planned({stage_of_elements("frames", 2)});
  const SubmissionJournal journal(folder);
  write_submission(submission, journal);
  try {
    submit(submission, Slurm(), journal, {});
    FAIL() << "nothing was refused";
  } catch (const SlurmFault& fault) {
    const std::string told = fault.what();
    EXPECT_NE(told.find("no more of that"), std::string::npos) << told;
    EXPECT_NE(told.find("could not be cancelled (scancel 1)"), std::string::npos) << told;
  }
  EXPECT_TRUE(fs::exists(submission.folder));
  EXPECT_FALSE(journal.read().jobs.front().was_refused) << "it waits";
}

TEST_F(Submitting, KeepsTheFolderOfARefusedSubmissionWhoseJobsHaveBegun) {
  const FakePrograms programs;
  add_sbatch(programs, "2");
  const Submission submission = planned({stage_of_elements("frames", 2)});
  write_submission(submission, SubmissionJournal(folder));
  std::ofstream(submission.folder / "log/walks-2-frames-1_1.log") << "begun\n";
  EXPECT_THROW(submit(submission, Slurm(), SubmissionJournal(folder), {}), SlurmFault);
  EXPECT_TRUE(fs::exists(submission.folder / "2-frames.sbatch"));
}

TEST_F(Submitting, TakesBackWhatWasAcceptedWhenSlurmIsFull) {
  const FakePrograms programs;
  const std::string at = programs.folder().string();
  programs.add("sbatch", "echo x >>" + at + "/count; n=$(wc -l <" + at + "/count)\n" +
                             "[ $n = 2 ] || { echo $n; exit 0; }\n" +
                             "echo 'sbatch: error: Slurm job queue full, sleeping and retrying' "
                             ">&2; exec sleep 60");
  programs.add("squeue", "echo \"1|1|1|RUNNING|None|n1|0:01|mien:abc:0001:2-frames\"");
  programs.add("scancel", "echo \"$@\" >>" + at + "/cancelled");
  const Submission submission =
      planned({stage_of_elements("frames", 2), stage_of_elements("films", 2)});
  const SubmissionJournal journal(folder);
  write_submission(submission, journal);
  EXPECT_THROW(submit(submission, Slurm(std::chrono::milliseconds(500)), journal, {}), SlurmFault);
  EXPECT_EQ(programs.text_of("cancelled"), "1\n");
  EXPECT_FALSE(fs::exists(submission.folder));
}

TEST_F(Submitting, TakesBackNothingWhenNobodyAnswers) {
  const FakePrograms programs;
  const std::string at = programs.folder().string();
  const std::string timed_out = "echo 'Socket timed out on send/recv operation' >&2; exit 1";
  programs.add("sbatch", "echo x >>" + at + "/count; n=$(wc -l <" + at + "/count)\n" +
                             "[ $n = 2 ] || { echo $n; exit 0; }\n" + timed_out);
  programs.add("squeue", timed_out);
  programs.add("scancel", "echo \"$@\" >>" + at + "/cancelled");
  const Submission submission =
      planned({stage_of_elements("frames", 2), stage_of_elements("films", 2)});
  const SubmissionJournal journal(folder);
  write_submission(submission, journal);
  EXPECT_THROW(submit(submission, Slurm(), journal, {}), SlurmTimeout);
  EXPECT_EQ(programs.text_of("cancelled"), "") << "both may have been taken";
  EXPECT_TRUE(fs::exists(submission.folder));
}

TEST_F(Submitting, FindsTheJobThatSlurmTookWithoutSayingSo) {
  const FakePrograms programs;
  programs.add("sbatch", "echo 'Socket timed out on send/recv operation' >&2; exit 1");
  programs.add("squeue",
               "echo \"55|55|1|PENDING|Priority||0:00|mien:abc:0001:3-films\"\n"
               "echo \"56|56|N/A|PENDING|Priority||0:00|mien:abc:0001:6-rest\"");
  const Submission submission = planned({stage_of_elements("films", 1)});
  write_submission(submission, SubmissionJournal(folder));
  const auto jobs = submit(submission, Slurm(), SubmissionJournal(folder), {});
  ASSERT_EQ(jobs.jobs.size(), 2u);
  EXPECT_EQ(jobs.jobs[0].job, "55");
}

TEST_F(Submitting, KeepsAnIntentWhoseFateIsUnknown) {
  const FakePrograms programs;
  programs.add("sbatch", "echo 'Socket timed out on send/recv operation' >&2; exit 1");
  programs.add("squeue", "exit 0");
  const Submission submission = planned({stage_of_elements("films", 1)});
  const SubmissionJournal journal(folder);
  write_submission(submission, journal);
  EXPECT_THROW(submit(submission, Slurm(), journal, {}), SlurmTimeout);
  EXPECT_FALSE(journal.read().jobs.back().was_refused);
  EXPECT_EQ(job_statuses(journal.read(), {}, folder).back().kind, JobStatus::Kind::unconfirmed);
}

TEST(GraphKey, IsAnothersForAnotherGraphOrFolder) {
  TaskGraph graph;
  Task task;
  task.id = "motion:a";
  task.products.push_back({"a", {}});
  graph.add(task);
  const std::string key = graph_key(graph, "/out/walks");
  EXPECT_EQ(key.size(), 12u);
  EXPECT_NE(key, graph_key(graph, "/other/walks"));
  task.id = "motion:b";
  graph.add(task);
  EXPECT_NE(key, graph_key(graph, "/out/walks"));
}

/// A submission of three elements of two items each, of which the journal has the job 17.
class Resuming : public testing::Test {
 protected:
  Resuming() {
    fs::create_directories(folder / "farm/0001/ends");
    std::ofstream(folder / "farm/0001/2-frames.tasks")
        << "film:a[1/2] film:a[2/2]\nfilm:b[1/2] film:b[2/2]\nfilm:c\n";
    for (const char* name : {"2-frames", "6-rest"}) {
      JournalJob job;
      job.submission = "0001";
      job.name = name;
      job.comment = std::string("mien:abc:0001:") + name;
      job.elements = job.name == "6-rest" ? 0 : 3;
      job.memory = memory;
      job.job = job.elements == 0 ? "18" : "17";
      journal.jobs.push_back(job);
    }
  }

  std::vector<JobStatus> statuses(const std::string& queue) {
    for (JournalJob& job : journal.jobs) job.memory = memory;
    return job_statuses(journal, queue_rows(queue), folder);
  }

  test::TemporaryFolder temporary;
  fs::path folder = temporary.path();
  std::string memory = "2G";
  JournalContent journal;
};

TEST_F(Resuming, CountsItemsOfLiveElementsAsCovered) {
  const auto found = statuses(
      "17|17|1|COMPLETED|None|n1|0:01|mien:abc:0001:2-frames\n"
      "19|17|2|RUNNING|None|n1|0:01|mien:abc:0001:2-frames\n"
      "20|17|3|SPECIAL_EXIT|JobHeldUser||0:01|mien:abc:0001:2-frames\n"
      "18|18|N/A|PENDING|Dependency||0:00|mien:abc:0001:6-rest\n");
  EXPECT_EQ(covered_items(found, folder), (std::set<std::string>{"film:b[1/2]", "film:b[2/2]"}));
  EXPECT_EQ(obsolete_jobs(found), (std::vector<std::string>{"17_3", "18"}));
}

TEST_F(Resuming, DoesNotCountOnWhatIsAboutToEnd) {
  EXPECT_TRUE(
      covered_items(statuses("19|17|2|COMPLETING|None|n1|9:01|mien:abc:0001:2-frames\n"), folder)
          .empty());
}

TEST_F(Resuming, LeavesTheLastJobAloneWhileItRuns) {
  EXPECT_TRUE(
      obsolete_jobs(statuses("18|18|N/A|RUNNING|None|n1|0:09|mien:abc:0001:6-rest\n")).empty());
}

TEST_F(Resuming, AsksForTwiceTheMemoryThatWasTooLittle) {
  std::ofstream(folder / "farm/0001/ends/2-frames.3") << "137 0 n1 memory\n";
  std::ofstream(folder / "farm/0001/ends/2-frames.2") << "137 0 n1 \n";  // killed by somebody
  const std::string queue = "17|17|1|OUT_OF_MEMORY|OutOfMemory|n1|0:01|mien:abc:0001:2-frames\n";
  const MemoryNeeds needs = memory_needs(statuses(queue), folder);
  EXPECT_EQ(needs.more, (std::map<std::string, std::string>{{"film:a", "4G"}, {"film:c", "4G"}}));
  memory = "";
  EXPECT_EQ(memory_needs(statuses(queue), folder).unknown,
            (std::vector<std::string>{"film:a[1/2]", "film:a[2/2]", "film:c"}));
}

TEST_F(Resuming, AsksForTwiceTheMemoryOfTheLastJob) {
  const std::string queue = "18|18|N/A|OUT_OF_MEMORY|OutOfMemory|n1|0:01|mien:abc:0001:6-rest\n";
  EXPECT_EQ(memory_needs(statuses(queue), folder).rest, "4G") << "according to Slurm";
  EXPECT_EQ(memory_needs(statuses(""), folder).rest, "");
  std::ofstream(folder / "farm/0001/ends/6-rest.1") << "137 0 n1 memory\n";
  EXPECT_EQ(memory_needs(statuses(""), folder).rest, "4G") << "according to the job";
  EXPECT_TRUE(memory_needs(statuses(""), folder).more.empty());
  memory = "";
  EXPECT_EQ(memory_needs(statuses(""), folder).unknown, std::vector<std::string>{"6-rest"});
}

TEST_F(Resuming, AsksForTwiceTheLargestMemoryThatWasTooLittle) {
  fs::create_directories(folder / "farm/0002/ends");
  std::ofstream(folder / "farm/0001/ends/2-frames.3") << "137 0 n1 memory\n";
  std::ofstream(folder / "farm/0002/ends/2-frames.1") << "137 0 n1 memory\n";
  std::ofstream(folder / "farm/0002/2-frames.tasks") << "film:c\n";
  JournalJob earlier = journal.jobs[0];
  earlier.memory = "2G";
  JournalJob later = earlier;
  later.submission = "0002";
  later.comment = "mien:abc:0002:2-frames";
  later.memory = "1G";
  JournalContent both;
  both.jobs = {earlier, later};
  EXPECT_EQ(memory_needs(job_statuses(both, {}, folder), folder).more.at("film:c"), "4G");
}

TEST(Memory, IsComparedWhateverItsUnit) {
  EXPECT_EQ(larger_memory("2G", "3000M"), "3000M");
  EXPECT_EQ(larger_memory("2G", "2000"), "2G");
  EXPECT_EQ(larger_memory("1t", "900G"), "1t");
  EXPECT_EQ(larger_memory("", "4G"), "4G");
  EXPECT_EQ(larger_memory("4G", ""), "4G");
  EXPECT_EQ(larger_memory("", ""), "");
}

TEST(Memory, IsDoubledInItsUnit) {
  EXPECT_EQ(doubled_memory("2G"), "4G");
  EXPECT_EQ(doubled_memory("1500"), "3000M");
  EXPECT_EQ(doubled_memory("750M"), "1500M");
  for (const char* none : {"", "0", "G", "2GB", "-2G", "99999999999999999999"}) {
    EXPECT_EQ(doubled_memory(none), "") << none;
  }
}

}  // namespace
}  // namespace mien::pipeline
