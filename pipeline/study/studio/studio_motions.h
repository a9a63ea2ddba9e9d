#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "motion/skeleton/example.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/study/figures/page_figures.h"
#include "pipeline/study/studio/seen_files.h"
#include "pipeline/study/studio/studio_draft.h"
#include "pipeline/study/studio/studio_people.h"
#include "scenes/figures/figure.h"
#include "scenes/figures/figure_colour.h"
#include "scenes/figures/shown_hands.h"

namespace mien::pipeline {

/// A cached motion.
struct StudioMotion {
  Synthesis synthesis;
  Output output;
  SeenFiles files;  ///< that it was made from, without those of the examples

  /// The motion as read back from its clip file, for comparisons (compared_example.h); computed on
  /// first use.
  std::optional<motion::Example> compared;
};

/// Synthesizes motions of drafts as `mien run` does. Caches examples and the most recent motions,
/// and makes them again when a file that they were made from has changed. Thread-safe; one motion
/// is synthesized at a time.
class StudioMotions {
 public:
  explicit StudioMotions(DraftReader& reader) : reader_(reader), people_(reader) {}

  /// What a page can choose from with the document's examples: "examples" and "sliders" as in
  /// LiveInfo (pipeline/study/page/src/live/core.ts), "blendable": whether the examples can be
  /// blended (if not, there are no sliders), "simulated": whether the ratings are simulated, and
  /// "warnings". Throws DraftFaults.
  nlohmann::ordered_json choices(const nlohmann::ordered_json& document);

  /// The motion of `show`, a stimulus of the document or an example, as bytes:
  ///
  ///     u32 length of the JSON, which is padded with spaces so that 4 + length is a multiple of 8
  ///     {"body": …, "hands": the body with its hands' joints or null, "findings": […],
  ///      "warnings": […], "notes": […], "reached": {…}, "weights": {…}, "modified": …,
  ///      "seconds": computing time, "distance": {…} or null,
  ///      "figure": {"key", "joints", "has_hands", "morphs", "face_frames"} (page_figures.h),
  ///      "people": null, or the JSON of several people (shown_people.h) with the keys of their
  ///      "figures"}
  ///     the motion (motion/live/live_message.h); of several people the first's in their film
  ///     the poses of the figure's own joints, if it has any, and the weights of its face; or those
  ///     of all people (shown_people.h)
  ///
  /// "distance" is D to the motion of `against`, if given, as `mien motion compare` reports it for
  /// the written clips: "D", "D_sum", "by_joint" (20 values), "by_time" (11 values), in metres.
  /// Throws DraftFaults.
  std::string motion(const nlohmann::ordered_json& document, const std::string& show,
                     const std::string& against);

  /// The GLB file of the figure of `show`, or of one of its people; empty if its key is not `key`.
  /// Throws DraftFaults.
  std::string figure(const nlohmann::ordered_json& document, const std::string& show,
                     const std::string& key);

 private:
  using CachedMotion = std::shared_ptr<StudioMotion>;

  /// The figure of a motion and its role in the film.
  struct Shown {
    scenes::Figure figure;
    scenes::Hands hands = scenes::Hands::automatic;
    scenes::Role role = scenes::Role::neutral;
  };

  void forget_changed_examples();
  Motions& study(const nlohmann::ordered_json& document);
  CachedMotion made(const nlohmann::ordered_json& document, const std::string& name);
  Shown shown(const nlohmann::ordered_json& document, const std::string& name);

  /// Examples and their ratings, without motions of stimuli.
  struct Study {
    std::string key;
    std::unique_ptr<const Manifest> manifest;  ///< on the heap, since `motions` refers to it
    std::unique_ptr<Motions> motions;
    SeenFiles files;
  };

  DraftReader& reader_;
  std::mutex mutex_;
  std::deque<Study> studies_;                                      ///< most recently used first
  std::deque<std::pair<std::string, CachedMotion>> motion_cache_;  ///< by request, newest first
  std::deque<std::pair<std::string, Shown>> shown_cache_;  ///< by name and looks, newest first
  PageFigures figures_;
  StudioPeople people_;
};

}  // namespace mien::pipeline
