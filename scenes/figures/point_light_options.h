#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mien::scenes {

/// A point-light figure: dots on the joints of an invisible body (Johansson 1973), and the
/// manipulations by which studies remove form, motion or order from it.
struct PointLightOptions {
  /// "standard": head, shoulders, elbows, wrists, hips, knees and ankles, the 13 of Cutting 1978;
  /// "all": every joint; empty: those of `joints`.
  std::string joint_set = "standard";
  std::vector<std::string> joints;  ///< names of the skeleton's joints, and "HeadTop"

  double size_px = 8.0;          ///< diameter, the same near and far
  std::optional<double> size_m;  ///< diameter in metres instead: nearer dots are larger

  bool dark_on_light = false;  ///< dots darker than the background
  /// Michelson contrast of dots and background, 0 … 1; the lighter of the two is white.
  double contrast = 1.0;
  std::string colour;      ///< "#rrggbb" of the dots; empty: by polarity and contrast
  std::string background;  ///< of the background; empty: by polarity and contrast

  /// Limited lifetime: frames that a dot keeps its position on the body before it moves to a random
  /// position on any limb (Beintema & Lappe 2002); dots change asynchronously. 0: unlimited, on the
  /// joint. Noise and mask dots have unlimited lifetimes.
  int lifetime = 0;

  bool inverted = false;         ///< upside down
  bool mirrored = false;         ///< left and right exchanged, as seen by the camera
  double rotated_degrees = 0.0;  ///< about the vertical, counter-clockwise seen from above
  bool scrambled = false;        ///< each dot's motion at a random position in the extent

  bool reversed = false;         ///< last frame first
  bool constant_speed = false;   ///< each dot follows its own path at constant speed
  bool phase_scrambled = false;  ///< each dot's motion starts at a random moment of it

  /// Number of noise dots, which move in straight lines in the picture plane, as fast as the
  /// figure's dots, and reverse at the ends of the figure's extent.
  int noise = 0;
  /// Number of mask dots of scrambled figures: each has a joint's motion at another position and
  /// with another phase.
  int mask = 0;

  std::optional<std::uint64_t> seed;  ///< default: derived from the production's

  friend bool operator==(const PointLightOptions&, const PointLightOptions&) = default;
};

}  // namespace mien::scenes
