#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "motion/skeleton/clip.h"
#include "scenes/figures/point_light_options.h"

namespace mien::scenes {

/// How tall the figure is drawn, metres: the body's stature, or how far any other skeleton reaches
/// from its root at first, and at least 0.2.
double figure_height(const motion::Clip& clip);

/// A round cone a bone and a sphere a joint.
struct StickOptions {
  friend bool operator==(const StickOptions&, const StickOptions&) = default;
};

/// A smooth body, made from the clip's own proportions.
struct MannequinOptions {
  double build = 0.5;  ///< 0 slim … 1 heavy
  double sex = 0.5;    ///< 0 female … 1 male

  friend bool operator==(const MannequinOptions&, const MannequinOptions&) = default;
};

/// A skinned character out of a glTF file.
struct CharacterOptions {
  std::filesystem::path file;

  friend bool operator==(const CharacterOptions&, const CharacterOptions&) = default;
};

/// What has a surface and can be shown in several poses at once.
using BodyFigure = std::variant<StickOptions, MannequinOptions, CharacterOptions>;

/// Several poses of one clip in one picture.
struct TrailOptions {
  BodyFigure figure;

  /// Poses left behind, evenly spread over the clip, each from its moment on; the last picture
  /// shows them all. 0 leaves none.
  int poses = 6;

  int before = 0;                   ///< onion skin: poses before the present one
  int after = 0;                    ///< and after it
  double every_s = 0.2;             ///< seconds from one to the next
  double faintest = 0.15;           ///< opacity of the pose farthest from the present, 0 … 1
  double trace_width_m = 0.018;     ///< of the lines that joints leave behind
  std::vector<std::string> traces;  ///< "feet", "hands", "head", "pelvis", or names of joints

  friend bool operator==(const TrailOptions&, const TrailOptions&) = default;
};

/// What stands for the moving body, with everything that can be said of it.
using Figure =
    std::variant<StickOptions, MannequinOptions, CharacterOptions, PointLightOptions, TrailOptions>;

/// The key that a manifest has for it: "stick", "mannequin", "character", "point-light", "trail".
std::string_view name_of(const Figure& figure);

/// The character that a figure, or a trail's figure, is; null for others.
const CharacterOptions* character_in(const Figure& figure);

}  // namespace mien::scenes
