#include "motion/live/live_core.h"

#include <limits>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/gait/contact.h"
#include "motion/gait/foot_lock.h"
#include "motion/live/small_bundle.h"

namespace mien::motion {
namespace {

void expect_same(const Clip& a, const Clip& b) {
  ASSERT_EQ(a.frame_count(), b.frame_count());
  for (std::size_t f = 0; f < a.poses.size(); ++f) {
    EXPECT_EQ(a.poses[f].root_position, b.poses[f].root_position);
    for (std::size_t j = 0; j < a.poses[f].rotations.size(); ++j) {
      EXPECT_EQ(a.poses[f].rotations[j].coeffs(), b.poses[f].rotations[j].coeffs());
    }
  }
}

TEST(LiveCore, MakesTheSameWhateverWasAskedBefore) {
  const LiveBundle bundle = test::small_bundle();
  LiveCore fresh(bundle), used(bundle);
  const LiveSetting setting{InterfaceKind::adjectives, {"sadness", "quickness"}, {0.3, 0.7}};
  used.make({InterfaceKind::adjectives, {"quickness", "sadness"}, {0.1, 0.2}});
  used.make({InterfaceKind::weights, {"slow"}, {1.0}});
  used.distance("t1", setting);
  expect_same(used.make(setting).motion.clip, fresh.make(setting).motion.clip);
  EXPECT_EQ(used.distance("t1", setting).mean, fresh.distance("t1", setting).mean);
}

TEST(LiveCore, LocksFeetWhereItIsTo) {
  for (const bool foot_lock : {true, false}) {
    const LiveBundle bundle = test::small_bundle(foot_lock);
    LiveCore core(bundle);
    const LiveMotion made = core.make({InterfaceKind::weights, {"normal", "slow"}, {0.5, 0.5}});
    const double drift = planted_drift(made.motion.clip, made.plants);
    if (foot_lock) {
      EXPECT_LT(drift, 1e-4);
    } else {
      EXPECT_GT(drift, 1e-4);
    }
    EXPECT_EQ(made.weights.size(), 4);
    EXPECT_FALSE(made.plants.empty());
  }
}

TEST(LiveCore, FindsATargetItselfAtNoDistance) {
  const LiveBundle bundle = test::small_bundle();
  LiveCore core(bundle);
  const LiveSetting setting{InterfaceKind::weights, {bundle.examples.examples[1].name}, {1.0}};
  EXPECT_LT(core.distance("t1", setting).mean, 1e-5);
  const LiveSetting other{InterfaceKind::weights, {bundle.examples.examples[2].name}, {1.0}};
  EXPECT_GT(core.distance("t1", other).mean, 0.01);
}

TEST(LiveCore, TakesWeightsThatAreNotNamedForNone) {
  const LiveBundle bundle = test::small_bundle();
  LiveCore core(bundle);
  const std::string name = bundle.examples.examples[2].name;
  expect_same(core.make({InterfaceKind::weights, {name}, {0.4}}).motion.clip,
              core.example(name).motion.clip);
  const LiveMotion mean = core.make({InterfaceKind::weights, {}, {}});
  EXPECT_NEAR(mean.weights.minCoeff(), 0.25, 1e-12);
}

TEST(LiveCore, RefusesWhatItCannotMake) {
  const LiveBundle bundle = test::small_bundle();
  LiveCore core(bundle);
  const auto refuses = [&](const LiveSetting& setting) {
    EXPECT_THROW(core.make(setting), Error);
    EXPECT_THROW(core.distance("t1", setting), Error);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refuses({InterfaceKind::adjectives, {}, {}});
  refuses({InterfaceKind::adjectives, {"brightness"}, {0.5}});
  refuses({InterfaceKind::adjectives, {"quickness"}, {}});
  refuses({InterfaceKind::adjectives, {"quickness"}, {1.5}});
  refuses({InterfaceKind::adjectives, {"quickness"}, {nan}});
  refuses({InterfaceKind::adjectives, {"quickness", "quickness"}, {0.5, 0.5}});
  refuses({InterfaceKind::features, {"quickness"}, {0.5}});
  refuses({InterfaceKind::weights, {"quickness"}, {0.5}});
  refuses({InterfaceKind::weights, {"normal"}, {-0.5}});
  EXPECT_THROW(core.example("nobody"), Error);
  EXPECT_THROW(core.target("t2"), Error);
  EXPECT_THROW(core.distance("t2", {InterfaceKind::weights, {}, {}}), Error);
}

}  // namespace
}  // namespace mien::motion
