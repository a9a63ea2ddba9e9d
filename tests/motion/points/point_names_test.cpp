#include "motion/points/point_names.h"

#include <set>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

TEST(PointNames, AreKeptWhereTheyDiffer) {
  std::vector<std::string> notes;
  const std::vector<std::string> names = {"LASI", "RASI", "point_2"};
  EXPECT_EQ(distinct_point_names(names, notes), names);
  EXPECT_TRUE(notes.empty());
}

TEST(PointNames, AreMadeDifferentAndNotEmpty) {
  std::vector<std::string> notes;
  EXPECT_EQ(distinct_point_names({"a", "", "a", "a_2", "a", ""}, notes),
            (std::vector<std::string>{"a", "point_2", "a_3", "a_2", "a_4", "point_6"}));
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_NE(notes[0].find("2 points have no name"), std::string::npos) << notes[0];
  EXPECT_NE(notes[1].find("occur more than once"), std::string::npos) << notes[1];
}

TEST(PointNames, DifferHoweverManyAreEqual) {
  std::vector<std::string> notes;
  const std::vector<std::string> names =
      distinct_point_names(std::vector<std::string>(100'000, "a"), notes);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

}  // namespace
}  // namespace mien::motion
