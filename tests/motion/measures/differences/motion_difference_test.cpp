#include "motion/measures/differences/motion_difference.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "motion/changed_motion.h"
#include "motion/refusal.h"

namespace mien::motion {
namespace {

using namespace mien::test;

MotionDifference difference(const Clip& before, const Clip& now) {
  return motion_difference(before, now, {.lint = false, .lint_options = {}});
}

TEST(MotionDifference, OfAMotionToItselfIsExactlyNothing) {
  for (const Clip& walk : {changeable_walk(), changeable_loop()}) {
    const MotionDifference none = motion_difference(walk, walk);
    EXPECT_TRUE(none.identical);
    EXPECT_EQ(none.errors.mpjpe, 0.0);
    EXPECT_EQ(none.errors.root_relative_mpjpe, 0.0);
    EXPECT_EQ(none.errors.pa_mpjpe, 0.0);
    ASSERT_TRUE(none.body);
    EXPECT_EQ(none.body->d_m, 0.0);
    EXPECT_EQ(none.body->mpjpe_m, 0.0);
    EXPECT_TRUE(none.lint.empty());
    EXPECT_EQ(worst_joint(none, &JointDifference::point_m).peak.value, 0.0);
    EXPECT_EQ(peak_of(none.root.tilt_radians).value, 0.0);
    EXPECT_EQ(none.whole.kind, WholeChange::none);
    EXPECT_TRUE(causes(none).empty());
    EXPECT_FALSE(is_root_only(none));
  }
}

TEST(MotionDifference, NamesTheOneJointThatTurnedAsItsCause) {
  const Clip walk = changeable_walk();
  for (int j = 1; j < body_joint_count; ++j) {
    const MotionDifference turned =
        difference(walk, with_turn(walk, BodyJoint(j), Vec3(0.4, 0.7, 0.2), degree));
    EXPECT_EQ(causes(turned), std::vector{j});
    EXPECT_FALSE(is_root_only(turned));
    EXPECT_FALSE(turned.identical);
  }
}

TEST(MotionDifference, PutsTheLargestCauseFirst) {
  const Clip walk = changeable_walk();
  Clip now = with_turn(walk, RightKnee, Vec3(1, 0, 0), degree);
  now = with_turn(now, Neck, Vec3(0, 1, 0), 3.0 * degree);
  now = with_turn(now, LeftWrist, Vec3(0, 1, 0), 2.0 * degree);
  EXPECT_EQ(causes(difference(walk, now)), (std::vector<int>{Neck, LeftWrist, RightKnee}));
}

TEST(MotionDifference, KnowsPathAndHeadingFromPoses) {
  const Clip walk = changeable_walk();
  EXPECT_TRUE(is_root_only(difference(walk, set_elsewhere(walk, Vec3(0.1, 0, 0), 0.0))));
  EXPECT_TRUE(is_root_only(difference(walk, set_elsewhere(walk, Vec3::Zero(), 2.0 * degree))));
  EXPECT_TRUE(is_root_only(difference(walk, with_turn(walk, Pelvis, Vec3(1, 0, 0), degree))));
  EXPECT_FALSE(is_root_only(difference(walk, with_turn(walk, Spine, Vec3(1, 0, 0), degree))));
}

TEST(MotionDifference, ErrorsHaveTheirClosedForms) {
  const Clip walk = changeable_walk();
  const MotionDifference raised = difference(walk, set_elsewhere(walk, Vec3(0.03, 0, 0.04), 0.0));
  EXPECT_NEAR(raised.errors.mpjpe, 0.05, 1e-12);
  EXPECT_NEAR(raised.errors.root_relative_mpjpe, 0.0, 1e-12);
  EXPECT_NEAR(raised.errors.pa_mpjpe, 0.0, 1e-12);
  EXPECT_NEAR(raised.body->d_m, 0.0, 1e-9);
  // Nothing hangs on the toes: one joint of 21 is elsewhere.
  Clip now = walk;
  now.body.joints[LeftToe].offset += Vec3(0, 0, 0.021);
  const MotionDifference longer = difference(walk, now);
  EXPECT_NEAR(longer.errors.mpjpe, 0.001, 1e-12);
  EXPECT_NEAR(longer.errors.root_relative_mpjpe, 0.001, 1e-12);
  EXPECT_LT(root_mean_square(longer, &JointDifference::aligned_m),
            root_mean_square(longer, &JointDifference::position_m));
}

TEST(MotionDifference, OfATwistNobodySeesInJointsIsSeenByVirtualPoints) {
  const Clip walk = changeable_walk();
  const Vec3 along = bone_axes(walk.body)[LeftWrist].along;
  const MotionDifference twisted = difference(walk, with_turn(walk, LeftWrist, along, degree));
  EXPECT_LT(twisted.errors.mpjpe, 1e-12);
  EXPECT_NEAR(worst_joint(twisted, &JointDifference::point_m).peak.value,
              0.2 * std::sin(0.5 * degree), 1e-12);
}

TEST(MotionDifference, ComparesTheMomentsThatBothHave) {
  const Clip walk = changeable_walk();
  const MotionDifference shorter = difference(walk, without_last(walk, 4));
  EXPECT_EQ(worst_joint(shorter, &JointDifference::point_m).peak.value, 0.0);
  EXPECT_FALSE(shorter.identical);
  EXPECT_EQ(shorter.timing.before.frames - shorter.timing.now.frames, 4);
  EXPECT_EQ(shorter.joints[0].position_m.size(), walk.poses.size() - 4);
}

TEST(MotionDifference, ComparesOtherRatesByTime) {
  const Clip walk = changeable_walk();
  const Clip twice = resampled(walk, 2.0 * walk.frames_per_second);
  EXPECT_LT(worst_joint(difference(walk, twice), &JointDifference::point_m).peak.value, 1e-9);
  const MotionDifference back = difference(twice, walk);
  EXPECT_EQ(back.joints[0].position_m.size(), twice.poses.size());
  EXPECT_LT(worst_joint(back, &JointDifference::point_m).peak.value, 0.005);
}

TEST(MotionDifference, TakesAClipOfOneFrame) {
  const Clip walk = changeable_walk();
  const Clip frame = without_last(walk, walk.frame_count() - 1);
  const MotionDifference turned =
      motion_difference(frame, with_turn(frame, LeftElbow, Vec3(0, 0, 1), degree));
  EXPECT_EQ(causes(turned), std::vector<int>{LeftElbow});
  EXPECT_EQ(worst_joint(turned, &JointDifference::velocity_m_s).peak.value, 0.0);
  EXPECT_TRUE(motion_difference(frame, frame).identical);
  EXPECT_EQ(motion_difference(frame, walk).timing.now.frames, walk.frame_count());
}

TEST(MotionDifference, TellsFaultsThatCameIn) {
  const Clip walk = changeable_walk();
  Clip now = walk;
  leap(now, Head, 20, 40.0, Vec3::UnitX());
  const MotionDifference faulty = motion_difference(walk, now);
  const auto is_jump = [](const LintChange& change) {
    return change.kind == LintChange::Kind::appeared && change.finding.check == "jump" &&
           change.finding.joint == "Head";
  };
  EXPECT_TRUE(std::ranges::any_of(faulty.lint, is_jump));
}

TEST(MotionDifference, TellsJointsThatOneOfThemHas) {
  const Clip walk = changeable_walk();
  Clip now = walk;
  now.body.joints[RightToe].name = "RightPaw";
  const MotionDifference other = difference(walk, now);
  EXPECT_EQ(other.only_before, std::vector<std::string>{"RightToe"});
  EXPECT_EQ(other.only_now, std::vector<std::string>{"RightPaw"});
  EXPECT_EQ(other.joints.size(), body_joint_count - 1U);
}

TEST(MotionDifference, RefusesWhatCannotBeCompared) {
  const Clip walk = changeable_walk();
  Clip broken = walk;
  broken.name = "broken";
  broken.poses[7].rotations[3].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(
      refusal_of([&] { difference(walk, broken); }).find("broken: frame 7 holds an invalid number"),
      std::string::npos);
  Clip empty = walk;
  empty.poses.clear();
  EXPECT_THROW(difference(walk, empty), Error);
  Clip other = walk;
  for (Joint& joint : other.body.joints) joint.name += "?";
  EXPECT_THROW(difference(walk, other), Error);
}

TEST(FeatureDifferences, AreOfFeaturesThatEitherHas) {
  FeatureValues before;
  before.fill(std::numeric_limits<double>::quiet_NaN());
  FeatureValues now = before;
  before[2] = 10.0;
  now[2] = 10.5;
  now[5] = 3.0;
  const auto differences = feature_differences(before, now);
  ASSERT_EQ(differences.size(), 2U);
  EXPECT_EQ(differences[0].feature, 2);
  EXPECT_TRUE(differences[1].is_notable());
  EXPECT_FALSE((FeatureDifference{0, 10.0, 10.0}).is_notable());
}

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
