#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "motion/formats/motion_file.h"
#include "motion/rig/body_mapping.h"
#include "motion/skeleton/clip.h"

#include "real_data.h"

namespace mien::test {

/// The takes of the folder below mocap/ whose file names hold `part`, on the canonical body, by
/// name. Empty where there is no motion capture.
inline std::vector<motion::Clip> real_takes(const std::string& folder, const std::string& part) {
  std::vector<motion::Clip> takes;
  const auto root = real_data();
  if (!root) return takes;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(*root / "mocap" / folder)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(".bvh") && name.find(part) != std::string::npos) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  for (const auto& file : files) takes.push_back(motion::to_body(motion::read_motion(file)));
  return takes;
}

inline std::vector<motion::Clip> real_walks() { return real_takes("bandai-namco-1", "_walk_"); }

inline std::vector<motion::Clip> real_waves() { return real_takes("bandai-namco-1", "_bye_"); }

}  // namespace mien::test
