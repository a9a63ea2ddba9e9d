#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "motion/skeleton/clip.h"
#include "scenes/figures/point_light_options.h"

namespace mien::scenes {

/// Height at which the figure is drawn, metres: the body's stature; of another skeleton its extent
/// from the root in the first frame, at least 0.2.
double figure_height(const motion::Clip& clip);

/// A stick figure: a round cone for each bone and a sphere for each joint.
struct StickOptions {
  friend bool operator==(const StickOptions&, const StickOptions&) = default;
};

/// A smooth body with the proportions of the clip's skeleton.
struct MannequinOptions {
  double build = 0.5;  ///< 0 slim … 1 heavy
  double sex = 0.5;    ///< 0 female … 1 male

  friend bool operator==(const MannequinOptions&, const MannequinOptions&) = default;
};

/// A skinned character from a glTF file.
struct CharacterOptions {
  std::filesystem::path file;

  friend bool operator==(const CharacterOptions&, const CharacterOptions&) = default;
};

/// Figures with a surface, which can be shown in several poses at once.
using BodyFigure = std::variant<StickOptions, MannequinOptions, CharacterOptions>;

/// Several poses of one clip in one picture.
struct TrailOptions {
  BodyFigure figure;

  /// Number of poses left behind, evenly spread over the clip, each visible from its time on; the
  /// last picture shows them all.
  int poses = 6;

  int before = 0;                   ///< onion skin: number of poses before the present one
  int after = 0;                    ///< and after it
  double every_s = 0.2;             ///< seconds from one to the next
  double faintest = 0.15;           ///< opacity of the pose farthest from the present, 0 … 1
  double trace_width_m = 0.018;     ///< of the lines that joints leave behind
  std::vector<std::string> traces;  ///< "feet", "hands", "head", "pelvis", or names of joints

  friend bool operator==(const TrailOptions&, const TrailOptions&) = default;
};

/// What represents the moving body, with its options.
using Figure =
    std::variant<StickOptions, MannequinOptions, CharacterOptions, PointLightOptions, TrailOptions>;

/// The key of a figure in a manifest: "stick", "mannequin", "character", "point-light", "trail".
std::string_view name_of(const Figure& figure);

/// The character options of a figure, or of a trail's figure; null for other kinds.
const CharacterOptions* character_in(const Figure& figure);

}  // namespace mien::scenes
