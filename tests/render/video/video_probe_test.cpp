#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "pipeline/temporary_folder.h"
#include "render/file_damage.h"
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
