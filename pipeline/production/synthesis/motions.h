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

/// The motions of a manifest, each made when it is first needed and then kept. A run that finds
/// everything in its store never reads an example. May be used from several threads.
class Motions : public FinishedMotions {
 public:
  /// Keeps a reference to the manifest.
  explicit Motions(const Manifest& manifest);
  ~Motions() override;
  Motions(const Motions&) = delete;
  Motions& operator=(const Motions&) = delete;

  const Repertoire& repertoire();

  const Stimulus* stimulus(const std::string& id) const override;

  /// The motion of a stimulus or, if no stimulus is called so, of an example. Throws Error.
  const Synthesis& of(const std::string& name);

  /// The distance of two motions (motion/measures/distance/distance.h). Feet of a motion file are
  /// settled first (settled_feet.h), as those of blends are: captures hang above the floor, and
  /// else their height would be most of the distance. Throws Error.
  motion::Distance distance(const std::string& target, const std::string& created);

  const motion::Clip& clip(const std::string& name) override { return of(name).motion.clip; }
  motion::Clip shown(const Stimulus& stimulus) override;

  /// Seconds that the shortest of all clips shown lasts. Makes all motions.
  double shortest_seconds();

  void know_shortest(double seconds) override;

 private:
  struct Entry;
  Entry& entry(const std::string& name);
  Synthesis make(const std::string& name);
  Synthesis synthesized(const Stimulus& requested);
  const motion::Example& measured(const std::string& name);

  const Manifest& manifest_;
  mutable std::once_flag stimuli_once_;
  mutable std::unordered_map<std::string_view, const Stimulus*> stimuli_;  ///< by id
  std::once_flag repertoire_once_;
  std::optional<Repertoire> repertoire_;
  std::mutex mutex_;  ///< of the map; entries stay where they are
  std::map<std::string, std::unique_ptr<Entry>> entries_;
  std::once_flag shortest_once_;
  double shortest_s_ = 0.0;  ///< of the clips shown
};

/// Whether a modification of the stimulus takes something from an example.
bool names_examples(const Stimulus& stimulus);

/// Whether anything is made from examples, and not from files or along paths alone.
bool blends_examples(const Manifest& manifest);

/// The stimulus of that id, or nullptr. Looks at one after the other: for a few ids.
const Stimulus* find_stimulus(const Manifest& manifest, const std::string& id);

}  // namespace mien::pipeline
