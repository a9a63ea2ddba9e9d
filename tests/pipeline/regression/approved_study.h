#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "motion/skeleton/recording.h"
#include "pipeline/regression/regression.h"
#include "pipeline/temporary_folder.h"

namespace mien::test {

using Videos = std::map<std::string, std::vector<pipeline::VideoFacts>>;

/// A changed study in a folder, and its earlier approved baseline.
struct ChangedStudy {
  std::filesystem::path folder;
  nlohmann::json manifest;  ///< written to study.yaml after all other changes
  pipeline::Baseline baseline;
  Videos videos;  ///< as they were made now
  int threads = 1;
  double audits = 0.0;

  nlohmann::json& stimulus(const std::string& id);
  pipeline::StimulusFacts& approved(const std::string& id);

  /// Writes the motion of "file" anew, after a change.
  void change_motion(const std::function<void(motion::Recording&)>& change) const;

  /// Another text in place of one that a file of the study holds. Throws when it does not.
  void change_text(const std::string& file, const std::string& from, const std::string& to) const;
};

/// The texture of "someone", all of one grey.
void write_texture(const std::filesystem::path& folder, std::uint8_t grey);

/// A tiny study with a stimulus of each kind, and its baseline:
///
///     blend   weights              file     a BVH file
///     wish    adjectives           tinted   weights, in a set of the study's own
///     styled  weights, modified    someone  weights, a character with a texture
///
/// The examples are BVH files in a folder, with simulated ratings. Made once for all tests, and
/// copied for each change.
class ApprovedStudy {
 public:
  ApprovedStudy();

  /// A copy of it all in `folder`, which is made.
  ChangedStudy copied(const std::filesystem::path& folder) const;

  /// A baseline of the study after a change, which is approved in `folder`: for changes of the
  /// program, which a test cannot make.
  pipeline::Baseline approved(const ChangedStudy& study, const std::filesystem::path& folder) const;

 private:
  std::filesystem::path folder_;
};

const ApprovedStudy& approved_study();

/// The study as it is now; what its films have in common is worked out in `store`.
std::unique_ptr<pipeline::Rendition> rendition_of(const ChangedStudy& study,
                                                  const std::filesystem::path& store);

/// Writes the manifest and compares.
pipeline::Regression regressed(const ChangedStudy& study);

/// What became of one stimulus.
const pipeline::StimulusComparison& comparison_of(const pipeline::Regression& regression,
                                                  std::string_view id);

}  // namespace mien::test
