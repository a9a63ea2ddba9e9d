#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "pipeline/base/adaptive/choice_chain.h"

namespace mien::pipeline {

/// A probability density at equally spaced places of a range, both ends included.
struct SampleDensity {
  std::vector<double> places;
  std::vector<double> density;  ///< its integral over the range is 1
};

/// The density of samples within a range: a kernel estimate with normal kernels, which are
/// reflected at the ends of the range. Their standard deviation is Silverman's (1986, eq. 3.31),
/// 0.9 times the smaller of the samples' standard deviation and their interquartile range/1.34,
/// times m^(−1/5), with m the number of independent samples (`effective`; that of all if NaN), and
/// at least 1 % of the range. Samples are first spread over the places, so that the time does not
/// grow with the product of their number and that of the places. There must be at least one sample.
SampleDensity sample_density(const std::vector<double>& samples, double effective,
                             const DimensionRange& range, int places = 101);

/// The plane in which samples vary most: their first two principal components.
struct SamplePlane {
  Eigen::VectorXd centre;        ///< mean of the samples
  Eigen::MatrixX2d axes;         ///< orthonormal; the largest entry of each is positive
  std::array<double, 2> shares;  ///< of the variance of the samples, 0…1

  Eigen::Vector2d at(const Eigen::VectorXd& sample) const;
};

/// `samples`: one column each, of two or more dimensions, in comparable units.
SamplePlane sample_plane(const Eigen::MatrixXd& samples);

/// A density over a square, at the middles of equal cells.
struct DensityMap {
  double low_x = 0.0, low_y = 0.0, width = 0.0;
  Eigen::MatrixXd density;  ///< (row: y from below, column: x); its integral over the square is 1
};

/// The density of points (one column each) of a square: a kernel estimate with normal kernels whose
/// standard deviation is that of the points along each axis, at least 2 % of the width, times
/// n^(−1/6) (Scott 1992). `cells`: number of cells along each side.
DensityMap density_map(const Eigen::Matrix2Xd& points, double low_x, double low_y, double width,
                       int cells = 48);

}  // namespace mien::pipeline
