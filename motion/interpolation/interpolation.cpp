#include "motion/interpolation/interpolation.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/measures/distance/distance.h"

namespace mien::motion {

namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
    text += names[i];
  }
  return text;
}

std::string counted(Eigen::Index count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

void add_shared_place_remarks(const ExampleSet& set, Interpolator& interpolator) {
  const DistinctParameters& distinct = interpolator.distinct;
  for (size_t place = 0; place < distinct.sharers.size(); ++place) {
    if (distinct.sharers[place] < 2) continue;
    std::vector<std::string> names;
    for (size_t i = 0; i < distinct.place_of_example.size(); ++i) {
      if (distinct.place_of_example[i] == static_cast<int>(place)) {
        names.push_back(set.examples[i].name);
      }
    }
    interpolator.remarks.push_back(listed(names) +
                                   " have the same parameters: they share their weight equally, "
                                   "and none of them can be used alone");
  }
}

/// Adds remarks on the dependence of the requested parameters, which come first.
void add_dependence_remarks(Interpolator& interpolator, Eigen::Index asked) {
  const Eigen::MatrixXd places = interpolator.distinct.places.leftCols(asked);
  const Eigen::Index count = places.rows();
  const std::string what = listed({interpolator.names.begin(), interpolator.names.begin() + asked});
  if (count == 1) {
    interpolator.remarks.push_back(
        "all examples have the same parameters, so every request gives the same motion");
    return;
  }
  if (places.cols() + 1 > count) {
    interpolator.remarks.push_back(
        what + " are more parameters than " + counted(count, "different example") +
        " can distinguish: requests are met only as far as the examples differ");
    return;
  }
  const int rank = spread_rank(places);
  if (rank < places.cols()) {
    interpolator.remarks.push_back(
        what + " depend on each other over these examples: they vary in " +
        counted(rank, "direction") + " only, and requests outside it have no effect");
  }
}

std::string percent(double share) {
  return std::to_string(static_cast<int>(std::lround(100.0 * share))) + " %";
}

void add_halving_remark(int halvings, const std::string& what, Interpolator& interpolator) {
  if (halvings == 0) return;
  interpolator.remarks.push_back("examples lie so close that the " + what + " was halved " +
                                 counted(halvings, "time") + " to keep the weights exact");
}

Eigen::VectorXd source_weights(const GridOfWeights& grid, const Eigen::RowVectorXd& parameters) {
  return std::visit([&](const auto& source) { return weights(source, parameters); }, grid.source);
}

Eigen::VectorXd grid_weights(const GridOfWeights& grid, const Eigen::RowVectorXd& parameters) {
  return weights(
      grid.grid, [&](const Eigen::RowVectorXd& node) { return source_weights(grid, node); },
      parameters);
}

/// Error of a grid at the examples themselves.
void add_grid_error_remark(const GridOfWeights& grid, const Eigen::MatrixXd& places,
                           Interpolator& interpolator) {
  double least = 1.0;
  for (Eigen::Index k = 0; k < places.rows(); ++k) {
    least = std::min(least, grid_weights(grid, places.row(k))[k]);
  }
  if (least > 0.95) return;
  interpolator.remarks.push_back(
      "the grid of " + counted(grid.grid.cells, "cell") +
      " per parameter does not represent every example: one has a weight of only " +
      std::to_string(static_cast<int>(std::lround(100.0 * std::max(0.0, least)))) +
      " % at its own parameters");
}

GridOfWeights fit_grid(const Eigen::MatrixXd& places, const InterpolationOptions& options) {
  GridOfWeights grid{make_weight_grid(places, options.grid_cells), {}};
  if (options.grid_source == GridSource::cardinal) {
    grid.source = fit_cardinal_basis(places);
  } else {
    grid.source = fit_nearest_neighbours(places, options.nearest);
  }
  return grid;
}

/// Unlikeness of places: that of the first examples that stand there.
Eigen::MatrixXd place_differences(const ExampleSet& set, const DistinctParameters& distinct) {
  const Eigen::MatrixXd all = half_squared_differences(set);
  std::vector<Eigen::Index> first(distinct.sharers.size());
  for (size_t i = distinct.place_of_example.size(); i-- > 0;) {
    first[static_cast<size_t>(distinct.place_of_example[i])] = static_cast<Eigen::Index>(i);
  }
  return all(first, first);
}

/// Input of the fits.
struct Fit {
  const ExampleSet& set;
  const Eigen::MatrixXd& parameters;
  const InterpolationOptions& options;
  Eigen::Index held;
};

void fit_cardinal(Interpolator& fitted) {
  CardinalBasis basis = fit_cardinal_basis(fitted.distinct.places);
  add_halving_remark(basis.halvings, "reach of the radial functions", fitted);
  fitted.method = std::move(basis);
}

void fit_reaching(const Fit& fit, Interpolator& fitted) {
  Reach reach = fit_reach(fitted.distinct.places, fit.held);
  add_halving_remark(reach.basis.halvings, "reach of the radial functions", fitted);
  fitted.method = std::move(reach);
}

void fit_grid_of_weights(const Fit& fit, Interpolator& fitted) {
  GridOfWeights grid = fit_grid(fitted.distinct.places, fit.options);
  add_grid_error_remark(grid, fitted.distinct.places, fitted);
  fitted.method = std::move(grid);
}

void fit_kriging_method(const Fit& fit, Interpolator& fitted) {
  Kriging kriging = fit_kriging(fitted.distinct.places, fit.options.kriging,
                                place_differences(fit.set, fitted.distinct));
  add_halving_remark(kriging.halvings, "range of the variogram", fitted);
  fitted.method = std::move(kriging);
}

void fit_model(const Fit& fit, Interpolator& fitted) {
  StatisticalModel model = fit_statistical_model(fit.set, fit.parameters, fit.options.pca);
  fitted.remarks.push_back("the statistical model keeps " + percent(model.kept_variance) +
                           " of the examples' variance in " +
                           counted(model.variances.size(), "component"));
  fitted.method = std::move(model);
}

void fit_method(const Fit& fit, Interpolator& fitted) {
  const Eigen::MatrixXd& places = fitted.distinct.places;
  switch (fit.options.method) {
    case InterpolationMethod::reach:
      return fit_reaching(fit, fitted);
    case InterpolationMethod::cardinal:
      return fit_cardinal(fitted);
    case InterpolationMethod::grid:
      return fit_grid_of_weights(fit, fitted);
    case InterpolationMethod::kriging:
      return fit_kriging_method(fit, fitted);
    case InterpolationMethod::pca:
      return fit_model(fit, fitted);
    case InterpolationMethod::nearest:
      fitted.method = fit_nearest_neighbours(places, fit.options.nearest);
      break;
    case InterpolationMethod::inverse_distance:
      fitted.method = InverseDistance{fit.options.power};
      break;
    case InterpolationMethod::incremental:
      fitted.method = fit_word_clicks(places, fit.options.click_step);
      break;
    case InterpolationMethod::direct:
      break;
  }
}

/// "3 × quickness up, 1 × largeness down": the clicks in their order, runs counted.
std::string click_log(const ClickPath& path, const std::vector<std::string>& names) {
  std::string log;
  for (size_t i = 0; i < path.clicks.size();) {
    size_t end = i;
    while (end < path.clicks.size() && path.clicks[end] == path.clicks[i]) ++end;
    if (!log.empty()) log += ", ";
    log += std::to_string(end - i) + " × " + names[static_cast<size_t>(path.clicks[i].parameter)] +
           (path.clicks[i].sign > 0 ? " up" : " down");
    i = end;
  }
  return log.empty() ? "no click" : log;
}

}  // namespace

