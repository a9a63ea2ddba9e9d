#include <map>
#include <utility>

#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "motion/formats/table/bids_motion.h"
#include "motion/formats/table/column_name.h"
#include "motion/formats/table/decimal_text.h"
#include "motion/points/point_names.h"

namespace mien::motion {

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr int position_decimals = 7;

std::string letters_and_digits(const std::string& label, const char* otherwise) {
  std::string kept;
  for (const char c : label) {
    const bool is_kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (is_kept) kept += c;
  }
  return kept.empty() ? otherwise : kept;
}

std::string file_prefix(const BidsLabels& labels) {
  const std::string session = letters_and_digits(labels.session, "");
  return "sub-" + letters_and_digits(labels.subject, "01") +
         (session.empty() ? "" : "_ses-" + session) + "_task-" +
         letters_and_digits(labels.task, "motion") + "_tracksys-" +
         letters_and_digits(labels.tracking_system, "points") + "_";
}

/// A point's name as a field of a table: without tabs and line ends, and not like a quoted field.
std::string as_field(std::string name) {
  for (char& c : name)
    if (c == '\t' || c == '\n' || c == '\r' || c == '"') c = ' ';
  return name;
}

std::string motion_table(const PointRecording& recording) {
  std::string text;
  for (int frame = 0; frame < recording.frame_count(); ++frame) {
    for (int point = 0; point < recording.point_count(); ++point) {
      const std::size_t at = recording.at(frame, point);
      for (int axis = 0; axis < 3; ++axis) {
        if (point > 0 || axis > 0) text += '\t';
        const double value = recording.positions[at][axis];
        if (!recording.seen[at]) {
          text += "n/a";
        } else if (recording.metres_per_unit > 0.0) {
          append_decimal(text, value * recording.metres_per_unit, position_decimals);
        } else {
          append_shortest(text, value);
        }
      }
    }
    text += '\n';
  }
  return text;
}

std::string channels_table(const PointRecording& recording) {
  const std::string unit = recording.metres_per_unit > 0.0 ? "m" : "n/a";
  std::string text = "name\tcomponent\ttype\ttracked_point\tunits\n";
  std::vector<std::string> names;
  for (const std::string& point : recording.points) names.push_back(as_field(point));
  std::vector<std::string> notes;  // the names are those of the recording but for odd characters
  for (const std::string& name : distinct_point_names(std::move(names), notes)) {
    for (int axis = 0; axis < 3; ++axis) {
      const char letter = axis_letters[axis];
      text += name + '_' + letter + '\t' + letter + "\tPOS\t" + name + '\t' + unit + '\n';
    }
  }
  return text;
}

std::string sidecar(const PointRecording& recording, const BidsLabels& labels) {
  OrderedJson json;
  json["TaskName"] = letters_and_digits(labels.task, "motion");
  json["TrackingSystemName"] = letters_and_digits(labels.tracking_system, "points");
  json["SamplingFrequency"] = recording.frames_per_second;
  json["RecordingDuration"] = recording.frame_count() / recording.frames_per_second;
  json["MotionChannelCount"] = 3 * recording.point_count();
  json["POSChannelCount"] = 3 * recording.point_count();
  json["TrackedPointsCount"] = recording.point_count();
  for (const char* const other :
       {"ACCEL", "ANGACCEL", "GYRO", "JNTANG", "LATENCY", "MAGN", "MISC", "ORNT", "VEL"})
    json[std::string(other) + "ChannelCount"] = 0;
  json["MissingValues"] = "n/a";
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

/// Parts of the name of a motion file, in the order that BIDS demands.
struct NamePart {
  std::string_view key;
  bool is_required = false;
};

constexpr NamePart name_parts[] = {{"sub-", true},      {"ses-", false}, {"task-", true},
                                   {"tracksys-", true}, {"acq-", false}, {"run-", false}};

/// The labels in a file's name. Throws mien::Error if it is not one of BIDS.
BidsLabels labels_of(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  std::string_view rest = name;
  std::map<std::string_view, std::string> labels;
  bool is_valid = true;
  for (const NamePart& part : name_parts) {
    const std::size_t end = rest.find('_');
    const bool is_there = rest.starts_with(part.key) && end != std::string_view::npos;
    if (!is_there) {
      is_valid = is_valid && !part.is_required;
      continue;
    }
    std::string label(rest.substr(part.key.size(), end - part.key.size()));
    is_valid = is_valid && letters_and_digits(label, "") == label && !label.empty();
    labels[part.key] = std::move(label);
    rest.remove_prefix(end + 1);
  }
  if (!is_valid || rest != "motion.tsv")
    throw Error({file.string()},
                "is not a name of motion in BIDS, the only table in .tsv that is "
                "written",
                "name it as in sub-01_task-walk_tracksys-markers_motion.tsv, with labels of "
                "letters and digits");
  return {labels["sub-"], labels["ses-"], labels["task-"], labels["tracksys-"]};
}

}  // namespace

void require_bids_motion_name(const std::filesystem::path& file) { labels_of(file); }

std::vector<std::string> bids_motion_texts(const PointRecording& recording,
                                           const std::filesystem::path& motion_tsv) {
  return {motion_table(recording), channels_table(recording),
          sidecar(recording, labels_of(motion_tsv))};
}

std::vector<std::pair<std::string, std::string>> to_bids_motion(const PointRecording& recording,
                                                                const BidsLabels& labels) {
  const std::string prefix = file_prefix(labels);
  return {{prefix + "motion.tsv", motion_table(recording)},
          {prefix + "channels.tsv", channels_table(recording)},
          {prefix + "motion.json", sidecar(recording, labels)}};
}

}  // namespace mien::motion
