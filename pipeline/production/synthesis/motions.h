#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "motion/measures/distance/distance.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/production/clips/finished_motions.h"
#include "pipeline/production/synthesis/repertoire.h"
#include "pipeline/production/synthesis/synthesis.h"

namespace mien::pipeline {

/// The motions of a manifest, each made at its first use and then kept. A run that finds everything
/// in its store does not read any example. May be used from several threads.
class Motions : public FinishedMotions {
 public:
  /// Keeps a reference to the manifest.
  explicit Motions(const Manifest& manifest);
  ~Motions() override;
  Motions(const Motions&) = delete;
  Motions& operator=(const Motions&) = delete;

  const Repertoire& repertoire();

  const Stimulus* stimulus(const std::string& id) const override;

  /// Returns the motion of a stimulus, of a person or, if there is neither, of an example. Throws
  /// Error, also for a stimulus with several people.
  const Synthesis& of(const std::string& name);

  /// Returns the distance between two motions (motion/measures/distance/distance.h). For motion
  /// files that do not walk in place, the feet are first aligned with the floor and locked
  /// (settled_feet.h), as for blends; otherwise the height of captured feet above the floor would
  /// dominate the distance. Throws Error.
  motion::Distance distance(const std::string& target, const std::string& created);

  const motion::Clip& clip(const std::string& name) override { return of(name).motion.clip; }
  motion::Clip shown(const Stimulus& stimulus) override;
  int shown_frames(const Stimulus& stimulus) override;

  /// Returns the duration of the shortest of all clips shown, in seconds. Makes all motions unless
  /// it is known (know_shortest).
  double shortest_seconds();

  void know_shortest(double seconds) override;

 private:
  struct Entry;
  Entry& entry(const std::string& name);
  Synthesis make(const std::string& name);
  Synthesis synthesized(const Stimulus& requested);
  const motion::Example& measured(const std::string& name);
  int cut_to_shortest(int frames, double frames_per_second);

  const Manifest& manifest_;
  mutable std::once_flag stimuli_once_;
  mutable std::unordered_map<std::string_view, const Stimulus*> stimuli_;  ///< stimuli by id
  std::once_flag repertoire_once_;
  std::optional<Repertoire> repertoire_;
  std::mutex mutex_;  ///< guards the map; entries keep their addresses
  std::map<std::string, std::unique_ptr<Entry>> entries_;
  std::once_flag shortest_once_;
  double shortest_s_ = 0.0;  ///< duration of the shortest clip shown
};

/// Whether any stimulus is made from examples instead of from a file or along a path.
bool blends_examples(const Manifest& manifest);

/// Returns the stimulus with that id, or that of a person's motion, or nullptr. A linear search,
/// suitable for a few ids.
const Stimulus* find_stimulus(const Manifest& manifest, const std::string& id);

}  // namespace mien::pipeline
