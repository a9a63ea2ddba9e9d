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
  Eigen::RowVectorXd
      spread_coordinates;  ///< coordinates of that blend in which targets are spread (TargetSpread)
  int nearest_example = 0;  ///< column of the table
  double distance = 0.0;    ///< to it
};

/// Handling of sampled parameters that no blend of the examples reaches.
enum class UnreachablePolicy {
  reject,   ///< another is sampled
  project,  ///< replaced by the nearest reachable parameters
};

/// Coordinates in which targets are spread as far as possible.
enum class TargetSpread {
  parameters,  ///< those that they are places of
  everything,  ///< all rows of the table: all that raters were asked about, or all features
};

struct TargetOptions {
  int targets = 5;
  int practice = 3;
  double max_distance = 0.35;  ///< beyond it there is nothing to blend
  UnreachablePolicy unreachable = UnreachablePolicy::reject;
  TargetSpread spread = TargetSpread::parameters;
  std::uint64_t seed = 0;
};

/// Targets for a matching experiment, after the second study of the adjective paper: places drawn
/// evenly from [0, 1]^M (to a thousandth), those farther than `max_distance` (Euclidean)
/// from every example rejected, those that no blend has rejected or moved, and of the 400 that
/// remain the chosen number spread by farthest points (Gonzalez 1985), the first being the one
/// farthest from their mean. Practice targets are further draws that were not chosen, in the order
/// of drawing.
///
/// `parameters` are rows of the table. Throws Error when the examples leave too little room.
std::vector<SampledTarget> sample_targets(const ParameterTable& table,
                                          const std::vector<std::string>& parameters,
                                          const TargetOptions& options);

/// The parameters that participants of a matching experiment would move: groups of rated scales
/// or, where there are none, all rated scales.
std::vector<std::string> primary_adjectives(const Repertoire& repertoire);

/// The four groups of features.
std::vector<std::string> primary_features();

}  // namespace mien::pipeline
