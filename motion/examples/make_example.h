#pragma once

#include <optional>
#include <vector>

#include "motion/gait/gait.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

enum class CycleChoice {
  automatic,       ///< the steadiest gait cycle; the whole clip when it holds none
  whole,           ///< the whole clip as one performance, not looped
  start_peak_end,  ///< the whole clip, its middle keytime where hands and feet are farthest out
};

struct FrameRange {
  int first = 0;
  int last = 0;  ///< included
};

struct ExampleOptions {
  CycleChoice cycle = CycleChoice::automatic;
  std::optional<FrameRange> frames;  ///< a manually chosen cycle: `last` is `first` one cycle later
  std::vector<double> keytimes;      ///< manual, seconds, ascending; empty: detected
};

/// A motion prepared for blending, with what was cut from it.
struct PreparedExample {
  Example example;                 ///< `example.clip.name` stays that of the take
  std::optional<GaitCycle> cycle;  ///< that it was cut from; none for the whole clip
  FrameRange frames;               ///< of the take that it was made from
};

/// Prepares a clip: one gait cycle, cut within 3 frames of its heel strikes at the smallest seam,
/// closed to a loop, begun at the left heel strike and straightened (along +Z from the origin),
/// with the 7 keytimes of gait.h. Without a cycle: the whole clip straightened, with the keytimes
/// start, minima of speed (`speed_minima`), end; or start, `peak_seconds`, end. With keytimes by
/// hand: the performance from the first to the last of them, straightened.
///
/// Throws Error, naming the clip, when it has fewer than two frames, when frames or keytimes given
/// by hand lie outside it, hold no cycle or are not a frame apart, or when nothing moves that could
/// have a peak.
PreparedExample prepare_example(const Clip& clip, const ExampleOptions& options = {});

Example make_example(const Clip& clip, const ExampleOptions& options = {});

/// Makes the number of keytimes of performances (examples that do not loop) equal, as blending
/// requires: each keeps its start, its end and as many of its deepest pauses as the one with the
/// fewest has.
void even_keytimes(std::vector<Example>& examples);

/// The peak of a performance: the time of the largest distance of a hand or foot (relative to the
/// pelvis, below 3 Hz) from the straight line between its first and its last position. Seconds, at
/// least two frames from either end; none if nothing moves 2 cm away.
std::optional<double> peak_seconds(const Clip& clip);

/// A pause of a motion: a local minimum of speed.
struct SpeedMinimum {
  double seconds = 0.0;
  double depth = 0.0;  ///< m/s below the lower of the two maxima beside it
};

/// The pauses of a clip: minima of the speed of hands and feet relative to the pelvis (largest of
/// the four, below 3 Hz), at least 0.2 s from either end and a quarter of the top speed deep.
std::vector<SpeedMinimum> speed_minima(const Clip& clip);

}  // namespace mien::motion
