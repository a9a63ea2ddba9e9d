#include "pipeline/production/run/shown_moods.h"

#include <algorithm>
#include <cmath>

#include "motion/skeleton/straighten.h"
#include "pipeline/production/film/film_presentation.h"

namespace mien::pipeline {

namespace {

/// The moods by time of the film, as long as that lasts.
std::vector<ShownMood> moods_of_film(Motions& motions, const Stimulus& stimulus,
                                     const motion::Clip& shown) {
  std::vector<ShownMood> moods = motions.of(stimulus.id).moods;
  const double seconds = shown.frame_count() / shown.frames_per_second;
  std::erase_if(moods, [&](const ShownMood& mood) { return mood.from_s >= seconds; });
  if (moods.size() < 2) moods.clear();
  return moods;
}

double seconds_before(const Stimulus& stimulus, const motion::Clip& shown) {
  const Output& output = stimulus.output;
  return frames_of(output.presentation, output.fps, shown.frame_count()).before() / output.fps;
}

}  // namespace

std::vector<ShownMood> shown_moods(Motions& motions, const Stimulus& stimulus) {
  if (!stimulus.walk) return {};
  const motion::Clip shown = motions.shown(stimulus);
  std::vector<ShownMood> moods = moods_of_film(motions, stimulus, shown);
  for (std::size_t i = 1; i < moods.size(); ++i) moods[i].from_s += seconds_before(stimulus, shown);
  return moods;
}

std::vector<MoodStretch> mood_stretches(Motions& motions, const Stimulus& stimulus,
                                        double least_s) {
  if (!stimulus.walk) return {};
  const motion::Clip shown = motions.shown(stimulus);
  const motion::Clip& walk = motions.of(stimulus.id).motion.clip;
  const double rate = shown.frames_per_second;
  const int frames = shown.frame_count();
  const auto least = static_cast<int>(std::ceil(least_s * rate));
  std::vector<int> starts;
  for (const ShownMood& mood : moods_of_film(motions, stimulus, shown)) {
    const auto first = static_cast<int>(std::lround(mood.from_s * rate));
    if (starts.empty() || (first - starts.back() >= least && frames - first >= least))
      starts.push_back(first);
  }
  if (starts.size() < 2) return {};
  std::vector<MoodStretch> stretches;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const int last = i + 1 < starts.size() ? starts[i + 1] : frames - 1;
    MoodStretch stretch;
    stretch.from_s = i == 0 ? 0.0 : starts[i] / rate + seconds_before(stimulus, shown);
    stretch.motion.name = stimulus.id;
    stretch.motion.clip = motion::straightened(motion::cut(walk, starts[i], last));
    stretch.motion.keytimes = {0.0, stretch.motion.clip.duration_seconds()};
    stretches.push_back(std::move(stretch));
  }
  return stretches;
}

}  // namespace mien::pipeline
