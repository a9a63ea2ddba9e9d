#include "render/video/video_check.h"

#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

#include "pipeline/temporary_folder.h"
#include "render/file_damage.h"
#include "render/refusal.h"
#include "render/video_frames.h"

namespace mien::render {
namespace {

using test::refusal_of;
using test::smooth_frames;

constexpr int wide = 160;
constexpr int high = 96;

VideoSketch sketch_of(const std::vector<Image8>& frames) {
  VideoSketch sketch(frames[0].width, frames[0].height);
  for (const Image8& frame : frames) sketch.add(frame);
  return sketch;
}

VideoFormat format_of(VideoKind kind, FrameRate rate = {30, 1}) {
  return {.width = wide, .height = high, .rate = rate, .kind = kind};
}

class VideoCheckTest : public testing::TestWithParam<VideoKind> {
 protected:
  mien::test::TemporaryFolder temporary;
  const std::filesystem::path path = with_ending(temporary.path() / "video", GetParam());

  std::string refusal_to(const std::vector<Image8>& written, const std::vector<Image8>& expected) {
    test::write_video(path, written, {30, 1}, GetParam());
    return refusal_of([&] { check_video(path, format_of(GetParam()), sketch_of(expected)); });
  }
};

TEST_P(VideoCheckTest, AcceptsWhatWasWritten) {
  // Still at first, as under a fixation cross, then moving.
  std::vector<Image8> frames = smooth_frames(wide, high, 20);
  std::fill_n(frames.begin(), 7, frames[7]);
  for (const FrameRate rate : {FrameRate{30, 1}, {30000, 1001}, {25, 1}, {50, 1}}) {
    test::write_video(path, frames, rate, GetParam());
    const VideoCheck check = check_video(path, format_of(GetParam(), rate), sketch_of(frames));
    EXPECT_EQ(check.identical, traits_of(GetParam()).lossless);
    EXPECT_EQ(check.summary.starts_with_key_frame, true);
  }
}

TEST_P(VideoCheckTest, AcceptsASingleFrame) {
  const std::vector<Image8> frames = smooth_frames(wide, high, 1);
  test::write_video(path, frames, {30, 1}, GetParam());
  EXPECT_NO_THROW(check_video(path, format_of(GetParam()), sketch_of(frames)));
}

TEST_P(VideoCheckTest, AcceptsAFilmThatStandsStill) {
  const std::vector<Image8> frames(5, smooth_frames(wide, high, 1)[0]);
  test::write_video(path, frames, {30, 1}, GetParam());
  const VideoCheck check = check_video(path, format_of(GetParam()), sketch_of(frames));
  EXPECT_EQ(check.frames, 5);
}

/// A grey ground on which thin dark and light lines move.
Image8 line_frame(int width, int height, int number) {
  Image8 image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool is_line = (x + y + number) % 7 == 0 || (2 * x - y + number) % 11 == 0;
      const int grain = (x * 7919 + y * 104729 + number * 1299709) % 23;
      const std::uint8_t grey = static_cast<std::uint8_t>((is_line ? 40 : 180) + grain);
      std::fill_n(image.at(x, y), 3, grey);
      if (is_line) image.at(x, y)[0] = static_cast<std::uint8_t>(grey + 60);
    }
  }
  return image;
}

TEST_P(VideoCheckTest, AcceptsTinyPicturesAndTellsWrongOnes) {
  using Size = std::pair<int, int>;
  for (const auto& [width, height] :
       {Size{16, 16}, {16, 64}, {32, 24}, {48, 32}, {66, 64}, {128, 72}, {130, 128}}) {
    std::vector<Image8> frames;
    for (int i = 0; i < 6; ++i) frames.push_back(line_frame(width, height, i));
    for (const VideoEffort effort : {VideoEffort::fast, VideoEffort::thorough}) {
      VideoFormat format = format_of(GetParam());
      format.width = width;
      format.height = height;
      format.effort = effort;
      VideoWriter video(path, format);
      for (const Image8& frame : frames) video.write(frame);
      video.finish();
      EXPECT_NO_THROW(check_video(path, format, sketch_of(frames))) << width << " x " << height;
    }
    VideoFormat format = format_of(GetParam());
    format.width = width;
    format.height = height;
    std::vector<Image8> others = frames;
    std::fill_n(others[3].at(0, 0), 3 * width * height / 2, std::uint8_t{20});
    EXPECT_NE(refusal_of([&] { check_video(path, format, sketch_of(others)); }).find("frame 3"),
              std::string::npos)
        << width << " x " << height;
  }
}

TEST_P(VideoCheckTest, RefusesALostFrame) {
  const std::vector<Image8> frames = smooth_frames(wide, high, 20);
  const std::vector<Image8> fewer(frames.begin(), frames.end() - 1);
  EXPECT_NE(refusal_to(fewer, frames).find("has 19 frames instead of 20"), std::string::npos);
}

TEST_P(VideoCheckTest, RefusesFramesInAnotherOrder) {
  const std::vector<Image8> frames = smooth_frames(wide, high, 40);
  std::vector<Image8> other = frames;
  std::swap(other[5], other[35]);
  EXPECT_NE(refusal_to(other, frames).find("frame "), std::string::npos);
}

