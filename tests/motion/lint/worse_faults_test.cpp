#include <functional>

#include <gtest/gtest.h>

#include "motion/gait/contact.h"
#include "motion/skeleton/straighten.h"

#include "injected_faults.h"

// What is worse is never judged better: every rule, over a fault that grows.

namespace mien::motion {
namespace {

using namespace mien::test;

/// 0 when the rule finds nothing, 1 when it warns, 2 when it calls it an error.
int judged(const std::vector<Finding>& findings, const std::string& check) {
  if (find_error(findings, check)) return 2;
  return find(findings, check) ? 1 : 0;
}

using Verdict = std::function<std::vector<Finding>(double size)>;

/// Goes through ever larger sizes, of which the largest must be an error.
void expect_never_better(const std::string& check, const Verdict& lint_of,
                         const std::vector<double>& sizes, const std::string& where) {
  int before = 0;
  for (const double size : sizes) {
    const std::vector<Finding> findings = lint_of(size);
    const int now = judged(findings, check);
    EXPECT_GE(now, before) << where << ": " << check << " at " << size << "\n" << all_of(findings);
    before = std::max(before, now);
  }
  EXPECT_EQ(before, 2) << where << ": " << check;
}

class WorseFault : public testing::Test {
 protected:
  /// Three walks that differ much, three cycles each.
  std::vector<Clip> walks() const {
    const std::vector<Clip> all = builtin_walks();
    return {three_cycles(all[0]), three_cycles(all[3]), three_cycles(all[all.size() - 2])};
  }

  void grows(const std::string& check, const std::vector<double>& sizes,
             const std::function<void(Clip& clip, double size)>& inject,
             bool against_original = false) const {
    for (const Clip& walk : walks()) {
      const auto verdict = [&](double size) {
        Clip clip = walk;
        inject(clip, size);
        return lint(clip, {}, against_original ? &walk : nullptr);
      };
      expect_never_better(check, verdict, sizes, walk.name);
    }
  }
};

void drift(Clip& clip, const Vec3& velocity) {
  for (int t = 0; t < clip.frame_count(); ++t) {
    clip.poses[t].root_position += t / clip.frames_per_second * velocity;
  }
}

FootPlant middle_plant(const Clip& clip) {
  std::vector<FootPlant> plants = foot_plants(clip);
  std::erase_if(plants, [&](const FootPlant& plant) {
    return plant.first == 0 || plant.last - plant.first < frames_of(clip, 0.4);
  });
  return plants[plants.size() / 2];
}

TEST_F(WorseFault, DriftSidewaysOfTheWholeBody) {
  const std::vector<double> speeds = {0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3,
                                      0.35, 0.4,  0.5, 0.6,  0.8, 1.0,  1.5};
  for (const Vec3& way : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0.7, 0, 0.7), Vec3(0, 0, 1)}) {
    grows("foot-skate", speeds, [&](Clip& clip, double speed) { drift(clip, speed * way); });
  }
}

TEST_F(WorseFault, SlideOfOnePlant) {
  grows("foot-skate", {0.005, 0.02, 0.03, 0.05, 0.06, 0.08, 0.1, 0.12, 0.16, 0.2, 0.3, 0.5},
        [](Clip& clip, double metres) { slide(clip, middle_plant(clip), Vec3(metres, 0, 0)); });
}

TEST_F(WorseFault, DriftAgainstTheOriginal) {
  grows(
      "foot-skate", {0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.6, 1.0},
      [](Clip& clip, double speed) { drift(clip, Vec3(speed, 0, 0)); }, true);
}

TEST_F(WorseFault, DriftOfAStandingBody) {
  Clip still;
  still.body = standard_body();
  still.frames_per_second = 30.0;
  Pose pose;
  pose.rotations.assign(body_joint_count, Quat::Identity());
  pose.root_position.y() = 0.96;
  still.poses.assign(60, pose);
  const auto verdict = [&](double speed) {
    Clip clip = still;
    drift(clip, Vec3(speed, 0, 0));
    return lint(clip);
  };
  expect_never_better("drift", verdict, {0.005, 0.02, 0.1, 0.2, 0.3, 0.5, 1.0}, "standing");
}

