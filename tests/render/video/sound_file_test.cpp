#include "render/video/sound_file.h"

#include <gtest/gtest.h>

#include "pipeline/temporary_folder.h"
#include "render/file_damage.h"
#include "render/refusal.h"
#include "render/sounds.h"
#include "render/video/video.h"
#include "render/video_frames.h"

namespace mien::render {
namespace {

using test::add_click;
using test::loudest_frame;
using test::noise;
using test::refusal_of;
using test::silence;
using test::smooth_frames;
using test::tone;
using test::write_encoded;
using test::write_wav;

class SoundFileTest : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& name) const { return temporary.path() / name; }

  /// Writes a video of 20 frames, 1 s, with a sound.
  VideoReceipt write_film(const std::filesystem::path& path, VideoKind kind, const Sound& sound) {
    VideoWriter video(path, {.width = 64, .height = 48, .rate = {20, 1}, .kind = kind}, &sound);
    for (const Image8& frame : smooth_frames(64, 48, 20)) video.write(frame);
    video.finish();
    return video.receipt();
  }

  mien::test::TemporaryFolder temporary;
};

constexpr VideoKind kinds_with_sound[] = {VideoKind::mp4, VideoKind::mp4_lossless, VideoKind::webm,
                                          VideoKind::webm_av1, VideoKind::mkv};

