#include <gtest/gtest.h>

#include "pipeline/manifest/ratings/answers/counted_answers.h"

namespace mien::pipeline {
namespace {

/// A participant who passes so many of so many checks.
void add_checks(std::vector<AnswerRow>& rows, const std::string& participant, int passed,
                int checks) {
  for (int i = 0; i < checks; ++i) {
    rows.push_back({.participant = participant,
                    .trial = i + 1,
                    .kind = "attention",
                    .is_check = true,
                    .expected = "1",
                    .passed = i < passed});
  }
}

TEST(Attention, LeavesOutWhoFailsMoreThanOneCheck) {
  std::vector<AnswerRow> rows;
  add_checks(rows, "all", 3, 3);
  add_checks(rows, "most", 2, 3);
  add_checks(rows, "few", 1, 3);
  rows.push_back({.participant = "unchecked", .trial = 1, .stimulus = "a", .item = "b"});
  const std::vector<Attention> all = attention_of(rows);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_FALSE(all[0].is_excluded);
  EXPECT_FALSE(all[1].is_excluded);
  EXPECT_TRUE(all[2].is_excluded);
  EXPECT_FALSE(all[3].is_excluded);
  EXPECT_EQ(all[2].passed, 1);
  EXPECT_EQ(all[2].checks, 3);
  EXPECT_TRUE(attention_of(rows, {.max_failed_checks = 0})[1].is_excluded);
  for (const Attention& own : attention_of(rows, {.max_failed_checks = 3}))
    EXPECT_FALSE(own.is_excluded);
}

TEST(Attention, ForgivesPractice) {
  std::vector<AnswerRow> rows;
  add_checks(rows, "p", 0, 1);
  rows[0].is_practice = true;
  EXPECT_EQ(attention_of(rows)[0].checks, 0);
  EXPECT_FALSE(attention_of(rows)[0].is_excluded);
}

}  // namespace
}  // namespace mien::pipeline
