#include "motion/biomechanics/body_dynamics.h"

#include <gtest/gtest.h>

#include "motion/biomechanics/body_mass.h"
#include "motion/biomechanics/inverse_dynamics.h"
#include "motion/lint/injected_faults.h"

namespace mien::motion {
namespace {

using namespace mien::test;

Clip standing(double rate = 100.0, int frames = 200) {
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = rate;
  Pose pose;
  pose.rotations.assign(body_joint_count, Quat::Identity());
  pose.root_position = Vec3(0.2, 0.96, -0.1);
  clip.poses.assign(static_cast<size_t>(frames), pose);
  return clip;
}

TEST(BodyDynamics, OfStandingStillIsWeight) {
  const std::vector<BodyDynamics> body = body_dynamics(lint_motion(standing()));
  for (const BodyDynamics& moment : body) {
    EXPECT_TRUE(moment.ground_reaction.isApprox(Vec3(0, gravity, 0), 1e-9));
    EXPECT_NEAR(moment.zero_moment_point.x(), moment.centre_of_mass.x(), 1e-9);
    EXPECT_NEAR(moment.zero_moment_point.z(), moment.centre_of_mass.z(), 1e-9);
  }
}

TEST(BodyDynamics, OfFreeFallIsNothing) {
  Clip clip = standing();
  for (int t = 0; t < clip.frame_count(); ++t) {
    const double seconds = t / clip.frames_per_second;
    clip.poses[t].root_position += Vec3(seconds, 5.0 - 0.5 * gravity * seconds * seconds, 0);
  }
  const std::vector<BodyDynamics> body = body_dynamics(lint_motion(clip));
  for (int t = 40; t < 160; ++t) EXPECT_LT(body[t].ground_reaction.norm(), 0.05) << t;
}

TEST(BodyDynamics, OfAPushedBodyMovesTheZeroMomentPointByHeightTimesAcceleration) {
  const double push = 2.0;  // m/s²
  Clip clip = standing();
  for (int t = 0; t < clip.frame_count(); ++t) {
    const double seconds = t / clip.frames_per_second;
    clip.poses[t].root_position.z() += 0.5 * push * seconds * seconds;
  }
  const std::vector<BodyDynamics> body = body_dynamics(lint_motion(clip));
  const BodyDynamics& moment = body[100];
  const double expected = moment.centre_of_mass.z() - moment.centre_of_mass.y() * push / gravity;
  EXPECT_NEAR(moment.zero_moment_point.z(), expected, 1e-3);
  EXPECT_NEAR(moment.ground_reaction.z(), push, 1e-3);
}

TEST(BodyDynamics, OfATurnAboutTheVerticalNeedsAMomentOnlyWhileItChanges) {
  Clip clip = standing();
  for (int t = 0; t < clip.frame_count(); ++t) {
    clip.poses[t].rotations[Pelvis] = exp(Vec3(0, 1.0 * t / clip.frames_per_second, 0));
  }
  const std::vector<BodyDynamics> body = body_dynamics(lint_motion(clip));
  double rate = 0.0;
  for (int s = 0; s < segment_count; ++s) rate += std::abs(body[100].momentum_rate[s].y());
  EXPECT_LT(rate, 1e-6);
}

TEST(InverseDynamics, OfAnArmHeldOutIsItsWeightTimesItsLever) {
  const Clip clip = standing();
  const LintMotion motion = lint_motion(clip);
  const std::vector<BodyDynamics> body = body_dynamics(motion);
  const std::vector<SegmentMass> segments = segment_masses(clip.body, motion.world[100]);
  const double shoulder = motion.world[100].positions[LeftShoulder].x();
  const double elbow = motion.world[100].positions[LeftElbow].x();
  double about_shoulder = 0.0;
  double about_elbow = 0.0;
  for (const SegmentMass& segment : segments) {
    const bool is_forearm = segment.name == "left forearm" || segment.name == "left hand";
    const double weight = segment.share * gravity;
    if (is_forearm) about_elbow += weight * (segment.centre.x() - elbow);
    if (is_forearm || segment.name == "left upper arm") {
      about_shoulder += weight * (segment.centre.x() - shoulder);
    }
  }
  const std::vector<double> torques = joint_torques(body[100], supports(motion)[100]);
  const auto& joints = torque_joints();
  for (size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].joint == LeftShoulder) {
      EXPECT_NEAR(torques[j], about_shoulder, 1e-6);
    }
    if (joints[j].joint == LeftElbow) {
      EXPECT_NEAR(torques[j], about_elbow, 1e-6);
    }
  }
  // About 4 kg of arm, 0.3 m out: 10 to 15 N·m of a body of 70 kg.
  EXPECT_NEAR(70 * about_shoulder, 12.0, 4.0);
}

TEST(InverseDynamics, OfStandingOnTwoLegsNeedsLittle) {
  const LintMotion motion = lint_motion(standing());
  const std::vector<double> torques =
      joint_torques(body_dynamics(motion)[100], supports(motion)[100]);
  ASSERT_FALSE(supports(motion)[100].empty());
  for (size_t j = 0; j < torques.size(); ++j) EXPECT_LT(70 * torques[j], 45.0) << j;
}

