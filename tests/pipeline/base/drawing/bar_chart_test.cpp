#include "pipeline/base/drawing/bar_chart.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/plot_texts.h"

namespace mien::pipeline {
namespace {

BarChart seconds() {
  BarChart chart;
  chart.title = "Time saved";
  chart.axis = "seconds";
  chart.whiskers = "90 % interval";
  chart.bars = {{"weights", 120.0, 90.0, 150.0, "n = 13"},
                {"the other way", -40.0, -90.0, 10.0, "n = 3"}};
  return chart;
}

BarChart shares() {
  BarChart chart;
  chart.title = "Matched";
  chart.axis = "share of trials";
  chart.percent = true;
  chart.simulated = true;
  chart.slot_width = 60.0;
  chart.line = 0.5;
  chart.line_name = "half";
  for (const char* name : {"a", "b", "c", "d"}) {
    chart.bars.push_back({name, 0.75, std::nan(""), std::nan(""), "n = 4"});
  }
  return chart;
}

TEST(BarChart, KeepsItsTextsToThePageAndApart) {
  test::expect_texts_apart(bar_chart_plot(seconds()));
  test::expect_texts_apart(bar_chart_plot(shares()));
}

TEST(BarChart, PrintsValuesWithATrueMinus) {
  EXPECT_TRUE(test::says(bar_chart_plot(seconds()), "−40.0"));
  EXPECT_TRUE(test::says(bar_chart_plot(shares()), "75.0 %"));
}

TEST(BarCharts, StandSideBySideWithTheTextsOfEach) {
  const Plot both = bar_charts_plot("Two of them", {seconds(), shares()}, "Made up");
  test::expect_texts_apart(both);
  for (const BarChart& chart : {seconds(), shares()}) {
    for (const DrawnText& text : test::texts_of(bar_chart_plot(chart))) {
      if (text.text == "Simulated sessions") continue;
      EXPECT_TRUE(test::says(both, text.text)) << text.text;
    }
  }
}

TEST(BarCharts, AreMarkedWhenOneOfThemIsSimulated) {
  EXPECT_TRUE(test::says(bar_charts_plot("t", {seconds(), shares()}, "Made up"), "Made up"));
  EXPECT_FALSE(test::says(bar_charts_plot("t", {seconds()}, "Made up"), "Made up"));
}

}  // namespace
}  // namespace mien::pipeline
