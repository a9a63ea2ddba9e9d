#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "pipeline/temporary_folder.h"
#include "render/file_damage.h"
#include "render/refusal.h"
#include "render/video/video.h"
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
  // More than encoders look ahead.
  const std::vector<Image8> frames = smooth_frames(160, 96, 70);
  for (const VideoTraits& traits : video_kinds()) {
    const auto file = temporary.path() / ("same" + std::string(traits.ending));
    write_video(file, frames, {30, 1}, traits.kind);
    const std::vector<char> first = test::bytes_of(file);
    write_video(file, frames, {30, 1}, traits.kind);
    EXPECT_TRUE(test::bytes_of(file) == first) << traits.name;
  }
}

TEST_F(VideoWriterTest, RefusesAnOddOrEmptySize) {
  for (const auto& [width, height] : {std::pair{65, 48}, {64, 47}, {0, 48}, {64, -2}}) {
    EXPECT_NE(refusal_of([&] {
                VideoWriter(path, {.width = width, .height = height});
              }).find("video.mp4: "),
              std::string::npos);
  }
  EXPECT_NE(refusal_of([&] {
              VideoWriter(path, {.width = 65, .height = 48});
            }).find("this kind of video needs an even width and height"),
            std::string::npos);
}

TEST_F(VideoWriterTest, TakesOddSizesWhereColoursAreNotHalved) {
  const std::vector<Image8> frames = smooth_frames(65, 47, 3);
  for (const VideoTraits& traits : video_kinds()) {
    if (traits.even_size) continue;
    const auto file = temporary.path() / ("odd" + std::string(traits.ending));
    write_video(file, frames, {30, 1}, traits.kind);
    probe(file, [](int, const Image8& frame) {
      EXPECT_EQ(frame.width, 65);
      EXPECT_EQ(frame.height, 47);
    });
  }
}

TEST_F(VideoWriterTest, EndsAGifWithinHalfAHundredthOfASecond) {
  const auto file = temporary.path() / "a.gif";
  for (const int rate : {1, 7, 12, 15, 24, 30, 49}) {
    for (const int count : {2, 9, 10, 11}) {
      write_video(file, smooth_frames(16, 16, count), {rate, 1}, VideoKind::gif);
      EXPECT_NEAR(probe(file).duration_seconds, static_cast<double>(count) / rate, 0.00501)
          << count << " frames at " << rate;
    }
  }
}

TEST_F(VideoWriterTest, LeavesNothingBesideAGif) {
  write_video(temporary.path() / "a.gif", smooth_frames(64, 48, 3), {30, 1}, VideoKind::gif);
  for (const auto& entry : std::filesystem::directory_iterator(temporary.path())) {
    EXPECT_EQ(entry.path().filename(), "a.gif");
  }
}

TEST_F(VideoWriterTest, SaysHowOftenAnAnimatedPictureRepeats) {
  const auto has = [&](const std::vector<char>& bytes, std::string_view text) {
    return std::string_view(bytes.data(), bytes.size()).find(text) != std::string_view::npos;
  };
  const auto written = [&](const char* name, VideoKind kind, bool loops) {
    const auto file = temporary.path() / name;
    VideoWriter video(file, {.width = 64, .height = 48, .kind = kind, .loops = loops});
    for (const Image8& frame : smooth_frames(64, 48, 3)) video.write(frame);
    video.finish();
    return test::bytes_of(file);
  };
  using namespace std::string_view_literals;
  EXPECT_TRUE(has(written("a.gif", VideoKind::gif, true), "NETSCAPE2.0\x03\x01\0\0"sv));
  EXPECT_FALSE(has(written("a.gif", VideoKind::gif, false), "NETSCAPE2.0"sv));
  EXPECT_TRUE(has(written("a.apng", VideoKind::apng, true), "acTL\0\0\0\x03\0\0\0\0"sv));
  EXPECT_TRUE(has(written("a.apng", VideoKind::apng, false), "acTL\0\0\0\x03\0\0\0\x01"sv));
  EXPECT_TRUE(
      has(written("a.webp", VideoKind::webp, true), "ANIM\x06\0\0\0\xff\xff\xff\xff\0\0"sv));
  EXPECT_TRUE(
      has(written("a.webp", VideoKind::webp, false), "ANIM\x06\0\0\0\xff\xff\xff\xff\x01\0"sv));
}

TEST_F(VideoWriterTest, RefusesAFrameOfAnotherSize) {
  VideoWriter video(path, {.width = 64, .height = 48});
  EXPECT_NE(refusal_of([&] { video.write(Image8(48, 64)); }).find("differs in size"),
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
