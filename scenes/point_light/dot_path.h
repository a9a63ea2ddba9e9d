#pragma once

#include <cstddef>
#include <vector>

#include "motion/math/geometry.h"

namespace mien::scenes {

/// The positions of a dot, one per frame; world space, metres.
using DotPath = std::vector<motion::Vec3>;

// Manipulations of the motion of single dots.

/// The path in reverse order: last frame first.
DotPath reversed(const DotPath& path);

/// A position on a path: at a frame, or a share of the way to the next one after it.
struct PathPlace {
  std::size_t frame = 0;
  double share = 0.0;  ///< [0, 1]
};

/// Where on the path each frame is when it is followed at constant speed: equal arc length from
/// frame to frame. Both ends stay in place.
std::vector<PathPlace> places_at_constant_speed(const DotPath& path);

/// The positions at these places.
DotPath at_places(const DotPath& path, const std::vector<PathPlace>& places);

/// The same path at constant speed.
DotPath at_constant_speed(const DotPath& path);

/// The path shifted cyclically: it begins with what was its point at index `frame`, and what came
/// before follows its end. An index outside the path is taken modulo its length.
DotPath begun_at(const DotPath& path, int frame);

/// The path with a translation of `step` metres per frame removed (without_travel) or added
/// (with_travel).
DotPath without_travel(const DotPath& path, const motion::Vec3& step);
DotPath with_travel(const DotPath& path, const motion::Vec3& step);

/// The path translated as a whole by `shift`, metres.
DotPath shifted(const DotPath& path, const motion::Vec3& shift);

/// The path mirrored in the vertical plane through `centre` with the unit normal `across`.
DotPath mirrored(const DotPath& path, const motion::Vec3& centre, const motion::Vec3& across);

/// The path inverted (upside down) about the horizontal plane at `height`, metres.
DotPath inverted(const DotPath& path, double height);

/// The path rotated about the vertical axis through `centre`, counter-clockwise seen from above.
DotPath rotated(const DotPath& path, const motion::Vec3& centre, double degrees);

/// Arc length of the path, metres.
double length_of(const DotPath& path);

}  // namespace mien::scenes