TEST(InverseDynamics, OfNormalWalkingIsWhatGaitLaboratoriesMeasure) {
  const LintMotion motion = lint_motion(builtin_walks()[0]);
  const std::vector<BodyDynamics> body = body_dynamics(motion);
  const std::vector<Support> floor = supports(motion);
  double ankle = 0.0;
  double force = 0.0;
  for (int t = motion.start; t < motion.start + motion.frames; ++t) {
    ankle = std::max(ankle, joint_torques(body[t], floor[t])[5]);
    force = std::max(force, body[t].ground_reaction.y() / gravity);
  }
  EXPECT_GT(ankle, 1.2);  // N·m/kg; 1.3 to 1.8 at push off (Winter 2009)
  EXPECT_LT(ankle, 2.6);
  EXPECT_GT(force, 1.05);
  EXPECT_LT(force, 1.45);
}

TEST(Forces, ThatThrowTheBodyUpAndDownAreFound) {
  Clip clip = standing(60.0, 180);
  for (int t = 0; t < clip.frame_count(); ++t) {
    clip.poses[t].root_position.y() += 0.12 * std::sin(2 * pi * 3.0 * t / 60.0);
  }
  const auto findings = lint(clip);
  const Finding* found = find(findings, "forces");
  ASSERT_TRUE(found) << all_of(findings);
  EXPECT_GT(found->measured, 3.0);
}

TEST(Forces, ThatPushSidewaysMoreThanShoesHoldAreFound) {
  Clip clip = standing(60.0, 180);
  // Leans to and fro about feet that stay where they are.
  for (int t = 0; t < clip.frame_count(); ++t) {
    const double lean = 0.35 * std::sin(2 * pi * 1.3 * t / 60.0);
    const Quat turn = exp(Vec3(lean, 0, 0));
    const Vec3 ankles(0.2, 0.08, -0.1);
    clip.poses[t].root_position = ankles + turn * (clip.poses[t].root_position - ankles);
    clip.poses[t].rotations[Pelvis] = turn;
    clip.poses[t].rotations[LeftAnkle] = clip.poses[t].rotations[RightAnkle] = turn.conjugate();
  }
  const auto findings = lint(clip);
  bool found = false;
  for (const Finding& finding : findings) {
    found = found || finding.sentence.find("would slip: horizontal") != std::string::npos;
  }
  EXPECT_TRUE(found) << all_of(findings);
}

TEST(Torques, OfAFlungArmAreFound) {
  Clip clip = standing(120.0, 240);
  for (int t = 60; t < 180; ++t) {
    const double swing = 1.3 * std::sin(2 * pi * 4.0 * (t - 60) / 120.0) * bump(t, 60, 179);
    clip.poses[t].rotations[RightShoulder] = exp(Vec3(0, swing, 0));
  }
  const auto findings = lint(clip);
  EXPECT_TRUE(find(findings, "joint-torque", "RightShoulder", 60, 180)) << all_of(findings);
  EXPECT_FALSE(find(findings, "joint-torque", "LeftShoulder")) << all_of(findings);
}

TEST(Torques, OfHeavierBodiesHaveTheSameFaults) {
  Clip clip = standing(120.0, 240);
  for (int t = 60; t < 180; ++t) {
    const double swing = 1.3 * std::sin(2 * pi * 4.0 * (t - 60) / 120.0) * bump(t, 60, 179);
    clip.poses[t].rotations[RightShoulder] = exp(Vec3(0, swing, 0));
  }
  LintOptions heavy;
  heavy.body_mass_kg = 105.0;
  const auto light_findings = lint(clip);
  const auto heavy_findings = lint(clip, heavy);
  const Finding* light = find(light_findings, "joint-torque");
  const Finding* more = find(heavy_findings, "joint-torque");
  ASSERT_TRUE(light && more);
  EXPECT_NEAR(more->measured, 1.5 * light->measured, 1e-9 * more->measured);
  EXPECT_NEAR(more->threshold, 1.5 * light->threshold, 1e-9 * more->threshold);
}

TEST(Speeds, BeyondWhatJointsDoAreErrors) {
  Clip clip = standing(240.0, 480);
  for (int t = 100; t < 315; ++t) {
    clip.poses[t].rotations[LeftKnee] =
        exp(Vec3(1.2 - 1.2 * std::cos(35.0 * (t - 100) / 240.0), 0, 0));
    clip.poses[t].rotations[Head] = exp(Vec3(0, 0.5 * std::sin(20.0 * (t - 100) / 240.0), 0));
  }
  const auto findings = lint(clip);
  const Finding* found = find_error(findings, "joint-speed", "LeftKnee", 100, 315);
  ASSERT_TRUE(found) << all_of(findings);
  EXPECT_NEAR(found->measured, 1.2 * 35.0, 0.5);
  EXPECT_FALSE(find(findings, "joint-speed", "Head"));
}

}  // namespace
}  // namespace mien::motion
