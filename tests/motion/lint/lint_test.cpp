#include "motion/lint/lint.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "motion/handed_motion.h"

#include "injected_faults.h"

namespace mien::motion {
namespace {

using namespace mien::test;

Clip faulty_walk() {
  Clip clip = three_cycles(builtin_walks()[0]);
  bend_knee_backwards(clip, true, 20, 32, 35.0);
  put_hand_through_torso(clip, false, 40, 60);
  raise(clip, 60, 80, 0.06);
  leap(clip, Head, 15, 40.0, Vec3::UnitX());
  return clip;
}

// A body that stands still for two seconds while its fingers move is no frozen recording.
TEST(Lint, TakesMovingFingersForAMotion) {
  Clip clip = three_cycles(builtin_walks()[0]);
  const auto frames = static_cast<std::size_t>(std::lround(2.0 * clip.frames_per_second));
  clip.poses.insert(clip.poses.end(), frames, clip.poses.back());
  const auto is_frozen = [](const Clip& given) {
    return std::ranges::any_of(lint(given),
                               [](const Finding& finding) { return finding.check == "frozen"; });
  };
  EXPECT_TRUE(is_frozen(clip));
  std::mt19937_64 random(5);
  EXPECT_FALSE(is_frozen(with_moving_fingers(clip, random)));
}

TEST(Lint, TellsItsFindingsInTheOrderOfItsRules) {
  const auto findings = lint(faulty_walk());
  ASSERT_GE(findings.size(), 4U);
  const auto rank = [](const Finding& finding) {
    const auto& checks = lint_checks();
    return std::find_if(checks.begin(), checks.end(),
                        [&](const LintCheck& check) { return check.id == finding.check; }) -
           checks.begin();
  };
  for (size_t i = 0; i < findings.size(); ++i) {
    EXPECT_LT(rank(findings[i]), static_cast<long>(lint_checks().size())) << findings[i].check;
    if (i == 0) continue;
    EXPECT_LE(rank(findings[i - 1]), rank(findings[i]));
    if (findings[i - 1].check == findings[i].check) {
      EXPECT_LE(findings[i - 1].first, findings[i].first);
    }
  }
}

TEST(Lint, TellsFramesWithinTheClipAndValuesBeyondTheThreshold) {
  const Clip clip = faulty_walk();
  for (const Finding& finding : lint(clip)) {
    EXPECT_GE(finding.first, 0);
    EXPECT_LE(finding.first, finding.last);
    EXPECT_LT(finding.last, clip.frame_count());
    EXPECT_GT(finding.measured, finding.threshold) << finding.sentence;
    EXPECT_TRUE(finding.sentence.ends_with(".")) << finding.sentence;
  }
}

TEST(Lint, TakesRoundingOfTwoJointsInOnePlaceForNoBoneThatGrows) {
  Recording recording = to_recording(three_cycles(builtin_walks()[0]));
  const int neck = find_joint(recording.skeleton, "Neck");
  ASSERT_GT(neck, 0);
  const auto with_neck = [&](double noise, double last) {
    recording.skeleton.joints[neck].offset = Vec3::Zero();
    for (size_t t = 0; t < recording.poses.size(); ++t) {
      Pose& pose = recording.poses[t];
      pose.offsets.clear();
      for (const Joint& joint : recording.skeleton.joints) pose.offsets.push_back(joint.offset);
      const auto phase = static_cast<double>(t);
      pose.offsets[neck] = noise * Vec3(std::sin(phase), std::cos(1.7 * phase), 0.0);
    }
    recording.poses.back().offsets[neck].y() += last;
    const auto findings = lint(recording);
    return std::count_if(findings.begin(), findings.end(),
                         [](const Finding& one) { return one.check == "bone-length"; });
  };
  const double unit =
      recording.skeleton.joints[find_joint(recording.skeleton, "LeftKnee")].offset.norm();
  EXPECT_EQ(with_neck(1e-6 * unit, 0.0), 0);
  EXPECT_GT(with_neck(1e-6 * unit, 0.1 * unit), 0);
}

TEST(Lint, TellsTheSameTwice) {
  const auto once = lint(faulty_walk());
  const auto again = lint(faulty_walk());
  ASSERT_EQ(once.size(), again.size());
  for (size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].sentence, again[i].sentence);
    EXPECT_EQ(once[i].measured, again[i].measured);
  }
}