Interpolator fit_interpolator(const ExampleSet& set, const Eigen::MatrixXd& parameters,
                              const InterpolationOptions& options,
                              const std::vector<std::string>& names, Eigen::Index held) {
  assert(parameters.rows() == static_cast<Eigen::Index>(set.examples.size()));
  assert(parameters.rows() > 0 && held >= 0 && held < std::max<Eigen::Index>(1, parameters.cols()));
  Interpolator fitted;
  if (options.method == InterpolationMethod::direct) {
    fitted.method = DirectShares{};
    return fitted;
  }
  fitted.distinct = distinct_parameters(parameters);
  fitted.names = names;
  for (Eigen::Index m = static_cast<Eigen::Index>(names.size()); m < parameters.cols(); ++m) {
    fitted.names.push_back("parameter " + std::to_string(m + 1));
  }
  add_shared_place_remarks(set, fitted);
  add_dependence_remarks(fitted, parameters.cols() - held);
  fit_method({set, parameters, options, held}, fitted);
  return fitted;
}

InterpolatedWeights weights_at(const Interpolator& interpolator,
                               const Eigen::RowVectorXd& parameters) {
  const DistinctParameters& distinct = interpolator.distinct;
  InterpolatedWeights result;
  const auto of_places = [&](const Eigen::VectorXd& by_place) {
    return clipped_and_normalised(by_example(distinct, by_place));
  };
  std::visit(
      Overloaded{
          [&](const CardinalBasis& basis) {
            result.weights = of_places(raw_weights(basis, parameters));
          },
          [&](const Reach& reach) { result.weights = of_places(weights(reach, parameters)); },
          [&](const NearestNeighbours& samples) {
            result.weights = of_places(weights(samples, parameters));
          },
          [&](const InverseDistance& how) {
            result.weights =
                of_places(inverse_distance_weights(distinct.places, parameters, how.power));
          },
          [&](const GridOfWeights& grid) {
            result.weights = of_places(grid_weights(grid, parameters));
          },
          [&](const Kriging& kriging) {
            const KrigedWeights kriged = kriged_weights(kriging, parameters);
            result.weights = of_places(kriged.weights);
            if (kriging.fitted) result.expected_error_m = std::sqrt(kriged.variance);
          },
          [&](const StatisticalModel& model) {
            result.weights = equivalent_weights(model, parameters);
          },
          [&](const WordClicks& words) {
            const ClickPath path = click_towards(words, parameters);
            result.weights = of_places(path.weights);
            result.remarks.push_back("clicks: " + click_log(path, interpolator.names));
            if (!path.arrived) {
              result.remarks.push_back("no further click came closer to the requested values");
            }
          },
          [&](const DirectShares&) { result.weights = direct_weights(parameters.transpose()); },
      },
      interpolator.method);
  return result;
}

