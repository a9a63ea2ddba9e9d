#include "pipeline/regression/comparison/compared_media.h"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/regression/comparison/frame_alignment.h"
#include "pipeline/temporary_folder.h"
#include "render/image/image_io.h"
#include "render/video/video.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
/// Whether one of the lines is that.
bool has(const std::vector<std::string>& lines, const std::string& line) {
  return std::ranges::find(lines, line) != lines.end();
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

render::Image8 disc(int frame) {
  render::Image8 picture(160, 96);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const int dx = x - 20 - 4 * frame, dy = y - 48;
      const bool inside = dx * dx + dy * dy < 300;
      for (int c = 0; c < 3; ++c)
        picture.at(x, y)[c] = static_cast<std::uint8_t>(inside ? 200 - 30 * c : 90 + c);
    }
  }
  return picture;
}

void write_film(const fs::path& file, const std::vector<int>& frames, int per_second = 25) {
  render::VideoWriter video(
      file,
      {.width = 160, .height = 96, .rate = {per_second, 1}, .kind = *render::video_kind_of(file)});
  for (const int frame : frames) video.write(disc(frame));
  video.finish();
}

std::vector<int> twenty() {
  std::vector<int> frames;
  for (int i = 0; i < 20; ++i) frames.push_back(i);
  return frames;
}

