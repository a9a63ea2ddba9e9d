#include <cmath>

#include <gtest/gtest.h>

#include "pipeline/regression/comparison/compared_media.h"

namespace mien::pipeline {
namespace {

/// A film of forty frames in a container that counts time in such units.
render::VideoSummary film(double frames_a_second, double unit) {
  const auto counted = [&](double seconds) { return std::round(seconds / unit) * unit; };
  render::VideoSummary summary;
  summary.codec = "h264";
  summary.rate = {static_cast<int>(std::lround(1000.0 * frames_a_second)), 1000};
  summary.frames = 40;
  summary.tick_seconds = unit;
  for (int i = 0; i < summary.frames; ++i) summary.times.push_back(counted(i / frames_a_second));
  summary.duration_seconds = counted(summary.frames / frames_a_second);
  return summary;
}

struct Differences {
  std::vector<std::string> seen, kept;
};

Differences differences_of(const render::VideoSummary& before, const render::VideoSummary& now) {
  Differences result;
  compare_containers(before, now, result.seen, result.kept);
  return result;
}

constexpr double mp4 = 1.0 / 12800.0, matroska = 1e-3;

TEST(Containers, ThatCountTimeInOtherUnitsShowTheSame) {
  for (const double rate : {12.5, 23.976, 25.0, 29.97, 59.94, 60.0, 120.0}) {
    EXPECT_TRUE(differences_of(film(rate, mp4), film(rate, matroska)).seen.empty()) << rate;
    EXPECT_TRUE(differences_of(film(rate, matroska), film(rate, mp4)).seen.empty()) << rate;
  }
}

TEST(Containers, ThatShowAFrameAtAnotherMomentDiffer) {
  render::VideoSummary late = film(25.0, matroska);
  late.times[7] += 0.004;
  EXPECT_EQ(differences_of(film(25.0, mp4), late).seen,
            (std::vector<std::string>{"time of frame 7, in seconds: 0.28 → 0.284"}));
}

TEST(Containers, AreToldApartToEnoughDigits) {
  render::VideoSummary longer = film(25.0, 1e-9);
  longer.duration_seconds += 1e-7;
  EXPECT_EQ(differences_of(film(25.0, 1e-9), longer).seen,
            (std::vector<std::string>{"duration in seconds: 1.6 → 1.6000001"}));
  EXPECT_EQ(differences_of(film(29.97, mp4), film(30.0, mp4)).seen.front(),
            "frames per second: 29.97 → 30");
}

TEST(Containers, OfAnotherCodecAreKeptOtherwiseAndShowTheSame) {
  render::VideoSummary other = film(25.0, mp4);
  other.codec = "ffv1";
  const Differences words = differences_of(film(25.0, mp4), other);
  EXPECT_TRUE(words.seen.empty());
  EXPECT_EQ(words.kept, (std::vector<std::string>{"codec: h264 → ffv1"}));
}

}  // namespace
}  // namespace mien::pipeline