Example motion_at(const Interpolator& interpolator, const ExampleSet& set,
                  const Eigen::RowVectorXd& parameters, const BlendOptions& options) {
  if (const auto* model = std::get_if<StatisticalModel>(&interpolator.method)) {
    return motion_of(*model, coordinates_at(*model, parameters), options.frames_per_second);
  }
  return blend(set, weights_at(interpolator, parameters).weights, options);
}

Eigen::VectorXd direct_weights(const Eigen::VectorXd& shares) {
  assert(shares.size() > 0 && shares.minCoeff() >= 0.0);
  const double sum = shares.sum();
  if (sum > 0.0) return shares / sum;
  return Eigen::VectorXd::Constant(shares.size(), 1.0 / static_cast<double>(shares.size()));
}

Eigen::MatrixXd half_squared_differences(const ExampleSet& set) {
  const auto count = static_cast<Eigen::Index>(set.examples.size());
  constexpr Eigen::Index moments = Eigen::Index{distance_times} * distance_joints;
  Example timing;
  timing.keytimes =
      mean_keytimes(set, Eigen::VectorXd::Constant(count, 1.0 / static_cast<double>(count)));
  Eigen::MatrixXd joints(3 * moments, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Example& example = set.examples[static_cast<size_t>(i)];
    Eigen::Index row = 0;
    for (int t = 0; t < distance_times; ++t) {
      const double seconds = corresponding_time(timing, example, t / (distance_times - 1.0));
      const auto positions = world_positions(
          example.clip.body, aligned_pose_at(example.clip, seconds, Alignment::pelvis));
      for (int j = 1; j <= distance_joints; ++j, row += 3) {
        joints.block<3, 1>(row, i) = positions[static_cast<size_t>(j)];
      }
    }
  }
  Eigen::MatrixXd result(count, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index k = 0; k < count; ++k) {
      result(i, k) =
          0.5 * (joints.col(i) - joints.col(k)).squaredNorm() / static_cast<double>(moments);
    }
  }
  return result;
}

}  // namespace mien::motion