class ComparedMediaFiles : public ::testing::Test {
 protected:
  fs::path in(const std::string& name) const { return folder_.path() / name; }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(ComparedMediaFiles, OnePictureIsAsItself) {
  render::write_png(in("a.png"), disc(1));
  render::write_png(in("b.png"), disc(1));
  const ComparedMedia media = compared_media(in("a.png"), in("b.png"), 0.0);
  EXPECT_TRUE(media.are_alike());
  EXPECT_EQ(media.frames_differing, 0);
  EXPECT_TRUE(contains(as_text(media), "the same")) << as_text(media);
}

TEST_F(ComparedMediaFiles, APixelIsADifferenceUnlessItMayBe) {
  render::Image8 changed = disc(1);
  changed.at(70, 40)[1] = 255;
  render::write_png(in("a.png"), disc(1));
  render::write_png(in("b.png"), changed);
  const ComparedMedia strict = compared_media(in("a.png"), in("b.png"), 0.0);
  EXPECT_FALSE(strict.are_alike());
  ASSERT_EQ(strict.worst.size(), 1U);
  EXPECT_EQ(strict.worst[0].difference.changed, (render::Window{70, 40, 1, 1}));
  EXPECT_TRUE(compared_media(in("a.png"), in("b.png"), 0.1).are_alike());
}

TEST_F(ComparedMediaFiles, TellsADroppedFrameOfAVideo) {
  std::vector<int> frames = twenty();
  write_film(in("a.mp4"), frames);
  frames.erase(frames.begin() + 7);
  write_film(in("b.mp4"), frames);
  const ComparedMedia media = compared_media(in("a.mp4"), in("b.mp4"), 0.02);
  EXPECT_FALSE(media.are_alike());
  EXPECT_TRUE(has(media.remarks, "frame 7 is missing"));
  EXPECT_EQ(media.frames_compared, 19);
}

TEST_F(ComparedMediaFiles, TellsAnotherRateOfTheSameFrames) {
  write_film(in("a.mp4"), twenty(), 25);
  write_film(in("b.mp4"), twenty(), 30);
  const ComparedMedia media = compared_media(in("a.mp4"), in("b.mp4"), 0.02);
  EXPECT_TRUE(has(media.remarks, "frames per second: 25 → 30"));
  EXPECT_FALSE(media.are_alike());
}

TEST_F(ComparedMediaFiles, ALosslessVideoIsItsFolderOfFrames) {
  fs::create_directory(in("frames"));
  for (const int frame : twenty())
    render::write_png(in("frames") / (std::to_string(100 + frame) + ".png"), disc(frame));
  write_film(in("a.mkv"), twenty());
  const ComparedMedia media = compared_media(in("frames"), in("a.mkv"), 0.0);
  EXPECT_EQ(media.frames_compared, 20);
  EXPECT_EQ(media.frames_differing, 0);
}

TEST_F(ComparedMediaFiles, SizesThatDifferAreTold) {
  render::write_png(in("a.png"), disc(1));
  render::write_png(in("b.png"), render::Image8(80, 48));
  try {
    compared_media(in("a.png"), in("b.png"), 0.0);
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(contains(error.what(), "160 x 96")) << error.what();
    EXPECT_TRUE(contains(error.what(), "80 x 48")) << error.what();
  }
}

TEST_F(ComparedMediaFiles, NumbersInNamesCountByTheirValue) {
  fs::create_directories(in("then"));
  fs::create_directories(in("today"));
  for (const int frame : twenty()) {
    render::write_png(in("then") / ("f" + std::to_string(frame) + ".png"), disc(frame));
    render::write_png(in("today") / ("f" + std::to_string(100 + frame).substr(1) + ".png"),
                      disc(frame));
  }
  const ComparedMedia media = compared_media(in("then"), in("today"), 0.0);
  EXPECT_TRUE(media.remarks.empty()) << as_text(media);
  EXPECT_TRUE(contains(as_text(media), "all are identical")) << as_text(media);
}

TEST_F(ComparedMediaFiles, DoNotSayThatNothingDiffersWhereFramesAreMissing) {
  std::vector<int> frames = twenty();
  write_film(in("a.mkv"), frames);
  frames.resize(12);
  write_film(in("b.mkv"), frames);
  const std::string text = as_text(compared_media(in("a.mkv"), in("b.mkv"), 0.0));
  EXPECT_TRUE(contains(text, "frames 12 to 19 are missing")) << text;
  EXPECT_TRUE(contains(text, "the 12 common to both are identical")) << text;
}

TEST_F(ComparedMediaFiles, TellsAFilmThatIsMirrored) {
  using Turn = Mirroring;
  for (const Turn turn : {Turn::left_right, Turn::upside_down, Turn::half_turn}) {
    fs::remove_all(in("then"));
    fs::remove_all(in("today"));
    fs::create_directory(in("then"));
    fs::create_directory(in("today"));
    for (const int frame : twenty()) {
      if (turn == Turn::upside_down && frame > 11) break;
      render::Image8 picture = disc(frame);
      for (int x = 30; x < 50; ++x) picture.at(x, 10)[0] = 255;  // above is not as below
      const std::string name = std::to_string(100 + frame) + ".png";
      render::write_png(in("then") / name, picture);
      render::write_png(in("today") / name, mirrored(picture, turn));
    }
    const ComparedMedia media = compared_media(in("then"), in("today"), 0.0);
    EXPECT_FALSE(media.are_alike());
    ASSERT_EQ(media.remarks.size(), 1U) << as_text(media);
    EXPECT_TRUE(contains(media.remarks[0], std::string(name_of(turn)))) << media.remarks[0];
    EXPECT_EQ(media.frames_differing, 0) << as_text(media);
    EXPECT_TRUE(compared_media(in("then"), in("then"), 0.0).are_alike());
  }
}

TEST_F(ComparedMediaFiles, TellNamesOfFramesBesideTheirNumbers) {
  fs::create_directories(in("then"));
  fs::create_directories(in("today"));
  for (const int frame : twenty()) {
    const std::string name = "f" + std::to_string(frame + 1) + ".png";
    render::Image8 picture = disc(frame);
    render::write_png(in("then") / name, picture);
    if (frame == 11) continue;
    if (frame == 4) picture.at(3, 3)[0] = 255;
    render::write_png(in("today") / name, picture);
  }
  const std::string text = as_text(compared_media(in("then"), in("today"), 0.0));
  EXPECT_TRUE(contains(text, "frame 4 (f5.png): mean")) << text;
  EXPECT_TRUE(contains(text, "frame 11 (f12.png) is missing")) << text;
}

/// What macOS and editors put beside files.
TEST_F(ComparedMediaFiles, LeavesHiddenFilesInAFolderOut) {
  for (const char* folder : {"then", "today"}) {
    fs::create_directories(in(folder));
    for (const char* name : {"1.png", "2.png"}) render::write_png(in(folder) / name, disc(1));
  }
  for (const char* hidden : {"._1.png", ".2.png.swp", ".hidden.png"})
    write_file(in("today") / hidden, "no picture");
  EXPECT_TRUE(compared_media(in("then"), in("today"), 0.0).are_alike());
}

TEST_F(ComparedMediaFiles, NamesThePictureOfAnotherSize) {
  fs::create_directories(in("then"));
  for (const char* name : {"1.png", "2.png"}) render::write_png(in("then") / name, disc(1));
  render::write_png(in("then") / "3.png", render::Image8(80, 48));
  try {
    compared_media(in("then"), in("then"), 0.0);
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(contains(error.what(), "3.png")) << error.what();
  }
}

}  // namespace
}  // namespace mien::pipeline
