#include "pipeline/base/drawing/palette.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

double difference(const Colour& a, const Colour& b) {
  const auto p = to_oklab(a);
  const auto q = to_oklab(b);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

TEST(Palette, OklabHasThePublishedValues) {
  const auto white = to_oklab(from_hex(0xffffff));
  EXPECT_NEAR(white[0], 1.0, 1e-6);
  EXPECT_NEAR(white[1], 0.0, 1e-6);
  EXPECT_NEAR(white[2], 0.0, 1e-6);
  const auto red = to_oklab(from_hex(0xff0000));
  EXPECT_NEAR(red[0], 0.6280, 1e-4);
  EXPECT_NEAR(red[1], 0.2249, 1e-4);
  EXPECT_NEAR(red[2], 0.1258, 1e-4);
}

TEST(Palette, AmountGrowsInStepsThatLookEqual) {
  std::vector<double> steps;
  for (int i = 0; i < 50; ++i) {
    steps.push_back(difference(amount_colour(i / 50.0), amount_colour((i + 1) / 50.0)));
  }
  double mean = 0.0;
  for (const double step : steps) mean += step / static_cast<double>(steps.size());
  for (const double step : steps) EXPECT_NEAR(step, mean, 0.15 * mean);
}

TEST(Palette, AmountDarkensLinearlyWithinWhatAScreenCanShow) {
  for (int i = 0; i <= 100; ++i) {
    // A colour outside sRGB would have been clipped and would miss its lightness.
    EXPECT_NEAR(to_oklab(amount_colour(i / 100.0))[0], 0.97 - 0.70 * i / 100.0, 1e-3) << i;
  }
}

TEST(Palette, AmountIsClamped) {
  EXPECT_EQ(amount_colour(-1.0), amount_colour(0.0));
  EXPECT_EQ(amount_colour(7.0), amount_colour(1.0));
}

double contrast(const Colour& a, const Colour& b) {
  const auto luminance = [](const Colour& c) {
    const auto linear = [](double x) {
      return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
  };
  const double p = luminance(a) + 0.05;
  const double q = luminance(b) + 0.05;
  return p > q ? p / q : q / p;
}

TEST(Palette, TextIsReadableByWcag) {
  for (const Colour& text :
       {ink, quiet_ink, target_colours.line, created_colours.line, reference_colours.line}) {
    EXPECT_GE(contrast(text, paper), 4.5);
    EXPECT_GE(contrast(text, panel), 4.5);
  }
  EXPECT_GE(contrast(caution_ink, caution), 4.5);
}

TEST(Palette, MotionsAndSidesAreTellable) {
  const std::vector<Colour> colours = {target_colours.line,    target_colours.light,
                                       created_colours.line,   created_colours.light,
                                       reference_colours.line, reference_colours.light};
  for (std::size_t i = 0; i < colours.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT(difference(colours[i], colours[j]), 0.1);
  }
}

}  // namespace
}  // namespace mien::pipeline
