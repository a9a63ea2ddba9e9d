#include "motion/formats/bvh/bvh_stream.h"

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/formats/bvh/bvh.h"
#include "motion/random_recording.h"
#include "motion/refusal.h"

namespace mien::motion {
namespace {

using mien::test::random_recording;
using mien::test::refusal_of;

const std::string arm =
    "HIERARCHY\nROOT Arm\n{\n  OFFSET 0 0 0\n"
    "  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
    "  End Site\n  {\n    OFFSET 0 -1 0\n  }\n}\n"
    "MOTION\nFrames: 0\nFrame Time: 0.0333333\n";

struct Streamed {
  std::vector<Pose> poses;
  std::optional<BvhHead> head;
};

/// The text in pieces of `size` characters.
Streamed in_pieces(const std::string& text, size_t size) {
  BvhStream stream("live.bvh");
  Streamed result;
  const auto take = [&] {
    while (const auto pose = stream.next()) result.poses.push_back(*pose);
  };
  for (size_t at = 0; at < text.size(); at += size) {
    stream.push(std::string_view(text).substr(at, size));
    take();
  }
  stream.finish();
  take();
  result.head = stream.head();
  return result;
}

std::string refusal(const std::string& text, size_t size = 7) {
  return refusal_of([&] { in_pieces(text, size); });
}

void expect_same(const std::vector<Pose>& a, const std::vector<Pose>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t f = 0; f < a.size(); ++f) {
    EXPECT_EQ(a[f].root_position, b[f].root_position);
    for (size_t j = 0; j < a[f].rotations.size(); ++j) {
      EXPECT_EQ(a[f].rotations[j].coeffs(), b[f].rotations[j].coeffs());
    }
  }
}

TEST(BvhStream, ReadsWhatTheFileReaderReadsHoweverItIsCut) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    std::mt19937_64 random(seed);
    const std::string text = to_bvh(random_recording(random));
    const Recording whole = parse_bvh(text, "whole.bvh");
    for (const size_t size : {size_t{1}, size_t{3}, size_t{64}, size_t{100000}}) {
      const Streamed streamed = in_pieces(text, size);
      expect_same(streamed.poses, whole.poses);
      EXPECT_EQ(streamed.head->frames_per_second, whole.frames_per_second);
      EXPECT_EQ(streamed.head->claimed_frames, whole.poses.size());
    }
  }
}

TEST(BvhStream, GivesAFrameAsSoonAsItsLineHasEnded) {
  BvhStream stream("live.bvh");
  stream.push(arm);
  EXPECT_FALSE(stream.next());
  ASSERT_TRUE(stream.head());
  EXPECT_EQ(stream.head()->claimed_frames, 0u);
  EXPECT_DOUBLE_EQ(stream.head()->frames_per_second, 30.0);
  stream.push("1 2 3 0 0 9");
  EXPECT_FALSE(stream.next()) << "the last number may go on";
  stream.push("0\n");
  const auto pose = stream.next();
  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->root_position, Vec3(1, 2, 3));
  EXPECT_FALSE(stream.next());
}

TEST(BvhStream, TakesAnyEndsOfLinesCommentsAndWrappedFrames) {
  std::string text =
      "\xEF\xBB\xBF" + arm + "1 2 3 0 0 0 # first\n\n// nothing\n4 5 6\n0 0 0\n7 8 9 0 0 0";
  const Streamed streamed = in_pieces(text, 1);
  ASSERT_EQ(streamed.poses.size(), 3u);
  EXPECT_EQ(streamed.poses[1].root_position, Vec3(4, 5, 6));
  for (const std::string end : {"\r\n", "\r"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? end : std::string(1, c);
    expect_same(in_pieces(other, 1).poses, streamed.poses);
    expect_same(in_pieces(other, 50).poses, streamed.poses);
  }
}

TEST(BvhStream, LetsFramesSayWhatItLikes) {
  for (const std::string count : {"0", "1", "5000000"}) {
    std::string text = arm;
    text.replace(text.find("Frames: 0"), 9, "Frames: " + count);
    EXPECT_EQ(in_pieces(text + "0 0 0 0 0 0\n1 0 0 0 0 0\n", 10).poses.size(), 2u);
  }
}

TEST(BvhStream, RefusesBrokenFramesAtTheirPlace) {
  // The head has 13 lines, so the first frame stands on line 14.
  const std::string sound = "0 0 0 0 0 0\n";
  EXPECT_EQ(refusal(arm + sound + "0 0 nan 0 0 0\n").find("live.bvh:15:5: \"nan\" is not a valid"),
            0u);
  EXPECT_EQ(refusal(arm + sound + "0 0 x 0 0 0\n").find("live.bvh:15:5: "), 0u);
  EXPECT_EQ(
      refusal(arm + sound + "0 0 0 0 0 0 0\n").find("live.bvh:15:13: this frame has more than"),
      0u);
  EXPECT_EQ(
      refusal(arm + sound + "0 0 0 0 0\n" + sound).find("live.bvh:15:10: this frame ends after 5"),
      0u);
  EXPECT_EQ(refusal(arm + sound + "0 0 0,5 0 0 0\n").find("live.bvh:15:5: "), 0u);
  EXPECT_EQ(refusal(arm + sound + "1e999 0 0 0 0 0\n").find("live.bvh:15:1: "), 0u);
}

TEST(BvhStream, RefusesATextThatEndsTooSoon) {
  EXPECT_NE(refusal(arm + "0 0 0 0").find("live.bvh:14:8: this frame ends after 4 of 6 numbers"),
            std::string::npos);
  EXPECT_NE(refusal(arm.substr(0, arm.find("CHANNELS"))).find("not closed"), std::string::npos);
  EXPECT_NE(refusal(arm.substr(0, arm.find("Frame Time"))).find("Frame Time"), std::string::npos);
  EXPECT_NE(refusal(" ").find("starts with HIERARCHY"), std::string::npos);
}

TEST(BvhStream, SaysOfEveryTextThatEndsWithinAFrameThatItIsTruncated) {
  const std::string frames = "0 -1.5 +2 1e-3 -0 7\n-1 -.5 -2e+1 3 4 5";
  const std::string whole = arm + frames;
  for (size_t size = arm.size() + 1; size < whole.size(); ++size) {
    const std::string cut = whole.substr(0, size);
    if (cut.ends_with(" 7") || cut.ends_with("7\n")) continue;  // a frame is complete
    const std::string refused = refusal(cut);
    EXPECT_NE(refused.find("truncated"), std::string::npos)
        << "after \"" << cut.substr(arm.size()) << "\": " << refused;
  }
}

TEST(BvhStream, RefusesWhatIsNoBvhBeforeItEnds) {
  BvhStream stream("live.bvh");
  stream.push("RIFF....\nmore");
  EXPECT_NE(refusal_of([&] { stream.next(); }).find("live.bvh:1:1: a BVH file starts with"),
            std::string::npos);
}

TEST(BvhStream, DoesNotHoldAHeadOrAFrameWithoutEnd) {
  BvhStream heads("live.bvh");
  heads.push("HIERARCHY\n" + std::string(5 << 20, ' '));
  EXPECT_NE(refusal_of([&] { heads.next(); }).find("4 MiB"), std::string::npos);
  BvhStream frames("live.bvh");
  frames.push(arm + std::string(10000, '1'));
  EXPECT_NE(refusal_of([&] { frames.next(); }).find("incomplete"), std::string::npos);
}

}  // namespace
}  // namespace mien::motion
