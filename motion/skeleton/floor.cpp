#include "motion/skeleton/floor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "motion/math/filter.h"
#include "motion/math/percentile.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/sole.h"

namespace mien::motion {

namespace {

constexpr double resting_speed = 0.3;  // m/s
constexpr double low_percent = 3.0;
constexpr double shortest_plant = 0.1;  // seconds
constexpr double same_level = 0.08;     // m at 1.75 m

using Points = std::array<Vec3, 6>;

std::vector<Points> sole_of_both(const Clip& clip) {
  const std::vector<SolePoints> left = sole_paths(clip, true);
  const std::vector<SolePoints> right = sole_paths(clip, false);
  std::vector<Points> points;
  for (size_t t = 0; t < left.size(); ++t) {
    points.push_back(
        {left[t].heel, left[t].ball, left[t].tip, right[t].heel, right[t].ball, right[t].tip});
  }
  return points;
}

size_t lowest(const Points& points) {
  const auto lower = [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); };
  return static_cast<size_t>(std::min_element(points.begin(), points.end(), lower) -
                             points.begin());
}

/// Where the balls of the feet rest, judged by speed alone.
struct Resting {
  std::vector<Vec3> points;
  int plants = 0;
};

void add_resting_points(const Clip& clip, bool left, Resting& resting) {
  const double rate = clip.frames_per_second;
  std::vector<Vec3> ball;
  for (const SolePoints& points : sole_paths(clip, left)) ball.push_back(points.ball);
  const std::vector<Vec3> velocity =
      derivative(low_pass(ball, std::min(10.0, 0.3 * rate), rate), rate);
  double rested = 0.0;
  for (size_t t = 0; t < ball.size(); ++t) {
    const double before = rested;
    rested = velocity[t].norm() < resting_speed ? rested + 1.0 / rate : 0.0;
    if (rested > 0.0) resting.points.push_back(ball[t]);
    if (before < shortest_plant && rested >= shortest_plant) ++resting.plants;
  }
}

/// The line of resting points as seen from above, and how their height goes along it.
struct Slope {
  Vec3 direction = Vec3::UnitZ();  ///< horizontal, unit: along which the points spread most
  double spread = 0.0;             ///< standard deviation along it, metres
  double rise = 0.0;               ///< metres up per metre along
  double error_level = 0.0;        ///< RMS distance to a level floor, metres
  double error_sloping = 0.0;      ///< RMS distance to the slope, metres
};

Slope fitted_slope(const std::vector<Vec3>& points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& point : points) mean += point / static_cast<double>(points.size());
  Mat3 covariance = Mat3::Zero();
  for (const Vec3& point : points) {
    covariance += (point - mean) * (point - mean).transpose() / static_cast<double>(points.size());
  }
  const double xx = covariance(0, 0);
  const double zz = covariance(2, 2);
  const double angle =
      0.5 * std::atan2(2.0 * covariance(0, 2), zz - xx);  // of the long axis, from +Z
  Slope slope;
  slope.direction = Vec3(std::sin(angle), 0.0, std::cos(angle));
  const double variance = slope.direction.dot(covariance * slope.direction);
  const double shared = slope.direction.dot(covariance.col(1));
  slope.spread = std::sqrt(variance);
  if (variance > 0.0) slope.rise = shared / variance;
  slope.error_level = std::sqrt(covariance(1, 1));
  slope.error_sloping = std::sqrt(std::max(0.0, covariance(1, 1) - slope.rise * shared));
  return slope;
}

/// Third percentile of the lowest sole point over the frames in which it is slow (all frames when
/// it never is).
double lowest_rest(const Clip& clip) {
  const std::vector<Points> points = sole_of_both(clip);
  std::vector<double> all;
  std::vector<double> resting;
  for (size_t t = 0; t < points.size(); ++t) {
    const size_t low = lowest(points[t]);
    all.push_back(points[t][low].y());
    if (t == 0) continue;
    const double speed = (points[t][low] - points[t - 1][low]).norm() * clip.frames_per_second;
    if (speed < resting_speed) resting.push_back(all.back());
  }
  return percentile(resting.size() > 2 ? resting : all, low_percent);
}

/// Where the ball of a foot rests that stands near the lowest level; empty when it never does.
std::optional<double> standing_level(const Clip& clip, bool left, double lowest) {
  Resting resting;
  add_resting_points(clip, left, resting);
  std::vector<double> heights;
  for (const Vec3& point : resting.points) {
    if (point.y() < lowest + same_level * relative_stature(clip.body)) heights.push_back(point.y());
  }
  if (heights.size() < 3) return std::nullopt;
  return percentile(heights, 50);
}

}  // namespace

double floor_height(const Clip& clip) {
  const double lowest = lowest_rest(clip);
  const std::optional<double> left = standing_level(clip, true, lowest);
  const std::optional<double> right = standing_level(clip, false, lowest);
  if (left && right) return std::min(*left, *right);
  return left ? *left : right.value_or(lowest);
}

Quat floor_levelling(const Clip& clip) {
  Resting resting;
  add_resting_points(clip, true, resting);
  add_resting_points(clip, false, resting);
  if (resting.plants < 4) return Quat::Identity();
  const Slope slope = fitted_slope(resting.points);
  const double degrees = std::abs(std::atan(slope.rise)) / radians_per_degree;
  // Few plants lie along some slope by chance.
  const double left_over = resting.plants < 5 ? 0.4 : 0.6;
  const bool is_slope = slope.spread > 0.4 && degrees > 0.3 && degrees < 6.0 &&
                        slope.error_level > 0.01 &&
                        slope.error_sloping < left_over * slope.error_level;
  if (!is_slope) return Quat::Identity();
  const Vec3 up_the_slope = (slope.direction + slope.rise * Vec3::UnitY()).normalized();
  return turn_between(up_the_slope, slope.direction);
}

}  // namespace mien::motion
