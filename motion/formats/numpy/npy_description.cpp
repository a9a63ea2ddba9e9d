#include "motion/formats/numpy/npy_description.h"

#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "motion/formats/reading/json_text.h"
#include "motion/formats/writing/point_description.h"
#include "motion/text/compressed_file.h"
#include "motion/text/file_contents.h"

namespace mien::motion {

namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse(const std::string& file, const std::string& wrong) {
  throw Error({file}, wrong, "write it as mien does, or remove it and give fps: and joints:");
}

std::vector<std::string> names_in(const Json& points, const std::string& file) {
  std::vector<std::string> names;
  for (const Json& name : points) {
    if (!name.is_string()) refuse(file, "a name in points is not a text");
    names.push_back(name.get<std::string>());
  }
  return names;
}

}  // namespace

std::string npy_description(const PointRecording& points, const std::string& axes) {
  nlohmann::ordered_json json;
  json["description"] =
      "Positions of points over time: frames × points × 3 (x, y, z); NaN where a point is missing.";
  json["unit"] = points.metres_per_unit > 0.0 ? "m" : "";
  add_description(points, axes, json);
  // Names may be in any encoding.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::optional<NpyDescription> read_npy_description(const std::filesystem::path& npy) {
  std::filesystem::path path = without_compression(npy);
  path.replace_extension(".npy.json");
  if (!read_error(path, max_document_bytes).empty()) return std::nullopt;
  const std::string file = path.string();
  const Json json = parse_json_text(read_contents(path), file, "a description of positions");
  if (!json.is_object() || !json.contains("points")) return std::nullopt;
  const Json& points = json["points"];
  if (!points.is_array()) refuse(file, "points is not a list of names");
  const auto rate = json.find("frames_per_second");
  if (rate == json.end() || !rate->is_number()) refuse(file, "frames_per_second is not a number");
  const auto unit = json.find("unit");
  if (unit == json.end() || !(*unit == "m" || *unit == "")) refuse(file, "unit is not \"m\"");
  return NpyDescription{file, names_in(points, file), rate->get<double>(),
                        unit->get<std::string>()};
}

}  // namespace mien::motion
