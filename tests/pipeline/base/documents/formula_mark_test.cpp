#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/base/documents/csv.h"

namespace mien::pipeline {
namespace {

TEST(FormulaMark, StandsBeforeWhatASpreadsheetWouldRun) {
  EXPECT_EQ(with_formula_mark("=HYPERLINK(\"http://a\")"), "'=HYPERLINK(\"http://a\")");
  EXPECT_EQ(with_formula_mark("+1+cmd|' /C calc'!A0"), "'+1+cmd|' /C calc'!A0");
  EXPECT_EQ(with_formula_mark("-1+2"), "'-1+2");
  EXPECT_EQ(with_formula_mark("@SUM(A1)"), "'@SUM(A1)");
  EXPECT_EQ(with_formula_mark("-1–A1"), "'-1–A1");
  EXPECT_EQ(with_formula_mark("\t=1"), "'\t=1");
  EXPECT_EQ(with_formula_mark(" =1"), "' =1");
  EXPECT_EQ(with_formula_mark("\uFF1D1"), "'\uFF1D1");
}

TEST(FormulaMark, LeavesNumbersAndPlainTextsAsTheyAre) {
  for (const char* text :
       {"-1.5", "-1", "+0.5", "-1e-07", "-.5", "-5.", "-inf", "-nan", "-1–1", "-0.5–-0.25", "",
        "walk", "a=b", "sad-happy", "it's", "'quoted'", "'", "1-2", "\u30FC"})
    EXPECT_EQ(with_formula_mark(text), text);
}

/// Texts of everything that matters to the mark, to quotes and to lines.
std::vector<std::string> random_fields(std::mt19937_64& random, std::size_t count) {
  const std::vector<std::string> pieces = {"=", "+",  "-",  "@",  "'", "'", " ",  "\t",     "\n",
                                           "1", ".5", "e3", "\"", ",", "a", "\r", "\uFF0D", "歩"};
  std::vector<std::string> fields(count);
  for (std::string& field : fields)
    for (std::size_t i = random() % 6; i > 0; --i) field += pieces[random() % pieces.size()];
  return fields;
}

TEST(FormulaMark, IsTakenOffAgainWhateverTheTextIs) {
  std::mt19937_64 random(11);
  CsvWriter csv({"a", "b", "c"});
  std::vector<std::vector<std::string>> rows;
  for (int i = 0; i < 5000; ++i) {
    rows.push_back(random_fields(random, 3));
    csv.row(rows.back());
    for (const std::string& field : rows.back()) {
      const std::string marked = with_formula_mark(field);
      EXPECT_EQ(without_formula_mark(marked), field);
      EXPECT_TRUE(!looks_like_formula(marked) || marked.starts_with('\'')) << marked;
    }
  }
  const CsvTable table = parse_csv(csv.text(), "t.csv");
  ASSERT_EQ(table.rows.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(table.rows[i][c].text, rows[i][c]);
}

}  // namespace
}  // namespace mien::pipeline
