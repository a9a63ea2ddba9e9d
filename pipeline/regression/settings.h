#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/manifest/file_keys.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// The aspect of a stimulus that an option changes: the first one affected in the order of
/// production. The random seed counts as `drawing`.
enum class Aspect {
  motion,
  scene,    ///< figure, set, camera, picture size
  drawing,  ///< how the scene is rendered: samples, shutter, seed of the noise
  video,    ///< how the frames are presented and encoded
};

inline constexpr Words<Aspect> aspect_words = {{"motion", Aspect::motion},
                                               {"scene", Aspect::scene},
                                               {"drawing", Aspect::drawing},
                                               {"video", Aspect::video}};

inline std::string_view name_of(Aspect aspect) { return word_of(aspect_words, aspect); }

/// The value of one option, whether the manifest states it or not.
struct Setting {
  std::string path;  ///< "adjectives.quickness"; for the whole study, "examples.set"
  Aspect aspect = Aspect::motion;
  std::string value;  ///< as JSON; for a file, its name

  friend bool operator==(const Setting&, const Setting&) = default;
};

/// The suffix of the path of a setting that contains the hashes of named files: "clip content".
inline constexpr char content_words[] = " content";

/// Whether an option changes what a video shows around and over the film: card, cross, blanks,
/// fades and background.
inline bool is_of_presentation(std::string_view path) {
  return path.starts_with("output.presentation");
}

/// Returns all settings of a manifest that affect how one of its stimuli looks, in the manifest's
/// order, including each option of the stimulus's set and the hashes of named files ("clip
/// content": {"walk.bvh": "0123456789ab"}). The settings of a foil include those that it inherits
/// from its original stimulus.
std::vector<Setting> settings_of(const Stimulus& stimulus, const Manifest& manifest,
                                 FileKeys& files);

/// Returns all options of an overlay that affect its video, in the same form. Those of the motions
/// that it shows are options of its stimuli.
std::vector<Setting> settings_of(const Overlay& overlay, const Manifest& manifest, FileKeys& files);

/// A changed option; `before` or `now` is empty if it is neither stated there nor has a default
/// (changes_between).
struct SettingChange {
  std::string path;
  Aspect aspect = Aspect::motion;
  std::string before;
  std::string now;

  friend bool operator==(const SettingChange&, const SettingChange&) = default;
};

/// Returns the changes in the order of `before`, followed by new options. An option that one side
/// does not state has its default there if that side states other options of the same light, wall,
/// box, belt or step of `modify`, unless a recipe determines the option; otherwise it is empty
/// there.
std::vector<SettingChange> changes_between(const std::vector<Setting>& before,
                                           const std::vector<Setting>& now);

/// Returns a change as readable text, with colours as "#c08040": "adjectives.quickness 0.6 → 0.61",
/// "examples content: sad.bvh has changed (01… → 23…)".
std::string change_text(const SettingChange& change);

}  // namespace mien::pipeline
