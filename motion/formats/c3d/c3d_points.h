#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "motion/formats/c3d/c3d_layout.h"
#include "motion/points/point_recording.h"

namespace mien::motion {

/// Reads positions into a recording (`positions` and `seen`): of every frame the points at
/// `columns`, each less than `layout.points`. `layout` is one of c3d_layout: its frames are in the
/// file. Which points count as missing: c3d.h. Throws mien::Error for a position beyond 1e12.
void read_c3d_points(const C3dFile& file, const C3dLayout& layout,
                     std::span<const std::size_t> columns, PointRecording& recording);

/// The events of the EVENT group, or else of the header, in the order of their times. `subject`: if
/// not empty, only events of this person and events of nobody.
std::vector<PointEvent> c3d_events(const C3dFile& file, const C3dLayout& layout,
                                   const std::string& subject);

}  // namespace mien::motion
