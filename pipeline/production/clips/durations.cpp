#include "pipeline/production/clips/durations.h"

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

double recorded_duration(const std::filesystem::path& file) {
  return nlohmann::json::parse(read_file(file)).get<double>();
}

void know_durations(const std::filesystem::path& folder, FinishedMotions& motions) {
  motions.know_shortest(recorded_duration(folder / duration_record_path));
}

}  // namespace mien::pipeline
