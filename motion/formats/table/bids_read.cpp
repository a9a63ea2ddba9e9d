#include <algorithm>
#include <array>
#include <cmath>
#include <system_error>
#include <unordered_map>

#include <nlohmann/json.hpp>

#include "motion/formats/reading/chosen_subject.h"
#include "motion/formats/reading/json_text.h"
#include "motion/formats/reading/option_names.h"
#include "motion/formats/table/bids_motion.h"
#include "motion/formats/table/table_cell.h"
#include "motion/formats/table/table_rows.h"
#include "motion/formats/table/wide_table.h"
#include "motion/text/compressed_file.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/file_kind.h"
#include "motion/text/safe_name.h"

namespace mien::motion {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::string_view motion_ending = "motion.tsv";
constexpr int most_folders_above = 3;

/// Metres per unit of a channel's `units`; 0 if they state none.
struct ChannelUnit {
  std::string name;
  double metres = 0.0;
};

/// The columns of the motion file, by its channels.
struct Channels {
  WideColumns columns;
  std::vector<ChannelUnit> units;  ///< of each point
  std::size_t count = 0;
};

/// Reads `…_channels.tsv`.
class ChannelReader {
 public:
  explicit ChannelReader(const BidsMotionTexts& texts)
      : rows_(texts.channels, texts.channels_file, '\t', TableComments::none) {}

  Channels read() {
    if (!rows_.next()) rows_.refuse(0, "there are no channels", "list the channels");
    find_columns();
    while (rows_.next()) read_channel();
    channels_.columns.width = channels_.count;
    drop_incomplete_points();
    if (channels_.columns.points.empty())
      throw Error({rows_.cursor().file},
                  "no tracked point has channels of type POS and components x, y and z",
                  "give positions; orientations and other channels are not read");
    return std::move(channels_);
  }

 private:
  enum Wanted { name, component, type, tracked_point, units, wanted_count };

  void find_columns() {
    constexpr std::array<std::string_view, wanted_count> names = {"name", "component", "type",
                                                                  "tracked_point", "units"};
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto found = std::ranges::find(rows_.fields(), names[i]);
      if (found == rows_.fields().end())
        rows_.refuse(0, "there is no column " + in_quotes(names[i]),
                     "name the columns name, component, type, tracked_point, units");
      at_[i] = static_cast<std::size_t>(found - rows_.fields().begin());
    }
  }

  std::string_view field(Wanted wanted) const { return rows_.field(at_[wanted]); }

  void read_channel() {
    if (channels_.count == most_table_fields)
      rows_.refuse(0, "there are too many channels", "keep those of the points");
    const int column = static_cast<int>(channels_.count++);
    const std::size_t axis = field(component).size() == 1
                                 ? std::string_view("xyz").find(field(component)[0])
                                 : std::string_view::npos;
    if (!same_word(field(type), "POS") || axis == std::string_view::npos) {
      channels_.columns.left_out.emplace_back(field(name));
      return;
    }
    const ChannelUnit unit = unit_of_channel();
    std::string_view point = field(tracked_point);
    if (point.empty() || same_word(point, "n/a")) {
      const std::optional<AxisName> named = axis_name(field(name));
      point = named ? named->base : field(name);
    }
    const auto [found, is_new] =
        index_of_.emplace(std::string(point), channels_.columns.points.size());
    if (is_new) {
      channels_.columns.points.push_back({std::string(point), {-1, -1, -1}});
      channels_.units.push_back(unit);
    }
    int& of_axis = channels_.columns.points[found->second].column[axis];
    if (of_axis >= 0)
      rows_.refuse(at_[tracked_point],
                   "the point " + in_quotes(point) + " has two channels of one component",
                   "give each point one channel for each of x, y and z");
    if (channels_.units[found->second].name != unit.name)
      rows_.refuse(at_[units], "the channels of " + in_quotes(point) + " are in different units",
                   "give a point in one unit");
    of_axis = column;
  }

  ChannelUnit unit_of_channel() const {
    const std::string_view word = field(units);
    if (word.empty() || same_word(word, "n/a")) return {};
    const std::optional<LengthUnit> unit = length_unit(word);
    if (!unit)
      rows_.refuse(at_[units], in_quotes(word) + " is not a unit of positions that is read",
                   "give positions in m, cm, mm, in or ft");
    return {std::string(unit->name), unit->metres};
  }

