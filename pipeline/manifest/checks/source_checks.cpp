#include <algorithm>
#include <string>
#include <system_error>

#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/named_motions.h"
#include "scenes/figures/figure.h"

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
    add(path, source.string() + " is in the folder of this study's results",
        "copy it elsewhere, or use a study name other than " + study_);
  }

  /// Checks a look that is given at this path, not inherited.
  void check_look(const std::string& path, const Look& look) {
    if (!was_given(path)) return;
    check(member_path(path, "scene"), look.scene_file);
    check(member_path(path, "face.file"), look.face.file);
    if (const fs::path* file = scenes::file_of(look.figure))
      check(member_path(path, "figure"), *file);
  }

  /// A value that is a map with a file, or that file alone.
  void check_file_of(const std::string& path, const std::string& key, const fs::path& source) {
    const std::string own = member_path(path, key);
    check(was_given(own) ? own : path, source);
  }

 private:
  /// Except for the copies of inputs and packed recordings, which a rerun from a study's record
  /// reads.
  bool is_inside(const fs::path& source) const {
    const auto [rest_of_folder, rest] = std::ranges::mismatch(folder_, source);
    return rest_of_folder == folder_.end() &&
           (rest == source.end() || (*rest != "inputs" && *rest != "recordings"));
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
  checker.check_look("look", manifest.look);
  for (const Stimulus* film : films_of(manifest))
    checker.check_look(member_path(film->path, "look"), film->look);
  for (const Stimulus& stimulus : manifest.stimuli) {
    for (const Person& person : stimulus.people) {
      const fs::path* file = person.figure ? scenes::file_of(*person.figure) : nullptr;
      if (file != nullptr) checker.check(member_path(person.motion.path, "look.figure"), *file);
      if (person.face)
        checker.check(member_path(person.motion.path, "look.face.file"), person.face->file);
    }
    for (const NamedMotion& motion : named_motions(stimulus))
      checker.check_file_of(motion.path, motion.key, motion.file);
    if (stimulus.audio)
      checker.check_file_of(member_path(stimulus.path, "audio"), "file", stimulus.audio->file);
  }
  return checker.take();
}

}  // namespace mien::pipeline
