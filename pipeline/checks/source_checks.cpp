#include "pipeline/checks/source_checks.h"

#include <algorithm>
#include <string>
#include <system_error>

#include "pipeline/documents/fault_list.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// Links followed, whether or not it is there yet.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path, error), error);
  return whole.has_filename() ? whole : whole.parent_path();
}

class SourceChecker : public FaultList {
 public:
  SourceChecker(const Manifest& manifest, const fs::path& folder)
      : FaultList(manifest.places), study_(manifest.study), folder_(resolved(folder)) {}

  void check(const std::string& path, const fs::path& source) {
    if (source.empty() || !is_inside(resolved(source))) return;
    add(path, source.string() + " lies where the results of this study go",
        "copy it elsewhere, or give the study another name than " + study_);
  }

  /// A value that is a map with a file, or that file alone.
  void check_file_of(const std::string& path, const char* key, const fs::path& source) {
    const std::string own = member_path(path, key);
    check(was_given(own) ? own : path, source);
  }

 private:
  bool is_inside(const fs::path& source) const {
    return std::ranges::mismatch(folder_, source).in1 == folder_.end();
  }

  std::string study_;
  fs::path folder_;
};

}  // namespace

std::vector<Fault> check_sources(const Manifest& manifest, const fs::path& folder) {
  SourceChecker checker(manifest, folder);
  checker.check("examples.set.folder", manifest.examples.folder);
  checker.check("examples.ratings", manifest.ratings.file);
  checker.check("examples.scales", manifest.scales.file);
  checker.check("recipes", manifest.recipes.file);
  for (const Stimulus& stimulus : manifest.stimuli) {
    if (stimulus.clip)
      checker.check_file_of(member_path(stimulus.path, "clip"), "file", stimulus.clip->file);
    for (const ModificationStep& step : stimulus.modify) {
      if (!step.pose) continue;
      const std::string pose = member_path(step.path, "pose");
      checker.check_file_of(member_path(pose, "neutral"), "motion", step.pose->neutral.file);
      checker.check_file_of(member_path(pose, "posed"), "motion", step.pose->posed.file);
    }
  }
  return checker.take();
}

}  // namespace mien::pipeline
