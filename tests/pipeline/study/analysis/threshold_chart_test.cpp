#include <algorithm>

#include <gtest/gtest.h>

#include "pipeline/study/analysis/quantification.h"

namespace mien::pipeline {
namespace {

std::vector<DrawnText> texts_of(int scales, bool simulated) {
  std::vector<ThresholdPoint> curve;
  for (const auto condition :
       {ThresholdPoint::Condition::largest_mean, ThresholdPoint::Condition::mean_deviation}) {
    for (int i = 0; i <= 40; ++i) curve.push_back({condition, 0.05 * i, scales, scales / 2});
  }
  const Plot plot = threshold_chart(curve, {}, scales, simulated);
  const auto canvas = Canvas::pdf(plot.width, plot.height, plot.title);
  plot.draw(*canvas);
  for (const DrawnText& text : canvas->texts()) {
    EXPECT_GE(text.box.x, 0.0) << text.text;
    EXPECT_LE(text.box.x + text.box.width, plot.width) << text.text;
    EXPECT_LE(text.box.y + text.box.height, plot.height) << text.text;
  }
  return canvas->texts();
}

bool says(const std::vector<DrawnText>& texts, const std::string& words) {
  return std::any_of(texts.begin(), texts.end(), [&](const DrawnText& text) {
    return text.text.find(words) != std::string::npos;
  });
}

TEST(ThresholdChart, NamesBothConditionsAndCountsUpToAllScales) {
  const auto texts = texts_of(5, false);
  EXPECT_TRUE(says(texts, "largest |mean| at least"));
  EXPECT_TRUE(says(texts, "mean SD at most"));
  EXPECT_TRUE(says(texts, "5"));
}

TEST(ThresholdChart, SaysSimulatedOnlyOfSimulatedRatings) {
  EXPECT_TRUE(says(texts_of(41, true), "Simulated ratings"));
  EXPECT_FALSE(says(texts_of(41, false), "Simulated"));
}

}  // namespace
}  // namespace mien::pipeline
