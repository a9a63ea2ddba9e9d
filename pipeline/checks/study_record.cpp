#include "pipeline/checks/study_record.h"

#include <fstream>

#include <nlohmann/json.hpp>

namespace mien::pipeline {

std::optional<StudyRecord> study_record_in(const std::filesystem::path& file) {
  if (file.extension() != ".json") return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  const auto record = nlohmann::json::parse(stream, nullptr, false);
  const auto text = [&](const char* place) -> std::string {
    const nlohmann::json::json_pointer pointer(place);
    if (!record.is_object() || !record.contains(pointer)) return "";
    return record[pointer].is_string() ? record[pointer].get<std::string>() : "";
  };
  if (text("/manifest/as_run").empty()) return std::nullopt;
  const std::filesystem::path folder = file.parent_path();
  return StudyRecord{folder / text("/manifest/as_run"), folder / text("/manifest/copy"),
                     text("/command")};
}

}  // namespace mien::pipeline
