#pragma once

#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"

namespace mien::pipeline {

/// The moods of a walk along a path, by time of its video, card, cross and blanks included, as
/// traces of continuous trials count it; those after the end of a shortened film are left out. The
/// first is at 0. Empty if the mood does not change, and for other stimuli.
std::vector<ShownMood> shown_moods(Motions& motions, const Stimulus& stimulus);

/// A part of a walk in one mood, and its time of the video, seconds.
struct MoodStretch {
  double from_s = 0.0;
  motion::Example motion;  ///< turned so that it leads along +Z
};

/// The parts of a walk between changes of its mood, of at least `least_s` seconds each; what is
/// shorter belongs to the part before it. Empty if the mood does not change.
std::vector<MoodStretch> mood_stretches(Motions& motions, const Stimulus& stimulus,
                                        double least_s = 1.0);

}  // namespace mien::pipeline
