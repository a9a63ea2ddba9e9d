#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace mien::motion {

/// Parameters that motions can be made from, and where the examples lie on them: one row each,
/// values 0…1 at the examples. Whether people's ratings or measures of the motions are behind them
/// is of no concern to whoever makes motions.
struct ParameterTable {
  std::vector<std::string> names;  ///< groups (primary parameters) first, then single ones
  Eigen::MatrixXd values;          ///< parameters × examples
  bool simulated = false;          ///< rests on ratings that nobody gave

  /// Row of a parameter, or −1.
  int find(const std::string& name) const;
};

/// The row of a parameter. Throws Error when the examples have none of that name.
Eigen::Index parameter_row(const std::string& name, const ParameterTable& table);

/// Where the examples lie on some of the parameters: N × parameters. Throws Error when they lack
/// one.
Eigen::MatrixXd places_of_examples(std::span<const std::string> parameters,
                                   const ParameterTable& table);

}  // namespace mien::motion
