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
  /// PeopleMessage (shown_people.h), framed (figure_message.h). Its JSON has the tokens of
  /// `figures`, too.
  std::string bytes;
  std::vector<FigureFile> figures;
};

/// Makes them, and the files of figures in `folder`, each once.
class TurnedMotions {
 public:
  /// Keeps a reference to the manifest.
  TurnedMotions(const Manifest& manifest, std::filesystem::path folder);

  /// Nothing if the stimulus is one motion of a figure that cannot be turned, or not of a human
  /// body: the page then shows its motion file. Throws Error.
  std::optional<TurnedMotion> of(const Stimulus& stimulus);

 private:
  FigureFile written(const std::string& glb);

  std::filesystem::path folder_;
  Motions motions_;
  PageFigures figures_;
  std::set<std::string> written_;  ///< tokens
};

}  // namespace mien::pipeline
