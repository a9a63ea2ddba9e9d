#include "pipeline/base/documents/fault.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "pipeline/base/documents/fault_list.h"

namespace mien::pipeline {
namespace {

std::vector<Fault> faults_on_lines(int count) {
  std::vector<Fault> faults;
  for (int line = 1; line <= count; ++line)
    faults.push_back({{"m.yaml", line, 1}, "key", "unknown key", "leave it out"});
  return faults;
}

auto lines_in(const std::string& text) { return std::ranges::count(text, '\n') + 1; }

TEST(Fault, IsToldAtItsPlace) {
  EXPECT_EQ(to_string({{"m.yaml", 14, 7}, "stimuli[2].look", "no such look", "leave it out"}),
            "m.yaml:14:7: stimuli[2].look: no such look; leave it out");
}

TEST(Fault, OfAValueIsToldByTheFirstListThatKnowsOneAndInReadingOrder) {
  const Fault kind = {{"m.yaml", 3, 1}, "seed", "no number", ""};
  const Fault also = {{"m.yaml", 3, 1}, "seed", "no whole number", ""};
  const Fault later = {{"m.yaml", 3, 1}, "seed", "too large", ""};
  const Fault above = {{"m.yaml", 1, 1}, "study", "no name", ""};
  const Fault whole = {{"m.yaml", 2, 1}, "", "no manifest", ""};
  std::string told;
  for (const Fault& fault : merged_faults({{kind, also}, {later, above}, {whole, kind}, {whole}}))
    told += fault.wrong + "; ";
  EXPECT_EQ(told, "no name; no manifest; no number; no whole number; ");
}

TEST(Fault, IsToldOneByOneUpToTwenty) {
  const std::string twenty = Faults(faults_on_lines(20)).what();
  EXPECT_EQ(lines_in(twenty), 20);
  EXPECT_TRUE(twenty.ends_with("m.yaml:20:1: key: unknown key; leave it out")) << twenty;
  const std::string more = Faults(faults_on_lines(200'000)).what();
  EXPECT_TRUE(more.starts_with(twenty));
  EXPECT_TRUE(more.ends_with("\nand 199980 more")) << more;
  EXPECT_EQ(lines_in(more), 21);
  EXPECT_EQ(Faults(faults_on_lines(200'000)).list().size(), 200'000u);
}

TEST(Fault, IsNoLongerThanSomebodyReadsAndGivesATerminalNoOrders) {
  const std::string told = to_string({{"m\x1b[2J.yaml", 1, 1},
                                      "a\x1b[31m." + std::string(100'000, 'x'),
                                      std::string(100'000, 'y') + "\x1b",
                                      "write \u202E"});
  EXPECT_TRUE(told.starts_with("m\\x1b[2J.yaml:1:1: a\\x1b[31m.xxx")) << told;
  EXPECT_TRUE(told.ends_with("write \\u202e")) << told;
  EXPECT_EQ(told.find('\x1b'), std::string::npos);
  EXPECT_LT(told.size(), 1200u);
}

}  // namespace
}  // namespace mien::pipeline
