#pragma once

#include <array>
#include <functional>
#include <vector>

#include "motion/math/geometry.h"
#include "scenes/face_figure.h"

namespace mien::test {

/// The weights of all targets.
using FaceShape = std::array<double, face_targets.size()>;

/// The targets, in the order of face_targets.
enum FaceTarget {
  blink_left,
  blink_right,
  jaw_open,
  smile_left,
  smile_right,
  frown_left,
  frown_right,
  brow_inner_up,
  brow_down_left,
  brow_down_right
};

/// What moves with a joint of its own where the figure has such joints.
enum class FaceBone { head, jaw, left_eye, right_eye };

/// The places of jaw and eyes, metres from the middle of the head.
motion::Vec3 place_of(FaceBone bone);

/// How much the skin at a place follows the jaw.
double jaw_share(const motion::Vec3& at);

/// Materials of the figure.
enum FaceMaterial { cloth, skin, white, iris, black, lip, hair };

/// A surface over a grid, as it is for some weights. Points are metres from the middle of the head:
/// x to the left, y up, z to the front.
struct FaceSurface {
  int rows = 0;
  int columns = 0;
  FaceMaterial material = skin;
  std::function<motion::Vec3(double u, double v, const FaceShape&)> point;  ///< u and v from 0 to 1
  FaceBone bone = FaceBone::head;
};

/// The head, lips, lids, eyes, brows and hair.
std::vector<FaceSurface> face_surfaces();

}  // namespace mien::test
