#include "render/compare/perceptual_color.h"

#include <Eigen/LU>

namespace mien::render {
namespace {

Eigen::Vector3d xyz_of_chromaticity(double x, double y) { return {x / y, 1.0, (1.0 - x - y) / y}; }

Eigen::Matrix3d relative_matrix() {
  Eigen::Matrix3d primaries;
  primaries << xyz_of_chromaticity(0.64, 0.33), xyz_of_chromaticity(0.30, 0.60),
      xyz_of_chromaticity(0.15, 0.06);
  const Eigen::Vector3d white = xyz_of_chromaticity(0.31271, 0.32902);
  const Eigen::Vector3d shares = primaries.inverse() * white;
  return white.cwiseInverse().asDiagonal() * primaries * shares.asDiagonal();
}

ColorMatrix as_floats(const Eigen::Matrix3d& matrix) {
  ColorMatrix rows{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
          static_cast<float>(matrix(i, j));
  return rows;
}

}  // namespace

const ColorMatrix& white_relative_xyz() {
  static const ColorMatrix matrix = as_floats(relative_matrix());
  return matrix;
}

const ColorMatrix& linear_from_white_relative_xyz() {
  static const ColorMatrix matrix = as_floats(relative_matrix().inverse());
  return matrix;
}

float largest_color_power() {
  const ColorMatrix& m = white_relative_xyz();
  static const float largest = power(hyab(hunt_lab_from_linear(m, {0.0f, 1.0f, 0.0f}),
                                          hunt_lab_from_linear(m, {0.0f, 0.0f, 1.0f})),
                                     color_exponent);
  return largest;
}

}  // namespace mien::render
