#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "motion/points/point_recording.h"

namespace mien::motion {

/// Adds what a file of points does not say itself to its description: `axes`, frames_per_second,
/// frames, points (their names in order), source (its name, format and unit), and where there are
/// any subject, events (label, context, seconds) and notes of the reader.
void add_description(const PointRecording& points, const std::string& axes,
                     nlohmann::ordered_json& json);

}  // namespace mien::motion
