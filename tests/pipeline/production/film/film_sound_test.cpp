#include "pipeline/production/film/film_sound.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/temporary_folder.h"
#include "render/sounds.h"
#include "render/video/sound_file.h"

namespace mien::pipeline {
namespace {

using render::Sound;
using render::sound_rate;
using render::test::add_click;
using render::test::loudest_frame;
using render::test::silence;
using render::test::tone;

class FilmSoundTest : public testing::Test {
 protected:
  /// A stimulus of 20 frames per second with a sound.
  Stimulus stimulus(const Sound& sound, SoundLength length, double offset = 0.0) {
    render::test::write_wav(folder.path() / "sound.wav", sound);
    Stimulus result;
    result.id = "a";
    result.output.fps = 20.0;
    result.sound = {folder.path() / "sound.wav", offset, 0.0, length, "a"};
    return result;
  }

  static std::string error_of(const Stimulus& stimulus, int frames,
                              std::optional<double> target = std::nullopt) {
    try {
      film_sound(stimulus, target, frames);
    } catch (const Error& error) {
      return error.what();
    }
    ADD_FAILURE() << "nothing was refused";
    return "";
  }

  test::TemporaryFolder folder;
};

/// Clicks at 0.25, 0.5 and 1.5 s of 2 s.
Sound three_clicks() {
  Sound sound = silence(2 * sound_rate);
  for (const int frame : {12'000, 24'000, 72'000}) add_click(sound, frame);
  return sound;
}

TEST_F(FilmSoundTest, ThereIsNoneWithoutASound) { EXPECT_FALSE(film_sound(Stimulus(), {}, 10)); }

TEST_F(FilmSoundTest, AClickIsHeardAtItsTimeMinusTheOffset) {
  for (const double offset : {0.0, 0.125, -0.3}) {
    const auto made = film_sound(stimulus(three_clicks(), SoundLength::cut, offset), {}, 20);
    ASSERT_TRUE(made);
    EXPECT_EQ(made->sound.frames(), sound_rate);
    const auto shift = static_cast<std::int64_t>(std::lround(offset * sound_rate));
    EXPECT_EQ(loudest_frame(made->sound, 0, 18'000 - shift), 12'000 - shift);
    EXPECT_EQ(loudest_frame(made->sound, 18'000 - shift, sound_rate), 24'000 - shift);
    EXPECT_EQ(made->record.offset_s, offset);
  }
}

TEST_F(FilmSoundTest, BeginsWithTheFilmAndNotWithTheCard) {
  Stimulus film = stimulus(three_clicks(), SoundLength::cut);
  film.output.presentation.fixation_seconds = 0.5;
  film.output.presentation.blank_before = 0.25;
  film.output.presentation.blank_after = 1.0;
  const auto made = film_sound(film, {}, 20);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->sound.frames(), 132'000);  // 2.75 s
  EXPECT_EQ(loudest_frame(made->sound, 0, 50'000), 36'000 + 12'000);
  // The click at 1.5 s of the sound lies after the film.
  EXPECT_EQ(render::sample_peak(render::placed(made->sound, {.offset = 84'000, .length = 48'000})),
            0.0);
}

TEST_F(FilmSoundTest, ALongerSoundIsCutOrTheFilmHeld) {
  const auto cut = film_sound(stimulus(three_clicks(), SoundLength::cut), {}, 20);
  EXPECT_EQ(cut->held_frames, 0);
  EXPECT_NEAR(cut->record.cut_s, 1.0, 1e-9);
  EXPECT_EQ(cut->record.silence_s, 0.0);
  const auto held = film_sound(stimulus(three_clicks(), SoundLength::hold), {}, 20);
  EXPECT_EQ(held->held_frames, 20);
  EXPECT_EQ(held->record.held_frames, 20);
  EXPECT_EQ(held->sound.frames(), 2 * sound_rate);
  EXPECT_EQ(loudest_frame(held->sound, 48'000, 96'000), 72'000);
  EXPECT_EQ(held->record.cut_s, 0.0);
  // 1.98 s of sound: the last frame is held until after its end.
  const auto part = film_sound(stimulus(silence(95'040), SoundLength::hold), {}, 20);
  EXPECT_EQ(part->held_frames, 20);
  EXPECT_NEAR(part->record.silence_s, 0.02, 1e-9);
}

TEST_F(FilmSoundTest, AShorterSoundIsFollowedBySilence) {
  for (const SoundLength length : {SoundLength::cut, SoundLength::hold}) {
    const auto made = film_sound(stimulus(tone(440, 0.5, sound_rate / 2), length), {}, 20);
    EXPECT_EQ(made->held_frames, 0);
    EXPECT_EQ(made->sound.frames(), sound_rate);
    EXPECT_NEAR(made->record.silence_s, 0.5, 1e-9);
  }
}

TEST_F(FilmSoundTest, LengthsThatDifferByMoreThanHalfAFrameAreRefused) {
  for (const int excess : {-1199, 0, 1199}) {
    EXPECT_NO_THROW(film_sound(stimulus(silence(sound_rate + excess), SoundLength::error), {}, 20));
  }
  EXPECT_EQ(error_of(stimulus(silence(sound_rate + 1300), SoundLength::error), 20),
            "sound.wav lasts 1.027 s from its offset, but the film of \"a\" 1.000 s; set "
            "audio.length to hold or cut, or use another offset");
  EXPECT_EQ(error_of(stimulus(silence(sound_rate), SoundLength::error, 0.5), 20),
            "sound.wav lasts 0.500 s from its offset, but the film of \"a\" 1.000 s; set "
            "audio.length to hold or cut, or use another offset");
  EXPECT_EQ(error_of(stimulus(silence(sound_rate), SoundLength::cut, 1.0), 20),
            "sound.wav lasts 1.000 s, and its offset is 1.000 s; use a smaller audio.offset");
}

TEST_F(FilmSoundTest, GainIsAppliedAndOverloadRefused) {
  Stimulus film = stimulus(tone(440, 0.5, sound_rate), SoundLength::error);
  film.sound->gain = -6.0;
  const auto made = film_sound(film, {}, 20);
  EXPECT_NEAR(render::decibels_of(render::sample_peak(made->sound)), -12.02, 0.01);
  EXPECT_EQ(made->record.gain_db, -6.0);
  film.sound->gain = 7.0;
  EXPECT_EQ(
      error_of(film, 20),
      "sound.wav exceeds full scale by 1.0 dB with its gain; use an audio.gain of at most 6.0");
}

TEST_F(FilmSoundTest, LoudnessIsMeasuredAndEqualized) {
  const Stimulus film = stimulus(tone(1000, 0.1, sound_rate), SoundLength::error);
  const auto plain = film_sound(film, {}, 20);
  ASSERT_TRUE(plain->record.loudness_lufs && plain->record.true_peak_dbtp);
  EXPECT_NEAR(*plain->record.loudness_lufs, -20.0, 0.1);
  EXPECT_NEAR(*plain->record.true_peak_dbtp, -20.0, 0.2);
  for (const double target : {-23.0, -35.0, -15.0}) {
    const auto equal = film_sound(film, target, 20);
    EXPECT_NEAR(render::loudness_of(equal->sound).integrated_lufs, target, 0.01);
    EXPECT_NEAR(*equal->record.loudness_lufs, target, 0.01);
    EXPECT_NEAR(equal->record.gain_db, target - *plain->record.loudness_lufs, 0.01);
  }
}

TEST_F(FilmSoundTest, ATruePeakAboveMinusOneIsRefusedWithTheLoudnessThatIsPossible) {
  Sound sound = tone(1000, 0.02, 2 * sound_rate);
  for (int frame = 30'000; frame < 30'010; ++frame)
    sound.samples[static_cast<std::size_t>(frame)] = 0.9f;
  const Stimulus film = stimulus(sound, SoundLength::error);
  const std::string refused = error_of(film, 40, -23.0);
  EXPECT_NE(refused.find("at -23.0 LUFS, sound.wav has a true peak of "), std::string::npos);
  const std::string remedy = "equalize to at most ";
  ASSERT_NE(refused.find(remedy), std::string::npos) << refused;
  const double possible = std::stod(refused.substr(refused.find(remedy) + remedy.size()));
  const auto made = film_sound(film, possible, 40);
  EXPECT_LE(render::loudness_of(made->sound).true_peak_dbtp, most_true_peak_dbtp);
  EXPECT_GT(render::loudness_of(made->sound).true_peak_dbtp, most_true_peak_dbtp - 0.2);
}

TEST_F(FilmSoundTest, SilenceHasNoLoudness) {
  const Stimulus film = stimulus(silence(sound_rate), SoundLength::error);
  const auto made = film_sound(film, {}, 20);
  EXPECT_FALSE(made->record.loudness_lufs);
  EXPECT_FALSE(made->record.true_peak_dbtp);
  EXPECT_EQ(error_of(film, 20, -23.0).substr(0, 45),
            "the loudness of sound.wav cannot be measured:");
}

TEST_F(FilmSoundTest, AFileThatCannotBeReadIsTheUsersError) {
  Stimulus film = stimulus(silence(10), SoundLength::cut);
  film.sound->file = folder.path() / "none.wav";
  EXPECT_NE(error_of(film, 20).find("none.wav: opening"), std::string::npos);
}

}  // namespace
}  // namespace mien::pipeline
