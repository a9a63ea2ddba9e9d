#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/manifest/file_keys.h"
#include "pipeline/manifest/manifest.h"

namespace mien::pipeline {

/// What of a stimulus an option changes: the first thing in the order of production.
enum class Aspect {
  motion,
  scene,    ///< figure, set, camera, size of the picture
  drawing,  ///< how the same scene is drawn: samples, shutter, seed of the noise
  video,    ///< how the same frames are shown and encoded
};

inline constexpr Words<Aspect> aspect_words = {{"motion", Aspect::motion},
                                               {"scene", Aspect::scene},
                                               {"drawing", Aspect::drawing},
                                               {"video", Aspect::video}};

inline std::string_view name_of(Aspect aspect) { return word_of(aspect_words, aspect); }

/// One option as it was used, whether the manifest names it or not.
struct Setting {
  std::string path;  ///< "adjectives.quickness"; of the whole study "examples.set"
  Aspect aspect = Aspect::motion;
  std::string value;  ///< as JSON; of a file its name

  friend bool operator==(const Setting&, const Setting&) = default;
};

/// What ends the path of a setting that says which files are named: "clip content".
inline constexpr char content_words[] = " content";

/// Everything that a manifest says of what is seen of one of its stimuli, in the manifest's order,
/// its set option by option, and the files that it names with hashes ("clip content":
/// {"walk.bvh": "0123456789ab"}). A foil has what its original says.
std::vector<Setting> settings_of(const Stimulus& stimulus, const Manifest& manifest,
                                 FileKeys& files);

/// An option that says something else than before; empty where it is not said on one side.
struct SettingChange {
  std::string path;
  Aspect aspect = Aspect::motion;
  std::string before;
  std::string now;

  friend bool operator==(const SettingChange&, const SettingChange&) = default;
};

/// In the order of `before`, then what is new. What a set's file does not say of a light, wall, box
/// or belt that is there is what it is by default, and so is what is not said of a step of
/// `modify`, unless a recipe says it.
std::vector<SettingChange> changes_between(const std::vector<Setting>& before,
                                           const std::vector<Setting>& now);

/// Values as people write them, colours as "#c08040" where they are such.
/// "adjectives.quickness 0.6 → 0.61", "examples content: sad.bvh is another (01… → 23…)"
std::string change_text(const SettingChange& change);

}  // namespace mien::pipeline