TEST_P(VideoCheckTest, RefusesAFrameWithABrokenBlock) {
  const std::vector<Image8> frames = smooth_frames(wide, high, 12);
  std::vector<Image8> other = frames;
  for (int y = 32; y < 64; ++y) std::fill_n(other[7].at(64, y), 3 * 32, std::uint8_t{255});
  const std::string refusal = refusal_to(other, frames);
  EXPECT_NE(refusal.find("frame 7"), std::string::npos) << refusal;
}

TEST_P(VideoCheckTest, RefusesExchangedColours) {
  const std::vector<Image8> frames = smooth_frames(wide, high, 3);
  std::vector<Image8> other = frames;
  for (Image8& frame : other) {
    for (std::size_t i = 0; i < frame.channels.size(); i += 3) {
      std::swap(frame.channels[i], frame.channels[i + 2]);
    }
  }
  EXPECT_NE(refusal_to(other, frames).find("frame "), std::string::npos);
}

TEST_P(VideoCheckTest, RefusesAnotherRateOrSize) {
  const std::vector<Image8> frames = smooth_frames(wide, high, 20);
  test::write_video(path, frames, {30, 1}, GetParam());
  const VideoSketch sketch = sketch_of(frames);
  VideoFormat other = format_of(GetParam(), {24, 1});
  EXPECT_NE(refusal_of([&] { check_video(path, other, sketch); }), "");
  other = format_of(GetParam());
  other.height = 98;
  const std::string refusal = refusal_of([&] { check_video(path, other, sketch); });
  EXPECT_TRUE(refusal.find("the size is ") != std::string::npos ||
              refusal.find("the size differs") != std::string::npos)
      << refusal;
}

// Films of several stretches from key frame to key frame, of which two are broken, or the end is
// missing; and one that is whole.
TEST_P(VideoCheckTest, SaysTheSameWithAnyNumberOfThreads) {
  const std::vector<Image8> frames = smooth_frames(wide, high, 150);
  test::write_video(path, frames, {30, 1}, GetParam());
  const std::vector<char> whole = test::bytes_of(path);
  const VideoSketch sketch = sketch_of(frames);
  const auto said_by = [&](int threads) {
    return refusal_of([&] { check_video(path, format_of(GetParam()), sketch, nullptr, threads); });
  };
  EXPECT_NO_THROW(check_video(path, format_of(GetParam()), sketch, nullptr, 3));
  std::vector<char> broken = whole;
  for (const double share : {0.4, 0.8}) {
    const auto at =
        broken.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(broken.size()));
    std::transform(at, at + 64, at, [](char c) { return static_cast<char>(~c); });
  }
  test::replace_bytes(path, broken);
  const std::string of_broken = said_by(1);
  EXPECT_NE(of_broken, "");
  for (const int threads : {2, 3, 4}) EXPECT_EQ(said_by(threads), of_broken);
  test::replace_bytes(path, whole);
  test::cut_short(path, 0.7);
  const std::string of_cut = said_by(1);
  EXPECT_NE(of_cut, "");
  for (const int threads : {2, 3, 4}) EXPECT_EQ(said_by(threads), of_cut);
}

TEST_P(VideoCheckTest, RefusesAFileWithABrokenByteOrAnotherPicture) {
  const std::vector<Image8> frames = smooth_frames(wide, high, 20);
  test::write_video(path, frames, {30, 1}, GetParam());
  const std::vector<char> whole = test::bytes_of(path);
  const VideoSketch sketch = sketch_of(frames);
  // Half a kilobyte in the midst of the pictures.
  std::vector<char> broken = whole;
  const auto middle = broken.begin() + static_cast<std::ptrdiff_t>(broken.size() / 2);
  std::transform(middle, middle + std::min<std::ptrdiff_t>(512, broken.end() - middle), middle,
                 [](char c) { return static_cast<char>(~c); });
  test::replace_bytes(path, broken);
  EXPECT_NE(refusal_of([&] { check_video(path, format_of(GetParam()), sketch); }), "");
  test::replace_bytes(path, whole);
  test::cut_short(path, 0.8);
  EXPECT_NE(refusal_of([&] { check_video(path, format_of(GetParam()), sketch); }), "");
}

TEST(VideoCheck, RefusesAnotherKind) {
  const mien::test::TemporaryFolder temporary;
  const std::vector<Image8> frames = smooth_frames(wide, high, 3);
  const auto path = temporary.path() / "video.mp4";
  test::write_video(path, frames, {30, 1}, VideoKind::mp4_lossless);
  EXPECT_NE(refusal_of([&] {
              check_video(path, format_of(VideoKind::mp4), sketch_of(frames));
            }).find("the matrix tag is \"gbr\" instead of \"bt709\""),
            std::string::npos);
}

std::string name_of(const testing::TestParamInfo<VideoKind>& info) {
  std::string name(traits_of(info.param).name);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(AllKinds, VideoCheckTest,
                         testing::Values(VideoKind::mp4, VideoKind::mp4_lossless, VideoKind::webm,
                                         VideoKind::webm_av1, VideoKind::mkv, VideoKind::webp,
                                         VideoKind::gif, VideoKind::apng),
                         name_of);

}  // namespace
}  // namespace mien::render
