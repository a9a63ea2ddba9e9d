#include "motion/formats/writing/point_description.h"

#include <utility>

#include <nlohmann/json.hpp>

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

}  // namespace mien::motion
