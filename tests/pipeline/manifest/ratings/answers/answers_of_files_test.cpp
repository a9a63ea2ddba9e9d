#include <gtest/gtest.h>

#include "pipeline/base/documents/fault.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/ratings/answers/answers.h"
#include "pipeline/manifest/ratings/answers/counted_answers.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

AnswerRow answer_at(int trial, const std::string& raw, const std::string& value) {
  AnswerRow row;
  row.participant = "p001";
  row.session = "s1";
  row.trial = trial;
  row.stimulus = "walk";
  row.item = "sad-happy";
  row.value_raw = raw;
  row.value = value;
  row.pole_left = "low";
  return row;
}

TEST(AnswersOfFiles, TakesOnceWhatIsThereAgain) {
  const test::TemporaryFolder folder;
  const std::string text = to_csv({answer_at(1, "3", "0"), answer_at(2, "5", "2")});
  for (const char* name : {"one.csv", "two.csv"}) write_file(folder.path() / name, text);
  const AnswersOfFiles all =
      answers_of_files({folder.path() / "one.csv", folder.path() / "two.csv"});
  EXPECT_EQ(all.rows.size(), 2U);
  ASSERT_EQ(all.notes.size(), 1U);
  EXPECT_NE(all.notes[0].find("2 answers were saved more than once"), std::string::npos);
}

TEST(AnswersOfFiles, TakesOnceWhatEarlierVersionsWrote) {
  const test::TemporaryFolder folder;
  std::string text = to_csv({answer_at(1, "3", "0"), answer_at(2, "5", "2")});
  write_file(folder.path() / "now.csv", text);
  text.replace(text.find("is_check"), 8, "is_catch");
  write_file(folder.path() / "former.csv", text);
  const AnswersOfFiles all =
      answers_of_files({folder.path() / "now.csv", folder.path() / "former.csv"});
  EXPECT_EQ(all.rows.size(), 2U);
  ASSERT_EQ(all.warnings.size(), 1U);
  EXPECT_EQ(to_string(all.warnings[0]),
            (folder.path() / "former.csv").string() +
                ":1:142: is_catch: now called is_check; rename the column");
}

TEST(AnswersOfFiles, RefusesTwoAnswersThatDiffer) {
  const test::TemporaryFolder folder;
  write_file(folder.path() / "one.csv", to_csv({answer_at(1, "3", "0")}));
  write_file(folder.path() / "two.csv", to_csv({answer_at(1, "5", "2")}));
  EXPECT_THROW(answers_of_files({folder.path() / "one.csv", folder.path() / "two.csv"}), Faults);
}

TEST(RawForm, FindsValuesThatAreNotWhatWasAnswered) {
  Scale scale;
  scale.id = "sad-happy";
  scale.least = -2.0;
  scale.most = 2.0;
  ScaleSet scales;
  scales.scales = {scale};
  std::vector<AnswerRow> rows = {answer_at(1, "3", "0"), answer_at(2, "5", "2"),
                                 answer_at(3, "2", "-1")};
  EXPECT_TRUE(contradicted_values(rows, scales).empty());
  rows[0].value = "2";
  EXPECT_EQ(contradicted_values(rows, scales).size(), 1U);
}

}  // namespace
}  // namespace mien::pipeline
