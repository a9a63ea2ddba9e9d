#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "motion/points/length_unit.h"

namespace mien::motion {

/// The names of the axes in columns.
inline constexpr char axis_letters[] = "xyz";

/// What the name of a column says of a coordinate.
struct AxisName {
  std::string_view base;  ///< what the coordinate is of: "nose"; may be empty
  int axis = 0;           ///< 0, 1, 2 for x, y, z; 3 for w of a quaternion
  std::optional<LengthUnit> unit = {};
};

/// Reads "nose_x", "nose.X", "nose x", "nose:x", "noseX", "x_nose", "X", and these with a unit:
/// "nose_x (mm)", "nose_x_m". "nose_pos_x" is of "nose". Without brackets only metres, centimetres
/// and millimetres are units: "x_left_foot" is of the left foot.
std::optional<AxisName> axis_name(std::string_view name);

/// Whether a base is of values that are no positions: "hip_rot", "hand velocity", "quat".
bool is_other_quantity(std::string_view base);

/// What a column is of, apart from coordinates.
enum class ColumnUse { frame, time, point, subject, model, trajectory, other };

struct NamedColumn {
  ColumnUse use = ColumnUse::other;
  double seconds_per_unit = 1.0;  ///< of a time
  bool has_unit = false;          ///< whether the name states the unit of time
};

/// Reads "Frame#", "frame_number"; "time", "Time (Seconds)", "t_ms", "timestamp"; "keypoint",
/// "marker name"; "subject", "person_id".
NamedColumn named_column(std::string_view name);

}  // namespace mien::motion
