#include "motion/gestures/hand_hits.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/arm_motions.h"
#include "motion/modify/real_takes.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/procedural/knock.h"
#include "motion/skeleton/mirror.h"

namespace mien::motion {
namespace {

using namespace mien::test;

constexpr double rates[] = {30.0, 60.0, 120.0};

TEST(HandHits, OfKnocksAreWhenTheHandIsAtTheDoor) {
  for (const double rate : rates) {
    for (const KnockStyle& style : {KnockStyle{}, angry_knock()}) {
      SCOPED_TRACE(rate);
      const Example example = knock(style, rate, standard_body());
      const std::vector<HandHit> hits = hand_hits(example.clip);
      ASSERT_EQ(hits.size(), static_cast<size_t>(style.knocks));
      for (std::size_t k = 0; k < hits.size(); ++k) {
        EXPECT_FALSE(hits[k].left);
        const double at = example.keytimes[1] + static_cast<double>(k) * style.knock_seconds;
        EXPECT_NEAR(hits[k].frame / rate, at, 1.01 / rate);
        if (k > 0) {
          EXPECT_NEAR(hits[k].since_turn / rate, 0.5 * style.knock_seconds, 0.01 + 1.01 / rate);
        }
        EXPECT_EQ(hits[k].until_turn > 0, k + 1 < hits.size());
      }
    }
  }
}

TEST(HandHits, OfClapsAreBothHandsTogether) {
  for (const double rate : rates) {
    SCOPED_TRACE(rate);
    const std::vector<HandHit> hits = hand_hits(clapping(rate));
    // At 0.5, 1 … 3.5 s.
    ASSERT_EQ(hits.size(), 14u);
    for (std::size_t i = 0; i < hits.size(); ++i) {
      EXPECT_EQ(hits[i].left, i % 2 == 0);
      EXPECT_NEAR(hits[i].frame / rate, 0.5 * (1.0 + std::floor(0.5 * static_cast<double>(i))),
                  1.01 / rate);
    }
  }
}

TEST(HandHits, OfATableComeFromAbove) {
  for (const double rate : rates) {
    SCOPED_TRACE(rate);
    const std::vector<HandHit> hits = hand_hits(drumming(rate));
    ASSERT_EQ(hits.size(), 7u);
    for (const HandHit& hit : hits) EXPECT_TRUE(hit.left);
    for (const HandHit& hit : hand_hits(mirrored(drumming(rate)))) EXPECT_FALSE(hit.left);
    EXPECT_EQ(hand_hits(mirrored(drumming(rate))).size(), 7u);
  }
}

TEST(HandHits, AreNoneInWavesAndWalks) {
  for (const double rate : rates) EXPECT_TRUE(hand_hits(waving(rate)).empty()) << rate;
  for (const std::string name : {"walks-10", "walks-27"}) {
    for (const Example& example : builtin_examples(name).examples)
      EXPECT_TRUE(hand_hits(example.clip).empty()) << example.name;
  }
}

TEST(HandHits, AreRareInRecordedWavesAndWalks) {
  int takes = 0, hits = 0;
  for (const std::vector<Clip>& clips : {real_waves(), real_walks()}) {
    for (const Clip& clip : clips) {
      ++takes;
      const std::vector<HandHit> found = hand_hits(clip);
      hits += found.empty() ? 0 : 1;
    }
  }
  if (takes == 0) GTEST_SKIP() << "no recorded motions";
  EXPECT_GE(takes, 20);
  EXPECT_LE(hits, takes / 10);
}

TEST(HandHits, OnceOnlyAreHardHits) {
  // A hand that turns back once, gently or as hard as a punch.
  const auto once = [](double speed) {
    return arm_motion(
        60.0,
        [&](double t) {
          const double away = std::min(1.0, speed * std::abs(t - 2.0));
          return forward_arm(true, 40.0 - 30.0 * std::sin(0.5 * pi * away), 5.0);
        },
        [](double) { return about(Vec3::UnitZ(), 80.0); });
  };
  EXPECT_TRUE(hand_hits(once(1.5)).empty());
  const std::vector<HandHit> hits = hand_hits(once(8.0));
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_NEAR(hits[0].frame, 120, 1);
}

}  // namespace
}  // namespace mien::motion
