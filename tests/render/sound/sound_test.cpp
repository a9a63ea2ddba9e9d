#include "render/sound/sound.h"

#include <gtest/gtest.h>

#include "render/sounds.h"

namespace mien::render {
namespace {

TEST(Sound, IsPlacedSoThatItsOffsetIsHeardAtTheBeginning) {
  Sound source{2, {}};
  for (int i = 0; i < 10; ++i)
    for (const float sign : {1.0f, -1.0f}) source.samples.push_back(sign * static_cast<float>(i));
  const Sound later = placed(source, {.offset = 3, .begin = 2, .length = 5});
  EXPECT_EQ(later.samples, (std::vector<float>{0, 0, 0, 0, 3, -3, 4, -4, 5, -5}));
  const Sound after_silence = placed(source, {.offset = -2, .begin = 1, .length = 5});
  EXPECT_EQ(after_silence.samples, (std::vector<float>{0, 0, 0, 0, 0, 0, 0, 0, 1, -1}));
  const Sound ended = placed(source, {.offset = 8, .begin = 0, .length = 4});
  EXPECT_EQ(ended.samples, (std::vector<float>{8, -8, 9, -9, 0, 0, 0, 0}));
  const Sound beyond = placed(source, {.offset = 20, .begin = 0, .length = 2});
  EXPECT_EQ(beyond.samples, (std::vector<float>{0, 0, 0, 0}));
}

TEST(Sound, GainIsInDecibels) {
  const Sound source{1, {0.25f, -0.5f}};
  const Sound doubled = placed(source, {.length = 2, .gain_db = 20.0 * std::log10(2.0)});
  EXPECT_FLOAT_EQ(doubled.samples[0], 0.5f);
  EXPECT_FLOAT_EQ(doubled.samples[1], -1.0f);
  EXPECT_DOUBLE_EQ(factor_of_decibels(-20.0), 0.1);
  EXPECT_DOUBLE_EQ(decibels_of(0.1), -20.0);
  EXPECT_DOUBLE_EQ(sample_peak(doubled), 1.0);
  EXPECT_DOUBLE_EQ(sample_peak(Sound{}), 0.0);
}

TEST(Sound, HashTellsSamplesAndChannelsApart) {
  const Sound one{1, {0.1f, 0.2f}};
  EXPECT_EQ(hash_of(one), hash_of(Sound{1, {0.1f, 0.2f}}));
  EXPECT_NE(hash_of(one), hash_of(Sound{1, {0.2f, 0.1f}}));
  EXPECT_NE(hash_of(one), hash_of(Sound{2, {0.1f, 0.2f}}));
}

TEST(Sound, WaveformHasTheRangeOfEachStretch) {
  const Sound sound{2, {0.1f, -0.1f, 0.5f, 0.0f, -0.7f, 0.2f, 0.3f, 0.3f}};
  const std::vector<SampleRange> ranges = waveform(sound, 2);
  ASSERT_EQ(ranges.size(), 2u);
  EXPECT_EQ(ranges[0].least, -0.1f);
  EXPECT_EQ(ranges[0].most, 0.5f);
  EXPECT_EQ(ranges[1].least, -0.7f);
  EXPECT_EQ(ranges[1].most, 0.3f);
  EXPECT_EQ(waveform(Sound{1, {0.4f}}, 3)[2].most, 0.4f);
  EXPECT_EQ(waveform(Sound{}, 3)[2].most, 0.0f);
}

}  // namespace
}  // namespace mien::render
