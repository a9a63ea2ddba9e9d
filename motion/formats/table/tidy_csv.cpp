#include "motion/formats/table/tidy_csv.h"

#include <nlohmann/json.hpp>

#include "motion/formats/table/decimal_text.h"
#include "motion/formats/writing/point_description.h"

namespace mien::motion {

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr int time_decimals = 9;
constexpr int tidy_position_decimals = 7;

/// The text as a field: in quotes if it would not be read back otherwise.
std::string as_csv_field(const std::string& text) {
  const bool is_plain = !text.empty() && text.find_first_of(",;\t\"\r\n") == std::string::npos &&
                        text.front() != ' ' && text.back() != ' ' && text.front() != '#';
  if (is_plain) return text;
  std::string field = "\"";
  for (const char c : text) {
    if (c == '"') field += '"';
    field += c;
  }
  return field + '"';
}

bool is_metric(const PointRecording& recording) { return recording.metres_per_unit > 0.0; }

void append_position(std::string& text, const PointRecording& recording, const Vec3& position) {
  for (int axis = 0; axis < 3; ++axis) {
    text += ',';
    if (is_metric(recording)) {
      append_decimal(text, position[axis] * recording.metres_per_unit, tidy_position_decimals);
    } else {
      append_shortest(text, position[axis]);
    }
  }
}

OrderedJson described(const std::string& meaning, const std::string& unit = "") {
  OrderedJson column{{"description", meaning}};
  if (!unit.empty()) column["unit"] = unit;
  return column;
}

OrderedJson columns_of(bool is_in_metres) {
  OrderedJson columns;
  columns["frame"] = described("number of the frame, from 0");
  columns["time_s"] = described("time since the first frame", "s");
  columns["point"] = described("name of the point");
  const std::string unit = is_in_metres ? "m" : "as in the source, which states none";
  for (const char* const axis : {"x", "y", "z"})
    columns[std::string(axis) + (is_in_metres ? "_m" : "")] = described(
        std::string("position along ") + axis + "; empty where the point is missing", unit);
  return columns;
}

}  // namespace

std::string to_tidy_csv(const PointRecording& recording) {
  std::string text =
      is_metric(recording) ? "frame,time_s,point,x_m,y_m,z_m\n" : "frame,time_s,point,x,y,z\n";
  std::vector<std::string> fields;
  for (const std::string& point : recording.points) fields.push_back(as_csv_field(point));
  std::string moment;
  for (int frame = 0; frame < recording.frame_count(); ++frame) {
    moment = std::to_string(frame) + ',';
    append_decimal(moment, frame / recording.frames_per_second, time_decimals);
    moment += ',';
    for (int point = 0; point < recording.point_count(); ++point) {
      const std::size_t at = recording.at(frame, point);
      text += moment;
      text += fields[static_cast<std::size_t>(point)];
      if (recording.seen[at]) {
        append_position(text, recording, recording.positions[at]);
      } else {
        text += ",,,";
      }
      text += '\n';
    }
  }
  return text;
}

std::string tidy_csv_sidecar(const PointRecording& recording, const std::string& axes) {
  OrderedJson json;
  json["description"] = "Positions of points over time; a row is a point of a frame.";
  json["columns"] = columns_of(is_metric(recording));
  add_description(recording, axes, json);
  // Names may be in any encoding.
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace mien::motion
