#include "render/video/video_receipt.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "pipeline/temporary_folder.h"
#include "render/error.h"
#include "render/file_damage.h"
#include "render/video/video_check.h"

namespace mien::render {
namespace {

constexpr int walk_width = 400;
constexpr int walk_height = 256;
constexpr int walk_frames = 24;

/// A figure of limbs that walks over a ground, or stands, as drafts show it.
Image8 walking_frame(double seconds) {
  Image8 image(walk_width, walk_height);
  for (int y = 0; y < walk_height; ++y)
    for (int x = 0; x < walk_width; ++x)
      for (int c = 0; c < 3; ++c)
        image.at(x, y)[c] = static_cast<std::uint8_t>((y > 140 ? 150 : 220) - 10 * c + y / 20);
  const auto limb = [&](double x, double y, double angle, double length) {
    for (double along = 0.0; along < length; along += 0.5)
      for (int across = -3; across <= 3; ++across) {
        const int px = static_cast<int>(x + along * std::sin(angle)) + across;
        const int py = static_cast<int>(y + along * std::cos(angle));
        const std::uint8_t colour[3] = {60, 110, 190};
        std::copy_n(colour, 3, image.at(px, py));
      }
  };
  const double x = 120.0 + 60.0 * seconds, swing = 0.5 * std::sin(6.0 * seconds);
  limb(x, 80.0, 0.0, 60.0);
  limb(x, 140.0, swing, 70.0);
  limb(x, 140.0, -swing, 70.0);
  limb(x, 90.0, -swing, 45.0);
  limb(x, 90.0, swing, 45.0);
  return image;
}

std::vector<Image8> walk() {
  std::vector<Image8> frames;
  for (int i = 0; i < walk_frames; ++i) frames.push_back(walking_frame(i / 30.0));
  return frames;
}

/// Each frame differs from the one before by one code of one channel of one pixel, which no coding
/// that loses anything keeps.
std::vector<Image8> hardly_moving() {
  std::vector<Image8> frames(walk_frames, walking_frame(0.0));
  for (std::size_t i = 1; i < frames.size(); ++i) {
    frames[i] = frames[i - 1];
    ++*frames[i].at(static_cast<int>(10 * i), 200);
  }
  return frames;
}

struct Written {
  std::filesystem::path path;
  VideoReceipt receipt;
};

class VideoReceiptTest : public testing::TestWithParam<VideoKind> {
 protected:
  mien::test::TemporaryFolder temporary;
  const VideoFormat format{
      .width = walk_width, .height = walk_height, .kind = GetParam(), .effort = VideoEffort::fast};

  Written written(const std::string& name, const std::vector<Image8>& frames) const {
    const auto path = with_ending(temporary.path() / name, GetParam());
    VideoWriter video(path, format);
    for (const Image8& frame : frames) video.write(frame);
    video.finish();
    return {path, video.receipt()};
  }

  VideoSketch sketch_of(const std::vector<Image8>& frames) const {
    VideoSketch sketch(walk_width, walk_height, checked_row_step(format));
    for (const Image8& frame : frames) sketch.add(frame);
    return sketch;
  }

