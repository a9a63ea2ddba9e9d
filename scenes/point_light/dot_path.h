#pragma once

#include <vector>

#include "motion/math/geometry.h"

namespace mien::scenes {

/// Where a dot is, frame by frame; metres.
using DotPath = std::vector<motion::Vec3>;

// Manipulations of the motion of single dots.

/// Last frame first.
DotPath reversed(const DotPath& path);

/// The same path at constant speed: equal arc length from frame to frame. The ends stay.
DotPath at_constant_speed(const DotPath& path);

/// Shifted cyclically: begins `frames` later, and the beginning follows the end.
DotPath delayed(const DotPath& path, int frames);

/// Removes, or adds, a translation of `step` metres a frame.
DotPath without_travel(const DotPath& path, const motion::Vec3& step);
DotPath with_travel(const DotPath& path, const motion::Vec3& step);

/// Translated as a whole.
DotPath shifted(const DotPath& path, const motion::Vec3& shift);

/// Mirrored in the vertical plane through `centre` with the unit normal `across`.
DotPath mirrored(const DotPath& path, const motion::Vec3& centre, const motion::Vec3& across);

/// Inverted (upside down) about the horizontal plane at `height`.
DotPath inverted(const DotPath& path, double height);

/// Rotated about the vertical axis through `centre`, counter-clockwise seen from above.
DotPath rotated(const DotPath& path, const motion::Vec3& centre, double degrees);

/// Arc length of the path, metres.
double length_of(const DotPath& path);

}  // namespace mien::scenes