  void drop_incomplete_points() {
    std::vector<PointColumns> complete;
    std::vector<ChannelUnit> complete_units;
    for (std::size_t i = 0; i < channels_.columns.points.size(); ++i) {
      PointColumns& point = channels_.columns.points[i];
      if (std::ranges::find(point.column, -1) != point.column.end()) {
        channels_.columns.left_out.push_back(point.name);
        continue;
      }
      complete.push_back(std::move(point));
      complete_units.push_back(std::move(channels_.units[i]));
    }
    channels_.columns.points = std::move(complete);
    channels_.units = std::move(complete_units);
  }

  TableRows rows_;
  std::array<std::size_t, wanted_count> at_{};
  Channels channels_;
  std::unordered_map<std::string, std::size_t> index_of_;
};

/// What is read of `…_motion.json`.
struct Sidecar {
  std::optional<double> rate;
  std::string missing;  ///< how the motion file writes what is missing; may be empty
  std::vector<std::string> notes;
};

std::optional<double> positive_number(const Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_number() || !(found->get<double>() > 0.0))
    return std::nullopt;
  return found->get<double>();
}

Sidecar read_sidecar(const BidsMotionTexts& texts) {
  Sidecar sidecar;
  if (texts.sidecar.empty()) return sidecar;
  const Json json = parse_json_text(texts.sidecar, texts.sidecar_file, "a BIDS sidecar");
  if (!json.is_object())
    throw Error({texts.sidecar_file}, "is not a BIDS sidecar", "give an object of fields");
  const std::optional<double> nominal = positive_number(json, "SamplingFrequency");
  const std::optional<double> effective = positive_number(json, "SamplingFrequencyEffective");
  sidecar.rate = effective ? effective : nominal;
  if (effective && nominal && std::abs(*effective / *nominal - 1.0) > 1e-4)
    sidecar.notes.emplace_back(
        "SamplingFrequencyEffective differs from SamplingFrequency and is used.");
  const auto missing = json.find("MissingValues");
  if (missing != json.end() && missing->is_string()) sidecar.missing = missing->get<std::string>();
  return sidecar;
}

/// Goes to the first frame: datasets exist whose motion file has a header, against the rules.
void require_columns(TableRows& rows, const Channels& channels, std::vector<std::string>& notes) {
  if (!rows.next()) rows.refuse(0, "there are no frames", "give at least one frame");
  std::size_t width = rows.fields().size();
  if (width == channels.count + 1 && rows.fields().back().empty()) --width;
  if (width != channels.count)
    rows.refuse(0,
                "the row has " + std::to_string(width) + " columns, but there are " +
                    std::to_string(channels.count) + " channels",
                "check that the channels file belongs to this motion");
  const auto first = static_cast<std::size_t>(channels.columns.points[0].column[0]);
  DecimalMarks marks;
  if (axis_name(rows.field(first)) && read_cell(rows.field(first), marks).kind == TableCell::text) {
    notes.emplace_back(
        "The motion file has a header row, which BIDS does not allow; it is skipped.");
    return;
  }
  rows.go_to(rows.row_start());
}

/// Brings points that have another unit than the first into that one.
void convert_units(const Channels& channels, const std::string& file, PointRecording& recording) {
  const ChannelUnit& unit = channels.units[0];
  recording.unit = unit.name;
  recording.metres_per_unit = unit.metres;
  for (std::size_t p = 0; p < channels.units.size(); ++p) {
    const double metres = channels.units[p].metres;
    if (metres == unit.metres) continue;
    if (metres == 0.0 || unit.metres == 0.0)
      throw Error({file}, "only some of the channels state a unit", "state all units");
    for (std::size_t i = p; i < recording.positions.size(); i += recording.points.size())
      recording.positions[i] *= metres / unit.metres;
  }
}

/// The value of "task" in "sub-01_task-walk_tracksys-omc_"; empty if there is none.
std::string entity(std::string_view name, std::string_view key) {
  const std::string start = std::string(key) + "-";
  std::size_t at = name.find(start);
  while (at != std::string_view::npos && at > 0 && name[at - 1] != '_')
    at = name.find(start, at + 1);
  if (at == std::string_view::npos) return "";
  at += start.size();
  return std::string(name.substr(at, name.find('_', at) - at));
}

