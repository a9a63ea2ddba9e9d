#include "pipeline/production/clips/people_clips.h"

#include <algorithm>
#include <cmath>

#include "motion/error.h"
#include "motion/skeleton/clip_markers.h"

namespace mien::pipeline {

namespace {

/// Frames by which a person's motion begins after the film.
int delay_of(const Person& person, const Output& output) {
  return static_cast<int>(std::lround(person.start * output.fps));
}

/// Frames of the film at which the person's motion has ended.
int end_of(const Person& person, const Output& output, FinishedMotions& motions) {
  const int end = delay_of(person, output) +
                  playback_clip(motions.clip(person.motion.id), output).frame_count();
  if (end > 0) return end;
  throw Error("the motion of \"" + person.name + "\" ends before the film begins",
              "give it a later start");
}

/// The clip whose frame f is the frame f − delay of `clip`, or its nearest.
motion::Clip delayed(const motion::Clip& clip, int delay, int frames) {
  motion::Clip shown = clip;
  shown.poses.clear();
  std::vector<double> moments;
  for (int f = 0; f < frames; ++f) {
    const int at = std::clamp(f - delay, 0, clip.frame_count() - 1);
    shown.poses.push_back(clip.poses[static_cast<std::size_t>(at)]);
    moments.push_back(at);
  }
  motion::carry_markers_at(clip, shown, moments);
  return shown;
}

motion::Clip person_clip(const Person& person, Output output, FinishedMotions& motions,
                         int frames) {
  const motion::Clip& made = motions.clip(person.motion.id);
  const int delay = delay_of(person, output);
  if (made.loops) output.cycles = std::max(1, (frames - delay - 1) / made.frame_count() + 1);
  return delayed(playback_clip(made, output), delay, frames);
}

}  // namespace

int own_frames(const Stimulus& stimulus, FinishedMotions& motions) {
  if (stimulus.people.empty())
    return playback_clip(motions.clip(stimulus.id), stimulus.output).frame_count();
  int frames = 0;
  for (const Person& person : stimulus.people)
    frames = std::max(frames, end_of(person, stimulus.output, motions));
  return frames;
}

std::vector<motion::Clip> people_clips(const Stimulus& stimulus, FinishedMotions& motions) {
  const int frames = motions.shown_frames(stimulus);
  std::vector<motion::Clip> clips;
  for (const Person& person : stimulus.people)
    clips.push_back(person_clip(person, stimulus.output, motions, frames));
  return clips;
}

}  // namespace mien::pipeline
