#pragma once

#include <vector>

#include "motion/math/geometry.h"

namespace mien::scenes {

/// Where a dot is, frame by frame; metres.
using DotPath = std::vector<motion::Vec3>;

// What studies do to the motion of single dots.

/// Last frame first.
DotPath reversed(const DotPath& path);

/// The same way, gone evenly: the same arc length from frame to frame. Ends stay.
DotPath at_constant_speed(const DotPath& path);

/// Begun `frames` later, what is missing at the end taken from the beginning.
DotPath begun_later(const DotPath& path, int frames);

/// Without, or with, a way of `step` metres a frame.
DotPath without_travel(const DotPath& path, const motion::Vec3& step);
DotPath with_travel(const DotPath& path, const motion::Vec3& step);

/// Shifted as a whole.
DotPath shifted(const DotPath& path, const motion::Vec3& shift);

/// In the upright mirror through `centre` whose normal is the unit vector `across`.
DotPath mirrored(const DotPath& path, const motion::Vec3& centre, const motion::Vec3& across);

/// Upside down about the level `height`.
DotPath inverted(const DotPath& path, double height);

/// Turned about the vertical through `centre`, counter-clockwise seen from above.
DotPath rotated(const DotPath& path, const motion::Vec3& centre, double degrees);

/// Length of the way, metres.
double length_of(const DotPath& path);

}  // namespace mien::scenes
