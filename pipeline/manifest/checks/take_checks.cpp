#include "pipeline/manifest/checks/take_checks.h"

#include "motion/formats/motion_file.h"

namespace mien::pipeline {

void check_take(const std::string& path, const std::filesystem::path& file, const std::string& take,
                FaultList& list) {
  if (take.empty() || !motion::is_motion_file(file) || motion::may_hold_takes(file)) return;
  list.add(path, "a file of " + file.extension().string() + " holds one motion",
           "leave take out; glTF files (.gltf, .glb) may hold several");
}

}  // namespace mien::pipeline
