#include "pipeline/regression/comparison/compared_sounds.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pipeline/regression/comparer.h"
#include "pipeline/temporary_folder.h"
#include "render/sounds.h"
#include "render/video_frames.h"

namespace mien::pipeline {
namespace {

using render::Sound;
using render::sound_rate;
using render::test::noise;
using render::test::tone;

class ComparedSounds : public testing::Test {
 protected:
  std::filesystem::path film(const std::string& name, const Sound* heard) {
    const std::filesystem::path file = folder.path() / name;
    render::VideoWriter video(
        file, {.width = 64, .height = 48, .rate = {10, 1}, .kind = *render::video_kind_of(file)},
        heard);
    for (const render::Image8& frame : render::test::smooth_frames(64, 48, 10)) video.write(frame);
    video.finish();
    return file;
  }

  /// The remarks, then the notes after "|".
  std::string told(const std::filesystem::path& before, const std::filesystem::path& now) {
    std::vector<std::string> remarks, notes;
    compare_sounds(before, now, remarks, notes);
    return fmt::format("{}|{}", fmt::join(remarks, ";"), fmt::join(notes, ";"));
  }

  std::string told(const Sound& before, const Sound& now) {
    return told(film("before.mp4", &before), film("now.mp4", &now));
  }

  test::TemporaryFolder folder;
  const Sound sound = noise(0.2, sound_rate);
};

TEST_F(ComparedSounds, SayNothingOfTheSameSoundOrNone) {
  EXPECT_EQ(told(sound, sound), "|");
  EXPECT_EQ(told(film("a.mp4", nullptr), film("b.mp4", nullptr)), "|");
  EXPECT_EQ(told(film("a.gif", nullptr), film("b.webp", nullptr)), "|");
}

TEST_F(ComparedSounds, TellASoundThatIsNewOrGone) {
  EXPECT_EQ(told(film("a.mp4", nullptr), film("b.mp4", &sound)), "has a sound now|");
  EXPECT_EQ(told(film("b.mp4", &sound), film("a.mp4", nullptr)), "no longer has a sound|");
}

TEST_F(ComparedSounds, TellAnotherSoundShiftDurationAndLoudness) {
  EXPECT_NE(told(sound, tone(440, 0.2, sound_rate)).find("another sound (correlation "),
            std::string::npos);
  const Sound later = render::placed(sound, {.begin = 48, .length = sound_rate});
  EXPECT_EQ(told(sound, later), "the sound is heard 1.00 ms later|");
  EXPECT_EQ(told(later, sound), "the sound is heard 1.00 ms earlier|");
  const Sound longer = render::placed(noise(0.2, 2 * sound_rate), {.length = 2 * sound_rate});
  EXPECT_NE(told(sound, longer).find(" s, and lasted "), std::string::npos);
  const Sound louder = render::placed(sound, {.length = sound_rate, .gain_db = 3.0});
  const std::string remark = told(sound, louder);
  EXPECT_TRUE(remark.starts_with("the sound has -")) << remark;
  EXPECT_NE(remark.find(" LUFS, and had -"), std::string::npos) << remark;
  EXPECT_EQ(told(sound, noise(0.2, sound_rate, 2)), "the sound has 2 channels, and had 1|");
}

TEST_F(ComparedSounds, NoteAnotherCodecOnly) {
  EXPECT_EQ(told(film("a.mp4", &sound), film("b.webm", &sound)), "|sound in opus instead of aac");
}

VideoFacts facts_with(std::optional<VideoSoundRecord> heard, const std::string& hash) {
  VideoFacts facts;
  facts.record = {.file = "videos/a.mp4",
                  .format = "mp4",
                  .frames = 10,
                  .fps = 10.0,
                  .duration_s = 1.0,
                  .identical = true,
                  .sound = std::move(heard)};
  facts.hash = hash;
  return facts;
}

TEST(VideoChanges, TellChangesOfTheSound) {
  const VideoSoundRecord sound{.codec = "aac",
                               .rate = sound_rate,
                               .channels = 1,
                               .frames = sound_rate,
                               .hash = "1",
                               .offset_frames = 0,
                               .correlation = 0.9};
  const auto change = [&](const std::optional<VideoSoundRecord>& before,
                          const std::optional<VideoSoundRecord>& now) {
    return video_changes({facts_with(before, "x")}, {facts_with(now, "y")}).at(0);
  };
  VideoSoundRecord other = sound;
  EXPECT_TRUE(change(sound, other).same_frames) << "only encoded otherwise";
  EXPECT_EQ(change(sound, other).what.front(), "different content");
  other.hash = "2";
  EXPECT_FALSE(change(sound, other).same_frames);
  EXPECT_EQ(change(sound, other).what.front(), "another sound");
  other.frames = 2 * sound_rate;
  EXPECT_EQ(change(sound, other).what.front().find("sound of 1"), 0u);
  EXPECT_EQ(change(sound, {}).what.front(), "no longer has a sound");
  EXPECT_FALSE(change({}, sound).same_frames);
}

}  // namespace
}  // namespace mien::pipeline