TEST_F(WorseFault, HeightAboveTheFloor) {
  const std::vector<double> heights = {0.01, 0.03, 0.035, 0.045, 0.06, 0.1, 0.3, 1.0, 5.0};
  grows("floating", heights, [](Clip& clip, double metres) {
    for (Pose& pose : clip.poses) pose.root_position.y() += metres;
  });
  grows("floating", heights, [](Clip& clip, double metres) {
    const int length = frames_of(clip, 1.2);
    raise(clip, 10, 10 + length, metres);
  });
}

TEST_F(WorseFault, DepthBelowTheFloor) {
  grows("penetration", {0.005, 0.015, 0.02, 0.035, 0.05, 0.1, 0.5, 2.0},
        [](Clip& clip, double metres) {
          for (Pose& pose : clip.poses) pose.root_position.y() -= metres;
        });
}

TEST_F(WorseFault, LeapOfAJoint) {
  for (const BodyJoint joint : {Head, LeftElbow, RightHip, LeftAnkle}) {
    grows("jump", {5, 15, 22, 26, 32, 40, 60, 90, 120},
          [&](Clip& clip, double degrees) { leap(clip, joint, 25, degrees, Vec3(1, 0, 0)); });
  }
}

TEST_F(WorseFault, LeapOfTheWholeBody) {
  grows("jump", {0.02, 0.06, 0.08, 0.12, 0.2, 0.5, 2.0}, [](Clip& clip, double metres) {
    for (int t = 25; t < clip.frame_count(); ++t) clip.poses[t].root_position.x() += metres;
  });
}

TEST_F(WorseFault, NoiseOnAllJoints) {
  grows("jump", {0, 2, 5, 10, 20, 30, 45, 60}, [](Clip& clip, double degrees) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> turn;
    for (Pose& pose : clip.poses) {
      for (Quat& rotation : pose.rotations) {
        const Vec3 noise(turn(random), turn(random), turn(random));
        rotation *= exp(degrees * radians_per_degree * noise);
      }
    }
  });
}

TEST_F(WorseFault, KneeBentBackwards) {
  grows("joint-limit", {2, 8, 12, 18, 25, 40, 70, 100, 130},
        [](Clip& clip, double degrees) { bend_knee_backwards(clip, true, 20, 36, degrees); });
}

TEST_F(WorseFault, SpeedOfAJoint) {
  grows("joint-speed", {5, 14, 18, 24, 28, 40, 60}, [](Clip& clip, double radians_per_second) {
    clip = resampled(clip, 120.0);
    double angle = 0.0;
    for (int t = 60; t < 100; ++t) {
      angle += radians_per_second / clip.frames_per_second;
      clip.poses[t].rotations[LeftKnee] = exp(Vec3(angle, 0, 0));
    }
  });
}

TEST_F(WorseFault, HandInTheBelly) {
  grows("self-intersection", {0.0, 0.25, 0.5, 0.75, 1.0}, [](Clip& clip, double share) {
    Clip through = clip;
    put_hand_through_torso(through, true, 10, 40);
    for (int t = 10; t <= 40; ++t) {
      for (const BodyJoint joint : limb(LeftWrist)) {
        Quat& rotation = clip.poses[t].rotations[joint];
        rotation = slerp(rotation, through.poses[t].rotations[joint], share);
      }
    }
  });
}

TEST_F(WorseFault, LeanOfAStandingBody) {
  const auto verdict = [](double degrees) {
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
      clip.poses.push_back(pose);
    }
    return lint(clip);
  };
  expect_never_better("balance", verdict, {0, 5, 10, 14, 18, 22, 30, 40}, "standing");
}

TEST_F(WorseFault, LeanOfAWalk) {
  grows("balance", {0.0, 0.1, 0.2, 0.3, 0.4, 0.5}, [](Clip& clip, double radians) {
    const Quat lean = exp(Vec3(0, 0, -radians));
    for (Pose& pose : clip.poses) {
      pose.root_position = lean * pose.root_position;
      pose.rotations[Pelvis] = lean * pose.rotations[Pelvis];
      pose.rotations[Spine] = exp(Vec3(0, 0, -2.0 * radians));
      for (const BodyJoint ankle : {LeftAnkle, RightAnkle}) {
        pose.rotations[ankle] = pose.rotations[ankle] * lean.conjugate();
      }
    }
  });
}

