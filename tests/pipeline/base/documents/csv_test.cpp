#include "pipeline/base/documents/csv.h"

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

std::string refusal(const std::string& text) {
  try {
    parse_csv(text, "t.csv");
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Csv, ReadsQuotesLineEndsAndTheByteOrderMark) {
  const CsvTable table =
      parse_csv("\xEF\xBB\xBFname,value\r\n\"a, \"\"b\"\"\nc\",1\r\n\r\n速さ,\n", "t.csv");
  ASSERT_EQ(table.header.size(), 2u);
  EXPECT_EQ(table.header[0].text, "name");
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0][0].text, "a, \"b\"\nc");
  EXPECT_EQ(table.rows[0][1].text, "1");
  EXPECT_EQ(table.rows[1][0].text, "速さ");
  EXPECT_EQ(table.rows[1][1].text, "");
}

TEST(Csv, KnowsWhereEachFieldStartsInCharacters) {
  const CsvTable table = parse_csv("a,b,c\n速さ,\"x\ny\",z\nq,r,s\n", "t.csv");
  const CsvField& quoted = table.rows[0][1];
  EXPECT_EQ(std::tuple(quoted.line, quoted.column), std::tuple(2, 4));
  EXPECT_EQ(std::tuple(table.rows[0][2].line, table.rows[0][2].column), std::tuple(3, 4));
  EXPECT_EQ(std::tuple(table.rows[1][2].line, table.rows[1][2].column), std::tuple(4, 5));
}

