#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "motion/procedural/builtin_sets.h"
#include "motion/steered_walk/steered_walk.h"

namespace mien::motion {

/// What somebody at the keys wants of the walker now.
struct WalkWish {
  double pace = 0.0;  ///< share of the mood's own speed: 0 stops, 1 walks, up to 1.2; else clamped
  std::optional<double> heading_deg;  ///< to face, about +Y from +Z; turned to the shorter way
  double turn_deg_s = 0.0;            ///< °/s to the left, when no heading is wanted
  std::vector<double> moods;  ///< weights ≥ 0, one a mood, divided by their sum; none: the first
};

/// A walker under control that can be played for ever, in real time: a pose in some 50 µs, without
/// threads, files or memory that grows. Moods are versions of every one of its motions, in
/// correspondence, and are interpolated while it walks, tempo too.
///
/// It goes by footsteps that are planned as it walks (steered_walk.h), not over a motion graph: in
/// a graph a new wish waits for the next transition, some tenths of a second and up to a step or
/// two, and a change of mood for motions that differ only in it. Graphs are for captures.
struct LiveWalk {
  std::vector<std::string> moods;
  WalkerGaits gaits;
  SteeredWalk walker;
};

/// A walker that stands at the origin and faces +Z. Throws mien::Error without moods, and as
/// `fit_walker` (walker_gaits.h). Takes some 60 ms a mood.
LiveWalk make_live_walk(std::span<const NamedStyle> moods, const Skeleton& body);

/// The pose `seconds` later. What is longer than a quarter of a second (a page that was out of
/// sight) counts as that. A time below 0, and numbers that are none, throw mien::Error; the walker
/// is then as it was.
Pose advance(LiveWalk& walk, double seconds, const WalkWish& wish);

}  // namespace mien::motion
