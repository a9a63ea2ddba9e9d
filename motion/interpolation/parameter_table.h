#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace mien::motion {

/// Distinct positions of the examples in parameter space. Examples closer than 1e-6 share a
/// position, because no interpolation can reproduce both.
struct DistinctParameters {
  Eigen::MatrixXd places;             ///< one row per position (K × M)
  std::vector<int> place_of_example;  ///< row of `places` for each of the N examples
  std::vector<int> sharers;           ///< number of examples at each of the K positions
};

/// The distinct positions of examples, in the order of the first example at each.
/// `example_parameters` has one row per example (N × M).
DistinctParameters distinct_parameters(const Eigen::MatrixXd& example_parameters);

/// Weights of the examples from weights of the distinct positions: examples that share a position
/// share its weight equally.
Eigen::VectorXd by_example(const DistinctParameters& distinct, const Eigen::VectorXd& by_place);

/// Singular values below this fraction of the largest one are treated as zero.
inline constexpr double singular_share = 1e-8;

/// Number of directions in which the rows vary: the number of singular values of the centred matrix
/// above `singular_share` of the largest. 0 for a single row.
int spread_rank(const Eigen::MatrixXd& places);

/// Parameters for motion synthesis and their values at the examples, scaled to 0…1. Values are
/// derived from ratings or from measures of the motions.
struct ParameterTable {
  std::vector<std::string> names;  ///< groups (primary parameters) first, then single ones
  Eigen::MatrixXd values;          ///< one row per parameter, one column per example
  bool simulated = false;          ///< based on simulated ratings

  /// The row of a parameter, or −1 if there is none of that name.
  int find(const std::string& name) const;
};

/// The row of a parameter. Throws Error if there is none of that name.
Eigen::Index parameter_row(const std::string& name, const ParameterTable& table);

/// Values of selected parameters for all examples: one row per example, one column per parameter.
/// Throws Error if a parameter does not exist.
Eigen::MatrixXd places_of_examples(std::span<const std::string> parameters,
                                   const ParameterTable& table);

}  // namespace mien::motion
