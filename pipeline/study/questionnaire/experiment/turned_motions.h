#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/study/figures/page_figures.h"

namespace mien::pipeline {

/// The GLB file of a mannequin or character (skinned_glb.h), which stimuli share.
struct FigureFile {
  std::filesystem::path file;
  std::string token;  ///< public name, from its contents
  std::string sha256;
};

/// What a page shows of a stimulus that can be turned: people who move as in the film.
struct TurnedMotion {
  /// Contains a PeopleMessage (shown_people.h), framed (figure_message.h). Its JSON has the tokens
  /// of `figures`, too.
  std::filesystem::path file;
  std::vector<FigureFile> figures;
};

/// Makes them in `folder`. Files that are there with the same contents are not written again.
class TurnedMotions {
 public:
  /// Keeps a reference to the manifest.
  TurnedMotions(const Manifest& manifest, std::filesystem::path folder);

  /// Nothing if the stimulus is one motion of a figure that cannot be turned, or not of a human
  /// body: the page then shows its motion file. `token` is the public name of the stimulus. Throws
  /// Error.
  std::optional<TurnedMotion> of(const Stimulus& stimulus, const std::string& token);

 private:
  FigureFile figure_file(const std::string& glb);
  void write(const std::filesystem::path& file, const std::string& bytes);

  std::filesystem::path folder_;
  Motions motions_;
  PageFigures figures_;
  std::set<std::filesystem::path> written_;
};

}  // namespace mien::pipeline
