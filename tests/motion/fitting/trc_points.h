#pragma once

#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "motion/points/point_recording.h"

namespace mien::motion::test {

/// A TRC file whose missing values are "NaN" or empty cells; enough for OpenSim's examples.
inline PointRecording trc_points(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, '\t');) rows.back().push_back(cell);
  }
  const auto number = [](const std::string& cell) {
    std::istringstream text(cell);
    text.imbue(std::locale::classic());
    double value = 0.0;
    return text >> value ? value : std::nan("");
  };
  PointRecording recording;
  recording.name = path.stem().string();
  recording.format = "trc";
  recording.unit = "mm";
  recording.metres_per_unit = 0.001;
  for (std::size_t cell = 2; cell < rows[3].size(); ++cell) {
    if (!rows[3][cell].empty()) recording.points.push_back(rows[3][cell]);
  }
  std::vector<double> times;
  for (std::size_t row = 5; row < rows.size(); ++row) {
    if (rows[row].size() < 2) continue;
    times.push_back(number(rows[row][1]));
    for (std::size_t point = 0; point < recording.points.size(); ++point) {
      Vec3 place = Vec3::Constant(std::nan(""));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t cell = 2 + 3 * point + axis;
        if (cell < rows[row].size()) place[static_cast<int>(axis)] = number(rows[row][cell]);
      }
      const bool seen = place.allFinite();
      recording.positions.push_back(seen ? place : Vec3::Zero());
      recording.seen.push_back(seen);
    }
  }
  recording.frames_per_second =
      static_cast<double>(times.size() - 1) / (times.back() - times.front());
  return recording;
}

}  // namespace mien::motion::test
