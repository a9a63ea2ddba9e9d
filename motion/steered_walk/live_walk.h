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
  double pace = 0.0;  ///< relative to the mood's own speed: 0 stops, 1 walks; clamped to 0–1.2
  std::optional<double> heading_deg;  ///< about +Y from +Z; turns through the smaller angle
  double turn_deg_s = 0.0;    ///< °/s to the left, if no heading is requested; clamped to ±180
  std::vector<double> moods;  ///< weights ≥ 0, one per mood, of any sum; empty: the first mood
};

/// An interactive walker that can run indefinitely, in real time: about 50 µs per pose, without
/// threads, files or growing memory. Each mood is a walk style, fitted for standing and for several
/// paces; the moods are blended during the walk, including tempo.
///
/// It plans footsteps as it walks (steered_walk.h) instead of searching a motion graph: in a graph,
/// a new request has to wait for the next transition (some tenths of a second, up to a step or
/// two), and a change of mood requires motions that differ in mood only. Graphs are for captures.
struct LiveWalk {
  std::vector<std::string> moods;
  WalkerGaits gaits;
  SteeredWalk walker;
};

/// A walker that stands at the origin and faces +Z. Throws mien::Error without moods, and as
/// `fit_walker` (walker_gaits.h). Takes about 60 ms per mood.
LiveWalk make_live_walk(std::span<const NamedStyle> moods, const Skeleton& body);

/// Advances the walker by `seconds`, capped at a quarter of a second (longer intervals occur when a
/// page was hidden), and returns its pose. Throws mien::Error, and leaves the walker unchanged, for
/// a negative time, non-finite numbers, negative mood weights, and more weights than moods.
Pose advance(LiveWalk& walk, double seconds, const WalkRequest& request);

}  // namespace mien::motion
