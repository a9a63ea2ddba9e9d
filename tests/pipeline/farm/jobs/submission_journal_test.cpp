#include "pipeline/farm/jobs/submission_journal.h"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "pipeline/farm/jobs/job_status.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

JournalJob intent(const std::string& name, int elements) {
  JournalJob job;
  job.submission = "0001";
  job.name = name;
  job.comment = "mien:abc:0001:" + name;
  job.elements = elements;
  job.memory = "2G";
  return job;
}

class Journal : public testing::Test {
 protected:
  test::TemporaryFolder temporary;
  fs::path folder = temporary.path();
  SubmissionJournal journal{folder};

  std::vector<JobStatus> statuses(const std::string& queue) const {
    return job_statuses(journal.read(), queue_rows(queue), folder);
  }
};

TEST_F(Journal, TellsWhatWasWrittenIntoIt) {
  EXPECT_TRUE(journal.read().jobs.empty());
  JournalSubmission requested{"0001",
                              "2026-11-23T00:00:00Z",
                              "draft",
                              12,
                              {"long", "1:00", "2G", "lab", 8, 3, "/shared/mien"}};
  journal.note_submission(requested, {intent("2-frames", 5), intent("3-films", 2)});
  journal.note_job("mien:abc:0001:2-frames", "17");
  journal.note_refusal("mien:abc:0001:3-films", "no \xff such partition");
  const JournalContent content = journal.read();
  ASSERT_EQ(content.submissions.size(), 1u);
  EXPECT_EQ(content.submissions[0].chunk_frames, 12);
  EXPECT_EQ(content.submissions[0].quality, "draft");
  EXPECT_EQ(content.submissions[0].request.partition, "long");
  EXPECT_EQ(content.submissions[0].request.array_limit, 8);
  EXPECT_EQ(content.submissions[0].request.processors, 3);
  EXPECT_EQ(content.submissions[0].request.program, "/shared/mien");
  ASSERT_EQ(content.jobs.size(), 2u);
  EXPECT_EQ(content.jobs[0].job, "17");
  EXPECT_EQ(content.jobs[0].elements, 5);
  EXPECT_EQ(content.jobs[0].memory, "2G");
  EXPECT_TRUE(content.jobs[1].was_refused);
}

TEST_F(Journal, GoesOnBehindALineThatWasCutOffAnywhere) {
  journal.note_submission({"0001"}, {intent("2-frames", 5)});
  journal.note_job("mien:abc:0001:2-frames", "17");
  std::ifstream stream(journal.file());
  const std::string whole{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t intended = whole.find('\n', whole.find('\n') + 1);
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    std::ofstream(journal.file(), std::ios::trunc) << whole.substr(0, size);
    EXPECT_LE(journal.read().jobs.size(), 1u);
    journal.note_submission({"0001"}, {intent("3-films", 2)});
    const JournalContent content = journal.read();
    ASSERT_FALSE(content.jobs.empty());
    EXPECT_EQ(content.jobs.back().name, "3-films") << size;
    EXPECT_EQ(content.jobs.front().name, size < intended ? "3-films" : "2-frames") << size;
  }
}

TEST_F(Journal, AdoptsAJobThatTheClientDidNotHearOf) {
  journal.note_submission({"0001"}, {intent("2-frames", 2)});
  const auto found = statuses("31|30|1|RUNNING|None|n1|0:01|mien:abc:0001:2-frames\n");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, JobStatus::Kind::live);
  EXPECT_TRUE(found[0].is_adopted);
  EXPECT_EQ(found[0].journal.job, "30");
}

TEST_F(Journal, TellsAnIntentThatNoJobFollowed) {
  journal.note_submission({"0001"}, {intent("2-frames", 2)});
  const auto found = statuses("");
  EXPECT_EQ(found.at(0).kind, JobStatus::Kind::unconfirmed);
  EXPECT_EQ(lost_job_messages(found).size(), 1u);
}

TEST_F(Journal, NoticesAJobThatSlurmLostEvenIfItsNumberIsAnothers) {
  journal.note_submission({"0001"}, {intent("2-frames", 2)});
  journal.note_job("mien:abc:0001:2-frames", "17");
  for (const char* queue : {"", "17|17|N/A|RUNNING|None|n1|0:01|somebody else's\n"}) {
    const auto found = statuses(queue);
    EXPECT_EQ(found.at(0).kind, JobStatus::Kind::lost);
    EXPECT_TRUE(live_jobs(found).empty());
    ASSERT_EQ(lost_job_messages(found).size(), 1u);
    EXPECT_NE(lost_job_messages(found)[0].find("no longer has job 17"), std::string::npos);
  }
}

TEST_F(Journal, DoesNotTakeAJobThatRanAndWasForgottenForALostOne) {
  journal.note_submission({"0001"}, {intent("2-frames", 2)});
  journal.note_job("mien:abc:0001:2-frames", "17");
  fs::create_directories(folder / "farm/0001/log");
  std::ofstream(folder / "farm/0001/log/walks-2-frames-17_2.log") << "\n";
  EXPECT_EQ(statuses("").at(0).kind, JobStatus::Kind::ended);
}

TEST_F(Journal, CountsWhatAPersonSubmittedAgainByHand) {
  journal.note_submission({"0001"}, {intent("2-frames", 3)});
  journal.note_job("mien:abc:0001:2-frames", "17");
  const auto found = statuses(
      "17|17|1|COMPLETED|None|n1|0:01|mien:abc:0001:2-frames\n"
      "40|40|3|PENDING|Priority||0:00|mien:abc:0001:2-frames\n");
  EXPECT_EQ(live_jobs(found), (std::vector<std::string>{"40_3"}));
}

TEST_F(Journal, CannotBeWrittenWhereAFileIsInTheWay) {
  std::ofstream(folder / "farm") << "no folder";
  EXPECT_THROW(journal.note_submission({"0001"}, {intent("2-frames", 2)}), std::runtime_error);
}

TEST_F(Journal, SkipsNamesThatLeadOutOfTheFarm) {
  journal.note_submission({"0001"}, {intent("2-frames", 5)});
  for (const char* name : {"../../x", "/etc/passwd", "..", "a/b", "a\nb"}) {
    JournalJob job = intent("3-films", 1);
    job.submission = name;
    journal.note_submission({"0001"}, {intent(name, 1), job});
    journal.note_submission({name, "2026-11-23T00:00:00Z", "draft", 12, {}});
  }
  const JournalContent content = journal.read();
  for (const JournalSubmission& one : content.submissions) EXPECT_EQ(one.number, "0001");
  ASSERT_EQ(content.jobs.size(), 1u);
  EXPECT_EQ(content.jobs[0].name, "2-frames");
}

}  // namespace
}  // namespace mien::pipeline
