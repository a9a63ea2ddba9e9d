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

/// The figure on which the studio shows a motion.
struct StudioFigure {
  /// Identifies the GLB file; empty: the page draws its own figure.
  std::string key;

  int joints = 0;  ///< joints of the GLB file, if other than the body's

  /// World-space poses of these joints as in the film: f32 positions (frames × joints × 3, metres),
  /// then rotations (frames × joints × 4: x, y, z, w), little endian.
  std::string poses;
};

/// Makes the mannequins and characters of films as GLB files. Caches characters and the last files.
/// Not thread-safe.
class StudioFigures {
 public:
  /// The figure of a clip, with its poses. Point lights, sticks and non-human bodies have no file.
  /// A trail has the figure of its body. Throws Error when a character cannot be read.
  StudioFigure fitted_figure(const scenes::Figure& figure, scenes::Role role,
                             const motion::Clip& clip);

  /// The GLB file with that key (skinned_glb.h); empty where the figure has another key or no file.
  /// Throws Error.
  const std::string& file(const std::string& key, const scenes::Figure& figure, scenes::Role role,
                          const motion::Skeleton& body);

 private:
  using CachedCharacter = std::shared_ptr<const scenes::Character>;

  CachedCharacter character(const std::filesystem::path& file, const motion::Skeleton& body);

  std::deque<std::pair<std::string, CachedCharacter>> characters_;  ///< most recently used first
  std::deque<std::pair<std::string, std::string>> files_;  ///< by key, most recently used first
};

}  // namespace mien::pipeline
