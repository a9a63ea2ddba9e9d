#include "pipeline/production/archive/bids_stimuli.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/production/film/film_record.h"
#include "render/video/video_kind.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr char stimuli_table[] = "metrics/stimuli.csv";

/// A column of stimuli.tsv that this program adds: its name there and in metrics/stimuli.csv, and
/// its description in stimuli.json.
struct AddedColumn {
  const char* name;
  const char* source;
  const char* description;
  const char* units;
};

constexpr auto added_columns = std::to_array<AddedColumn>({
    {"mien_id", "stimulus", "Id of the stimulus in the manifest of mien", ""},
    {"role", "role", "Whether the motion is a target or was created to resemble one", ""},
    {"source", "source", "What the motion was made from", ""},
    {"requested", "requested", "Settings that were requested", ""},
    {"figure", "figure", "What is shown of the body", ""},
    {"camera", "camera", "View of the camera", ""},
    {"duration", "video_s", "Duration of the video", "s"},
    {"frame_rate", "fps", "Frames per second", "Hz"},
    {"width", "width_px", "Width of the picture", "px"},
    {"height", "height_px", "Height of the picture", "px"},
});

using Row = std::map<std::string, std::string>;

/// metrics/stimuli.csv by the ids in its first column; empty if it was not kept.
std::map<std::string, Row> rows_by_id(const StudyContents& contents) {
  std::map<std::string, Row> rows;
  const fs::path file = contents.folder / stimuli_table;
  if (contents.find(stimuli_table) == nullptr || !fs::exists(file)) return rows;
  const CsvTable table = read_csv(file);
  for (const std::vector<CsvField>& fields : table.rows)
    for (std::size_t i = 0; i < fields.size(); ++i)
      rows[fields[0].text][table.header[i].text] = fields[i].text;
  return rows;
}

/// Paths of the videos that have sound.
std::set<std::string> heard_videos(const StudyContents& contents) {
  std::set<std::string> heard;
  for (const ArtifactRecord& artifact : contents.artifacts) {
    if (!artifact.path.starts_with("metrics/films/")) continue;
    const fs::path file = contents.folder / artifact.path;
    if (!fs::exists(file)) continue;
    try {
      for (const VideoRecord& video : parse_film_record(read_file(file)).videos)
        if (video.sound) heard.insert(video.file);
    } catch (const std::runtime_error& error) {
      throw Error({file.string()}, error.what(), "run the study again");
    }
  }
  return heard;
}

std::string in_lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Labels by ids: letters and digits, and no two the same in lower case, since file names may not
/// differ in it. Ids that consist of letters and digits are their own labels where possible.
std::map<std::string, std::string> labels_of(const std::vector<std::string>& ids) {
  const auto is_kept = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  std::map<std::string, std::string> labels;
  std::set<std::string> used;  // in lower case
  for (const std::string& id : ids)
    if (!id.empty() && std::ranges::all_of(id, is_kept) && used.insert(in_lower_case(id)).second)
      labels[id] = id;
  for (const std::string& id : ids) {
    if (labels.contains(id)) continue;
    std::string kept;
    std::ranges::copy_if(id, std::back_inserter(kept), is_kept);
    if (kept.empty()) kept = "stimulus";
    std::string label = kept;
    for (int number = 2; !used.insert(in_lower_case(label)).second; ++number)
      label = kept + std::to_string(number);
    labels[id] = label;
  }
  return labels;
}

/// A cell of a table of BIDS: "n/a" for what is not known; neither tabs nor line ends.
std::string cell(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
  return text.empty() ? "n/a" : text;
}

std::string field_of(const Row& row, const std::string& name) {
  const auto found = row.find(name);
  return found == row.end() ? "" : found->second;
}

/// "Human motion (figure stick, camera three-quarter), made from adjectives: quickness=0.7"
std::string description_of(const Row& row) {
  if (row.empty()) return "";
  std::string text =
      fmt::format("Human motion (figure {}, camera {}), made from {}", field_of(row, "figure"),
                  field_of(row, "camera"), field_of(row, "source"));
  if (const std::string asked = field_of(row, "requested"); !asked.empty()) text += ": " + asked;
  return text;
}

