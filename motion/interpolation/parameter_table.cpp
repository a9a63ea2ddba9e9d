#include "motion/interpolation/parameter_table.h"

#include <algorithm>

#include "motion/error.h"
#include "motion/math/singular_values.h"

namespace mien::motion {

namespace {

constexpr double same_parameters = 1e-6;

}  // namespace

DistinctParameters distinct_parameters(const Eigen::MatrixXd& example_parameters) {
  DistinctParameters distinct;
  std::vector<Eigen::Index> representatives;
  for (Eigen::Index i = 0; i < example_parameters.rows(); ++i) {
    size_t place = 0;
    while (place < representatives.size() &&
           (example_parameters.row(i) - example_parameters.row(representatives[place])).norm() >=
               same_parameters) {
      ++place;
    }
    if (place == representatives.size()) {
      representatives.push_back(i);
      distinct.sharers.push_back(0);
    }
    distinct.place_of_example.push_back(static_cast<int>(place));
    ++distinct.sharers[place];
  }
  distinct.places.resize(static_cast<Eigen::Index>(representatives.size()),
                         example_parameters.cols());
  for (size_t k = 0; k < representatives.size(); ++k) {
    distinct.places.row(static_cast<Eigen::Index>(k)) = example_parameters.row(representatives[k]);
  }
  return distinct;
}

Eigen::VectorXd by_example(const DistinctParameters& distinct, const Eigen::VectorXd& by_place) {
  Eigen::VectorXd weights(static_cast<Eigen::Index>(distinct.place_of_example.size()));
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    const int place = distinct.place_of_example[static_cast<size_t>(i)];
    weights[i] = by_place[place] / distinct.sharers[static_cast<size_t>(place)];
  }
  return weights;
}

int spread_rank(const Eigen::MatrixXd& places) {
  if (places.rows() < 2 || places.cols() == 0) return 0;
  const Eigen::MatrixXd centred = places.rowwise() - places.colwise().mean();
  return static_cast<int>(singular_values(centred).rank(singular_share));
}

int ParameterTable::find(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

Eigen::Index parameter_row(const std::string& name, const ParameterTable& table) {
  const int row = table.find(name);
  if (row >= 0) return row;
  throw Error("the examples have no parameter \"" + name + "\"",
              "use a rated scale, or a feature that all examples have");
}

Eigen::MatrixXd places_of_examples(std::span<const std::string> parameters,
                                   const ParameterTable& table) {
  Eigen::MatrixXd places(table.values.cols(), static_cast<Eigen::Index>(parameters.size()));
  for (Eigen::Index i = 0; i < places.cols(); ++i) {
    const std::string& name = parameters[static_cast<std::size_t>(i)];
    places.col(i) = table.values.row(parameter_row(name, table)).transpose();
  }
  return places;
}

}  // namespace mien::motion
