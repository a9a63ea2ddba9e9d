#include "injected_faults.h"

#include <gtest/gtest.h>

#include "motion/gait/contact.h"
#include "motion/lint/lint.h"

// Every fault put into every built-in walk, at random places, is found.

namespace mien::motion {
namespace {

using namespace mien::test;

class InjectedFault : public testing::Test {
 protected:
  std::mt19937_64 random{20240117};
  std::vector<Clip> walks = builtin_walks();

  bool coin() { return std::bernoulli_distribution(0.5)(random); }

  Vec3 direction() {
    std::normal_distribution<double> along;
    return Vec3(along(random), along(random), along(random)).normalized();
  }
};

TEST_F(InjectedFault, WalksWithoutAnyHaveNoFindings) {
  for (const Clip& loop : walks) {
    const std::vector<Finding> findings = lint(loop, {}, &loop);
    EXPECT_FALSE(has_errors(findings)) << loop.name << "\n" << all_of(findings);
    EXPECT_TRUE(findings.empty()) << loop.name << "\n" << all_of(findings);
    const Clip clip = three_cycles(loop);
    EXPECT_TRUE(lint(clip).empty()) << loop.name << "\n" << all_of(lint(clip));
  }
}

TEST_F(InjectedFault, KneeBentBackwardsIsAnError) {
  for (const Clip& loop : walks) {
    Clip clip = three_cycles(loop);
    const bool left = coin();
    const int length = frames_of(clip, 0.4);
    const int first = random_start(random, clip, length);
    bend_knee_backwards(clip, left, first, first + length, 35.0);
    const auto findings = lint(clip);
    const Finding* found =
        find(findings, "joint-limit", left ? "LeftKnee" : "RightKnee", first, first + length);
    ASSERT_TRUE(found) << loop.name << "\n" << all_of(findings);
    EXPECT_NEAR(found->measured, 35.0, 1.0);
  }
}

TEST_F(InjectedFault, FootSkateOfThreeCentimetresIsFound) {
  for (const Clip& loop : walks) {
    const Clip before = three_cycles(loop);
    Clip clip = before;
    std::vector<FootPlant> plants = foot_plants(clip);
    std::erase_if(plants, [&](const FootPlant& plant) {
      return plant.first == 0 || plant.last - plant.first < frames_of(clip, 0.4);
    });
    ASSERT_GE(plants.size(), 3U);
    const FootPlant plant = plants[std::uniform_int_distribution<size_t>(0, 2)(random)];
    Vec3 way = direction();
    way.y() = 0.0;
    slide(clip, plant, 0.03 * way.normalized());
    const std::string foot = plant.left ? "LeftAnkle" : "RightAnkle";
    const auto findings = lint(clip);
    const Finding* found = find(findings, "foot-skate", foot, plant.first, plant.last);
    ASSERT_TRUE(found) << loop.name << "\n" << all_of(findings);
    EXPECT_NEAR(found->measured, 0.03, 0.01) << loop.name;
    // Against a walk whose feet stand still it is an error.
    const auto compared = lint(clip, {}, &before);
    EXPECT_TRUE(find_error(compared, "foot-skate", foot, plant.first, plant.last))
        << loop.name << "\n"
        << all_of(compared);
  }
}

TEST_F(InjectedFault, HandThroughTorsoIsAnError) {
  for (const Clip& loop : walks) {
    Clip clip = three_cycles(loop);
    const bool left = coin();
    const int length = frames_of(clip, 0.6);
    const int first = random_start(random, clip, length);
    put_hand_through_torso(clip, left, first, first + length);
    const auto findings = lint(clip);
    const Finding* found = find_error(findings, "self-intersection",
                                      left ? "LeftWrist" : "RightWrist", first, first + length);
    ASSERT_TRUE(found) << loop.name << "\n" << all_of(findings);
  }
}

TEST_F(InjectedFault, FrameJumpIsAnError) {
  const std::vector<BodyJoint> joints = {
      Spine,     Chest,   Neck,     Head,      LeftClavicle,  LeftElbow, LeftShoulder,
      LeftWrist, LeftHip, LeftKnee, LeftAnkle, RightShoulder, RightHip,  RightAnkle};
  for (const Clip& loop : walks) {
    Clip clip = three_cycles(loop);
    const BodyJoint joint = random_of(random, joints);
    const int frame = random_start(random, clip, 1);
    leap(clip, joint, frame, 40.0, direction());
    const auto findings = lint(clip);
    const Finding* found = find_error(findings, "jump", std::string(name_of(joint)), frame, frame);
    ASSERT_TRUE(found) << loop.name << " " << name_of(joint) << "\n" << all_of(findings);
  }
}

TEST_F(InjectedFault, FloatingIsAnError) {
  for (const Clip& loop : walks) {
    Clip clip = three_cycles(loop);
    const int length = frames_of(clip, 0.8);
    const int first = random_start(random, clip, length);
    raise(clip, first, first + length, 0.05);
    const auto findings = lint(clip);
    const Finding* found = find_error(findings, "floating", "", first, first + length);
    ASSERT_TRUE(found) << loop.name << "\n" << all_of(findings);
    EXPECT_NEAR(found->measured, 0.05, 0.005);
  }
}

TEST_F(InjectedFault, LoopThatFloatsThroughoutIsAnError) {
  for (Clip loop : walks) {
    for (Pose& pose : loop.poses) pose.root_position.y() += 0.05;
    const auto findings = lint(loop);
    const Finding* found = find_error(findings, "floating");
    ASSERT_TRUE(found) << loop.name << "\n" << all_of(findings);
    EXPECT_EQ(found->first, 0);
    EXPECT_EQ(found->last, loop.frame_count() - 1);
  }
}

TEST_F(InjectedFault, SinkingIsAnError) {
  for (const Clip& loop : walks) {
    Clip clip = three_cycles(loop);
    const int length = frames_of(clip, 0.5);
    const int first = random_start(random, clip, length);
    raise(clip, first, first + length, -0.04);
    const auto findings = lint(clip);
    const Finding* found = find_error(findings, "penetration", "", first, first + length);
    ASSERT_TRUE(found) << loop.name << "\n" << all_of(findings);
  }
}

TEST_F(InjectedFault, DoubledSpeedOfOneLimbIsFound) {
  for (const Clip& loop : walks) {
    const BodyJoint end = random_of(random, {LeftWrist, RightWrist, LeftAnkle, RightAnkle});
    Clip clip = loop;
    retime(clip, end, [](double seconds) { return 2.0 * seconds; });
    const auto findings = lint(clip, {}, &loop);
    const std::string name(name_of(end));
    const bool is_found = find(findings, "jerk", name) || find(findings, "limb-phase", name) ||
                          find(findings, "contact-timing", name);
    EXPECT_TRUE(is_found) << loop.name << " " << name << "\n" << all_of(findings);
  }
}

TEST_F(InjectedFault, NotANumberIsAnError) {
  for (const Clip& loop : walks) {
    Clip clip = loop;
    const int joint = std::uniform_int_distribution<int>(0, body_joint_count - 1)(random);
    const int frame = random_start(random, clip, 1);
    clip.poses[frame].rotations[joint].x() = std::numeric_limits<double>::quiet_NaN();
    const auto findings = lint(clip, {}, &loop);
    const Finding* found =
        find_error(findings, "non-finite", std::string(name_of(BodyJoint(joint))));
    ASSERT_TRUE(found) << loop.name;
    EXPECT_EQ(found->first, frame);
    EXPECT_EQ(found->last, frame);
  }
}

TEST_F(InjectedFault, StretchedBoneIsAnError) {
  for (const Clip& loop : walks) {
    Clip clip = three_cycles(loop);
    const BodyJoint joint = random_of(random, {Neck, LeftElbow, LeftWrist, RightKnee, RightAnkle});
    const int first = random_start(random, clip, 6);
    for (int t = first; t < first + 6; ++t) {
      for (const Joint& each : clip.body.joints) clip.poses[t].offsets.push_back(each.offset);
      clip.poses[t].offsets[joint] *= 1.05;
    }
    const auto findings = lint(clip);
    const Finding* found = find_error(findings, "bone-length", std::string(name_of(joint)));
    ASSERT_TRUE(found) << loop.name;
    EXPECT_EQ(found->first, first);
    EXPECT_EQ(found->last, first + 5);
    EXPECT_NEAR(found->measured, 0.05, 1e-9);
  }
}

TEST_F(InjectedFault, BrokenSeamIsAnError) {
  for (const Clip& loop : walks) {
    Clip clip = loop;
    const BodyJoint joint = random_of(random, {Chest, Head, LeftShoulder, RightElbow, LeftHip});
    break_seam(clip, joint, 25.0);
    const auto findings = lint(clip);
    const Finding* found = find_error(findings, "loop-seam", std::string(name_of(joint)));
    ASSERT_TRUE(found) << loop.name << " " << name_of(joint) << "\n" << all_of(findings);
    EXPECT_EQ(found->first, loop.frame_count() - 1);
  }
}

TEST_F(InjectedFault, LimbHalfASecondLateIsFound) {
  for (const Clip& loop : walks) {
    const BodyJoint end = random_of(random, {LeftWrist, RightWrist, LeftAnkle, RightAnkle});
    Clip clip = loop;
    retime(clip, end, [](double seconds) { return seconds - 0.5; });
    const auto findings = lint(clip, {}, &loop);
    EXPECT_TRUE(find(findings, "limb-phase", std::string(name_of(end))))
        << loop.name << " " << name_of(end) << "\n"
        << all_of(findings);
  }
}

TEST_F(InjectedFault, StepThatComesLateIsFound) {
  for (const Clip& loop : walks) {
    const BodyJoint end = random_of(random, {LeftAnkle, RightAnkle});
    Clip clip = loop;
    retime(clip, end, [](double seconds) { return seconds - 0.15; });
    const auto findings = lint(clip, {}, &loop);
    EXPECT_TRUE(find(findings, "contact-timing", std::string(name_of(end))))
        << loop.name << " " << name_of(end) << "\n"
        << all_of(findings);
  }
}

}  // namespace
}  // namespace mien::motion