TEST(Lint, OfALoopTellsAFaultOverTheSeamOnce) {
  Clip loop = builtin_walks()[0];
  const int n = loop.frame_count();
  for (int t = -6; t <= 6; ++t) {
    const Quat wrong = exp(Vec3(-35 * radians_per_degree * bump(t + 6, 0, 12), 0, 0));
    Quat& rotation = loop.poses[(t + n) % n].rotations[LeftKnee];
    rotation = slerp(rotation, wrong, bump(t + 6, 0, 12));
  }
  const auto findings = lint(loop);
  int count = 0;
  for (const Finding& finding : findings) {
    if (finding.check != "joint-limit") continue;
    ++count;
    EXPECT_LT(finding.first, n);
    EXPECT_GE(finding.first, n - 7);
    EXPECT_GE(finding.last, n);  // frame n is frame 0 again
    EXPECT_LE(finding.last, n + 6);
  }
  EXPECT_EQ(count, 1) << all_of(findings);
}

TEST(Lint, OfAnotherSkeletonLooksAtTheDataOnly) {
  Clip clip;
  clip.body.joints = {{"base", -1, Vec3::Zero(), std::nullopt},
                      {"tip", 0, Vec3(0, 1, 0), std::nullopt}};
  Pose pose;
  pose.rotations.assign(2, Quat::Identity());
  clip.poses.assign(20, pose);
  EXPECT_TRUE(lint(clip).empty());
  leap(clip, BodyJoint(1), 10, 40.0, Vec3::UnitX());
  const auto findings = lint(clip);
  ASSERT_EQ(findings.size(), 1U) << all_of(findings);
  EXPECT_EQ(findings[0].check, "jump");
  EXPECT_EQ(findings[0].joint, "tip");
}

TEST(Lint, OfShortMotionsDoesNotFail) {
  Clip clip;
  clip.body = standard_body();
  EXPECT_TRUE(lint(clip).empty());
  Pose pose;
  pose.rotations.assign(body_joint_count, Quat::Identity());
  pose.root_position.y() = 0.96;
  const Clip walk = builtin_walks()[0];
  for (int frames = 1; frames < 12; ++frames) {
    clip.poses.assign(static_cast<size_t>(frames), pose);
    clip.loops = false;
    EXPECT_TRUE(lint(clip, {}, &walk).size() < 100);
    clip.loops = true;
    EXPECT_TRUE(lint(clip, {}, &clip).empty()) << frames << all_of(lint(clip, {}, &clip));
  }
}

TEST(Lint, TellsQuaternionsThatAreNoRotations) {
  Clip clip = builtin_walks()[0];
  clip.poses[7].rotations[Chest].coeffs() *= 1.01;
  const auto findings = lint(clip);
  const Finding* found = find_error(findings, "rotation-not-unit", "Chest", 7, 7);
  ASSERT_TRUE(found) << all_of(findings);
  EXPECT_NEAR(found->measured, 0.01, 1e-9);
  EXPECT_EQ(findings.size(), 1U) << all_of(findings);
}

TEST(Lint, OfARecordingTellsBonesThatGrow) {
  Recording recording = to_recording(three_cycles(builtin_walks()[0]));
  EXPECT_TRUE(lint(recording).empty());
  for (Pose& pose : recording.poses) {
    for (const Joint& joint : recording.skeleton.joints) pose.offsets.push_back(joint.offset);
  }
  EXPECT_TRUE(lint(recording).empty());
  recording.poses[30].offsets[LeftKnee] *= 1.02;
  const auto findings = lint(recording);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].joint, "LeftKnee");
}

}  // namespace
}  // namespace mien::motion
