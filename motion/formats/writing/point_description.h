#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "motion/points/point_recording.h"

namespace mien::motion {

/// Adds what a file of points does not say itself to its description: `axes`, frames_per_second,
/// frames, points (their names in order), source (its name, format and unit), and where there are
/// any subject, events (label, context, seconds) and notes of the reader.
void add_description(const PointRecording& points, const std::string& axes,
                     nlohmann::ordered_json& json);

/// The frame rate in the description beside a file of points ("walk.csv.json" beside "walk.csv" or
/// "walk.CSV"); none if there is no such file, or if it is another JSON, without `points`. Throws
/// mien::Error with its path if it is no JSON or `frames_per_second` is not a number above 0.
std::optional<double> described_rate(const std::filesystem::path& points);

}  // namespace mien::motion
