#pragma once

#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "motion/skeleton/clip.h"
#include "scenes/character/character.h"
#include "scenes/figures/figure.h"
#include "scenes/figures/figure_colour.h"

namespace mien::pipeline {

/// The figure with which the studio displays a motion.
struct StudioFigure {
  /// Identifies the GLB file; empty: the page uses its own figure.
  std::string key;

  int joints = 0;  ///< number of joints of a GLB file with joints of its own, which those of hands
                   ///< are too; 0 if its joints are those of the body

  /// World-space poses of these joints as in the film; empty if `joints` is 0. Little-endian f32:
  /// positions (frames × joints × 3, metres), then rotations as quaternions (frames × joints × 4:
  /// x, y, z, w).
  std::string poses;
};

/// Creates GLB files of the mannequins and characters of films. Caches characters and the most
/// recent files. Not thread-safe.
class StudioFigures {
 public:
  /// The figure of a clip with the fingers that are shown, and its poses. Point-light figures,
  /// stick figures and non-human bodies have no GLB file. A trail has the figure of its body.
  /// Throws Error if a character cannot be read.
  StudioFigure fitted_figure(const scenes::Figure& figure, scenes::Role role,
                             const motion::Clip& clip);

  /// The GLB file of a figure (skinned_glb.h); empty if the figure has no file or its key is not
  /// `key`. Throws Error.
  const std::string& file(const std::string& key, const scenes::Figure& figure, scenes::Role role,
                          const motion::Clip& clip);

 private:
  using CachedCharacter = std::shared_ptr<const scenes::Character>;

  CachedCharacter character(const std::filesystem::path& file, const motion::Skeleton& body);

  std::deque<std::pair<std::string, CachedCharacter>> characters_;  ///< newest first
  std::deque<std::pair<std::string, std::string>> files_;           ///< by key, newest first
};

}  // namespace mien::pipeline
