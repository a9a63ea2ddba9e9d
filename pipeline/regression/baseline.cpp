#include "pipeline/regression/baseline.h"

#include <algorithm>
#include <fstream>

#include "pipeline/tasks/code_identity.h"
#include "render/image/contact_sheet.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

std::string processor_vendor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("vendor_id") && !line.starts_with("CPU implementer")) continue;
    const std::size_t value = line.find_first_not_of(" \t", line.find(':') + 1);
    if (value != std::string::npos) return line.substr(value);
  }
  return "unknown";
}

std::string numbered(int frame, const char* ending) {
  std::string digits = std::to_string(frame);
  digits.insert(0, 5 - std::min<std::size_t>(5, digits.size()), '0');
  return digits + ending;
}

}  // namespace

Origin this_origin() {
  Origin origin{.program = std::string(program_version()),
                .motion_code = std::string(motion_code()),
                .film_code = std::string(film_code()),
                .libraries = {},
                .processor = processor_vendor()};
  for (const auto& [name, version] : library_versions()) origin.libraries[name] = version;
  return origin;
}

const StimulusFacts* Baseline::find(const std::string& id) const {
  const auto found = std::ranges::find(stimuli, id, &StimulusFacts::id);
  return found == stimuli.end() ? nullptr : &*found;
}

fs::path Baseline::edition_manifest(const std::string& edition) const {
  return folder / "editions" / edition / "inputs" / "as-run.yaml";
}

fs::path Baseline::motion_file(const std::string& id) const {
  return folder / "stimuli" / id / "motion.bvh";
}

fs::path Baseline::picture_file(const std::string& id, int frame) const {
  return folder / "stimuli" / id / "frames" / numbered(frame, ".png");
}

fs::path Baseline::blocks_file(const std::string& id, int frame) const {
  return folder / "stimuli" / id / "frames" / numbered(frame, ".exr");
}

fs::path Baseline::video_file(const std::string& id, const VideoFacts& video) const {
  return folder / "stimuli" / id / "videos" / fs::path(video.record.file).filename();
}

bool is_baseline(const fs::path& folder) {
  std::error_code unknown;
  return fs::is_regular_file(folder / "baseline.json", unknown);
}

std::vector<int> key_frames_of(int frame_count, int most) {
  return render::evenly_spread(frame_count, most);
}

}  // namespace mien::pipeline
