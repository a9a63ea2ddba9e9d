#include "pipeline/base/drawing/canvas.h"

#include <gtest/gtest.h>

namespace mien::pipeline {
namespace {

std::unique_ptr<Canvas> drawn(std::unique_ptr<Canvas> canvas) {
  canvas->fill(Box{10, 10, 80, 30}, target_colours.line, 4.0);
  canvas->line({10, 60}, {90, 60}, {.width = 1.0, .dashed = true});
  canvas->disc({50, 80}, 5.0, created_colours.line);
  canvas->text({10, 100}, "quickness 速さ", {.size = 10.0, .bold = true});
  return canvas;
}

int big_endian(const std::string& bytes, std::size_t at) {
  int value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value * 256 + static_cast<unsigned char>(bytes[at + i]);
  return value;
}

TEST(Canvas, PdfIsCompleteAndCarriesNoDate) {
  const std::string bytes = drawn(Canvas::pdf(200, 120, "a title"))->finish();
  EXPECT_TRUE(bytes.starts_with("%PDF-1."));
  EXPECT_NE(bytes.rfind("%%EOF"), std::string::npos);
  EXPECT_NE(bytes.find("/Title (a title)"), std::string::npos);
  EXPECT_EQ(bytes.find("Date"), std::string::npos);
}

TEST(Canvas, PngHasTheSizeAskedFor) {
  const std::string bytes = drawn(Canvas::png(200, 120, 500))->finish();
  EXPECT_TRUE(bytes.starts_with("\x89PNG\r\n\x1a\n"));
  EXPECT_EQ(big_endian(bytes, 16), 500);
  EXPECT_EQ(big_endian(bytes, 20), 300);
}

TEST(Canvas, IsTheSameBytesEachTime) {
  EXPECT_EQ(drawn(Canvas::pdf(200, 120, "t"))->finish(),
            drawn(Canvas::pdf(200, 120, "t"))->finish());
  EXPECT_EQ(drawn(Canvas::png(200, 120, 400))->finish(),
            drawn(Canvas::png(200, 120, 400))->finish());
}

TEST(Canvas, PicturesKeepTheirPixels) {
  render::Image8 picture(5, 3);
  for (std::size_t i = 0; i < picture.channels.size(); ++i) {
    picture.channels[i] = static_cast<std::uint8_t>(5 * i + 7);
  }
  const auto canvas = Canvas::png(20, 10, 40);
  canvas->picture({4, 3, 2.5, 1.5}, picture);
  const render::Image8 page = canvas->finish_picture();
  for (int y = 0; y < page.height; ++y) {
    for (int x = 0; x < page.width; ++x) {
      const bool inside = x >= 8 && x < 13 && y >= 6 && y < 9;
      for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(page.at(x, y)[c], inside ? picture.at(x - 8, y - 6)[c] : 255) << x << " " << y;
      }
    }
  }
}

TEST(Canvas, TextKeepsToItsAlignmentAndBaseline) {
  const auto canvas = Canvas::pdf(200, 120, "t");
  const double advance = canvas->text_width("HHHH", {.size = 10.0});
  const Box left = canvas->text({100, 50}, "HHHH", {.size = 10.0});
  const Box centre = canvas->text({100, 50}, "HHHH", {.size = 10.0, .align = Align::centre});
  const Box right = canvas->text({100, 50}, "HHHH", {.size = 10.0, .align = Align::right});
  EXPECT_NEAR(left.x - centre.x, advance / 2, 0.01);
  EXPECT_NEAR(left.x - right.x, advance, 0.01);
  EXPECT_GE(left.x, 100.0);
  EXPECT_LE(right.right(), 100.0);
  EXPECT_NEAR(left.bottom(), 50.0, 0.2);  // an H stands on its baseline
  EXPECT_EQ(canvas->texts().size(), 3u);
}

TEST(Canvas, LongTextIsShortenedToItsWidth) {
  const auto canvas = Canvas::pdf(200, 120, "t");
  const std::string words = "a name that is much too long for its place";
  const Box box = canvas->text({10, 50}, words, {.size = 10.0, .max_width = 60.0});
  EXPECT_LE(box.right(), 70.0);
  EXPECT_GT(box.width, 40.0);
  EXPECT_GT(canvas->text_width(words, {.size = 10.0, .max_width = 60.0}), 150.0);
}

TEST(Canvas, BoxesThatTouchDoNotOverlap) {
  EXPECT_TRUE(overlap({0, 0, 10, 10}, {9, 9, 5, 5}));
  EXPECT_FALSE(overlap({0, 0, 10, 10}, {10, 0, 5, 5}));
  EXPECT_FALSE(overlap({0, 0, 10, 10}, {0, -5, 5, 5}));
}

}  // namespace
}  // namespace mien::pipeline
