#include "pipeline/study/matching/target_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "motion/error.h"
#include "motion/interpolation/reach.h"
#include "pipeline/base/statistics/named_random.h"

namespace mien::pipeline {

namespace {

constexpr int max_draws = 200'000;
constexpr std::size_t pool_size = 400;

/// Largest error of a parameter for a point to count as reached.
constexpr double reached_within = 1e-3;

Eigen::RowVectorXd drawn(std::uint64_t seed, int draw, const std::vector<std::string>& names) {
  Eigen::RowVectorXd place(static_cast<Eigen::Index>(names.size()));
  for (std::size_t d = 0; d < names.size(); ++d) {
    const double value = uniform(seed, fmt::format("target draw {} {}", draw, names[d]));
    place[static_cast<Eigen::Index>(d)] = std::round(1000.0 * value) / 1000.0;
  }
  return place;
}

/// Samples targets and finds the blends that approximate them.
class TargetPool {
 public:
  TargetPool(const ParameterTable& table, const std::vector<std::string>& names,
             const TargetOptions& options)
      : table_(table),
        names_(names),
        options_(options),
        examples_(places_of_examples(names, table)),
        reach_(motion::fit_reach(examples_, 0)) {}

  std::vector<SampledTarget> targets() const {
    std::vector<SampledTarget> pool;
    for (int draw = 0; draw < max_draws && pool.size() < pool_size; ++draw) {
      SampledTarget target;
      target.place = drawn(options_.seed, draw, names_);
      if (!is_near(target) || !reach(target)) continue;
      const auto is_same = [&](const SampledTarget& other) { return other.place == target.place; };
      if (std::ranges::any_of(pool, is_same)) continue;  // projected onto the same corner
      pool.push_back(std::move(target));
    }
    return pool;
  }

 private:
  bool is_near(SampledTarget& target) const {
    const Eigen::VectorXd distances = (examples_.rowwise() - target.place).rowwise().norm();
    target.distance = distances.minCoeff(&target.nearest_example);
    return target.distance <= options_.max_distance;
  }

  /// Whether the target can be made; it is moved to where it can when that is wanted.
  bool reach(SampledTarget& target) const {
    Eigen::VectorXd weights = motion::weights(reach_, target.place);
    target.reached = weights.transpose() * examples_;
    if ((target.reached - target.place).lpNorm<Eigen::Infinity>() > reached_within) {
      if (options_.unreachable == UnreachablePolicy::reject) return false;
      // Rounding may leave the border of what is possible by half a thousandth.
      target.place = (1000.0 * target.reached).array().round() / 1000.0;
      weights = motion::weights(reach_, target.place);
      target.reached = weights.transpose() * examples_;
      is_near(target);
    }
    target.spread_coordinates = options_.spread == TargetSpread::parameters
                                    ? target.reached
                                    : Eigen::RowVectorXd((table_.values * weights).transpose());
    return true;
  }

  const ParameterTable& table_;
  const std::vector<std::string>& names_;
  const TargetOptions& options_;
  Eigen::MatrixXd examples_;
  motion::Reach reach_;
};

/// Index of the largest.
std::size_t farthest(const std::vector<double>& distances) {
  return static_cast<std::size_t>(std::max_element(distances.begin(), distances.end()) -
                                  distances.begin());
}

/// Places in the pool, each as far as possible from those before.
std::vector<std::size_t> spread(const std::vector<SampledTarget>& pool, std::size_t count) {
  Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(pool.front().spread_coordinates.size());
  for (const SampledTarget& t : pool)
    mean += t.spread_coordinates / static_cast<double>(pool.size());
  std::vector<double> distances;
  for (const SampledTarget& t : pool) distances.push_back((t.spread_coordinates - mean).norm());
  std::vector<std::size_t> chosen = {farthest(distances)};
  std::fill(distances.begin(), distances.end(), std::numeric_limits<double>::infinity());
  while (chosen.size() < count) {
    for (std::size_t i = 0; i < pool.size(); ++i)
      distances[i] =
          std::min(distances[i],
                   (pool[i].spread_coordinates - pool[chosen.back()].spread_coordinates).norm());
    chosen.push_back(farthest(distances));
  }
  return chosen;
}

}  // namespace

std::vector<SampledTarget> sample_targets(const ParameterTable& table,
                                          const std::vector<std::string>& parameters,
                                          const TargetOptions& options) {
  const std::vector<SampledTarget> pool = TargetPool(table, parameters, options).targets();
  const auto wanted = static_cast<std::size_t>(options.targets + options.practice);
  if (pool.size() < wanted)
    throw Error(fmt::format("only {} of {} random samples are within {:g} of an example{}",
                            pool.size(), max_draws, options.max_distance,
                            options.unreachable == UnreachablePolicy::reject
                                ? " and can be made by a blend of the examples"
                                : ""),
                "use fewer parameters, or allow a larger distance");
  std::vector<SampledTarget> targets;
  std::vector<bool> taken(pool.size(), false);
  for (const std::size_t i : spread(pool, static_cast<std::size_t>(options.targets))) {
    taken[i] = true;
    targets.push_back(pool[i]);
    targets.back().id = fmt::format("target-{}", targets.size());
  }
  int practised = 0;
  for (std::size_t i = 0; i < pool.size() && practised < options.practice; ++i) {
    if (taken[i]) continue;
    targets.push_back(pool[i]);
    targets.back().practice = true;
    targets.back().id = fmt::format("practice-{}", ++practised);
  }
  return targets;
}

std::vector<std::string> primary_adjectives(const Repertoire& repertoire) {
  std::vector<std::string> groups;
  for (const ScaleGroup& group : repertoire.scales.groups)
    if (repertoire.parameters.find(group.id) >= 0) groups.push_back(group.id);
  return groups.empty() ? repertoire.parameters.names : groups;
}

std::vector<std::string> primary_features() {
  std::vector<std::string> names = feature_parameter_names();
  names.resize(motion::feature_group_count);
  return names;
}

}  // namespace mien::pipeline