/// A body that leaps up and down as if gravity were `times` as strong.
std::vector<Finding> leaping(double times) {
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = 120.0;
  for (int t = 0; t < 300; ++t) {
    Pose pose;
    pose.rotations.assign(body_joint_count, Quat::Identity());
    const double flown = std::clamp(t / 120.0 - 1.0, 0.0, 0.4);
    pose.root_position = Vec3(0, 0.96 + 0.5 * 9.81 * times * flown * (0.4 - flown), 0);
    clip.poses.push_back(pose);
  }
  return lint(clip);
}

TEST_F(WorseFault, FallThatIsTooFast) {
  // Below its own gravity the body hangs; at it, it leaps; beyond it, it is pulled.
  EXPECT_FALSE(find(leaping(1.0), "floating")) << all_of(leaping(1.0));
  std::vector<std::string> pulled;
  int before = 0;
  for (const double times : {1.0, 1.2, 1.5, 1.8, 2.2, 3.0, 5.0, 8.0}) {
    int now = 0;
    for (const Finding& finding : leaping(times)) {
      if (finding.sentence.find("pulled") == std::string::npos) continue;
      now = std::max(now, finding.severity == Severity::error ? 2 : 1);
    }
    EXPECT_GE(now, before) << times << "\n" << all_of(leaping(times));
    before = now;
  }
  EXPECT_EQ(before, 2);
}

TEST_F(WorseFault, PushSidewaysOfTheFeet) {
  grows("forces", {0.0, 0.1, 0.2, 0.4, 0.8, 1.6, 3.0}, [](Clip& clip, double metres) {
    for (int t = 0; t < clip.frame_count(); ++t) {
      const double seconds = t / clip.frames_per_second;
      clip.poses[t].root_position.x() += metres * std::sin(2.0 * pi * 1.5 * seconds);
    }
  });
}

TEST_F(WorseFault, FlungArm) {
  grows("joint-torque", {0.0, 0.3, 0.6, 1.0, 1.5, 2.0, 2.5, 3.0}, [](Clip& clip, double radians) {
    clip = resampled(clip, 120.0);
    for (int t = 40; t < 160; ++t) {
      const double swing = radians * std::sin(2 * pi * 4.0 * (t - 40) / 120.0) * bump(t, 40, 159);
      clip.poses[t].rotations[RightShoulder] *= exp(Vec3(0, swing, 0));
    }
  });
}

TEST_F(WorseFault, JerkOfAHand) {
  grows(
      "jerk", {0.0, 0.1, 0.3, 0.6, 1.0},
      [](Clip& clip, double radians) {
        for (int t = 0; t < clip.frame_count(); ++t) {
          const double shake = radians * std::sin(2 * pi * 5.0 * t / clip.frames_per_second);
          clip.poses[t].rotations[LeftElbow] *= exp(Vec3(0, shake, 0));
        }
      },
      true);
}

TEST_F(WorseFault, SeamOfALoop) {
  for (const Clip& loop : {builtin_walks()[0], builtin_walks()[5]}) {
    const auto verdict = [&](double degrees) {
      Clip clip = loop;
      break_seam(clip, Head, degrees);
      return lint(clip);
    };
    expect_never_better("loop-seam", verdict, {0, 2, 5, 8, 12, 20, 40, 80}, loop.name);
  }
}

TEST_F(WorseFault, LateLimbs) {
  for (const Clip& loop : {builtin_walks()[0], builtin_walks()[5]}) {
    for (const std::string check : {"contact-timing", "limb-phase"}) {
      const auto verdict = [&](double seconds) {
        Clip clip = loop;
        retime(clip, LeftAnkle, [&](double time) { return time - seconds; });
        return lint(clip, {}, &loop);
      };
      expect_never_better(check, verdict, {0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4}, loop.name);
    }
  }
}

TEST_F(WorseFault, DataThatIsBroken) {
  grows("rotation-not-unit", {1e-9, 1e-5, 1e-2, 0.5},
        [](Clip& clip, double share) { clip.poses[7].rotations[Chest].coeffs() *= 1.0 + share; });
  grows("bone-length", {1e-6, 5e-3, 0.02, 0.5}, [](Clip& clip, double share) {
    for (int t = 10; t < 16; ++t) {
      for (const Joint& each : clip.body.joints) clip.poses[t].offsets.push_back(each.offset);
      clip.poses[t].offsets[LeftKnee] *= 1.0 + share;
    }
  });
}

}  // namespace
}  // namespace mien::motion
