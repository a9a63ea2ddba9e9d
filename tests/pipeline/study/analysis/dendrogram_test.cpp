#include "pipeline/study/analysis/dendrogram.h"

#include <random>

#include <gtest/gtest.h>

#include "pipeline/base/drawing/plot.h"

namespace mien::pipeline {
namespace {

Dendrogram sample(int leaves, int clusters) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Eigen::MatrixXd rows(leaves, 6);
  for (Eigen::Index i = 0; i < rows.size(); ++i) rows(i / 6, i % 6) = share(random);
  Dendrogram d;
  d.title = "Clusters of adjective pairs";
  d.subtitle = "29 of 41 scales kept; 27 examples, 14 raters; Ward's method";
  d.linkage = ward(rows);
  d.partition = cut(d.linkage, clusters);
  for (int i = 0; i < leaves; ++i) {
    d.leaves.push_back({"unpleasant – pleasant " + std::to_string(i), "不快な–快い"});
  }
  for (int i = 0; i < clusters; ++i) d.clusters.push_back({"activeness", "活発さ"});
  return d;
}

TEST(Dendrogram, IsTheSameBytesInEveryFormat) {
  const Plot plot = dendrogram_plot(sample(12, 4));
  EXPECT_EQ(as_pdf(plot), as_pdf(plot));
  EXPECT_EQ(as_svg(plot), as_svg(plot));
  EXPECT_EQ(as_png(plot, 72.0), as_png(plot, 72.0));
  EXPECT_TRUE(as_svg(plot).starts_with("<?xml"));
  EXPECT_NE(as_svg(plot).find("</svg>"), std::string::npos);
}

TEST(Dendrogram, TextsNeitherOverlapNorLeaveThePage) {
  for (const auto& [leaves, clusters] : {std::pair(1, 1), {2, 2}, {12, 4}, {41, 4}, {30, 30}}) {
    Dendrogram d = sample(leaves, clusters);
    d.simulated = true;
    const Plot plot = dendrogram_plot(d);
    const auto canvas = Canvas::pdf(plot.width, plot.height, "t");
    plot.draw(*canvas);
    const auto& texts = canvas->texts();
    for (size_t i = 0; i < texts.size(); ++i) {
      const Box& box = texts[i].box;
      EXPECT_GE(box.x, 0.0) << texts[i].text;
      EXPECT_GE(box.y, 0.0) << texts[i].text;
      EXPECT_LE(box.right(), plot.width) << texts[i].text;
      EXPECT_LE(box.bottom(), plot.height) << texts[i].text;
      for (size_t k = 0; k < i; ++k) {
        EXPECT_FALSE(overlap(box, texts[k].box))
            << leaves << " leaves: " << texts[i].text << " over " << texts[k].text;
      }
    }
  }
}

TEST(Dendrogram, SaysWhenRatingsAreSimulated) {
  for (const bool simulated : {false, true}) {
    Dendrogram d = sample(5, 2);
    d.simulated = simulated;
    const Plot plot = dendrogram_plot(d);
    const auto canvas = Canvas::pdf(plot.width, plot.height, "t");
    plot.draw(*canvas);
    bool marked = false;
    for (const DrawnText& text : canvas->texts()) {
      marked = marked || text.text.starts_with("Simulated ratings");
    }
    EXPECT_EQ(marked, simulated);
  }
}

TEST(Axis, TicksAreRoundAndFew) {
  EXPECT_EQ(axis_ticks(1.0, 5).size(), 6u);
  EXPECT_EQ(axis_ticks(7.3, 6), (std::vector<double>{0, 2, 4, 6}));
  EXPECT_EQ(axis_ticks(0.0, 6), std::vector<double>{0.0});
  for (double most = 0.003; most < 5000.0; most *= 1.37) {
    const std::vector<double> ticks = axis_ticks(most, 6);
    EXPECT_GE(ticks.size(), 3u) << most;
    EXPECT_LE(ticks.size(), 7u) << most;
    EXPECT_LE(ticks.back(), most * (1.0 + 1e-9));
  }
}

}  // namespace
}  // namespace mien::pipeline
