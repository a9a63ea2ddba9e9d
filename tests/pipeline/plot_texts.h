#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/base/drawing/plot.h"

namespace mien::test {

/// All text of a plot.
inline std::vector<pipeline::DrawnText> texts_of(const pipeline::Plot& plot) {
  const auto canvas = pipeline::Canvas::pdf(plot.width, plot.height, plot.title);
  plot.draw(*canvas);
  return canvas->texts();
}

inline bool says(const pipeline::Plot& plot, const std::string& words) {
  for (const pipeline::DrawnText& text : texts_of(plot)) {
    if (text.text == words) return true;
  }
  return false;
}

/// No text leaves the page or runs into another.
inline void expect_texts_apart(const pipeline::Plot& plot) {
  const auto texts = texts_of(plot);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const pipeline::Box& box = texts[i].box;
    EXPECT_TRUE(box.x >= 0.0 && box.y >= 0.0 && box.right() <= plot.width &&
                box.bottom() <= plot.height)
        << texts[i].text;
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_FALSE(overlap(box, texts[k].box)) << texts[i].text << " over " << texts[k].text;
    }
  }
}

}  // namespace mien::test
