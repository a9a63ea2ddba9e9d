#pragma once

#include <filesystem>
#include <map>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "motion/skeleton/clip.h"
#include "pipeline/manifest/determinants.h"
#include "pipeline/production/film/film.h"
#include "pipeline/production/film/film_equalized.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/regression/baseline.h"
#include "pipeline/regression/comparison/noise_test.h"
#include "pipeline/tasks/hash.h"
#include "render/image/image.h"
#include "scenes/stage/shot.h"

namespace mien::pipeline {

/// A study as this program shows it: its motions, and single frames of its films without the films.
/// Made of a manifest of today, or of one that was approved some time ago.
class Rendition {
 public:
  /// Films are equalized in `folder`, which is a store. Throws Error, also where the films cannot
  /// be equalized, and Interrupted.
  Rendition(Manifest manifest, const std::filesystem::path& folder, int threads,
            const std::stop_token& stop);

  const Manifest& manifest() const { return manifest_; }
  Motions& motions() { return motions_; }
  FileKeys& files() { return files_; }

  /// What the film of a stimulus shows. Throws Error when it cannot be made.
  const motion::Clip& clip_of(const std::string& id);

  /// Shows another clip in its place.
  void show(const std::string& id, motion::Clip clip) { clips_[id] = std::move(clip); }

  /// What determines a frame beside the clip, the program and its libraries: the scene, and how it
  /// is drawn.
  Hash scene_key(const std::string& id);
  Hash drawing_key(const std::string& id) const;

  Equalized alike(const std::string& id) const { return equalized_.of(id); }

 private:
  Manifest manifest_;
  FileKeys files_;
  EqualizedFilms equalized_;
  Motions motions_;
  std::map<std::string, motion::Clip> clips_;
};

/// What a frame is made from; each may be another rendition's.
struct FrameSources {
  Rendition* motion = nullptr;
  Rendition* scene = nullptr;
  Rendition* drawing = nullptr;
  const motion::Clip* clip = nullptr;  ///< shown in place of `motion`'s, if any
};

/// A stimulus staged, so that any of its frames can be drawn.
struct StagedFilm {
  scenes::Shot shot;
  FilmSettings settings;
};

/// Throws Error.
StagedFilm staged(const std::string& id, const FrameSources& sources, int threads);

/// Frames as a display shows them. All are in the shot. Throws Interrupted.
std::vector<render::Image8> drawn(const StagedFilm& film, const std::vector<int>& frames,
                                  const std::stop_token& stop);

/// How much of each frame is noise: the light of its blocks, as a display shows it, under several
/// patterns of it. Throws Interrupted.
std::vector<BlockStatistics> measured_blocks(const StagedFilm& film, const std::vector<int>& frames,
                                             const std::stop_token& stop);

/// What is known of a stimulus once its motion is made: all but edition, key frames and videos.
/// Throws Error when the motion cannot be made.
StimulusFacts facts_of(const std::string& id, Rendition& rendition);

}  // namespace mien::pipeline
