#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "motion/skeleton/clip.h"
#include "scenes/figures/face.h"

namespace mien::scenes {

/// Height of the drawn figure, metres: the standing height of a canonical body (body.h). Without
/// one, the median over the frames of the vertical extent of the clip's markers or, if it has none,
/// the largest distance of a joint or tip from the root in the first frame; at least 0.2.
double figure_height(const motion::Clip& clip);

/// The properties of a kind of figure, declared as the member `kind` of its options. All code that
/// reads, checks, lists or describes figures is based on them.
struct FigureKind {
  const char* name;            ///< name in manifests, options and tables: "point-light"
  const char* set = "studio";  ///< default set

  /// Whether it is drawn as dots (Actor::dots) in exactly the given colours, without motion blur.
  /// Their random properties depend on the stimulus, and a table lists their positions.
  bool has_dots = false;

  const char* not_in_overlays = "";  ///< why an overlay cannot show it; empty: it can
};

/// A stick figure: a round cone for each bone and a sphere for each joint.
struct StickOptions {
  static constexpr FigureKind kind = {.name = "stick"};

  friend bool operator==(const StickOptions&, const StickOptions&) = default;
};

/// How finely surfaces that are made for a shot are divided into triangles.
enum class MeshDetail {
  full,
  draft  ///< about half as many triangles
};

/// A smooth body with the proportions of the clip's skeleton.
struct MannequinOptions {
  static constexpr FigureKind kind = {.name = "mannequin"};

  double build = 0.5;  ///< 0 slim … 1 heavy
  double sex = 0.5;    ///< 0 female … 1 male

  friend bool operator==(const MannequinOptions&, const MannequinOptions&) = default;
};

/// A skinned character from a glTF or FBX file.
struct CharacterOptions {
  static constexpr FigureKind kind = {.name = "character"};

  std::filesystem::path file;
  Face face;  ///< by `with_face`; a manifest states it beside the figure

  friend bool operator==(const CharacterOptions&, const CharacterOptions&) = default;
};

/// A point-light figure: dots on the joints of an invisible body (Johansson 1973), and the
/// manipulations by which studies remove form, motion or order from it.
struct PointLightOptions {
  static constexpr FigureKind kind = {
      .name = "point-light",
      .set = "void",
      .has_dots = true,
      .not_in_overlays = "the point lights of several motions cannot be told apart"};

  /// "standard": head, shoulders, elbows, wrists, hips, knees and ankles, the 13 of Cutting 1978
  /// (every joint of a skeleton other than the canonical body); "hands": these and the ten
  /// fingertips; "all": every joint of the body; empty: the joints listed in `joints`.
  std::string joint_set = "standard";
  /// Names of the skeleton's joints, "HeadTop", and those of fingers and their tips (dot_joints.h).
  std::vector<std::string> joints;

  double size_px = 8.0;          ///< diameter in pixels, independent of distance
  std::optional<double> size_m;  ///< diameter in metres instead: nearer dots are larger

  bool dark_on_light = false;  ///< dots darker than the background
  /// Michelson contrast of dots and background, 0 … 1; the lighter of the two is white.
  double contrast = 1.0;
  std::string colour;      ///< "#rrggbb" of the dots; empty: from dark_on_light and contrast
  std::string background;  ///< "#rrggbb" of the background; empty: from dark_on_light and contrast

  /// Limited lifetime: frames that a dot keeps its position on the body before it moves to a random
  /// position on any limb (Beintema & Lappe 2002); dots change asynchronously. 0: unlimited, on the
  /// joint. Noise and mask dots have unlimited lifetimes.
  int lifetime = 0;

  bool inverted = false;         ///< upside down
  bool mirrored = false;         ///< left and right swapped, as seen by the camera
  double rotated_degrees = 0.0;  ///< about the vertical, counter-clockwise seen from above
  bool scrambled = false;  ///< each dot's motion at a random position within the figure's extent

  bool reversed = false;         ///< last frame first
  bool constant_speed = false;   ///< each dot follows its own path at constant speed
  bool phase_scrambled = false;  ///< each dot's motion starts at a random phase

