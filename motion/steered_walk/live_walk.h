#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "motion/procedural/builtin_sets.h"
#include "motion/steered_walk/steered_walk.h"

namespace mien::motion {

/// User input for a walker.
struct WalkRequest {
  double pace = 0.0;  ///< share of the mood's own speed: 0 stops, 1 walks, up to 1.2; else clamped
  std::optional<double> heading_deg;  ///< to face, about +Y from +Z; turns the shorter way
  double turn_deg_s = 0.0;            ///< °/s to the left, if no heading is requested
  std::vector<double> moods;  ///< weights ≥ 0, one for each mood, normalised; empty: the first mood
};

/// An interactive walker that can run indefinitely, in real time: a pose in some 50 µs, without
/// threads, files or memory that grows. Moods are versions of every one of its motions, in
/// correspondence, and are interpolated while it walks, tempo too.
///
/// It goes by footsteps that are planned as it walks (steered_walk.h), not over a motion graph: in
/// a graph a new request waits for the next transition, some tenths of a second and up to a step or
/// two, and a change of mood for motions that differ only in it. Graphs are for captures.
struct LiveWalk {
  std::vector<std::string> moods;
  WalkerGaits gaits;
  SteeredWalk walker;
};

/// A walker that stands at the origin and faces +Z. Throws mien::Error without moods, and as
/// `fit_walker` (walker_gaits.h). Takes some 60 ms a mood.
LiveWalk make_live_walk(std::span<const NamedStyle> moods, const Skeleton& body);

/// Advances the walker by `seconds`, at most a quarter of a second (longer after a page was
/// hidden), and returns its pose. Throws mien::Error for a negative time or non-finite numbers and
/// leaves the walker unchanged.
Pose advance(LiveWalk& walk, double seconds, const WalkRequest& request);

}  // namespace mien::motion
