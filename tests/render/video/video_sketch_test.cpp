#include "render/video/video_sketch.h"

#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "render/video_frames.h"

namespace mien::render {
namespace {

using test::smooth_frame;

double psnr_of(const Image8& a, const Image8& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.channels.size(); ++i) {
    const double difference = static_cast<double>(a.channels[i]) - b.channels[i];
    sum += difference * difference;
  }
  return 10.0 * std::log10(255.0 * 255.0 * static_cast<double>(a.channels.size()) / sum);
}

double luma(const std::uint8_t* p) { return (54 * p[0] + 183 * p[1] + 19 * p[2] + 128) >> 8; }

/// By definition, over windows of the sketch's tiles.
double ssim_of(const Image8& a, const Image8& b, int edge) {
  double sum = 0.0;
  for (int top = 0; top < a.height; top += edge) {
    for (int left = 0; left < a.width; left += edge) {
      double n = 0, ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
      for (int y = top; y < std::min(top + edge, a.height); ++y) {
        for (int x = left; x < std::min(left + edge, a.width); ++x) {
          const double la = luma(a.at(x, y));
          const double lb = luma(b.at(x, y));
          n += 1;
          ma += la;
          mb += lb;
          aa += la * la;
          bb += lb * lb;
          ab += la * lb;
        }
      }
      ma /= n;
      mb /= n;
      const double c1 = 6.5025;
      const double c2 = 58.5225;
      sum += n * (2 * ma * mb + c1) * (2 * (ab / n - ma * mb) + c2) /
             ((ma * ma + mb * mb + c1) * (aa / n - ma * ma + bb / n - mb * mb + c2));
    }
  }
  return sum / (static_cast<double>(a.width) * a.height);
}

Image8 with_noise(Image8 image, int most, unsigned seed) {
  std::mt19937 random(seed);
  for (std::uint8_t& channel : image.channels) {
    const int noise = static_cast<int>(random() % static_cast<unsigned>(2 * most + 1)) - most;
    channel = static_cast<std::uint8_t>(std::clamp(channel + noise, 0, 255));
  }
  return image;
}

TEST(FrameSketch, TellsPsnrAndSsimOfNoise) {
  const int width = 480;
  const int height = 270;
  const FrameSketcher sketcher(width, height);
  const double sigma = std::sqrt(2.0 / sketcher.tile_count());
  for (unsigned seed = 0; seed < 12; ++seed) {
    const Image8 frame = smooth_frame(width, height, static_cast<int>(seed));
    const Image8 noisy = with_noise(frame, 1 + static_cast<int>(seed) * 2, seed);
    const FrameSimilarity like =
        sketcher.similarity(sketcher.sketch(frame), sketcher.sketch(noisy));
    EXPECT_FALSE(like.identical);
    EXPECT_NEAR(like.psnr_db, psnr_of(frame, noisy), 4.0 * sigma * 10.0 / std::log(10.0));
    const double ssim = ssim_of(frame, noisy, sketcher.tile_edge());
    EXPECT_NEAR(like.ssim, ssim, 4.0 * sigma * (1.0 - ssim));
  }
}

TEST(FrameSketch, IsRightOnAverage) {
  // The same error in 400 places: the estimates scatter about the true squared error.
  const FrameSketcher sketcher(64, 64);
  const Image8 frame = smooth_frame(64, 64, 0);
  const FrameSketch sketch = sketcher.sketch(frame);
  double sum = 0.0;
  for (unsigned i = 0; i < 400; ++i) {
    const Image8 noisy = with_noise(frame, 6, i);
    sum += std::pow(10.0, -0.1 * sketcher.similarity(sketch, sketcher.sketch(noisy)).psnr_db) /
           std::pow(10.0, -0.1 * psnr_of(frame, noisy));
  }
  // 400 · 16 tiles: a standard error of √(2 / 6400) = 0.018.
  EXPECT_NEAR(sum / 400, 1.0, 0.075);
}

TEST(FrameSketch, KnowsAFrameAgainAndTellsOneChangedChannel) {
  const FrameSketcher sketcher(100, 70);
  Image8 frame = smooth_frame(100, 70, 3);
  const FrameSketch sketch = sketcher.sketch(frame);
  EXPECT_TRUE(sketcher.similarity(sketch, sketcher.sketch(frame)).identical);
  for (const std::size_t i : {std::size_t{0}, std::size_t{10'001}, frame.channels.size() - 1}) {
    frame.channels[i] ^= 1;
    const FrameSimilarity like = sketcher.similarity(sketch, sketcher.sketch(frame));
    EXPECT_FALSE(like.identical);
    EXPECT_GT(like.psnr_db, 60.0);
    frame.channels[i] ^= 1;
  }
}

TEST(FrameSketch, StaysSmallAndRefusesOtherSizes) {
  static_assert(sizeof(FrameSketch::Tile) == 8);
  EXPECT_LE(FrameSketcher(1920, 1080).tile_count(), 512);
  EXPECT_LE(FrameSketcher(8192, 4320).tile_count(), 512);
  EXPECT_GE(FrameSketcher(1280, 720).tile_count(), 400);
  EXPECT_THROW(FrameSketcher(10, 10).sketch(Image8(10, 11)), std::invalid_argument);
}

}  // namespace
}  // namespace mien::render
