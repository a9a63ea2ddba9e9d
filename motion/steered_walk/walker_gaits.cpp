#include "motion/steered_walk/walker_gaits.h"

#include <algorithm>

#include "motion/error.h"
#include "motion/steered_walk/paced_style.h"

namespace mien::motion {

namespace {

MoodGaits fit_mood(const WalkStyle& style, const Skeleton& body) {
  MoodGaits mood;
  for (const double pace : gait_paces) {
    mood.paced.push_back(fit_gait(paced_style(style, pace), body));
    if (pace == 1.0) mood.speed_m_s = mood.paced.back().style.speed_m_s;
  }
  mood.standing = fit_standing(style, body);
  // Who steps on the spot stands over their feet as in standing.
  mood.paced.front().ahead_m = mood.standing.ahead_m;
  mood.paced.front().passing_phase = mood.standing.passing_phase;
  return mood;
}

/// Weights of the paces: linear between neighbours.
std::array<double, gait_paces.size()> pace_weights(double pace) {
  std::array<double, gait_paces.size()> weights{};
  const double within = std::clamp(pace, gait_paces.front(), gait_paces.back());
  const auto above = std::upper_bound(gait_paces.begin() + 1, gait_paces.end() - 1, within);
  const auto i = static_cast<std::size_t>(above - gait_paces.begin());
  const double share = (within - gait_paces[i - 1]) / (gait_paces[i] - gait_paces[i - 1]);
  weights[i - 1] = 1.0 - share;
  weights[i] = share;
  return weights;
}

}  // namespace

WalkerGaits fit_walker(std::span<const WalkStyle> moods, const Skeleton& body) {
  if (moods.empty()) throw Error("a walker without a mood", "give one style at least");
  WalkerGaits gaits;
  gaits.body = body;
  for (const WalkStyle& style : moods) gaits.moods.push_back(fit_mood(style, body));
  return gaits;
}

double own_speed(const WalkerGaits& gaits, std::span<const double> moods) {
  double speed = 0.0;
  for (std::size_t m = 0; m < moods.size(); ++m) speed += moods[m] * gaits.moods[m].speed_m_s;
  return speed;
}

FittedGait gait_at(const WalkerGaits& gaits, std::span<const double> moods, double speed_m_s,
                   double activity) {
  const auto paces = pace_weights(speed_m_s / own_speed(gaits, moods));
  std::vector<FittedGait> nodes;
  std::vector<double> weights;
  const auto add = [&](const FittedGait& gait, double weight) {
    if (weight == 0.0) return;
    nodes.push_back(gait);
    weights.push_back(weight);
  };
  for (std::size_t m = 0; m < moods.size(); ++m) {
    add(gaits.moods[m].standing, moods[m] * (1.0 - activity));
    for (std::size_t p = 0; p < paces.size(); ++p) {
      add(gaits.moods[m].paced[p], moods[m] * activity * paces[p]);
    }
  }
  return blended(nodes, weights);
}

}  // namespace mien::motion
