#include "pipeline/study/results/answer_files.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/study/results/comparisons.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

TEST(AnswerFiles, AreFoundBelowAnExportWithTheirParticipants) {
  const test::TemporaryFolder folder;
  const fs::path data = folder.path() / "answers/data";
  make_folder(data);
  const fs::path answers = data / "subject-p001_session-ab_description-answers_data.csv";
  const fs::path people = data / "subject-p001_session-ab_description-participant_data.csv";
  write_file(answers, "");
  write_file(people, "");
  for (const fs::path& given : {folder.path(), folder.path() / "answers", data, answers}) {
    const AnswerFiles found = answer_files({given});
    EXPECT_EQ(found.answers, std::vector{answers}) << given;
    EXPECT_EQ(found.participants, std::vector{people}) << given;
  }
}

TEST(AnswerFiles, RefuseAFolderWithoutAny) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(answer_files({folder.path()}), Error);
}

TEST(WithinParticipants, FindNothingWhereAllDifferencesAreAlike) {
  const WithinParticipants within = within_participants({2.0, 2.0, 2.0, 2.0});
  EXPECT_TRUE(within.all_equal);
  EXPECT_TRUE(std::isnan(within.t.t) && std::isnan(within.t.p) && std::isnan(within.dz));
  EXPECT_EQ(within.t.mean, 2.0);
}

}  // namespace
}  // namespace mien::pipeline