/// The JSON file beside or above a motion file; empty if there is none.
fs::path sidecar_of(const fs::path& motion, const std::string& prefix) {
  std::vector<std::string> names = {prefix + "motion.json"};
  const std::string task = entity(prefix, "task");
  const std::string tracking = entity(prefix, "tracksys");
  if (!task.empty() && !tracking.empty())
    names.push_back("task-" + task + "_tracksys-" + tracking + "_motion.json");
  if (!task.empty()) names.push_back("task-" + task + "_motion.json");
  fs::path folder = motion.parent_path();
  for (int above = 0; above <= most_folders_above; ++above) {
    for (const std::string& name : names) {
      const fs::path file = folder / safe_component(name, {motion.string()});
      if (read_error(file, max_document_bytes).empty()) return file;
    }
    folder /= "..";
  }
  return {};
}

/// The channels file beside a motion file, perhaps compressed.
fs::path channels_of(const fs::path& motion, const std::string& prefix) {
  const fs::path plain =
      motion.parent_path() / safe_component(prefix + "channels.tsv", {motion.string()});
  const std::string name = in_quotes(plain.filename().string());
  std::error_code unknown;
  for (const fs::path& file : {plain, fs::path(plain.string() + ".gz")}) {
    if (!fs::exists(file, unknown)) continue;
    const std::string problem = read_error(file, max_document_bytes);
    if (problem.empty()) return file;
    throw Error({file.string()}, problem, "put the channels file of the motion there");
  }
  throw Error({motion.string()}, "has no channels file " + name + " beside it",
              "put it into the same folder; it says what the columns are");
}

}  // namespace

bool is_bids_motion(const fs::path& path) {
  const std::string name = without_compression(path).filename().string();
  return name == motion_ending || name.ends_with("_motion.tsv");
}

PointRecording parse_bids_motion(const BidsMotionTexts& texts, const ReadOptions& options) {
  Channels channels = ChannelReader(texts).read();
  Sidecar sidecar = read_sidecar(texts);
  channels.columns.rate = sidecar.rate;
  channels.columns.missing_word = sidecar.missing;
  channels.columns.notes = std::move(sidecar.notes);
  TableRows rows(texts.motion, texts.motion_file, '\t', TableComments::none);
  require_columns(rows, channels, channels.columns.notes);
  PointRecording recording = read_wide_rows(rows, channels.columns, options);
  convert_units(channels, texts.channels_file, recording);
  recording.name = recording_name(texts.motion_file);
  recording.format = "bids";
  const std::string subject = entity(recording.name, "sub");
  recording.subjects = {subject.empty() ? recording.name : "sub-" + subject};
  chosen_subject({texts.motion_file}, recording.subjects, options.subject);
  return recording;
}

PointRecording read_bids_motion(const fs::path& motion_tsv, const ReadOptions& options) {
  const std::string name = without_compression(motion_tsv).filename().string();
  if (!is_bids_motion(motion_tsv))
    throw Error({motion_tsv.string()}, "is not named as motion in BIDS",
                "give the path of a …_motion.tsv");
  const std::string prefix = name.substr(0, name.size() - motion_ending.size());
  const fs::path channels = channels_of(motion_tsv, prefix);
  const fs::path sidecar = sidecar_of(motion_tsv, prefix);
  if (sidecar.empty() && !options.frames_per_second)
    throw Error({motion_tsv.string()}, "has no …_motion.json, which states the frame rate",
                std::string("put it beside the motion file, or state the frames per second with ") +
                    rate_option);
  const std::string motion_text = read_contents(motion_tsv);
  const std::string channels_text = read_contents(channels);
  const std::string sidecar_text = sidecar.empty() ? "" : read_contents(sidecar);
  require_kind(motion_text, motion_tsv.string(), "bids");
  require_kind(channels_text, channels.string(), "bids");
  return parse_bids_motion({motion_text, motion_tsv.string(), channels_text, channels.string(),
                            sidecar_text, sidecar.string()},
                           options);
}

}  // namespace mien::motion
