#include <gtest/gtest.h>

#include "injected_faults.h"

namespace mien::motion {
namespace {

using namespace mien::test;

/// Stands still, the whole figure leant over its feet by an angle that comes and goes.
Clip leaning(double degrees) {
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = 60.0;
  for (int t = 0; t < 240; ++t) {
    Pose pose;
    pose.rotations.assign(body_joint_count, Quat::Identity());
    const Quat turn = exp(Vec3(degrees * radians_per_degree * bump(t, 20, 220), 0, 0));
    pose.root_position = Vec3(0, 0.08, 0) + turn * Vec3(0, 0.88, 0);
    pose.rotations[Pelvis] = turn;
    pose.rotations[LeftAnkle] = pose.rotations[RightAnkle] = turn.conjugate();
    pose.rotations[LeftShoulder] = exp(Vec3(0, 0, -1.4));
    pose.rotations[RightShoulder] = exp(Vec3(0, 0, 1.4));
    clip.poses.push_back(pose);
  }
  return clip;
}

TEST(Balance, OfABodyThatStandsUprightIsKept) {
  EXPECT_TRUE(lint(leaning(0.0)).empty()) << all_of(lint(leaning(0.0)));
  EXPECT_FALSE(find(lint(leaning(5.0)), "balance")) << all_of(lint(leaning(5.0)));
}

TEST(Balance, OfABodyThatLeansBeyondItsFeetIsLost) {
  for (const double degrees : {25.0, -20.0}) {
    const auto findings = lint(leaning(degrees));
    const Finding* found = find_error(findings, "balance");
    ASSERT_TRUE(found) << all_of(findings);
    EXPECT_NE(found->sentence.find("standing"), std::string::npos) << found->sentence;
    EXPECT_GT(found->first, 20);
    EXPECT_LT(found->last, 220);
  }
}

TEST(Balance, OfAWalkThatLeansSidewaysIsLost) {
  Clip clip = three_cycles(builtin_walks()[0]);
  const Quat lean = exp(Vec3(0, 0, -0.3));
  for (Pose& pose : clip.poses) {
    pose.root_position = lean * pose.root_position;
    pose.rotations[Pelvis] = lean * pose.rotations[Pelvis];
    pose.rotations[Spine] = exp(Vec3(0, 0, -0.6));
    for (const BodyJoint ankle : {LeftAnkle, RightAnkle}) {
      pose.rotations[ankle] = pose.rotations[ankle] * lean.conjugate();
    }
  }
  const auto findings = lint(clip);
  EXPECT_TRUE(find_error(findings, "balance")) << all_of(findings);
}

}  // namespace
}  // namespace mien::motion
