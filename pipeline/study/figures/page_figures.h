#pragma once

#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "motion/skeleton/clip.h"
#include "scenes/character/character.h"
#include "scenes/figures/figure.h"
#include "scenes/figures/figure_colour.h"

namespace mien::pipeline {

/// The figure with which a page displays a motion.
struct PageFigure {
  /// Identifies the GLB file; empty: the page draws a stick figure.
  std::string key;

  /// Number of the joints that have poses of their own: those of a character, or those of the body
  /// and its hands (motion::with_fingers). 0: the figure has the joints of the body.
  int joints = 0;
  bool has_hands = false;  ///< whether these joints are those of the body and its hands

  /// World-space poses of these joints as in the film; empty if `joints` is 0. Little-endian f32:
  /// positions (frames × joints × 3, metres), then rotations as quaternions (frames × joints × 4:
  /// x, y, z, w).
  std::string poses;

  /// Number of morphs of a character that the look's face moves (MorphTarget::morph); 0: its face
  /// is as its file has it.
  int morphs = 0;
  /// Their weights, little-endian f32: frames of the film × morphs, or one frame if they stay.
  std::string face;
};

/// What a figure shows.
struct FigureRequest {
  const scenes::Figure& figure;
  scenes::FigureColours colours;
  const motion::Clip& clip;  ///< with the fingers that are shown
  int film_frames = 0;       ///< of the film, whose face may move on while a loop repeats
};

/// The poses of all joints of the clip's skeleton, as PageFigure::poses.
std::string body_poses(const motion::Clip& clip);

/// Creates GLB files of the mannequins and characters of films. Caches characters, the most recent
/// files and the weights of faces. Not thread-safe.
class PageFigures {
 public:
  /// The figure and its poses. Point-light figures, stick figures and non-human bodies have no GLB
  /// file. A trail has the figure of its body. Throws Error if a character cannot be read, or its
  /// face as FaceMotion.
  PageFigure fitted_figure(const FigureRequest& request);

  /// The GLB file of a figure (skinned_glb.h); empty if the figure has no file or its key is not
  /// `key`. Throws Error.
  const std::string& file(const std::string& key, const FigureRequest& request);

 private:
  using CachedCharacter = std::shared_ptr<const scenes::Character>;
  /// A face in each frame of the film, or in one frame if it stays.
  struct FaceFrames {
    int morphs = 0;
    std::string weights;                   ///< PageFigure::face
    std::vector<scenes::FaceTurns> turns;  ///< of jaw and eyes; empty: none
  };

  CachedCharacter character(const std::filesystem::path& file, const motion::Skeleton& body);
  const FaceFrames& face(const scenes::Character& character, const std::string& character_key,
                         const FigureRequest& request);

  std::deque<std::pair<std::string, CachedCharacter>> characters_;  ///< newest first
  std::deque<std::pair<std::string, std::string>> files_;           ///< by key, newest first
  std::deque<std::pair<std::string, FaceFrames>> faces_;            ///< newest first
};

}  // namespace mien::pipeline
