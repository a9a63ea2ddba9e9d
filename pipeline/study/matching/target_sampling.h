#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pipeline/manifest/ratings/scales/parameter_table.h"
#include "pipeline/production/synthesis/repertoire.h"

namespace mien::pipeline {

/// A target motion of a matching experiment, to be recreated by participants.
struct SampledTarget {
  std::string id;  ///< "target-1", "practice-1", …
  bool practice = false;
  Eigen::RowVectorXd place;    ///< target parameters, each in [0, 1]
  Eigen::RowVectorXd reached;  ///< parameters of the blend that approximates them (reach.h)
  Eigen::RowVectorXd spread_coordinates;  ///< coordinates of that blend, in which targets are
                                          ///< spread (TargetSpread)
  int nearest_example = 0;                ///< column of the table
  double distance = 0.0;                  ///< Euclidean distance of `place` from that example
};

/// Handling of sampled parameters that no blend of the examples reaches.
enum class UnreachablePolicy {
  reject,   ///< discarded; another point is sampled
  project,  ///< replaced by the nearest reachable parameters
};

/// Coordinates in which targets are chosen as far apart as possible.
enum class TargetSpread {
  parameters,  ///< the parameters that define the targets
  everything,  ///< all rows of the table: all rated scales and groups, or all features
};

struct TargetOptions {
  int targets = 5;             ///< number of targets
  int practice = 3;            ///< number of practice targets
  double max_distance = 0.35;  ///< largest Euclidean distance from the nearest example
  UnreachablePolicy unreachable = UnreachablePolicy::reject;
  TargetSpread spread = TargetSpread::parameters;
  std::uint64_t seed = 0;
};

/// Samples targets for a matching experiment, as in the second study of the adjective paper. Points
/// are drawn uniformly from [0, 1]^M and rounded to 0.001. Points farther than `max_distance` from
/// every example are rejected; points that no blend reaches are rejected or projected. From 400
/// distinct points of this kind (fewer if 200 000 draws do not yield so many), targets are chosen
/// by farthest-point sampling (Gonzalez 1985) in the spread coordinates, starting with the point
/// farthest from the mean. Practice targets are the first points, in order of drawing, that were
/// not chosen.
///
/// `parameters` are names of rows of the table. Throws Error if too few points are accepted.
std::vector<SampledTarget> sample_targets(const ParameterTable& table,
                                          const std::vector<std::string>& parameters,
                                          const TargetOptions& options);

/// The parameters that have sliders in a matching experiment: the groups of rated scales, or all
/// rated scales if there are no groups.
std::vector<std::string> primary_adjectives(const Repertoire& repertoire);

/// Names of the four groups of features.
std::vector<std::string> primary_features();

}  // namespace mien::pipeline
