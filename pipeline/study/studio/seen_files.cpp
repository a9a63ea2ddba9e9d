#include "pipeline/study/studio/seen_files.h"

#include <algorithm>
#include <system_error>

#include "pipeline/manifest/example_files.h"
#include "pipeline/manifest/named_motions.h"

namespace mien::pipeline {

namespace fs = std::filesystem;

SeenFiles::SeenFiles(const std::vector<fs::path>& paths) {
  for (const fs::path& path : paths) files_.push_back(seen(path));
}

bool SeenFiles::are_unchanged() const {
  return std::ranges::all_of(files_, [](const SeenFile& file) { return seen(file.path) == file; });
}

SeenFiles::SeenFile SeenFiles::seen(const fs::path& path) {
  std::error_code unknown;
  SeenFile file{path, fs::last_write_time(path, unknown)};
  file.bytes = fs::file_size(path, unknown);
  return file;
}

std::vector<fs::path> files_of_examples(const Manifest& manifest) {
  std::vector<fs::path> files = repertoire_files(manifest);
  const Examples& examples = manifest.examples;
  if (examples.builtin.empty() && !examples.folder.empty()) files.push_back(examples.folder);
  return files;
}

std::vector<fs::path> files_of_motion(const Manifest& manifest, const Stimulus& stimulus) {
  std::vector<fs::path> files;
  for (const NamedMotion& motion : named_motions(stimulus)) {
    files.push_back(motion.file);
    if (!motion.how.body_model.empty()) files.push_back(motion.how.body_model);
    for (const fs::path& part : motion_parts(motion.file)) files.push_back(part);
  }
  if (!manifest.recipes.file.empty()) files.push_back(manifest.recipes.file);
  return files;
}

}  // namespace mien::pipeline