std::string columns_text() {
  ordered_json columns = {
      {"stimulus_id", {{"Description", "Stimulus, as in the names of its files"}}},
      {"type", {{"Description", "Kind of the files: video, or audiovideo with sound"}}},
      {"license", {{"Description", "Licence of the files"}}},
      {"description", {{"Description", "What is seen"}}},
      {"filename", {{"Description", "The files, relative to this folder, separated by commas"}}},
      {"present", {{"Description", "Whether the files are in this folder"}}}};
  for (const AddedColumn& column : added_columns) {
    ordered_json meaning = {{"Description", column.description}};
    if (*column.units != '\0') meaning["Units"] = column.units;
    columns[column.name] = std::move(meaning);
  }
  return columns.dump(2) + "\n";
}

struct ShownStimulus {
  std::string type;
  std::map<std::string, std::string> videos;  ///< by extension
};

PayloadFile text_file(const std::string& name, std::string text) {
  const std::uint64_t size = text.size();
  return {std::string(bids_folder) + "/" + name, size, {}, {}, std::move(text)};
}

}  // namespace

BidsStimuli bids_stimuli(const StudyContents& contents, const std::vector<PayloadFile>& payload,
                         const std::string& licence) {
  const std::set<std::string> heard = heard_videos(contents);
  const std::map<std::string, Row> rows = rows_by_id(contents);
  BidsStimuli made;
  std::map<std::string, ShownStimulus> stimuli;  // by id
  for (const PayloadFile& file : payload) {
    if (!file.path.starts_with("videos/") || contents.find(file.path) == nullptr) continue;
    const std::optional<render::VideoKind> kind = render::video_kind_of(file.path);
    if (!kind) continue;
    const std::string name = fs::path(file.path).filename().string();
    const std::string ending = render::with_ending("", *kind).string();
    ShownStimulus& stimulus = stimuli[name.substr(0, name.size() - ending.size())];
    const std::string extension = fs::path(file.path).extension().string();
    if (render::traits_of(*kind).picture || stimulus.videos.contains(extension)) {
      made.omitted.push_back(file.path);
      continue;
    }
    stimulus.type = heard.contains(file.path) ? "audiovideo" : "video";
    stimulus.videos[extension] = file.path;
  }
  std::erase_if(stimuli, [](const auto& entry) { return entry.second.videos.empty(); });

  std::string table = "stimulus_id\ttype\tlicense\tdescription\tfilename\tpresent";
  for (const AddedColumn& column : added_columns) table += std::string("\t") + column.name;
  table += "\n";
  std::vector<std::string> ids;
  for (const auto& [id, stimulus] : stimuli) ids.push_back(id);
  const std::map<std::string, std::string> labels = labels_of(ids);
  for (const auto& [id, stimulus] : stimuli) {
    const auto found = rows.find(id);
    const Row row = found == rows.end() ? Row{{"stimulus", id}} : found->second;
    const std::string description = found == rows.end() ? "" : description_of(row);
    const std::string stem = fmt::format("stim-{}_{}", labels.at(id), stimulus.type);
    std::string names;
    for (const auto& [extension, path] : stimulus.videos) {
      ++made.videos;
      names += (names.empty() ? "" : ",") + stem + extension;
      const auto source = std::ranges::lower_bound(payload, path, {}, &PayloadFile::path);
      made.files.push_back({std::string(bids_folder) + "/" + stem + extension,
                            source->size,
                            {},
                            source->from.empty() ? contents.folder / path : source->from});
    }
    if (!description.empty())
      made.files.push_back(
          text_file(stem + ".json", ordered_json{{"Description", description}}.dump(2) + "\n"));
    table += fmt::format("stim-{}\t{}\t{}\t{}\t{}\ttrue", labels.at(id), stimulus.type,
                         cell(licence), cell(description), names);
    for (const AddedColumn& column : added_columns)
      table += "\t" + cell(field_of(row, column.source));
    table += "\n";
  }
  made.files.push_back(text_file("stimuli.tsv", std::move(table)));
  made.files.push_back(text_file("stimuli.json", columns_text()));
  std::ranges::sort(made.files, {}, &PayloadFile::path);
  return made;
}

}  // namespace mien::pipeline
