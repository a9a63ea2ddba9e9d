#include "pipeline/production/synthesis/fitted_recordings.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "motion/formats/fitted_file.h"
#include "pipeline/manifest/example_files.h"
#include "pipeline/manifest/named_motions.h"
#include "pipeline/manifest/people.h"
#include "pipeline/manifest/recording_files.h"

namespace mien::pipeline {

namespace {

/// Collects recordings, each once.
class Collection {
 public:
  /// Adds a use of a recording; `fit_of` is called once for each recording.
  void add(const std::filesystem::path& file, const motion::ReadOptions& how,
           const std::string& user, const auto& fit_of) {
    const std::filesystem::path place = std::filesystem::absolute(file).lexically_normal();
    auto known = std::ranges::find_if(
        entries_, [&](const Entry& one) { return one.file == place && one.how == how; });
    if (known == entries_.end()) {
      entries_.push_back({place, how, fit_of(), {}});
      known = entries_.end() - 1;
    }
    if (known->used_by.empty() || known->used_by.back() != user) known->used_by.push_back(user);
  }

  std::vector<FittedRecording> take() {
    std::vector<FittedRecording> fitted;
    for (Entry& one : entries_) {
      if (one.fit)
        fitted.push_back({one.file, one.how, std::move(*one.fit), std::move(one.used_by)});
    }
    return fitted;
  }

 private:
  struct Entry {
    std::filesystem::path file;
    motion::ReadOptions how;
    std::optional<motion::FitQuality> fit;
    std::vector<std::string> used_by;
  };
  std::vector<Entry> entries_;
};

bool uses_examples_of(const Stimulus* motion) {
  return is_blend(*motion) || names_examples(*motion);
}

}  // namespace

std::vector<FittedRecording> fitted_recordings(const Manifest& manifest, Motions& motions) {
  Collection collection;
  if (std::ranges::any_of(motion_sources(manifest), uses_examples_of)) {
    for (const motion::ExampleOrigin& origin : motions.repertoire().origins)
      collection.add(origin.file, read_options(manifest.examples.how), "examples",
                     [&] { return origin.fit; });
  }
  for (const Stimulus* source : motion_sources(manifest)) {
    const Stimulus& stimulus = *source;
    for (const NamedMotion& motion : named_motions(stimulus)) {
      const bool is_clip = motion.path == member_path(stimulus.path, "clip");
      collection.add(motion.file, motion.how, stimulus.id, [&] {
        return is_clip ? motions.of(stimulus.id).fit
                       : motion::read_fitted(motion.file, motion.how).fit;
      });
    }
  }
  return collection.take();
}

}  // namespace mien::pipeline
