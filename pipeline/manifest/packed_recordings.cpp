#include "pipeline/manifest/packed_recordings.h"

#include <system_error>

#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "motion/text/file_contents.h"
#include "motion/text/json_depth.h"
#include "motion/text/safe_name.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> paths_of(const nlohmann::json& list, const fs::path& file) {
  std::vector<std::string> paths;
  for (const nlohmann::json& path : list) {
    paths.push_back(path.get<std::string>());
    if (const std::string fault = motion::fault_of_relative(paths.back()); !fault.empty())
      throw Error({file.string()}, "names " + path.dump() + ", a path that " + fault,
                  "do not trust this study");
  }
  return paths;
}

PackedRecordings parsed(const std::string& text, const fs::path& file) {
  PackedRecordings recordings;
  const auto list = nlohmann::json::parse(text);
  recordings.packed = paths_of(list.at("packed"), file);
  recordings.left_out = paths_of(list.at("left_out"), file);
  recordings.left_out_files = paths_of(list.at("left_out_files"), file);
  for (const auto& [as_run, name] : list.at("folders").items())
    recordings.folders[as_run] = paths_of({name}, file).front();
  return recordings;
}

}  // namespace

PackedRecordings packed_recordings_in(const fs::path& folder) {
  const fs::path file = folder / packed_recordings_path;
  std::error_code unknown;
  if (!fs::exists(fs::symlink_status(file, unknown))) return {};
  const motion::FileReading text = motion::bytes_of_file(file, motion::max_table_bytes);
  if (!text.bytes) throw Error({file.string()}, text.error, "restore the file");
  try {
    const bool is_deep = motion::is_nested_deeper(*text.bytes, motion::max_json_depth);
    return parsed(is_deep ? std::string() : *text.bytes, file);
  } catch (const nlohmann::json::exception&) {
    throw Error({file.string()}, "this is not a list of packed recordings",
                "unpack the archive again");
  }
}

std::string to_json(const PackedRecordings& recordings) {
  const nlohmann::ordered_json list = {
      {"about",
       "recordings of this study that were packed with it (in recordings/), and those that were "
       "left out because their licence does not permit sharing, with the motion files made from "
       "them; provenance.json contains hashes, licences and sources"},
      {"packed", recordings.packed},
      {"left_out", recordings.left_out},
      {"left_out_files", recordings.left_out_files},
      {"folders", recordings.folders}};
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;
  return list.dump(2, ' ', false, replace) + "\n";
}

fs::path packed_place(const PackedRecordings& recordings, const fs::path& folder,
                      const std::string& text) {
  const fs::path place = folder / packed_recordings_folder;
  const auto named = recordings.folders.find(text);
  if (named != recordings.folders.end()) return place / named->second;
  const fs::path file(text);
  const auto around = recordings.folders.find(file.parent_path().generic_string());
  const bool is_named = file.has_filename() && file.filename() != ".." && file.filename() != ".";
  if (around == recordings.folders.end() || !is_named) return {};
  return place / around->second / file.filename();
}

}  // namespace mien::pipeline
