#include "render/sound/sound_match.h"

#include <gtest/gtest.h>

#include "render/sounds.h"

namespace mien::render {
namespace {

using test::noise;
using test::silence;
using test::tone;

Sound shifted(const Sound& sound, std::int64_t by) {
  return placed(sound, {.offset = by < 0 ? -by : 0,
                        .begin = std::max(by, std::int64_t{0}),
                        .length = sound.frames()});
}

Sound added(Sound a, const Sound& b) {
  for (std::size_t i = 0; i < a.samples.size(); ++i) a.samples[i] += b.samples[i];
  return a;
}

TEST(SoundMatch, MeasuresShiftsOfSingleSampleFrames) {
  for (const int channels : {1, 2}) {
    const Sound written = noise(0.3, 30'000, channels);
    for (const std::int64_t shift : {-2400, -100, -1, 0, 1, 2, 48, 2400}) {
      const SoundMatch match = match_sounds(written, shifted(written, shift));
      EXPECT_EQ(match.offset_frames, shift);
      EXPECT_GT(match.correlation, 0.99);
    }
  }
}

TEST(SoundMatch, FindsTheShiftOfALowVoiceUnderNoise) {
  // Two partials of a low voice, which begin at some time, and a coder's noise 30 dB below.
  const Sound voice = placed(added(tone(110, 0.3, 40'000), tone(337, 0.2, 40'000)),
                             {.begin = 5'000, .length = 45'000});
  for (const std::int64_t shift : {-3, -1, 0, 1, 3}) {
    const SoundMatch match = match_sounds(voice, added(shifted(voice, shift), noise(0.01, 45'000)));
    EXPECT_EQ(match.offset_frames, shift);
  }
}

TEST(SoundMatch, TakesAPeriodicSoundAsItIs) {
  const Sound sound = tone(1000, 0.5, 96'000);
  EXPECT_EQ(match_sounds(sound, added(sound, noise(0.001, 96'000))).offset_frames, 0);
}

TEST(SoundMatch, TakesALowToneWithAnotherPhaseAsItIs) {
  // 0.6 sample frames late, as codecs' filters make it.
  const Sound written = tone(200, 0.4, 48'000);
  Sound later = written;
  for (std::size_t i = 1; i < later.samples.size(); ++i)
    later.samples[i] = 0.4f * written.samples[i] + 0.6f * written.samples[i - 1];
  EXPECT_EQ(match_sounds(written, later).offset_frames, 0);
}

TEST(SoundMatch, TellsOtherSoundsApart) {
  const Sound sound = noise(0.3, 30'000);
  EXPECT_LT(std::abs(match_sounds(sound, tone(440, 0.3, 30'000)).correlation), 0.1);
  EXPECT_EQ(match_sounds(sound, silence(30'000)).correlation, 0.0);
}

TEST(SoundMatch, MeasuresNoShiftInSilence) {
  const SoundMatch match = match_sounds(silence(1000), silence(1000));
  EXPECT_FALSE(match.offset_frames);
  EXPECT_EQ(match.correlation, 1.0);
  EXPECT_EQ(match_sounds(silence(1000), tone(440, 0.5, 1000)).correlation, 0.0);
}

TEST(SoundMatch, TakesShortSoundsWhole) {
  Sound click = silence(100);
  test::add_click(click, 40);
  EXPECT_EQ(match_sounds(click, shifted(click, 7)).offset_frames, 7);
}

}  // namespace
}  // namespace mien::render
