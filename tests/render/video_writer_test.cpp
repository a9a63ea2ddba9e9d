#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "pipeline/temporary_folder.h"
#include "render/file_damage.h"
#include "render/refusal.h"
#include "render/video.h"
#include "render/video_frames.h"

namespace mien::render {
namespace {

using test::refusal_of;
using test::smooth_frames;
using test::write_video;

class VideoWriterTest : public testing::Test {
 protected:
  mien::test::TemporaryFolder temporary;
  const std::filesystem::path path = temporary.path() / "video.mp4";
};

/// Peak signal-to-noise ratio of 8-bit pictures, decibel.
double psnr(const Image8& a, const Image8& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.channels.size(); ++i) {
    const double difference = static_cast<double>(a.channels[i]) - b.channels[i];
    sum += difference * difference;
  }
  return 10.0 * std::log10(255.0 * 255.0 * static_cast<double>(a.channels.size()) / sum);
}

TEST_F(VideoWriterTest, WritesExactlyTheFramesGivenAtTheirRate) {
  for (const FrameRate rate : {FrameRate{30, 1}, {30000, 1001}, {12, 1}, {120, 1}}) {
    for (const int count : {1, 2, 61}) {
      write_video(path, smooth_frames(64, 48, count), rate);
      const VideoSummary summary = probe(path);
      EXPECT_EQ(summary.frames, count);
      EXPECT_EQ(summary.rate, rate) << summary.rate.numerator << "/" << summary.rate.denominator;
      EXPECT_TRUE(summary.steady_timestamps);
      EXPECT_NEAR(summary.duration_seconds, count / rate.per_second(), 1e-9);
      EXPECT_TRUE(summary.starts_with_key_frame);
    }
  }
}

TEST_F(VideoWriterTest, WritesTaggedH264WithItsIndexAtTheFront) {
  write_video(path, smooth_frames(66, 50, 5));
  const VideoSummary summary = probe(path);
  EXPECT_NE(summary.container.find("mp4"), std::string::npos);
  EXPECT_EQ(summary.codec, "h264");
  EXPECT_EQ(summary.pixel_format, "yuv420p");
  EXPECT_EQ(summary.width, 66);
  EXPECT_EQ(summary.height, 50);
  EXPECT_EQ(summary.primaries, "bt709");
  EXPECT_EQ(summary.transfer, "bt709");
  EXPECT_EQ(summary.matrix, "bt709");
  EXPECT_EQ(summary.range, "tv");
  EXPECT_TRUE(summary.index_at_front);
}

TEST_F(VideoWriterTest, KeepsASmoothPicture) {
  const std::vector<Image8> frames = smooth_frames(160, 96, 12);
  write_video(path, frames);
  int decoded = 0;
  probe(path, [&](int index, const Image8& frame) {
    EXPECT_EQ(index, decoded++);
    EXPECT_GT(psnr(frame, frames[static_cast<std::size_t>(index)]), 38.0) << "frame " << index;
  });
  EXPECT_EQ(decoded, 12);
}

TEST_F(VideoWriterTest, WritesTheSameBytesForTheSameFrames) {
  const std::vector<Image8> frames = smooth_frames(160, 96, 30);
  write_video(path, frames);
  const std::vector<char> first = test::bytes_of(path);
  write_video(path, frames);
  EXPECT_EQ(test::bytes_of(path), first);
}

TEST_F(VideoWriterTest, RefusesAnOddOrEmptySize) {
  for (const auto& [width, height] : {std::pair{65, 48}, {64, 47}, {0, 48}, {64, -2}}) {
    EXPECT_NE(refusal_of([&] {
                VideoWriter(path, {.width = width, .height = height});
              }).find("video.mp4: H.264 needs an even width and height"),
              std::string::npos);
  }
}

TEST_F(VideoWriterTest, RefusesAFrameOfAnotherSize) {
  VideoWriter video(path, {.width = 64, .height = 48});
  EXPECT_NE(refusal_of([&] { video.write(Image8(48, 64)); }).find("another size"),
            std::string::npos);
}

TEST_F(VideoWriterTest, RefusesAVideoWithoutFrames) {
  VideoWriter video(path, {.width = 64, .height = 48});
  EXPECT_NE(refusal_of([&] { video.finish(); }).find("without frames"), std::string::npos);
}

TEST_F(VideoWriterTest, RefusesAFolderThatIsNotThere) {
  const auto nowhere = temporary.path() / "no" / "video.mp4";
  EXPECT_NE(refusal_of([&] {
              VideoWriter(nowhere, {.width = 64, .height = 48});
            }).find("video.mp4: opening for writing"),
            std::string::npos);
}

TEST(FrameRates, AreTheNearestThatAVideoCanHave) {
  EXPECT_EQ(frame_rate(30.0), (FrameRate{30, 1}));
  EXPECT_EQ(frame_rate(1.0 / 0.033333333), (FrameRate{30, 1}));
  EXPECT_EQ(frame_rate(29.97), (FrameRate{30000, 1001}));
  EXPECT_EQ(frame_rate(12.5), (FrameRate{25, 2}));
  EXPECT_THROW(frame_rate(0.0), std::invalid_argument);
  EXPECT_THROW(frame_rate(std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace mien::render
