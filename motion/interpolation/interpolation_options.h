#pragma once

#include <cstdint>
#include <string_view>

#include "motion/text/words.h"

namespace mien::motion {

/// Method of computing blend weights from parameters.
enum class InterpolationMethod {
  reach,     ///< meets the request where possible, with weights nearest to `cardinal`; default
  cardinal,  ///< linear part and cubic B-splines (cardinal_basis.h); the method of the paper
  nearest,   ///< nearest neighbours among examples and random blends of them
  inverse_distance,  ///< inverse distance weighting (Shepard)
  grid,              ///< multilinear interpolation of another method's weights on a regular grid
  kriging,           ///< universal kriging, with an error estimate
  pca,               ///< statistical model of the motions; does not blend examples
  incremental,       ///< incremental clicks on words, solved with the pseudo-inverse
  direct,            ///< the parameters are the weights of the examples, up to normalisation
};

/// Names of the methods in manifests and tables.
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
  int neighbours = 0;  ///< number of neighbours, at least 3, the farthest of which has weight 0; 0:
                       ///< two more than there are parameters
  int trials = 300;    ///< random blends to try as additional samples; 0 for none
  double least_distance = 0.05;  ///< minimum distance of a blend's parameters from other samples
  std::uint64_t seed = 0;

  friend bool operator==(const NearestNeighboursOptions&,
                         const NearestNeighboursOptions&) = default;
};

struct KrigingOptions {
  bool linear_drift = true;  ///< true: universal kriging; false: ordinary kriging (constant mean)
  double nugget = 0.0;  ///< fraction of the sill attributed to noise in the examples; 0: examples
                        ///< are met exactly

  friend bool operator==(const KrigingOptions&, const KrigingOptions&) = default;
};

/// Estimator for the motion at given parameters in a statistical model.
enum class ModelEstimate {
  expected,  ///< mean of the motions with these parameters: regression of coordinates on parameters
  most_likely,  ///< maximum a posteriori: a likely motion whose measured parameters are near the
                ///< given ones
};

struct StatisticalModelOptions {
  ModelEstimate estimate = ModelEstimate::expected;
  double noise = 0.1;  ///< for `most_likely`: standard deviation of the noise in parameters, > 0
  double variance_share = 0.95;  ///< fraction of the examples' variance that the components retain
  double ridge = 1e-3;           ///< for `expected`: added to the variances of the parameters
  int samples = 60;              ///< times at which a motion is sampled, from first to last keytime

  friend bool operator==(const StatisticalModelOptions&, const StatisticalModelOptions&) = default;
};

/// The method that computes the weights at the nodes of a grid.
enum class GridSource { cardinal, nearest };

/// Maximum number of parameters of a grid: a cell has 2^M corners.
inline constexpr int max_grid_dimensions = 8;

/// Options of all methods; only those of the selected method apply.
struct InterpolationOptions {
  InterpolationMethod method = InterpolationMethod::reach;
  NearestNeighboursOptions nearest;
  double power = 2.0;  ///< exponent of inverse distances, > 0
  int grid_cells = 8;  ///< per dimension
  GridSource grid_source = GridSource::cardinal;
  KrigingOptions kriging;
  StatisticalModelOptions pca;
  double click_step = 0.25;  ///< change per click, in standard deviations over the examples

  friend bool operator==(const InterpolationOptions&, const InterpolationOptions&) = default;
};

}  // namespace mien::motion
