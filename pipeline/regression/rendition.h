#pragma once

#include <filesystem>
#include <map>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "motion/skeleton/clip.h"
#include "pipeline/manifest/determinants.h"
#include "pipeline/manifest/people.h"
#include "pipeline/production/film/film.h"
#include "pipeline/production/film/film_equalized.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/regression/baseline.h"
#include "pipeline/regression/comparison/noise_test.h"
#include "pipeline/tasks/hash.h"
#include "render/image/image.h"
#include "scenes/stage/shot.h"

namespace mien::pipeline {

/// A study as made by this program: its motions and single frames of its films, without the films
/// themselves. Each of several people in a film counts as a stimulus ("greet.a"), whose clip is
/// where the film shows it and whose frames are those of the film. The manifest is the current one
/// or an approved one.
class Rendition {
 public:
  /// Computes the equalized properties in `folder`, which is a store. Throws Error, also if the
  /// films cannot be equalized, and Interrupted.
  Rendition(Manifest manifest, const std::filesystem::path& folder, int threads,
            const std::stop_token& stop);

  const Manifest& manifest() const { return manifest_; }
  Motions& motions() { return motions_; }
  FileKeys& files() { return files_; }

  /// Returns the clip that the film of a stimulus shows. Throws Error if it cannot be made.
  const motion::Clip& clip_of(const std::string& id);

  /// Replaces the clip that the film of a stimulus shows.
  void show(const std::string& id, motion::Clip clip) { clips_[id] = std::move(clip); }

  /// Keys of the inputs of a frame other than the clip, the program and its libraries: the scene
  /// and the settings of rendering.
  Hash scene_key(const std::string& id);
  Hash drawing_key(const std::string& id) const;

  /// What is equalized across the stimuli (exposure, size and position of the figure), for this
  /// stimulus.
  Equalized alike(const std::string& id) const {
    return equalized_.of(film_showing(manifest_, id)->id);
  }

 private:
  Manifest manifest_;
  FileKeys files_;
  EqualizedFilms equalized_;
  Motions motions_;
  std::map<std::string, motion::Clip> clips_;
};

/// The renditions from which the inputs of a frame are taken; they may differ.
struct FrameSources {
  Rendition* motion = nullptr;
  Rendition* scene = nullptr;
  Rendition* drawing = nullptr;
  const motion::Clip* clip = nullptr;  ///< if not null, replaces the clip of `motion`
};

/// A staged stimulus, of which any frame can be rendered.
struct StagedFilm {
  scenes::Shot shot;
  FilmSettings settings;
};

/// Stages a stimulus. Throws Error.
StagedFilm staged(const std::string& id, const FrameSources& sources, int threads);

/// Renders frames as a display shows them. All frame numbers must be in the shot. Throws
/// Interrupted.
std::vector<render::Image8> drawn(const StagedFilm& film, const std::vector<int>& frames,
                                  const std::stop_token& stop);

/// Measures the noise of frames: renders each frame with noise_patterns different noise patterns,
/// and returns its block statistics, computed from the linear light of the pictures as a display
/// shows them. Throws Interrupted.
std::vector<BlockStatistics> measured_blocks(const StagedFilm& film, const std::vector<int>& frames,
                                             const std::stop_token& stop);

/// Makes a stimulus's motion and returns the facts about the stimulus, without edition, key frames,
/// videos and files. Throws Error if the motion cannot be made.
StimulusFacts facts_of(const std::string& id, Rendition& rendition);

}  // namespace mien::pipeline