  /// What the check says of a file, or "".
  std::string said_of(const Written& video, const VideoSketch& sketch) const {
    try {
      check_video(video.path, format, sketch, &video.receipt);
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  }

  /// Tries every frame of `frames` lost, doubled, swapped with the next and damaged, on the way to
  /// the encoder, and in a file that took the place of what the encoder made.
  void try_all(const std::vector<Image8>& frames) const {
    const VideoSketch sketch = sketch_of(frames);
    const Written right = written("right", frames);
    ASSERT_EQ(said_of(right, sketch), "");
    // Other encoders take their time, and the same is compared.
    const std::size_t step = GetParam() == VideoKind::mp4 ? 1 : 11;
    for (std::size_t at = 0; at + 1 < frames.size(); at += step) {
      std::vector<Image8> lost = frames, doubled = frames, swapped = frames, damaged = frames;
      lost.erase(lost.begin() + static_cast<std::ptrdiff_t>(at));
      // The number stays the same: one is shown twice and the next one never.
      doubled[at + 1] = doubled[at];
      std::swap(swapped[at], swapped[at + 1]);
      ++*damaged[at].at(static_cast<int>(7 * at), static_cast<int>(5 * at));
      for (const std::vector<Image8>* wrong : {&lost, &doubled, &swapped, &damaged})
        EXPECT_NE(said_of(written("wrong", *wrong), sketch), "") << at;
    }
  }
};

TEST_P(VideoReceiptTest, TellsEveryFrameThatIsLostOrDoubledOrSwappedOrDamagedInAWalk) {
  try_all(walk());
}

TEST_P(VideoReceiptTest, TellsThemWhereFramesDifferByACode) { try_all(hardly_moving()); }

TEST_P(VideoReceiptTest, TellsAFileInThePlaceOfWhatTheEncoderMade) {
  const std::vector<Image8> frames = walk();
  const Written right = written("right", frames);
  const VideoSketch sketch = sketch_of(frames);
  const std::size_t step = GetParam() == VideoKind::mp4 ? 1 : 11;
  for (std::size_t at = 0; at + 1 < frames.size(); at += step) {
    std::vector<Image8> doubled = frames;
    doubled[at + 1] = doubled[at];
    const Written other{written("other", doubled).path, right.receipt};
    EXPECT_NE(said_of(other, sketch), "") << at;
  }
}

TEST_P(VideoReceiptTest, TellsEachByteThatIsOther) {
  const std::vector<Image8> frames = walk();
  const Written right = written("right", frames);
  const VideoSketch sketch = sketch_of(frames);
  const std::vector<char> bytes = test::bytes_of(right.path);
  // Where frames are: between the index and the end, which also have bytes that mean nothing.
  const std::size_t begin = bytes.size() / 2, end = bytes.size() - bytes.size() / 8;
  for (std::size_t k = 0; k < 30; ++k) {
    std::vector<char> damaged = bytes;
    damaged[begin + k * (end - begin) / 30] ^= 1;
    test::replace_bytes(right.path, damaged);
    EXPECT_NE(said_of(right, sketch), "") << k;
  }
}

TEST_P(VideoReceiptTest, HoldsOfEveryFrameOneHash) {
  const std::vector<Image8> frames = walk();
  const VideoReceipt receipt = written("right", frames).receipt;
  EXPECT_EQ(receipt.frames, sketch_of(frames).hashes);
  EXPECT_EQ(receipt.packet_hashes.size(), frames.size());
}

std::string receipt_kind(const testing::TestParamInfo<VideoKind>& kind) {
  std::string name(traits_of(kind.param).name);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(KindsThatCodeFramesApart, VideoReceiptTest,
                         testing::Values(VideoKind::mp4, VideoKind::mp4_lossless, VideoKind::webm,
                                         VideoKind::webm_av1, VideoKind::mkv),
                         receipt_kind);

TEST(VideoReceipt, HoldsCodedBytesOfVideosAndNotOfPictures) {
  for (const VideoTraits& traits : video_kinds())
    EXPECT_EQ(has_packet_per_frame(traits.kind), !traits.picture) << traits.name;
}

TEST(VideoReceipt, HasOneHashForUnitsAfterMarksAndAfterLengths) {
  const std::vector<std::uint8_t> marked = {0, 0, 0, 1, 103, 7, 9, 0, 0, 1, 101, 5};
  const std::vector<std::uint8_t> measured = {0, 0, 0, 3, 103, 7, 9, 0, 0, 0, 2, 101, 5};
  const std::uint64_t hash = packet_hash("h264", marked, false);
  EXPECT_EQ(hash, packet_hash("h264", measured, true));
  for (std::size_t i = 0; i < measured.size(); ++i) {
    std::vector<std::uint8_t> other = measured;
    other[i] ^= 1;
    EXPECT_NE(hash, packet_hash("h264", other, true)) << i;
    EXPECT_NE(hash, packet_hash("h264", std::span(measured).first(i), true)) << i;
  }
  const std::vector<std::uint8_t> delimited = {0x12, 0, 10, 1, 2}, bare = {10, 1, 2};
  EXPECT_EQ(packet_hash("av1", delimited, false), packet_hash("av1", bare, false));
  EXPECT_NE(packet_hash("vp9", delimited, false), packet_hash("vp9", bare, false));
}

TEST(VideoReceipt, IsNeededUnlessEveryRowIsLookedAt) {
  VideoSketch sketch(walk_width, walk_height, 4);
  sketch.add(walking_frame(0.0));
  EXPECT_THROW(check_video("none.mp4", {.width = walk_width, .height = walk_height}, sketch),
               std::invalid_argument);
}

TEST(VideoReceipt, ChecksEveryRowOfWhatIsForKeepsOrLossless) {
  VideoFormat format{.width = 1280, .height = 720};
  EXPECT_EQ(checked_row_step(format), 1);
  for (const VideoTraits& traits : video_kinds()) {
    format.kind = traits.kind;
    format.effort = VideoEffort::fast;
    EXPECT_EQ(checked_row_step(format), traits.lossless || traits.picture ? 1 : 4) << traits.name;
  }
}

}  // namespace
}  // namespace mien::render
