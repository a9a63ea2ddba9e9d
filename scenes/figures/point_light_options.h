#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mien::scenes {

/// A point-light figure: dots on the joints of a body that is not seen itself (Johansson 1973), and
/// the transformations by which studies take form, motion or order away from it.
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
  std::string background;  ///< likewise of the background

  /// Frames that a dot stays in its place on the body before it takes another one, at random on any
  /// limb (Beintema & Lappe 2002); the dots change one after the other, not all at once. 0: for
  /// ever on its joint. Noise and mask dots live for ever.
  int lifetime = 0;

  bool inverted = false;         ///< upside down
  bool mirrored = false;         ///< left and right exchanged, as seen by the camera
  double rotated_degrees = 0.0;  ///< about the vertical, counter-clockwise seen from above
  bool scrambled = false;        ///< each dot's motion at a random place within the figure's extent

  bool reversed = false;         ///< last frame first
  bool constant_speed = false;   ///< each dot goes its own path evenly
  bool phase_scrambled = false;  ///< each dot's motion starts at a random moment of it

  /// Dots that go straight in the plane of the picture, as fast as the figure's dots do there, and
  /// turn back at the ends of the figure's extent.
  int noise = 0;
  /// Dots of scrambled figures: each has a joint's motion, somewhere else and begun at another
  /// moment.
  int mask = 0;

  std::optional<std::uint64_t> seed;  ///< of all that is random; the production's own otherwise

  friend bool operator==(const PointLightOptions&, const PointLightOptions&) = default;
};

}  // namespace mien::scenes
