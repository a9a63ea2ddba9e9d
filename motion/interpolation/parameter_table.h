#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace mien::motion {

/// Places in parameter space at which examples stand. Examples nearer than 1e-6 to one another
/// share a place: no interpolation can reproduce both.
struct DistinctParameters {
  Eigen::MatrixXd places;             ///< one row a place (K × M)
  std::vector<int> place_of_example;  ///< N entries
  std::vector<int> sharers;           ///< examples a place; K entries
};

/// `example_parameters`: one row an example (N × M). Places are in the order of their first
/// examples.
DistinctParameters distinct_parameters(const Eigen::MatrixXd& example_parameters);

/// Weights of examples from weights of places: those who share a place share its weight equally.
Eigen::VectorXd by_example(const DistinctParameters& distinct, const Eigen::VectorXd& by_place);

/// Singular values below this share of the largest count as zero.
inline constexpr double singular_share = 1e-8;

/// Directions in which the rows spread: the number of singular values of the centred matrix above
/// that share. 0 for one row.
int spread_rank(const Eigen::MatrixXd& places);

/// Parameters that motions can be made from, and where the examples lie on them: one row each,
/// values 0…1 at the examples. They may come from ratings or from measures of the motions.
struct ParameterTable {
  std::vector<std::string> names;  ///< groups (primary parameters) first, then single ones
  Eigen::MatrixXd values;          ///< parameters × examples
  bool simulated = false;          ///< based on simulated ratings

  /// Row of a parameter, or −1.
  int find(const std::string& name) const;
};

/// The row of a parameter. Throws Error when the examples have none of that name.
Eigen::Index parameter_row(const std::string& name, const ParameterTable& table);

/// Values of the examples for some of the parameters: N × parameters. Throws Error when one does
/// not exist.
Eigen::MatrixXd places_of_examples(std::span<const std::string> parameters,
                                   const ParameterTable& table);

}  // namespace mien::motion
