#pragma once

#include <array>
#include <string>
#include <string_view>

namespace mien::test {

/// The morph targets of the figure, named as ARKit names blend shapes.
inline constexpr std::array<std::string_view, 10> face_targets = {
    "eyeBlinkLeft",   "eyeBlinkRight",   "jawOpen",     "mouthSmileLeft", "mouthSmileRight",
    "mouthFrownLeft", "mouthFrownRight", "browInnerUp", "browDownLeft",   "browDownRight"};

/// Half the height of the opening between the lids of an open eye, metres, and the radius of the
/// eyeball.
inline constexpr double lid_opening_m = 0.0046;
inline constexpr double eyeball_radius_m = 0.0125;

enum class FaceFormat {
  gltf,   ///< morph targets alone
  vrm,    ///< with the bones and some expressions of VRM 1.0
  joints  ///< without morph targets; jaw and eyes are joints, named as in HumanIK
};

/// A figure with a face, as a GLB file: the body of a mannequin, and a head of simple surfaces with
/// eyes, lids, brows, lips and hair, whose morph targets are sparse accessors.
std::string face_figure_glb(FaceFormat format);

}  // namespace mien::test
