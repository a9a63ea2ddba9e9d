#include "pipeline/study/matching/simulated_trial.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "pipeline/base/statistics/named_random.h"
#include "pipeline/production/synthesis/slider_interface.h"

namespace mien::pipeline {

namespace {

constexpr double guess_step = 0.1;
constexpr double first_step = 0.2;
constexpr double last_step = 0.02;

/// One user before one target.
class Search {
 public:
  Search(const SimulatedUser& user, const SliderDistance& distance_at)
      : user_(user), distance_at_(distance_at) {}

  SimulatedTrial run(const Eigen::RowVectorXd& ideal) {
    settings_ = first_guess(ideal);
    SimulatedTrial trial;
    trial.first_guess = settings_;
    true_ = look(settings_);
    trial.first_distance = true_;
    seen_ = seen(true_);
    for (double step = first_step; step >= last_step && !is_over();)
      if (!round(step)) step *= 0.5;
    trial.distance = true_;
    trial.views = views_;
    trial.matched = matches();
    return trial;
  }

 private:
  Eigen::RowVectorXd first_guess(const Eigen::RowVectorXd& ideal) const {
    Eigen::RowVectorXd guess = ideal;
    for (Eigen::Index i = 0; i < guess.size(); ++i) {
      const double error = normal(user_.seed, fmt::format("{} reading {}", user_.name, i));
      guess[i] = std::clamp(guess[i] + user_.reading_error * error, 0.0, 1.0);
    }
    return rounded(guess, guess_step);
  }

  double look(const Eigen::RowVectorXd& settings) {
    ++views_;
    return distance_at_(settings);
  }

  double seen(double distance) const {
    const double error = normal(user_.seed, fmt::format("{} look {}", user_.name, views_));
    return distance * std::max(0.0, 1.0 + user_.seeing_error * error);
  }

  bool matches() const { return true_ < user_.threshold; }
  bool is_over() const { return matches() || views_ >= user_.max_views; }

  /// Whether the move was kept.
  bool move(Eigen::Index slider, double by) {
    Eigen::RowVectorXd moved = settings_;
    moved[slider] = std::clamp(moved[slider] + by, 0.0, 1.0);
    if (moved[slider] == settings_[slider]) return false;
    const double distance = look(moved);
    const double as_seen = seen(distance);
    if (as_seen >= seen_) return false;
    settings_ = std::move(moved);
    true_ = distance;
    seen_ = as_seen;
    return true;
  }

  /// The sliders in a random order for this round.
  std::vector<Eigen::Index> order() {
    std::vector<std::pair<double, Eigen::Index>> drawn;
    ++rounds_;
    for (Eigen::Index i = 0; i < settings_.size(); ++i)
      drawn.emplace_back(
          uniform(user_.seed, fmt::format("{} round {} slider {}", user_.name, rounds_, i)), i);
    std::sort(drawn.begin(), drawn.end());
    std::vector<Eigen::Index> sliders;
    for (const auto& [number, slider] : drawn) sliders.push_back(slider);
    return sliders;
  }

  /// Whether any move was an improvement.
  bool round(double step) {
    bool improved = false;
    for (const Eigen::Index slider : order()) {
      for (const double by : {step, -step}) {
        if (is_over()) return improved;
        if (!move(slider, by)) continue;
        improved = true;
        break;
      }
    }
    return improved;
  }

  const SimulatedUser& user_;
  const SliderDistance& distance_at_;
  Eigen::RowVectorXd settings_;
  double true_ = 0.0;
  double seen_ = 0.0;
  int views_ = 0;
  int rounds_ = 0;
};

}  // namespace

SimulatedTrial simulate_trial(const Eigen::RowVectorXd& ideal, const SimulatedUser& user,
                              const SliderDistance& distance_at) {
  return Search(user, distance_at).run(ideal);
}

}  // namespace mien::pipeline