TEST(Csv, TellsAHeaderOfManyColumnsWithoutComparingEachWithEach) {
  std::string header = "stimulus";
  for (int column = 0; column < 500'000; ++column) header += ",c" + std::to_string(column);
  EXPECT_EQ(parse_csv(header + "\n", "t.csv").header.size(), 500'001u);
  EXPECT_EQ(refusal(header + ",stimulus\n").find("t.csv:1:"), 0u);
}

TEST(Csv, QuotesNoMoreOfAFileThanSomebodyReads) {
  const std::string longest(100'000, 'x');
  EXPECT_LT(refusal(longest + "," + longest + "\n").size(), 200u);
  const CsvTable table = parse_csv(longest + ",b\x1b[2J\n" + longest + ",2\n", "t.csv");
  const auto told = [](auto&& refused) {
    try {
      refused();
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_LT(told([&] { number_in(table, table.rows[0][0]); }).size(), 200u);
  const std::string missing = told([&] { require_column(table, "value"); });
  EXPECT_LT(missing.size(), 400u);
  EXPECT_TRUE(missing.ends_with(", b\\x1b[2J")) << missing;
}

TEST(Csv, TakesALastLineWithoutItsEnd) {
  EXPECT_EQ(parse_csv("a,b\n1,2", "t.csv").rows.at(0).at(1).text, "2");
  EXPECT_EQ(parse_csv("a,b\n1,2\r", "t.csv").rows.at(0).at(1).text, "2");
}

TEST(Csv, RefusesWithThePlaceAndTheRemedy) {
  EXPECT_EQ(refusal(""), "t.csv:1:1: the table is empty; begin with a line of column names");
  EXPECT_EQ(
      refusal("a,b\n1,2,3\n"),
      "t.csv:2:1: 3 fields where the header has 2; give every row as many fields as the header");
  EXPECT_EQ(refusal("a,b\n1,\"2\n"), "t.csv:2:3: a quote that is not closed; add the closing \"");
  EXPECT_EQ(refusal("a,b\n1,\"2\"3\n"),
            "t.csv:2:6: text after a closing quote; write a quote inside a quoted field as \"\"");
  EXPECT_EQ(
      refusal("a,b\n1,2\"3\n"),
      "t.csv:2:4: a quote in the middle of a field; quote the whole field and write the quote "
      "as \"\"");
  EXPECT_EQ(refusal("a,b,a\n"), "t.csv:1:5: the column \"a\" appears twice; rename one of the two");
  EXPECT_EQ(refusal("a,b\n1,\xff\n"), "t.csv:2:3: not UTF-8 text; save it as UTF-8");
}

TEST(Csv, RefusesAHeaderThatStandsThereAgain) {
  try {
    parse_csv("a,b\n1,2\na,b\n3,4\n", "joined.csv");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "joined.csv:3:1: the header is repeated here; keep only the first one");
  }
  EXPECT_EQ(parse_csv("word\nword\n", "words.csv").rows.size(), 1u);
}

TEST(Csv, RefusesWhatIsNoFiniteNumber) {
  const CsvTable table = parse_csv("a\n1.5\n+2\n1e3\nx\nnan\n1.5 \n1e999\n0x1\n", "t.csv");
  EXPECT_EQ(number_in(table, table.rows[0][0]), 1.5);
  EXPECT_EQ(number_in(table, table.rows[1][0]), 2.0);
  EXPECT_EQ(number_in(table, table.rows[2][0]), 1000.0);
  for (std::size_t row = 3; row < table.rows.size(); ++row) {
    EXPECT_THROW(number_in(table, table.rows[row][0]), Error) << table.rows[row][0].text;
  }
  try {
    number_in(table, table.rows[3][0]);
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "t.csv:5:1: \"x\" is not a number; write a finite decimal number");
  }
}

TEST(Csv, ListsTheColumnsThereAre) {
  const CsvTable table = parse_csv("a,b\n", "t.csv");
  EXPECT_EQ(require_column(table, "b"), 1);
  EXPECT_EQ(find_column(table, "c"), -1);
  try {
    require_column(table, "c");
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "t.csv:1:1: there is no column \"c\"; the columns are a, b");
  }
}

TEST(Csv, GivesColumnsTheirPresentNames) {
  CsvTable old = parse_csv("a,asked\n1,2\n", "t.csv");
  const std::optional<Fault> warning = rename_column(old, "asked", "requested");
  ASSERT_TRUE(warning);
  EXPECT_EQ(to_string(*warning), "t.csv:1:3: asked: now called requested; rename the column");
  EXPECT_EQ(require_column(old, "requested"), 1);
  EXPECT_FALSE(rename_column(old, "asked", "requested"));

  CsvTable both = parse_csv("asked,requested\n1,2\n", "t.csv");
  EXPECT_FALSE(rename_column(both, "asked", "requested"));
  EXPECT_EQ(require_column(both, "requested"), 1);
  CsvTable neither = parse_csv("a\n1\n", "t.csv");
  EXPECT_FALSE(rename_column(neither, "asked", "requested"));
}

TEST(Csv, ReadsBackWhateverItWrites) {
  std::mt19937 random(5);
  const std::string letters = "ab ,\"\n\r;速";
  for (int round = 0; round < 300; ++round) {
    const std::size_t width = 1 + random() % 4;
    std::vector<std::string> header;
    for (std::size_t i = 0; i < width; ++i) header.push_back("c" + std::to_string(i));
    CsvWriter writer(header);
    std::vector<std::vector<std::string>> rows(random() % 5, std::vector<std::string>(width));
    for (auto& row : rows) {
      for (std::string& field : row) {
        for (std::size_t n = random() % 6; n > 0; --n) {
          const char c = letters[random() % 8];
          field += c;
        }
        if (random() % 3 == 0) field += "速";
      }
      writer.row(row);
    }
    const CsvTable table = parse_csv(writer.text(), "t.csv");
    ASSERT_EQ(table.rows.size(), rows.size()) << writer.text();
    for (std::size_t r = 0; r < rows.size(); ++r) {
      for (std::size_t c = 0; c < width; ++c) EXPECT_EQ(table.rows[r][c].text, rows[r][c]);
    }
  }
}

TEST(Csv, WritesTheShortestNumberThatReadsBackTheSame) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(-3.0), "-3");
  EXPECT_EQ(shortest(-0.0), "0");
  EXPECT_EQ(shortest(1e-7), "1e-07");
  EXPECT_EQ(shortest(std::numeric_limits<double>::quiet_NaN()), "nan");
  std::mt19937_64 random(7);
  for (int i = 0; i < 2000; ++i) {
    const double value =
        std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 200) - 100);
    EXPECT_EQ(std::stod(shortest(value)), value);
  }
}

TEST(Csv, WritesNothingForWhatRoundingsLeave) {
  EXPECT_EQ(shortest_measured(4.6e-16), "0");
  EXPECT_EQ(shortest_measured(-2e-13), "0");
  EXPECT_EQ(shortest_measured(2e-12), "2e-12");
  EXPECT_EQ(shortest_measured(-0.25), "-0.25");
  EXPECT_EQ(shortest_measured(std::numeric_limits<double>::quiet_NaN()), "nan");
}

}  // namespace
}  // namespace mien::pipeline
