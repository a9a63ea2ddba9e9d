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

/// What the studio shows a motion on.
struct StudioFigure {
  /// Tells the GLB file apart from others; empty: the page draws a figure of its own.
  std::string key;

  int joints = 0;  ///< of the file, if not the body's own

  /// Where these are: f32 positions (frames × joints × 3, metres), then rotations (× 4: x, y, z,
  /// w), world space, little endian; what a film's figure does in these frames.
  std::string poses;
};

/// Mannequins and characters for pages, made as films have them. Characters and the last files are
/// kept. Not for several threads at once.
class StudioFigures {
 public:
  /// How a clip is worn; no file for point lights and sticks, nor for what is no human body. A
  /// trail's figure is its body's. Throws Error when a character cannot be read.
  StudioFigure worn(const scenes::Figure& figure, scenes::Role role, const motion::Clip& clip);

  /// The file of that key (skinned_glb.h); empty where the figure has another or none. Throws
  /// Error.
  const std::string& file(const std::string& key, const scenes::Figure& figure, scenes::Role role,
                          const motion::Skeleton& body);

 private:
  using Kept = std::shared_ptr<const scenes::Character>;

  Kept character(const std::filesystem::path& file, const motion::Skeleton& body);

  std::deque<std::pair<std::string, Kept>> characters_;    ///< the last asked for first
  std::deque<std::pair<std::string, std::string>> files_;  ///< likewise, by their keys
};

}  // namespace mien::pipeline
