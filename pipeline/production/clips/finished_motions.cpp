#include "pipeline/production/clips/finished_motions.h"

#include <nlohmann/json.hpp>

#include "motion/skeleton/straighten.h"
#include "pipeline/base/documents/files.h"

namespace mien::pipeline {

motion::Clip playback_clip(const motion::Clip& motion, const Output& output) {
  return motion::playback_clip(motion, {output.cycles, output.in_place});
}

double recorded_duration(const std::filesystem::path& file) {
  return nlohmann::json::parse(read_file(file)).get<double>();
}

void know_durations(const std::filesystem::path& folder, FinishedMotions& motions) {
  motions.know_shortest(recorded_duration(folder / duration_record_path));
}

}  // namespace mien::pipeline
