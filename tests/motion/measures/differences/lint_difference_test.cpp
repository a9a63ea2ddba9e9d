#include <gtest/gtest.h>

#include "motion/measures/differences/motion_difference.h"

namespace mien::motion {
namespace {

Finding finding(const std::string& check, const std::string& joint, int first, int last,
                Severity severity = Severity::warning) {
  Finding result;
  result.check = check;
  result.joint = joint;
  result.first = first;
  result.last = last;
  result.severity = severity;
  return result;
}

TEST(LintChanges, AreNoneForTheSameFindings) {
  const std::vector<Finding> findings = {finding("jump", "Head", 3, 5),
                                         finding("foot-skate", "LeftAnkle", 10, 20)};
  EXPECT_TRUE(lint_changes(findings, 30.0, findings, 30.0).empty());
}

TEST(LintChanges, TellWhatIsNewAndWhatIsGone) {
  const auto changes =
      lint_changes({finding("jump", "Head", 3, 5)}, 30.0,
                   {finding("jump", "Neck", 3, 5), finding("jump", "Head", 30, 32)}, 30.0);
  ASSERT_EQ(changes.size(), 3U);
  EXPECT_EQ(changes[0].kind, LintChange::Kind::appeared);
  EXPECT_EQ(changes[0].finding.joint, "Neck");
  EXPECT_EQ(changes[1].finding.first, 30);
  EXPECT_EQ(changes[2].kind, LintChange::Kind::gone);
  EXPECT_EQ(changes[2].finding.joint, "Head");
}

TEST(LintChanges, TellAFaultThatBecameAnErrorOrNoLongerIsOne) {
  const Finding mild = finding("floating", "", 10, 20);
  const Finding grave = finding("floating", "", 15, 30, Severity::error);
  EXPECT_EQ(lint_changes({mild}, 30.0, {grave}, 30.0).at(0).kind, LintChange::Kind::worse);
  EXPECT_EQ(lint_changes({grave}, 30.0, {mild}, 30.0).at(0).kind, LintChange::Kind::better);
}

TEST(LintChanges, CompareFramesByTheirTime) {
  const Finding before = finding("jump", "Head", 30, 32);
  EXPECT_TRUE(lint_changes({before}, 30.0, {finding("jump", "Head", 60, 64)}, 60.0).empty());
  EXPECT_EQ(lint_changes({before}, 30.0, {finding("jump", "Head", 30, 32)}, 60.0).size(), 2U);
}

}  // namespace
}  // namespace mien::motion
