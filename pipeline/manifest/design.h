#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pipeline/base/documents/concerns.h"

namespace mien::pipeline {

/// `design:`: what is known of the factors of the stimuli, for the checks of confounds
/// (production/design/confounds.h) and of levels that are alike (production/design/close_levels.h).
struct Design {
  /// Factor → properties (stimulus_properties) or other factors that are meant to differ between
  /// its levels, so that no warning is given.
  std::vector<std::pair<std::string, std::vector<std::string>>> varies;

  std::vector<std::string> alike;  ///< factors whose levels are meant to look alike

  /// Distance D, metres, below which levels of a factor are reported as alike.
  double threshold_m = 0.06;
};

void fields_of(auto&& field, MaybeConst<Design> auto& design) {
  field("varies", design.varies, concerns::page);
  field("alike", design.alike, concerns::page);
  field("threshold_m", design.threshold_m, concerns::page);
}

/// A property of a stimulus that participants may see besides what its factors describe.
struct StimulusProperty {
  const char* id;    ///< as in `design.varies`: "figure_height"
  const char* name;  ///< "height of the figure"
  const char* unit;  ///< of a number; empty for texts
  bool is_number;
};

/// All properties, in the order of tables.
inline constexpr StimulusProperty stimulus_properties[] = {
    {"figure", "kind of figure", "", false},
    {"figure_options", "options of the figure", "", false},
    {"colours", "colours of figure and background", "", false},
    {"set", "set", "", false},
    {"camera", "camera", "", false},
    {"picture_size", "size of the picture", "", false},
    {"frame_rate", "frames per second", "", false},
    {"in_place", "walking in place", "", false},
    {"sound", "sound", "", false},
    {"figure_height", "height of the figure", "pixels", true},
    {"duration", "duration", "s", true},
    {"speed", "speed over the floor", "m/s", true},
    {"distance", "distance walked in the film", "m", true},
    {"luminance", "mean luminance", "0–1", true},
    {"loudness", "loudness", "LUFS", true}};

}  // namespace mien::pipeline
