#include "motion/formats/writing/point_description.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "motion/formats/reading/json_text.h"
#include "motion/text/compressed_file.h"
#include "motion/text/file_contents.h"

namespace mien::motion {

void add_description(const PointRecording& points, const std::string& axes,
                     nlohmann::ordered_json& json) {
  json["axes"] = axes;
  json["frames_per_second"] = points.frames_per_second;
  json["frames"] = points.frame_count();
  json["points"] = points.points;
  json["source"] = {{"name", points.name}, {"format", points.format}};
  if (!points.unit.empty()) json["source"]["unit"] = points.unit;
  if (!points.subject.empty()) json["subject"] = points.subject;
  auto events = nlohmann::ordered_json::array();
  for (const PointEvent& event : points.events)
    events.push_back(
        {{"label", event.label}, {"context", event.context}, {"seconds", event.seconds}});
  if (!events.empty()) json["events"] = std::move(events);
  if (!points.notes.empty()) json["notes"] = points.notes;
}

std::optional<double> described_rate(const std::filesystem::path& points) {
  const auto is_absent = [](const std::filesystem::path& file) {
    return !read_error(file, max_document_bytes).empty();
  };
  const std::filesystem::path table = without_compression(points);
  std::string ending = table.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::filesystem::path path = table;
  path.replace_extension(ending + ".json");  // "WALK.csv.json" is written beside "WALK.CSV"
  if (is_absent(path)) {
    path = table;
    path += ".json";
  }
  if (is_absent(path)) return std::nullopt;
  const std::string file = path.string();
  const nlohmann::json json =
      parse_json_text(read_contents(path), file, "a description of positions");
  if (!json.is_object() || !json.contains("points")) return std::nullopt;
  const auto rate = json.find("frames_per_second");
  if (rate == json.end() || !rate->is_number() || !(rate->get<double>() > 0.0))
    throw Error({file}, "frames_per_second is not a number above 0",
                "write it as mien does, or remove it and give fps:");
  return rate->get<double>();
}

}  // namespace mien::motion
