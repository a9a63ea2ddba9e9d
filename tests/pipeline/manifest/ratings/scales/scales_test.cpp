#include "pipeline/manifest/ratings/scales/scales.h"

#include <gtest/gtest.h>

#include "pipeline/base/documents/fault.h"

namespace mien::pipeline {
namespace {

std::string refusal(const std::string& yaml) {
  try {
    parse_scales(yaml, "s.yaml");
  } catch (const Faults& faults) {
    return faults.what();
  }
  return "accepted";
}

TEST(Scales, HaveFortyOnePairsAndFourGroupsBuiltIn) {
  const ScaleSet set = builtin_scales();
  ASSERT_EQ(set.scales.size(), 41u);
  EXPECT_EQ(set.scales[13].id, "sad-happy");
  EXPECT_EQ(set.scales[13].japanese_high, "嬉しい");
  ASSERT_EQ(set.groups.size(), 4u);
  // Table 2 of the adjective paper: 3 + 10 + 9 + 5 of the 27 pairs kept.
  EXPECT_EQ(set.groups[0].id, "quickness");
  EXPECT_EQ(set.groups[0].scales.size(), 3u);
  EXPECT_EQ(set.groups[1].scales.size(), 10u);
  EXPECT_EQ(set.groups[2].scales.size(), 9u);
  EXPECT_EQ(set.groups[3].scales.size(), 5u);
}

TEST(Scales, AreReadWithRangesGroupsAndOrder) {
  const ScaleSet set = parse_scales(
      "name: test\nrange: [-3, 3]\nscales:\n  zeal: {low: idle, high: eager, ja: [a, b]}\n"
      "  age: {low: young, high: old, range: [1, 7]}\ngroups:\n  all: {scales: [age, zeal], ja: "
      "c}\n",
      "s.yaml");
  EXPECT_EQ(set.name, "test");
  ASSERT_EQ(set.scales.size(), 2u);
  EXPECT_EQ(set.scales[0].id, "zeal");
  EXPECT_EQ(set.scales[0].least, -3.0);
  EXPECT_EQ(set.scales[0].japanese_low, "a");
  EXPECT_EQ(set.scales[1].most, 7.0);
  ASSERT_EQ(set.groups.size(), 1u);
  EXPECT_EQ(set.groups[0].scales, (std::vector<std::string>{"age", "zeal"}));
  EXPECT_EQ(set.groups[0].japanese, "c");
  EXPECT_DOUBLE_EQ(share_of(set.scales[0], 0.0), 0.5);
  EXPECT_DOUBLE_EQ(share_of(set.scales[1], 7.0), 1.0);
  EXPECT_EQ(find_scale(set, "nothing"), nullptr);
}

TEST(Scales, RefuseWithEveryFaultAndItsPlace) {
  EXPECT_EQ(refusal("range: [3, -3]\nscales:\n  a: {low: x, high: y}\n  b: {low: x, high: y, "
                    "range: [2, 2]}\ngroups:\n  b: {scales: [a, bb]}\n"),
            "s.yaml:1:8: range: the lower limit is not below the upper limit; write [low, high]; "
            "to reverse a scale, exchange the names of its ends\n"
            "s.yaml:4:31: scales.b.range: the lower limit is not below the upper limit; write "
            "[low, high]; to reverse a scale, exchange the names of its ends\n"
            "s.yaml:6:3: groups.b: a scale has the same name; rename the group\n"
            "s.yaml:6:19: groups.b.scales[1]: unknown scale \"bb\"; did you mean \"b\"?");
  EXPECT_EQ(refusal("scales: {a: {low: x, hihg: y}}\n"),
            "s.yaml:1:22: scales.a.hihg: unknown key; did you mean \"high\"?");
  EXPECT_EQ(refusal("scales: {a: {low: x}}\n"),
            "s.yaml:1:13: scales.a.high: missing; add it, for example high: extraverted");
}

}  // namespace
}  // namespace mien::pipeline
