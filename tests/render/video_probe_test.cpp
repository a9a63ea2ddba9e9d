#include <gtest/gtest.h>

#include "pipeline/temporary_folder.h"
#include "render/file_damage.h"
#include "render/refusal.h"
#include "render/video.h"
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

}  // namespace
}  // namespace mien::render
