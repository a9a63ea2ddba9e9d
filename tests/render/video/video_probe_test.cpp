#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/temporary_folder.h"
#include "render/file_damage.h"
#include "render/image/image_io.h"
#include "render/refusal.h"
#include "render/video/video.h"
#include "render/video_frames.h"

namespace mien::render {
namespace {

using test::refusal_of;

class VideoProbe : public testing::Test {
 protected:
  mien::test::TemporaryFolder temporary;
  const std::filesystem::path path = temporary.path() / "video.mp4";
};

TEST_F(VideoProbe, RefusesAVideoThatIsCutShort) {
  for (const double share : {0.0, 0.05, 0.5, 0.9, 0.99}) {
    test::write_video(path, test::smooth_frames(160, 96, 30));
    test::cut_short(path, share);
    EXPECT_NE(refusal_of([&] { probe(path); }).find("video.mp4: "), std::string::npos)
        << "kept " << share;
  }
}

TEST_F(VideoProbe, RefusesWhatIsNoVideo) {
  test::replace_bytes(path, std::vector<char>(4096, 'x'));
  EXPECT_NE(refusal_of([&] { probe(path); }).find("video.mp4: opening"), std::string::npos);
  EXPECT_NE(refusal_of([&] { probe(temporary.path() / "none.mp4"); }).find("none.mp4: opening"),
            std::string::npos);
}

std::string little_endian(std::uint32_t value, int bytes = 4) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xffU);
  return text;
}

std::string chunk(const std::string& name, const std::string& content) {
  return name + little_endian(static_cast<std::uint32_t>(content.size())) + content +
         std::string(content.size() % 2, '\0');
}

/// An AVI of PNG pictures of any sizes, which says of all of them that they have that of the first.
std::string avi_of_pngs(const std::vector<Image8>& frames, const std::filesystem::path& scratch) {
  std::string pictures = "movi";
  for (const Image8& frame : frames) {
    write_png(scratch, frame);
    std::ifstream file(scratch, std::ios::binary);
    pictures += chunk("00dc", {std::istreambuf_iterator<char>(file), {}});
  }
  const auto count = static_cast<std::uint32_t>(frames.size());
  const auto width = static_cast<std::uint32_t>(frames.front().width);
  const auto height = static_cast<std::uint32_t>(frames.front().height);
  const auto zeros = [](int bytes) { return std::string(static_cast<std::size_t>(bytes), '\0'); };
  const std::string all = little_endian(100'000) + zeros(12) + little_endian(count) + zeros(4) +
                          little_endian(1) + zeros(4) + little_endian(width) +
                          little_endian(height) + zeros(16);
  const std::string stream = "vidsMPNG" + zeros(12) + little_endian(1) + little_endian(10) +
                             zeros(4) + little_endian(count) + zeros(16);
  const std::string format = little_endian(40) + little_endian(width) + little_endian(height) +
                             little_endian(1, 2) + little_endian(24, 2) + "MPNG" + zeros(20);
  const std::string header = "hdrl" + chunk("avih", all) +
                             chunk("LIST", "strl" + chunk("strh", stream) + chunk("strf", format));
  return chunk("RIFF", "AVI " + chunk("LIST", header) + chunk("LIST", pictures));
}

// A decoder goes on with pictures of another size; whoever compares them must not.
TEST_F(VideoProbe, RefusesAVideoWhosePicturesChangeTheirSize) {
  const std::filesystem::path avi = temporary.path() / "sizes.avi";
  const auto write = [&](int width, int height) {
    std::vector<Image8> frames = test::smooth_frames(64, 48, 3);
    frames.push_back(test::smooth_frame(width, height, 3));
    frames.push_back(test::smooth_frame(64, 48, 4));
    std::ofstream(avi, std::ios::binary) << avi_of_pngs(frames, temporary.path() / "frame.png");
  };
  write(64, 48);
  EXPECT_EQ(probe(avi).frames, 5);
  for (const auto& [width, height] : {std::pair(96, 48), {64, 50}, {32, 24}}) {
    write(width, height);
    EXPECT_EQ(
        refusal_of([&] { probe(avi); }),
        avi.string() + ": frame 3 has " + std::to_string(width) + " x " + std::to_string(height) +
            " pixels, and the video 64 x 48; encode it again with the same size for all frames");
  }
}

TEST_F(VideoProbe, RefusesAVideoThatWasNotFinished) {
  {
    VideoWriter video(path, {.width = 64, .height = 48});
    for (const Image8& frame : test::smooth_frames(64, 48, 5)) video.write(frame);
  }
  EXPECT_NE(refusal_of([&] { probe(path); }), "");
}

TEST_F(VideoProbe, ReadsAFileWhoseNameLooksLikeAProtocol) {
  struct Stay {
    std::filesystem::path before = std::filesystem::current_path();
    ~Stay() { std::filesystem::current_path(before); }
  } const stay;
  std::filesystem::current_path(temporary.path());
  VideoWriter video("take:1.mp4", {.width = 64, .height = 48});
  for (const Image8& frame : test::smooth_frames(64, 48, 5)) video.write(frame);
  video.finish();
  EXPECT_EQ(probe("take:1.mp4").frames, 5);
  EXPECT_TRUE(std::filesystem::exists(temporary.path() / "take:1.mp4"));
}

TEST_F(VideoProbe, ReadsAWebpToTheEndItStatesAndNoFurther) {
  const std::filesystem::path webp = temporary.path() / "loop.webp";
  const auto write = [&] {
    VideoWriter video(webp, {.width = 64, .height = 48, .kind = VideoKind::webp});
    for (const Image8& frame : test::smooth_frames(64, 48, 5)) video.write(frame);
    video.finish();
  };
  write();
  std::ofstream(webp, std::ios::binary | std::ios::app) << "bytes of another program";
  EXPECT_EQ(probe(webp).frames, 5);
  write();
  test::cut_short(webp, 0.9);
  EXPECT_NE(refusal_of([&] { probe(webp); }).find("loop.webp: is cut short"), std::string::npos);
}

}  // namespace
}  // namespace mien::render
