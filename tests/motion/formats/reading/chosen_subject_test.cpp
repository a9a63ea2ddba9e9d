#include "motion/formats/reading/chosen_subject.h"

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

using Names = std::vector<std::string>;

TEST(SubjectNames, AreDistinctAndNeverEmpty) {
  EXPECT_EQ(subject_names({"Anna", "", "Anna"}), (Names{"Anna", "subject 2", "Anna 3"}));
}

TEST(SubjectNames, AreThosePeopleHaveBeforeTheNamesOfTheirRoots) {
  EXPECT_EQ(subject_names({"Anna_Hips", "Ben_Hips"}), (Names{"Anna", "Ben"}));
  EXPECT_EQ(subject_names({"A:pelvis", "B C:pelvis", "D:pelvis"}), (Names{"A", "B C", "D"}));
  // Not if one is left without a name, if endings differ, or if they do not name a root.
  for (const Names& kept : {Names{"Anna_Hips", "_Hips"}, Names{"Anna_Hips", "Ben_Root"},
                            Names{"Anna_Smith", "Ben_Smith"}, Names{"Anna_Hips"}})
    EXPECT_EQ(subject_names(kept), kept);
}

}  // namespace
}  // namespace mien::motion
