#include "pipeline/production/clips/people_clips.h"

#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/skeleton/body.h"

namespace mien::pipeline {
namespace {

/// A clip whose frame f is f metres along z.
motion::Clip counted(int frames, bool loops) {
  motion::Clip clip;
  clip.body = motion::standard_body();
  clip.frames_per_second = 10.0;
  clip.loops = loops;
  for (int f = 0; f < frames; ++f) {
    motion::Pose pose;
    pose.root_position = {0.0, 1.0, static_cast<double>(f)};
    pose.rotations.assign(clip.body.joints.size(), motion::Quat::Identity());
    clip.poses.push_back(pose);
  }
  if (loops) clip.cycle_displacement = {0.0, 0.0, static_cast<double>(frames)};
  return clip;
}

/// Given motions, not equalized.
class GivenMotions : public FinishedMotions {
 public:
  explicit GivenMotions(std::map<std::string, motion::Clip> clips) : clips_(std::move(clips)) {}

  const Stimulus* stimulus(const std::string&) const override { return nullptr; }
  const motion::Clip& clip(const std::string& name) override { return clips_.at(name); }
  motion::Clip shown(const Stimulus& stimulus) override {
    return playback_clip(clip(stimulus.id), stimulus.output);
  }
  int shown_frames(const Stimulus& stimulus) override { return own_frames(stimulus, *this); }
  void know_shortest(double) override {}

 private:
  std::map<std::string, motion::Clip> clips_;
};

Stimulus with_starts(double a, double b) {
  Stimulus stimulus;
  stimulus.id = "s";
  stimulus.output.fps = 10.0;
  stimulus.output.cycles = 2;
  for (const auto& [name, start] : {std::pair("a", a), std::pair("b", b)}) {
    Person person;
    person.name = name;
    person.start = start;
    person.motion.id = std::string("s.") + name;
    person.motion.output = stimulus.output;
    stimulus.people.push_back(person);
  }
  return stimulus;
}

std::string frames_of(const motion::Clip& clip) {
  std::string text;
  for (const motion::Pose& pose : clip.poses)
    text += std::to_string(static_cast<int>(std::lround(pose.root_position.z()))) + " ";
  return text;
}

TEST(PeopleClips, LastAsLongAsTheLastOfThem) {
  GivenMotions motions({{"s.a", counted(4, false)}, {"s.b", counted(6, false)}});
  const Stimulus stimulus = with_starts(0.3, 0.0);
  EXPECT_EQ(own_frames(stimulus, motions), 7);
  const std::vector<motion::Clip> clips = people_clips(stimulus, motions);
  ASSERT_EQ(clips.size(), 2u);
  EXPECT_EQ(frames_of(clips[0]), "0 0 0 0 1 2 3 ");
  EXPECT_EQ(frames_of(clips[1]), "0 1 2 3 4 5 5 ");
}

TEST(PeopleClips, BeginWithinMotionsThatBeganBefore) {
  GivenMotions motions({{"s.a", counted(6, false)}, {"s.b", counted(3, false)}});
  const std::vector<motion::Clip> clips = people_clips(with_starts(-0.2, 0.0), motions);
  EXPECT_EQ(frames_of(clips[0]), "2 3 4 5 ");
  EXPECT_EQ(frames_of(clips[1]), "0 1 2 2 ");
}

TEST(PeopleClips, RepeatLoopsForAsLongAsTheFilmLasts) {
  GivenMotions motions({{"s.a", counted(3, true)}, {"s.b", counted(10, false)}});
  const std::vector<motion::Clip> clips = people_clips(with_starts(0.1, 0.0), motions);
  EXPECT_EQ(frames_of(clips[0]), "0 0 1 2 3 4 5 6 7 8 ");
  EXPECT_EQ(frames_of(clips[1]), "0 1 2 3 4 5 6 7 8 9 ");
  // Two cycles, where nobody else takes longer.
  GivenMotions loops({{"s.a", counted(3, true)}, {"s.b", counted(2, false)}});
  EXPECT_EQ(own_frames(with_starts(0.0, 0.0), loops), 6);
}

TEST(PeopleClips, AreRefusedIfOneHasEndedBefore) {
  GivenMotions motions({{"s.a", counted(3, false)}, {"s.b", counted(9, false)}});
  EXPECT_EQ(own_frames(with_starts(-0.2, 0.0), motions), 9);
  try {
    people_clips(with_starts(-0.3, 0.0), motions);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("the motion of \"a\" ends before the film begins"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace mien::pipeline
