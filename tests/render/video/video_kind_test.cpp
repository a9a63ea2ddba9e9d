#include "render/video/video_kind.h"

#include <set>

#include <gtest/gtest.h>

namespace mien::render {
namespace {

TEST(VideoKinds, AreInTheOrderOfTheirEnumerationAndFoundByEnding) {
  std::set<std::string_view> endings;
  for (std::size_t i = 0; i < video_kinds().size(); ++i) {
    const VideoTraits& traits = video_kinds()[i];
    EXPECT_EQ(static_cast<std::size_t>(traits.kind), i);
    EXPECT_EQ(&traits_of(traits.kind), &traits);
    EXPECT_EQ(video_kind_of(with_ending("folder.mp4/walk", traits.kind)), traits.kind);
    EXPECT_TRUE(endings.insert(traits.ending).second) << traits.ending;
    EXPECT_EQ(traits.lossless, traits.least_psnr_db == 0.0) << traits.name;
  }
}

TEST(VideoKinds, OfOtherEndingsAreNone) {
  EXPECT_EQ(video_kind_of("walk.png"), std::nullopt);
  EXPECT_EQ(video_kind_of("walk.webm.bvh"), std::nullopt);
  EXPECT_EQ(video_kind_of("webm"), std::nullopt);
}

}  // namespace
}  // namespace mien::render
