#include "pipeline/base/documents/table.h"

#include <limits>
#include <optional>

#include <gtest/gtest.h>

#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

struct Walk {
  std::string name;
  double speed_m_s;
  std::optional<int> steps;
  bool loops;
  std::vector<std::string> levels;
};

constexpr auto walk_columns =
    table_of<Walk>("metrics/walks.csv", "a walk",
                   {{"walk", "", "name of the walk", [](auto& r) { return r.name; }},
                    {"speed_m_s", "m/s", "its mean speed", [](auto& r) { return r.speed_m_s; }},
                    {"factor_*", "", "level of a factor", [](auto& r) { return r.levels; }},
                    {"steps", "", "steps that were counted", [](auto& r) { return r.steps; }},
                    {"loops", "0/1", "1: it can be repeated", [](auto& r) { return r.loops; }}});

struct Share {
  double whole;
  int part;
};

constexpr auto share_columns =
    table_of<Share>("shares.csv", "a part",
                    {{"share", "", "part of the whole", [](auto& r) { return r.part / r.whole; }}});

const std::vector<Walk> walks = {
    {"sad, slow", 0.1, 4, true, {"sad", "slow"}},
    {"stands", std::numeric_limits<double>::infinity(), std::nullopt, false, {"", "still"}}};

TEST(Table, HasHeaderAndRowsFromOneList) {
  const WrittenTable table = walk_columns.of(walks, {"mood", "pace"});
  EXPECT_EQ(table.csv,
            "walk,speed_m_s,factor_mood,factor_pace,steps,loops\n"
            "\"sad, slow\",0.1,sad,slow,4,1\n"
            "stands,,,still,,0\n");
  EXPECT_EQ(table.form.path, "metrics/walks.csv");
}

TEST(Table, OfPartsMakesRowsOfWholeAndPart) {
  EXPECT_EQ(share_columns.of_parts(8.0, std::vector{2, 4}).csv, "share\n0.25\n0.5\n");
}

TEST(Table, WithoutRowsIsItsHeader) {
  EXPECT_EQ(walk_columns.of(std::vector<Walk>{}).csv, "walk,speed_m_s,steps,loops\n");
}

TEST(Table, FindsItsColumns) {
  const TableForm form = walk_columns.form();
  ASSERT_NE(find_column(form, "steps"), nullptr);
  EXPECT_EQ(find_column(form, "steps")->meaning, "steps that were counted");
  EXPECT_EQ(find_column(form, "step"), nullptr);
}

TEST(WrittenTables, StandBesideACodebookOfAllTheirColumns) {
  const test::TemporaryFolder folder;
  write_tables(folder.path() / "new", {walk_columns.of(walks, {"mood", "pace"})});
  const CsvTable walk = read_csv(folder.path() / "new/walks.csv");
  EXPECT_EQ(walk.rows.size(), 2u);
  const CsvTable book = read_csv(folder.path() / "new/codebook.csv");
  ASSERT_EQ(book.rows.size(), 5u);
  const std::vector<std::string> second = {"walks.csv", "a walk", "speed_m_s", "m/s",
                                           "its mean speed"};
  for (std::size_t i = 0; i < second.size(); ++i) EXPECT_EQ(book.rows[1][i].text, second[i]);
}

}  // namespace
}  // namespace mien::pipeline
