#include "motion/dynamics/tempo_curve.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

Tempo curve(std::vector<TempoPoint> points) {
  Tempo tempo;
  tempo.curve = std::move(points);
  return tempo;
}

TEST(TempoCurve, GoesThroughItsPointsAndStaysBetweenThem) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> factor(0.25, 4.0);
  for (int i = 0; i < 200; ++i) {
    const std::vector<TempoPoint> points = {{0.1, factor(random)},
                                            {0.35, factor(random)},
                                            {0.5, factor(random)},
                                            {0.9, factor(random)}};
    for (const bool loops : {true, false}) {
      const Tempo tempo = curve(points);
      for (const TempoPoint& point : points)
        EXPECT_NEAR(factor_at(tempo, point.share, loops), point.factor, 1e-12);
      for (size_t k = 0; k + 1 < points.size(); ++k) {
        const double least = std::min(points[k].factor, points[k + 1].factor);
        const double most = std::max(points[k].factor, points[k + 1].factor);
        for (double t = 0.0; t < 1.0; t += 0.05) {
          const double share = points[k].share + t * (points[k + 1].share - points[k].share);
          const double here = factor_at(tempo, share, loops);
          EXPECT_GE(here, least - 1e-12);
          EXPECT_LE(here, most + 1e-12);
        }
      }
    }
  }
}

TEST(TempoCurve, IsConstantBeyondItsEndsUnlessItLoops) {
  const Tempo tempo = curve({{0.2, 2.0}, {0.6, 0.5}});
  EXPECT_EQ(factor_at(tempo, 0.0, false), 2.0);
  EXPECT_EQ(factor_at(tempo, 1.0, false), 0.5);
  // In a loop, 0.9 lies halfway from 0.6 to 1.2: the geometric mean.
  EXPECT_NEAR(factor_at(tempo, 0.9, true), 1.0, 1e-12);
}

TEST(TempoCurve, ClosesInALoop) {
  for (const auto& points : {std::vector<TempoPoint>{{0.0, 1.0}, {0.5, 1.4}},
                             {{0.0, 0.5}, {0.3, 3.0}, {1.0, 2.0}},
                             {{0.4, 1.3}},
                             {{0.1, 0.4}, {0.2, 0.6}, {0.95, 3.0}}}) {
    const Tempo tempo = curve(points);
    constexpr double h = 1e-5;
    EXPECT_NEAR(factor_at(tempo, 0.0, true), factor_at(tempo, 1.0, true), 1e-12);
    EXPECT_NEAR(factor_at(tempo, 1.0 - h, true), factor_at(tempo, h, true), 1e-3);
    const double before = factor_at(tempo, 1.0 - h, true) - factor_at(tempo, 1.0 - 2.0 * h, true);
    const double after = factor_at(tempo, 2.0 * h, true) - factor_at(tempo, h, true);
    EXPECT_NEAR(before / h, after / h, 0.02);
  }
  EXPECT_NEAR(factor_at(curve({{0.0, 0.5}, {0.3, 3.0}, {1.0, 2.0}}), 0.0, true), 1.0, 1e-12);
}

TEST(TempoCurve, ChangesItsSpeedSmoothly) {
  const Tempo tempo = curve({{0.0, 1.0}, {0.3, 1.5}, {0.6, 3.0}, {1.0, 1.2}});
  double largest = 0.0;
  constexpr double h = 1e-4;
  for (double share = h; share < 1.0 - 2.0 * h; share += h) {
    const double bend = factor_at(tempo, share + h, false) - 2.0 * factor_at(tempo, share, false) +
                        factor_at(tempo, share - h, false);
    largest = std::max(largest, std::abs(bend));
  }
  EXPECT_LT(largest, 1e-5);  // a corner of a polyline would bend by 5e-4
}

TEST(TempoCurve, IsScaledByItsLogarithm) {
  const Tempo half = scaled(curve({{0.0, 4.0}, {0.5, 0.25}}), 0.5);
  EXPECT_NEAR(half.curve[0].factor, 2.0, 1e-12);
  EXPECT_NEAR(half.curve[1].factor, 0.5, 1e-12);
  EXPECT_EQ(scaled(curve({{0.0, 3.0}}), 2.0).curve[0].factor, 4.0);
  EXPECT_TRUE(is_unit(scaled(curve({{0.0, 3.0}, {1.0, 0.5}}), 0.0)));
  EXPECT_FALSE(is_unit(curve({{0.0, 1.0}, {0.5, 1.1}})));
}

TEST(TempoCurve, NamesItsFault) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  struct Case {
    Tempo tempo;
    const char* wrong;
    int point;
  };
  for (const Case& each :
       {Case{curve({{0.0, 1.0}, {0.5, 1.4}}), "", -1}, Case{0.2, "tempo is 0.2", -1},
        Case{nan, "tempo is nan", -1},
        Case{curve({{0.5, 1.0}, {0.5, 1.4}}), "the moment 0.5 does not follow 0.5", 1},
        Case{curve({{0.5, 1.0}, {0.2, 1.4}}), "the moment 0.2 does not follow 0.5", 1},
        Case{curve({{0.0, 1.0}, {1.5, 1.4}}), "the moment 1.5 is not in the motion", 1},
        Case{curve({{-0.1, 1.0}}), "the moment -0.1 is not in the motion", 0},
        Case{curve({{nan, 1.0}}), "the moment nan is not in the motion", 0},
        Case{curve({{0.0, 1.0}, {0.2, 5.0}}), "the speed factor is 5", 1},
        Case{curve({{0.0, 1.0}, {0.2, nan}}), "the speed factor is nan", 1}}) {
    EXPECT_EQ(fault_of(each.tempo).wrong, each.wrong);
    EXPECT_EQ(fault_of(each.tempo).point, each.point);
    EXPECT_EQ(fault_of(each.tempo).remedy.empty(), fault_of(each.tempo).wrong.empty());
  }
}

TEST(TempoCurve, IsWrittenAsItsFactors) {
  EXPECT_EQ(text_of(Tempo(1.2)), "1.2");
  EXPECT_EQ(text_of(curve({{0.0, 1.0}, {0.5, 1.4}})), "1 → 1.4");
}

}  // namespace
}  // namespace mien::motion
