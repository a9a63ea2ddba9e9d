#include "motion/modify/hit_timing.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

std::vector<HandHit> hits_at(std::initializer_list<int> frames) {
  std::vector<HandHit> hits;
  for (const int frame : frames) hits.push_back({true, frame, 1.0, 10.0, 0, 0});
  return hits;
}

TEST(HitTiming, KeepsHitsAndWhatIsFarFromThem) {
  for (const bool loops : {false, true}) {
    const std::vector<HandHit> hits = hits_at({40, 60, 140});
    const std::vector<double> sources = hard_hit_sources(hits, 200, 100.0, loops);
    ASSERT_EQ(sources.size(), 200u);
    for (const HandHit& hit : hits)
      EXPECT_EQ(sources[static_cast<std::size_t>(hit.frame)], hit.frame);
    EXPECT_TRUE(std::ranges::is_sorted(sources));
    for (int f = 0; f < 200; ++f) {
      const bool is_near = (f > 20 && f < 80) || (f > 120 && f < 160);
      if (is_near) continue;
      EXPECT_EQ(sources[static_cast<std::size_t>(f)], f);
    }
  }
}

TEST(HitTiming, ArrivesTwiceAsFastAndLeavesSlowly) {
  const std::vector<double> sources = hard_hit_sources(hits_at({1000}), 2000, 1000.0, false);
  EXPECT_NEAR(sources[1000] - sources[999], 2.0, 0.03);
  EXPECT_NEAR(sources[1001] - sources[1000], 0.2, 0.03);
  // Smooth where the neighbourhood ends.
  EXPECT_NEAR(sources[802] - sources[801], 1.0, 0.03);
  EXPECT_NEAR(sources[1199] - sources[1198], 1.0, 0.03);
}

TEST(HitTiming, ChangesAllOfAStrokeFromATurnOn) {
  std::vector<HandHit> hits = hits_at({1000});
  hits[0].since_turn = 100;
  hits[0].until_turn = 150;
  const std::vector<double> sources = hard_hit_sources(hits, 2000, 1000.0, false);
  EXPECT_TRUE(std::ranges::is_sorted(sources));
  EXPECT_EQ(sources[900], 900.0);
  EXPECT_EQ(sources[1150], 1150.0);
  // From a stand to twice the speed, which is that of before in the middle.
  EXPECT_NEAR(sources[901] - sources[900], 0.0, 0.03);
  EXPECT_NEAR(sources[951] - sources[950], 1.0, 0.03);
  EXPECT_NEAR(sources[1000] - sources[999], 2.0, 0.03);
}

TEST(HitTiming, ReachesAcrossTheSeamOfALoop) {
  const std::vector<double> here = hard_hit_sources(hits_at({50}), 100, 100.0, true);
  const std::vector<double> at_seam = hard_hit_sources(hits_at({0}), 100, 100.0, true);
  for (std::size_t f = 0; f < 100; ++f) {
    const double ahead = here[(f + 50) % 100] - static_cast<double>((f + 50) % 100);
    EXPECT_NEAR(at_seam[f] - static_cast<double>(f), ahead, 1e-12) << f;
  }
}

}  // namespace
}  // namespace mien::motion
