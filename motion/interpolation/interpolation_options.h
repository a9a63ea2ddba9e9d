#pragma once

#include <cstdint>
#include <string_view>

#include "motion/text/words.h"

namespace mien::motion {

/// How blend weights are computed from parameters.
enum class InterpolationMethod {
  reach,     ///< meets the request exactly, as near to `cardinal` as possible (reach.h); default
  cardinal,  ///< linear part and cubic B-splines (cardinal_basis.h): the paper's
  nearest,   ///< nearest neighbours among examples and random blends of them
  inverse_distance,  ///< Shepard's inverse distances
  grid,              ///< multilinear on a regular grid of another method's weights
  kriging,           ///< universal kriging, with an error estimate
  pca,               ///< statistical model of the motions; yields no blend
  incremental,       ///< incremental clicks on words, solved with the pseudo-inverse
  direct,            ///< the parameters are the examples' shares
};

/// Their names in manifests and tables.
inline constexpr mien::Words<InterpolationMethod> interpolation_methods = {
    {"reach", InterpolationMethod::reach},
    {"cardinal", InterpolationMethod::cardinal},
    {"knn", InterpolationMethod::nearest},
    {"inverse-distance", InterpolationMethod::inverse_distance},
    {"grid", InterpolationMethod::grid},
    {"kriging", InterpolationMethod::kriging},
    {"pca", InterpolationMethod::pca},
    {"incremental", InterpolationMethod::incremental},
    {"direct", InterpolationMethod::direct}};

inline std::string_view name_of(InterpolationMethod method) {
  return word_of(interpolation_methods, method);
}

struct NearestNeighboursOptions {
  int neighbours = 0;  ///< number of neighbours, the farthest with weight 0; 0 means M + 2
  int trials = 300;    ///< random blends that are tried as further samples; 0 for none
  double least_distance = 0.05;  ///< of a blend's parameters from those of every other sample
  std::uint64_t seed = 0;

  friend bool operator==(const NearestNeighboursOptions&,
                         const NearestNeighboursOptions&) = default;
};

struct KrigingOptions {
  bool linear_drift = true;  ///< universal kriging; otherwise ordinary kriging (constant mean)
  double nugget = 0.0;       ///< share of the sill taken as noise of the examples; 0 is exact

  friend bool operator==(const KrigingOptions&, const KrigingOptions&) = default;
};

/// Estimator of a statistical model for the motion at given parameters.
enum class ModelEstimate {
  expected,     ///< mean of the motions that have them: regression of coordinates on parameters
  most_likely,  ///< maximum a posteriori: likely by itself, and with parameters as measured near
};

struct StatisticalModelOptions {
  ModelEstimate estimate = ModelEstimate::expected;
  double noise = 0.1;  ///< most likely: SD with which a motion's parameters are known, > 0
  double variance_share = 0.95;  ///< of the examples' variance that the components keep
  double ridge = 1e-3;           ///< added to the variances of the parameters
  int samples = 60;              ///< of a motion between its first and last keytime

  friend bool operator==(const StatisticalModelOptions&, const StatisticalModelOptions&) = default;
};

/// The method from which a grid's nodes are sampled.
enum class GridSource { cardinal, nearest };

/// Largest number of parameters of a grid: a cell has 2^M corners.
inline constexpr int max_grid_dimensions = 8;

/// Options of all methods; only those of the chosen method apply.
struct InterpolationOptions {
  InterpolationMethod method = InterpolationMethod::reach;
  NearestNeighboursOptions nearest;
  double power = 2.0;  ///< of inverse distances, > 0
  int grid_cells = 8;  ///< a dimension
  GridSource grid_source = GridSource::cardinal;
  KrigingOptions kriging;
  StatisticalModelOptions pca;
  double click_step = 0.25;  ///< standard deviations over the examples

  friend bool operator==(const InterpolationOptions&, const InterpolationOptions&) = default;
};

}  // namespace mien::motion