/// One second with clicks at 0.25 and 0.75 s and in the last milliseconds.
Sound clicks(int channels = 1) {
  Sound sound = silence(sound_rate, channels);
  for (const int frame : {12'000, 36'000, 47'900}) add_click(sound, frame);
  return sound;
}

TEST_F(SoundFileTest, ReadsWavSampleBySample) {
  for (const int channels : {1, 2}) {
    const Sound sound = noise(0.4, 10'007, channels);
    write_wav(file("a.wav"), sound);
    const Sound read = read_sound(file("a.wav"));
    ASSERT_EQ(read.channels, channels);
    ASSERT_EQ(read.frames(), sound.frames());
    for (std::size_t i = 0; i < sound.samples.size(); ++i)
      ASSERT_NEAR(read.samples[i], sound.samples[i], 1e-4) << i;
  }
}

TEST_F(SoundFileTest, ReadsEachFormatWithItsFirstSampleAtZero) {
  const std::pair<const char*, const char*> formats[] = {
      {"a.flac", "flac"}, {"a.opus", "libopus"}, {"a.mp3", "libmp3lame"}};
  for (const auto& [name, encoder] : formats) {
    write_encoded(file(name), clicks(2), encoder);
    const Sound read = read_sound(file(name));
    EXPECT_EQ(read.channels, 2) << name;
    EXPECT_EQ(read.frames(), sound_rate) << name;
    EXPECT_EQ(loudest_frame(read, 0, 24'000), 12'000) << name;
    EXPECT_EQ(loudest_frame(read, 24'000, 40'000), 36'000) << name;
  }
}

TEST_F(SoundFileTest, ConvertsOtherRatesWithoutAShift) {
  for (const int rate : {8'000, 22'050, 44'100, 96'000}) {
    Sound source = silence(rate);
    source.samples[static_cast<std::size_t>(rate / 4)] = 0.9f;  // at 0.25 s
    write_wav(file("a.wav"), source, static_cast<std::uint32_t>(rate));
    const Sound read = read_sound(file("a.wav"));
    EXPECT_EQ(read.frames(), sound_rate) << rate;
    const double expected = sound_rate * static_cast<double>(rate / 4) / rate;
    EXPECT_NEAR(static_cast<double>(loudest_frame(read, 0, read.frames())), expected, 0.51) << rate;
  }
}

TEST_F(SoundFileTest, RefusesWhatIsNoSound) {
  std::ofstream(file("a.wav")) << "no sound";
  EXPECT_NE(refusal_of([&] {
              read_sound(file("a.wav"));
            }).find("a.wav: is not a sound file; save it as WAV, FLAC, Opus, Ogg Vorbis or MP3"),
            std::string::npos);
  EXPECT_NE(refusal_of([&] { read_sound(file("none.wav")); }).find("none.wav: opening"),
            std::string::npos);
  std::ofstream(file("list.wav")) << "ffconcat version 1.0\nfile a.wav\n";
  EXPECT_NE(refusal_of([&] { read_sound(file("list.wav")); }).find("is not a sound file"),
            std::string::npos);
  write_wav(file("three.wav"), silence(300, 3));
  EXPECT_NE(refusal_of([&] {
              read_sound(file("three.wav"));
            }).find("three.wav: has 3 channels; mix it down to one or two"),
            std::string::npos);
  write_wav(file("empty.wav"), silence(0));
  EXPECT_NE(refusal_of([&] { read_sound(file("empty.wav")); }).find("has no sound"),
            std::string::npos);
}

TEST_F(SoundFileTest, RefusesAFilmAsASound) {
  const Sound sound = clicks();
  write_film(file("a.mp4"), VideoKind::mp4, sound);
  EXPECT_NE(refusal_of([&] { read_sound(file("a.mp4")); }).find("is not a sound file"),
            std::string::npos);
}

TEST_F(SoundFileTest, RefusesASoundThatIsTooLong) {
  write_wav(file("long.wav"), silence(601 * 100), 100);  // 601 s at 100 Hz
  EXPECT_NE(refusal_of([&] {
              read_sound(file("long.wav"));
            }).find("lasts longer than 600 s; cut out what is to be heard"),
            std::string::npos);
}

TEST_F(SoundFileTest, ReadsOrRefusesDamagedFiles) {
  write_encoded(file("a.flac"), noise(0.3, 20'000), "flac");
  const std::vector<char> whole = test::bytes_of(file("a.flac"));
  for (std::size_t at = 0; at < whole.size(); at += whole.size() / 97 + 1) {
    std::vector<char> damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
    test::replace_bytes(file("b.flac"), damaged);
    try {
      EXPECT_GE(read_sound(file("b.flac")).channels, 1);
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("b.flac: "), std::string::npos);
    }
  }
}

TEST_F(SoundFileTest, ClicksOfAFilmSoundWhereTheyWereWritten) {
  for (const VideoKind kind : kinds_with_sound) {
    for (const int channels : {1, 2}) {
      const Sound sound = clicks(channels);
      const auto path = file("film" + std::string(traits_of(kind).ending));
      write_film(path, kind, sound);
      const auto found = sound_of_video(path);
      ASSERT_TRUE(found) << traits_of(kind).name;
      EXPECT_EQ(found->codec, sound_codec_of(kind));
      EXPECT_EQ(found->sound.channels, channels);
      // In MP4, the rest of a packet of AAC may follow.
      const std::int64_t more = found->sound.frames() - sound_rate;
      EXPECT_GE(more, 0) << traits_of(kind).name;
      EXPECT_LT(more, found->codec == "aac" ? 1024 : 1) << traits_of(kind).name;
      EXPECT_NEAR(found->start_seconds, 0.0, 0.00101) << traits_of(kind).name;
      EXPECT_EQ(loudest_frame(found->sound, 0, 24'000), 12'000) << traits_of(kind).name;
      EXPECT_EQ(loudest_frame(found->sound, 24'000, 47'000), 36'000) << traits_of(kind).name;
      EXPECT_EQ(loudest_frame(found->sound, 47'000, 48'000), 47'900) << traits_of(kind).name;
    }
  }
}

TEST_F(SoundFileTest, AFilmWithSoundHasTheFramesOfOneWithout) {
  const Sound sound = noise(0.2, sound_rate);
  for (const VideoKind kind : kinds_with_sound) {
    const auto with = file("with" + std::string(traits_of(kind).ending));
    const auto without = file("without" + std::string(traits_of(kind).ending));
    write_film(with, kind, sound);
    test::write_video(without, smooth_frames(64, 48, 20), {20, 1}, kind);
    EXPECT_EQ(probe(with).packet_hashes, probe(without).packet_hashes);
    EXPECT_EQ(probe(with).times, probe(without).times);
    EXPECT_DOUBLE_EQ(probe(with).duration_seconds, probe(without).duration_seconds);
    EXPECT_FALSE(sound_of_video(without));
  }
}

TEST_F(SoundFileTest, WritesTheSameBytesForTheSameSound) {
  const Sound sound = noise(0.2, sound_rate, 2);
  for (const VideoKind kind : kinds_with_sound) {
    const auto path = file("same" + std::string(traits_of(kind).ending));
    write_film(path, kind, sound);
    const std::vector<char> first = test::bytes_of(path);
    write_film(path, kind, sound);
    EXPECT_TRUE(test::bytes_of(path) == first) << traits_of(kind).name;
  }
}

TEST_F(SoundFileTest, ChecksWhatIsHeardInAFilm) {
  for (const VideoKind kind : kinds_with_sound) {
    for (const Sound& sound :
         {clicks(), noise(0.2, sound_rate, 2), tone(200, 0.4, sound_rate), silence(sound_rate)}) {
      const auto path = file("film" + std::string(traits_of(kind).ending));
      const VideoReceipt receipt = write_film(path, kind, sound);
      ASSERT_TRUE(receipt.sound);
      const SoundCheck check = check_sound(path, kind, sound, *receipt.sound);
      EXPECT_EQ(check.codec, sound_codec_of(kind));
      EXPECT_EQ(check.frames, sound_rate);
      EXPECT_EQ(check.hash, hash_of(sound));
      EXPECT_EQ(check.match.offset_frames.value_or(0), 0);
      EXPECT_GT(check.match.correlation, 0.8) << traits_of(kind).name;
    }
  }
}

TEST_F(SoundFileTest, RefusesAnotherSoundThanThatWritten) {
  const Sound sound = noise(0.2, sound_rate);
  const auto path = file("a.mp4");
  VideoReceipt receipt = write_film(path, VideoKind::mp4, sound);
  const auto refusal = [&](const Sound& written, const SoundReceipt& by) {
    return refusal_of([&] { check_sound(path, VideoKind::mp4, written, by); });
  };
  EXPECT_NO_THROW(check_sound(path, VideoKind::mp4, sound, *receipt.sound));
  EXPECT_NE(refusal(tone(440, 0.2, sound_rate), *receipt.sound)
                .find("a.mp4: the sound that was encoded is not the film's"),
            std::string::npos);
  SoundReceipt other = *receipt.sound;
  other.packet_hashes[3] ^= 1;
  EXPECT_NE(refusal(sound, other).find("is not in the bytes that it was encoded in"),
            std::string::npos);
  // One sample frame later, as if the encoder's delay were told wrong.
  const Sound later = placed(sound, {.begin = 1, .length = sound_rate});
  other = *receipt.sound;
  other.hash = hash_of(later);
  EXPECT_NE(refusal(later, other).find("the sound is shifted by -1 sample frames"),
            std::string::npos);
  const Sound foreign = tone(440, 0.2, sound_rate);
  other.hash = hash_of(foreign);
  EXPECT_NE(refusal(foreign, other), "");
  const Sound longer = placed(sound, {.length = sound_rate + 129});
  other.hash = hash_of(longer);
  EXPECT_NE(refusal(longer, other).find("48128 sample frames instead of 48129"), std::string::npos);
  test::write_video(path, smooth_frames(64, 48, 20), {20, 1});
  EXPECT_NE(refusal(sound, *receipt.sound).find("a.mp4: has no sound"), std::string::npos);
}

TEST_F(SoundFileTest, AnimatedPicturesHaveNoSound) {
  const Sound sound = silence(sound_rate);
  for (const VideoTraits& traits : video_kinds()) {
    EXPECT_EQ(sound_codec_of(traits.kind).empty(), traits.picture);
    if (!traits.picture) continue;
    EXPECT_NE(refusal_of([&] {
                VideoWriter(file("a"), {.width = 64, .height = 48, .kind = traits.kind}, &sound);
              }).find("this kind of video has no sound"),
              std::string::npos);
  }
}

// EBU Tech 3341 (2016), table 1, cases 1 and 2: a stereo sine of 1000 Hz for 20 s.
TEST(LoudnessTest, HasThePublishedValuesOfSines) {
  for (const double level : {-23.0, -33.0}) {
    const double amplitude = factor_of_decibels(level);
    const Loudness loudness = loudness_of(tone(1000, amplitude, 20 * sound_rate, 2));
    EXPECT_NEAR(loudness.integrated_lufs, level, 0.1);
    EXPECT_NEAR(loudness.true_peak_dbtp, level, 0.4);
  }
}

// EBU Tech 3341, table 1, case 3: quieter stretches are not counted.
TEST(LoudnessTest, LeavesOutQuietStretches) {
  Sound sound{2, {}};
  const std::pair<double, int> parts[] = {{-36.0, 10}, {-23.0, 60}, {-36.0, 10}};
  for (const auto& [level, seconds] : parts) {
    const Sound part = tone(1000, factor_of_decibels(level), seconds * sound_rate, 2);
    sound.samples.insert(sound.samples.end(), part.samples.begin(), part.samples.end());
  }
  EXPECT_NEAR(loudness_of(sound).integrated_lufs, -23.0, 0.1);
}

TEST(LoudnessTest, CountsOneChannelAsHeardFromTwoLoudspeakers) {
  const double amplitude = factor_of_decibels(-23.0);
  EXPECT_NEAR(loudness_of(tone(1000, amplitude, 5 * sound_rate, 1)).integrated_lufs, -23.0, 0.1);
}

// ITU-R BS.1770-4, annex 2: a sine at a quarter of the rate, whose samples miss its peaks by 3 dB.
TEST(LoudnessTest, MeasuresPeaksBetweenSamples) {
  Sound sound = silence(sound_rate);
  for (std::size_t i = 0; i < sound.samples.size(); ++i)
    sound.samples[i] = (i / 2 % 2 == 0 ? 0.5f : -0.5f);  // phase of 45°, 12 kHz
  EXPECT_NEAR(decibels_of(sample_peak(sound)), -6.02, 0.01);
  EXPECT_NEAR(loudness_of(sound).true_peak_dbtp, -3.01, 0.6);
}

TEST(LoudnessTest, HasNoLoudnessInSilence) {
  EXPECT_LT(loudness_of(silence(sound_rate)).integrated_lufs, -1000.0);
}

}  // namespace
}  // namespace mien::render
