#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "motion/formats/c3d/c3d_parameters.h"
#include "motion/skeleton/recording.h"

namespace mien::motion {

/// World transforms of a segment, one a frame; empty if the segment is in no frame.
struct SegmentMotion {
  std::string name;
  std::vector<JointTransform> transforms;
  std::size_t missing = 0;  ///< frames in which the file does not have the segment
};

/// The label without "_4X4".
std::string segment_name(std::string_view label);

/// Whether a label of Theia is none of a body's segment: "worldbody", "pelvis_shifted".
bool is_no_segment(std::string_view name);

/// Sets skeleton, poses and notes of a recording from its segments, as parse_c3d_rotations (c3d.h)
/// describes. Throws mien::Error if no segment has transforms.
void set_segments(const C3dFile& file, std::vector<SegmentMotion> segments, Recording& recording);

}  // namespace mien::motion
