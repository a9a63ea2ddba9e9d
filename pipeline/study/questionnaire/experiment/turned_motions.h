#pragma once

#include <filesystem>
#include <map>
#include <optional>
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
  /// A message (figure_message.h). Its JSON has "fps", "frames", "front" (the horizontal direction
  /// from which several people are seen first: x, z; null for one person), "figures" (the tokens
  /// of `figures`) and "people": of each
  /// "body" and "hands" (body_info; null for other than human bodies), "colours" of the middle, the
  /// left and the right (linear Rec. 709), "file" (an index of `figures`; -1: a stick figure), and
  /// figure_json. The bytes are, for each person, the world-space poses of the joints
  /// (PageFigure::poses), of the body's if the figure has no others, and the weights of the face.
  std::string bytes;
  std::vector<FigureFile> figures;
};

/// Makes them, and the files of figures in `folder`, each once.
class TurnedMotions {
 public:
  /// Keeps a reference to the manifest.
  TurnedMotions(const Manifest& manifest, std::filesystem::path folder);

  /// Nothing if the stimulus is one motion of another figure, or not of a human body: the page then
  /// shows its motion file. Throws Error.
  std::optional<TurnedMotion> of(const Stimulus& stimulus);

 private:
  FigureFile file_of(const std::string& key, const FigureRequest& request);

  std::filesystem::path folder_;
  Motions motions_;
  PageFigures figures_;
  std::map<std::string, FigureFile> files_;  ///< by key
};

}  // namespace mien::pipeline
