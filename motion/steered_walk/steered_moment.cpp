#include "motion/steered_walk/steered_moment.h"

#include <algorithm>
#include <cmath>

namespace mien::motion {

namespace {

/// Step length of the moods at pace 1.2, metres.
double longest_step_of(const WalkerGaits& gaits, const std::vector<double>& moods) {
  double longest = 0.0;
  for (std::size_t m = 0; m < moods.size(); ++m) {
    longest += moods[m] * step_length_m(gaits.moods[m].paced.back().style);
  }
  return longest;
}

constexpr double brisk_turning = 1.25;  // rad/s, at which turning on the spot is widest and fastest

}  // namespace

std::vector<double> mood_goals(const std::vector<double>& asked, std::size_t moods) {
  std::vector<double> goals(moods, 0.0);
  double sum = 0.0;
  for (std::size_t m = 0; m < std::min(moods, asked.size()); ++m) {
    goals[m] = std::max(0.0, asked[m]);
    sum += goals[m];
  }
  if (sum <= 0.0) {
    goals.front() = 1.0;
    return goals;
  }
  for (double& goal : goals) goal /= sum;
  return goals;
}

std::vector<double> shares_of(const std::vector<DampedSpring>& moods) {
  std::vector<double> shares;
  for (const DampedSpring& mood : moods) shares.push_back(mood.value);
  return shares;
}

SteeredMoment moment_at(const WalkerGaits& gaits, const SteeredWalk& walker) {
  const std::vector<double> moods = shares_of(walker.gaits);
  const double speed = std::max(0.0, walker.root.speed.value);
  SteeredMoment moment;
  moment.gait = gait_at(gaits, moods, speed, walker.activity.value);
  moment.upper = gait_at(gaits, shares_of(walker.moods), speed, walker.activity.value).style;
  // Who is still faster than the mood wants takes more steps, not longer ones.
  const double longest = longest_step_of(gaits, moods);
  double& cadence = moment.gait.style.cadence_steps_min;
  cadence = std::max(cadence, 60.0 * speed / longest);
  const double slow = std::max(0.0, 1.0 - speed / own_speed(gaits, moods));
  const double turning = std::abs(walker.root.turning.value) / brisk_turning;
  const double turned = slow * turning * turning / (0.25 + turning * turning);
  cadence *= 1.0 + 0.3 * turned;
  moment.gait.style.step_width_m += 0.04 * turned;
  moment.legs = legs_of(moment.gait, gaits.body, speed);
  return moment;
}

}  // namespace mien::motion