  /// Number of noise dots, which move in straight lines in the picture plane, as fast as the
  /// figure's dots, and reverse at the ends of the figure's extent.
  int noise = 0;
  /// Number of mask dots, as if from scrambled figures: each has the motion of one of the figure's
  /// dots, at a random position within the figure's extent and from a random phase on.
  int mask = 0;

  std::optional<std::uint64_t>
      seed;  ///< default: Look::seed, which a study derives from its seed and the stimulus's id

  friend bool operator==(const PointLightOptions&, const PointLightOptions&) = default;
};

/// The markers of the recording that a motion was made from (motion/skeleton/clip_markers.h), as
/// point lights or joined to a stick figure: what was recorded, without a body.
struct MarkersOptions {
  static constexpr FigureKind kind = {
      .name = "markers",
      .set = "void",
      .has_dots = true,
      .not_in_overlays = "the markers of several motions cannot be told apart"};

  std::vector<std::string> show;  ///< patterns of names (motion/text/glob.h); empty: all
  /// Names of markers that a stick joins. With a limited lifetime they are the limbs of the dots
  /// instead, and sticks are not drawn.
  std::vector<std::array<std::string, 2>> pairs;
  /// Whether a marker that was not recorded is shown where its gap was filled in. Otherwise it is
  /// dark, as in gaps that were not filled in.
  bool fills_gaps = false;

  /// How the dots are drawn and changed; its joints are not used.
  PointLightOptions dots;

  friend bool operator==(const MarkersOptions&, const MarkersOptions&) = default;
};

/// Figures with a surface, which can be shown in several poses at once.
using BodyFigure = std::variant<StickOptions, MannequinOptions, CharacterOptions>;

/// Several poses of one clip in one picture.
struct TrailOptions {
  static constexpr FigureKind kind = {.name = "trail",
                                      .not_in_overlays = "a trail shows one motion only"};

  BodyFigure figure;

  /// Number of poses that stay visible, evenly spread over the clip. Each appears at its time in
  /// the clip and stays, so that the last picture shows them all.
  int poses = 6;

  int before = 0;                ///< onion skin: number of poses before the present one
  int after = 0;                 ///< onion skin: number of poses after the present one
  double every_s = 0.2;          ///< interval between the onion skin's poses, seconds
  double min_opacity = 0.15;     ///< 0 … 1: lower limit of the opacity of poses, which decreases
                                 ///< with their distance in time from the present one
  double trace_width_m = 0.018;  ///< width of the traces of joints
  std::vector<std::string> traces;  ///< "feet", "hands", "head", "pelvis", or names of joints

  friend bool operator==(const TrailOptions&, const TrailOptions&) = default;
};

/// The representation of the moving body, with its options.
using Figure = std::variant<StickOptions, MannequinOptions, CharacterOptions, PointLightOptions,
                            MarkersOptions, TrailOptions>;

/// Options of a kind that is read from a file, so that its name alone does not specify it.
template <class Options>
concept FromFile = requires(const Options& options) {
  options.file;
};

/// Calls `use` with the default options of each kind of Figure or BodyFigure, in their order.
template <class Figures>
void for_each_kind(const auto& use) {
  const auto use_each = [&]<std::size_t... k>(std::index_sequence<k...>) {
    (use(std::variant_alternative_t<k, Figures>()), ...);
  };
  use_each(std::make_index_sequence<std::variant_size_v<Figures>>());
}

const FigureKind& kind_of(const Figure& figure);

/// How the dots of a point-light figure, or of markers, are drawn; null for other kinds.
const PointLightOptions* dots_in(const Figure& figure);
PointLightOptions* dots_in(Figure& figure);

/// The names of the kinds of Figure or BodyFigure that are not read from a file.
template <class Figures>
std::vector<std::string> figure_names() {
  std::vector<std::string> names;
  for_each_kind<Figures>([&]<class Options>(const Options&) {
    if (!FromFile<Options>) names.emplace_back(Options::kind.name);
  });
  return names;
}

/// The figure with a face, if it, or a trail's figure, is a character; others have none.
Figure with_face(Figure figure, const Face& face);

/// The file that a figure, or a trail's figure, is read from; null for other kinds.
const std::filesystem::path* file_of(const Figure& figure);

}  // namespace mien::scenes
