#pragma once

#include <optional>
#include <vector>

#include "motion/gait/gait.h"
#include "motion/skeleton/example.h"

namespace mien::motion {

enum class CycleChoice {
  automatic,       ///< the steadiest gait cycle, or the whole clip if it contains none
  whole,           ///< the whole clip, not looped
  start_peak_end,  ///< the whole clip, with a middle keytime where a hand or foot is farthest out
};

struct FrameRange {
  int first = 0;
  int last = 0;  ///< inclusive
};

struct ExampleOptions {
  CycleChoice cycle = CycleChoice::automatic;
  /// A manual cycle, used as it is: frame `last` is one cycle after `first`.
  std::optional<FrameRange> frames;
  std::vector<double> keytimes;  ///< manual, seconds, ascending; empty: detected
};

/// A motion prepared for blending, and the part of the clip it was cut from.
struct PreparedExample {
  Example example;                 ///< `example.clip.name` remains that of the take
  std::optional<GaitCycle> cycle;  ///< the gait cycle of the example; none if it has no gait cycle
  FrameRange frames;               ///< the frames of the take that were used
};

/// Prepares a clip for blending.
///
/// - By default, one gait cycle is cut out. If it is a detected cycle of two steps, the cut is made
///   at the frames with the lowest seam cost (gait/loop.h) up to 3 away from its ends. The cycle is
///   closed into a loop that begins at the left heel strike, and straightened (along +Z from the
///   origin); its feet rest on the floor, and it has the 7 keytimes of gait.h.
/// - A clip without a gait cycle is used whole and straightened, and so is every clip with a
///   `CycleChoice` other than automatic. Its keytimes are the start, the minima of speed
///   (`speed_minima`) and the end or, with start_peak_end, the start, `peak_seconds` and the end.
/// - A clip that loops is straightened but not cut. If it has no gait cycle, its keytimes are its
///   start and its end.
/// - With manual keytimes, whatever the other options, the part of the clip from the first keytime
///   to the last is used and straightened.
///
/// Throws Error naming the clip if it has fewer than two frames; if manual frames lie outside it,
/// are less than 8 apart or contain no gait cycle; if manual keytimes are fewer than two, lie
/// outside it or are less than one frame apart; or if, with start_peak_end, no hand or foot moves
/// far enough to have a peak.
PreparedExample prepare_example(const Clip& clip, const ExampleOptions& options = {});

Example make_example(const Clip& clip, const ExampleOptions& options = {});

/// Reduces the keytimes of examples that do not loop to the same number, as blending requires. The
/// number is that of the example with the fewest; every example keeps its start, its end and its
/// deepest pauses.
void even_keytimes(std::vector<Example>& examples);

/// The peak of a motion, seconds: the time at which a hand or foot (relative to the pelvis,
/// low-pass filtered at 3 Hz) is farthest from where it would be if it moved straight from its
/// first position to its last at constant velocity. At least two frames from either end; empty if
/// this distance is never more than 2 cm.
std::optional<double> peak_seconds(const Clip& clip);

/// A pause of a motion: a local minimum of speed.
struct SpeedMinimum {
  double seconds = 0.0;
  double depth = 0.0;  ///< m/s; prominence of the minimum (peaks.h)
};

/// The pauses of a clip: minima of the maximum speed of hands and feet relative to the pelvis
/// (low-pass filtered at 3 Hz), at least 0.2 s from either end and with a depth of at least a
/// quarter of the top speed.
std::vector<SpeedMinimum> speed_minima(const Clip& clip);

}  // namespace mien::motion
