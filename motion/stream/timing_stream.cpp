#include "motion/stream/timing_stream.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/modify/nine_grid.h"
#include "motion/skeleton/joint_curve.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

namespace {

constexpr double standstill = 0.05;      // m/s
constexpr double pause_seconds = 0.1;    // over which a limb's speed is taken
constexpr double easing_seconds = 0.06;  // in which a limb takes up another speed
constexpr double landing_seconds = 0.1;  // before the ends of what it may show it slows down
constexpr double return_seconds = 0.6;   // in which a limb left to itself comes back to its time
constexpr double quickest = 2.5;         // times its own speed, when it catches up

/// 1 well below half the mean speed, 0 from three quarters on.
double pause_of(double speed, double mean) { return smooth_step((0.75 - speed / mean) / 0.5); }

}  // namespace

TimingStream::TimingStream(const Modification& modification, const Skeleton& body,
                           double frames_per_second, int look_ahead)
    : body_(body),
      acceleration_(modification.acceleration),
      frames_per_second_(frames_per_second),
      look_ahead_(look_ahead) {
  for (const Limb limb : all_limbs) {
    if (has(modification.limbs, limb)) {
      players_.emplace_back();
      players_.back().limb = limb;
    }
  }
}

std::optional<Pose> TimingStream::push(const Pose& pose) {
  poses_.push_back(pose);
  for (Player& player : players_) {
    player.places.push_back(world_transform(body_, pose, end_of(player.limb)).position -
                            pose.root_position);
  }
  const long newest = first_ + static_cast<long>(poses_.size()) - 1;
  if (newest - given_ < look_ahead_) return std::nullopt;
  return next();
}

std::vector<Pose> TimingStream::finish() {
  std::vector<Pose> rest;
  while (given_ < first_ + static_cast<long>(poses_.size())) rest.push_back(next());
  return rest;
}

/// How long the limb should take for what it shows now, against its own time. Brings the means up
/// to date.
double TimingStream::target_duration(Player& player) const {
  const bool constant = acceleration_ < 0.0;
  const double segment = constant ? constant_segment_seconds : acceleration_segment_seconds;
  const auto newest = static_cast<long>(player.places.size()) - 1;
  const long width = std::max(1L, std::lround(pause_seconds * frames_per_second_));
  // About the place that is shown, as far as it is known.
  const long centre = std::lround(player.source) - first_;
  const long to = std::clamp(centre + (width + 1) / 2, 0L, newest);
  const long from = std::clamp(to - width, 0L, newest);
  if (to == from) return 1.0;
  const Vec3 way =
      player.places[static_cast<size_t>(to)] - player.places[static_cast<size_t>(from)];
  const double speed = frames_per_second_ * way.norm() / static_cast<double>(to - from);
  const double share = 1.0 / (segment * frames_per_second_);
  if (player.mean_speed < 0.0) player.mean_speed = speed;
  player.mean_speed += share * (speed - player.mean_speed);
  player.top_speed = std::max(speed, player.top_speed * (1.0 - share));
  double duration = 1.0;
  if (constant) {
    const double pause = std::max(standstill, 0.1 * player.top_speed);
    if (speed >= pause) duration = std::max(speed / player.mean_speed, 0.05);
  } else if (player.top_speed > standstill) {
    duration = 1.0 + (max_pause_factor - 1.0) * pause_of(speed, player.mean_speed);
  }
  player.mean_duration += share * (duration - player.mean_duration);
  return duration;
}

/// Advances the limb by one frame: at its requested speed, drawn back to the trunk's time, and
/// slower near the newest frame or its longest lag.
void TimingStream::play_on(Player& player) const {
  const auto newest = static_cast<double>(first_ + static_cast<long>(poses_.size()) - 1);
  const double oldest = static_cast<double>(given_) - longest_lag_seconds * frames_per_second_;
  const double landing = landing_seconds * frames_per_second_;
  double rate = std::min(player.mean_duration / target_duration(player), quickest);
  rate += (static_cast<double>(given_ - 1) - player.source) / (return_seconds * frames_per_second_);
  const double room = rate > 1.0 ? newest - 1.0 - player.source : player.source + 1.0 - oldest;
  rate = std::max(0.0, 1.0 + (rate - 1.0) * std::clamp(room / landing, 0.0, 1.0));
  player.rate += std::min(1.0, 1.0 / (easing_seconds * frames_per_second_)) * (rate - player.rate);
  player.source = std::clamp(player.source + player.rate, oldest, newest);
}

Pose TimingStream::shown_at(const Player& player, const Pose& now) const {
  Pose shown = now;
  const double within = player.source - static_cast<double>(first_);
  const auto at =
      std::clamp(static_cast<long>(std::floor(within)), 0L, static_cast<long>(poses_.size()) - 1);
  const long from = std::max(0L, at - 1);
  const long to = std::min(static_cast<long>(poses_.size()) - 1, at + 2);
  for (const BodyJoint joint : joints_of(player.limb)) {
    std::vector<Directions> curve;
    for (long i = from; i <= to; ++i) {
      curve.push_back(directions_of(poses_[static_cast<size_t>(i)].rotations[joint]));
    }
    const Quat& previous = (before_ ? *before_ : now).rotations[joint];
    shown.rotations[joint] =
        to_rotation(value_at(curve, within - static_cast<double>(from), false), previous);
  }
  return shown;
}

Pose TimingStream::next() {
  const Pose now = poses_[static_cast<size_t>(given_ - first_)];
  Pose timed = now;
  for (Player& player : players_) {
    if (given_ > 0) play_on(player);
    const double lag = static_cast<double>(given_) - player.source;
    if (std::abs(lag) > std::abs(largest_lag_)) largest_lag_ = lag;
    timed = shown_at(player, timed);
  }
  ++given_;
  drop_past_frames();
  const std::array<const Pose*, 2> both = {&now, &timed};
  const std::array<double, 2> shares = {1.0 - std::abs(acceleration_), std::abs(acceleration_)};
  before_ =
      std::abs(acceleration_) >= 1.0 ? timed : mean_pose(both, shares, before_ ? *before_ : now);
  return *before_;
}

void TimingStream::drop_past_frames() {
  const auto kept =
      static_cast<long>(std::ceil((longest_lag_seconds + pause_seconds) * frames_per_second_)) +
      look_ahead_ + 4;
  while (static_cast<long>(poses_.size()) > kept && first_ < given_) {
    poses_.pop_front();
    for (Player& player : players_) player.places.pop_front();
    ++first_;
  }
}

}  // namespace mien::motion
