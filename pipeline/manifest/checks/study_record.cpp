#include "pipeline/manifest/checks/study_record.h"

#include <nlohmann/json.hpp>

#include "motion/text/file_contents.h"
#include "motion/text/json_depth.h"
#include "motion/text/safe_name.h"

namespace mien::pipeline {

std::optional<StudyRecord> study_record_in(const std::filesystem::path& file) {
  if (file.extension() != ".json") return std::nullopt;
  const motion::FileReading reading = motion::bytes_of_file(file, motion::max_table_bytes);
  if (reading.bytes && motion::is_nested_deeper(*reading.bytes, motion::max_json_depth))
    return std::nullopt;
  const auto record = nlohmann::json::parse(reading.bytes.value_or(""), nullptr, false);
  const auto text = [&](const char* place) -> std::string {
    const nlohmann::json::json_pointer pointer(place);
    if (!record.is_object() || !record.contains(pointer)) return "";
    return record[pointer].is_string() ? record[pointer].get<std::string>() : "";
  };
  if (text("/manifest/as_run").empty()) return std::nullopt;
  const std::filesystem::path folder = file.parent_path();
  const auto kept = [&](const char* place) {
    return motion::inside(folder, text(place), {file.string()});
  };
  return StudyRecord{kept("/manifest/as_run"), kept("/manifest/copy"), text("/command")};
}

}  // namespace mien::pipeline
