#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "motion/biomechanics/weight_bearing.h"
#include "motion/lint/checks.h"
#include "motion/lint/planted_slip.h"
#include "motion/lint/threshold_findings.h"
#include "motion/math/percentile.h"
#include "motion/skeleton/sole.h"

namespace mien::motion {

namespace {

constexpr double steadiness = 0.25;   // share of the way by which a steady slide may vary
constexpr double explained = 0.5;     // share of the variance
constexpr double slope_share = 0.5;   // by which the usual climb may differ from the whole
constexpr double rolling_m_s = 0.02;  // and that of feet whose lowest point changes as they roll

/// Stretches in which both feet bear; as plants of the left foot.
std::vector<FootPlant> double_stances(const LintMotion& motion) {
  const WeightBearing bearing = weight_bearing_of(motion);
  const int count = motion.frame_count();
  std::vector<FootPlant> found;
  for (int first = 0; first < count; ++first) {
    if (!bearing.left[first] || !bearing.right[first]) continue;
    int last = first;
    while (last + 1 < count && bearing.left[last + 1] && bearing.right[last + 1]) ++last;
    if (last - first >= take_limits.drift_seconds * motion.rate())
      found.push_back({true, first, last});
    first = last;
  }
  return found;
}

/// Whether a track goes its way at a constant velocity.
bool is_steady(const std::vector<Vec3>& track) {
  const Vec3 way = track.back();
  for (size_t t = 0; t < track.size(); ++t) {
    const double share = static_cast<double>(t) / std::max<double>(track.size() - 1.0, 1.0);
    if ((track[t] - share * way).norm() > steadiness * way.norm()) return false;
  }
  return true;
}

/// How far both feet slide together; zero where they do not.
double common_slide(const LintMotion& motion, FootPlant stance) {
  const std::vector<Vec3> left = planted_track(motion, stance);
  stance.left = false;
  const std::vector<Vec3> right = planted_track(motion, stance);
  const double way = std::min(left.back().norm(), right.back().norm());
  if ((left.back() - right.back()).norm() > steadiness * way) return 0.0;
  return is_steady(left) && is_steady(right) ? way / motion.scale : 0.0;
}

double largest_slide(const LintMotion& motion) {
  double largest = 0.0;
  for (const FootPlant& stance : double_stances(motion)) {
    largest = std::max(largest, common_slide(motion, stance));
  }
  return largest;
}

Finding drift_of(int first, int last, double measured, const Levels& levels) {
  Finding finding = graded_finding("drift", measured, "m", levels);
  finding.first = first;
  finding.last = last;
  return finding;
}

/// A line through points by least squares.
struct Line {
  double slope = 0.0;
  double explained = 0.0;  ///< share of the variance
};

/// Least-squares line through values of consecutive frames.
Line line_of(const std::vector<double>& values, double rate) {
  const double count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (size_t i = 0; i < values.size(); ++i) {
    const double x = (static_cast<double>(i) - 0.5 * (count - 1.0)) / rate;
    xx += x * x;
    xy += x * (values[i] - mean);
    yy += (values[i] - mean) * (values[i] - mean);
  }
  if (!(xx > 0.0) || !(yy > 0.0)) return {};
  return {xy / xx, xy * xy / (xx * yy)};
}

/// Height of the lower sole in every frame.
std::vector<double> lower_sole(const LintMotion& motion) {
  std::vector<double> heights;
  for (const JointTransforms& world : motion.world) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const bool left : {true, false}) {
      const SolePoints sole = sole_points(motion.clip.body, world, left);
      lowest = std::min({lowest, sole.heel.y(), sole.ball.y(), sole.tip.y()});
    }
    heights.push_back(lowest / motion.scale);
  }
  return heights;
}

/// The median rate, a second, at which values change from frame to frame.
double usual_rate(const std::vector<double>& values, double rate) {
  std::vector<double> steps;
  for (size_t t = 1; t < values.size(); ++t) steps.push_back(rate * (values[t] - values[t - 1]));
  return percentile(steps, 50);
}

/// How far the body rises over the take, steadily; below zero where it sinks.
double steady_rise(const LintMotion& motion) {
  if (motion.frame_count() < 3) return 0.0;
  const std::vector<double> heights = lower_sole(motion);
  const double rate = motion.rate();
  const Line whole = line_of(heights, rate);
  if (whole.explained < explained) return 0.0;
  const double apart = std::abs(usual_rate(heights, rate) - whole.slope);
  if (apart > std::max(slope_share * std::abs(whole.slope), rolling_m_s)) return 0.0;
  return whole.slope * (motion.frame_count() - 1) / rate;
}

}  // namespace

Findings find_walk_on_spot(const LintMotion& motion, const LintMotion* original) {
  const bool was_there = original && !original->floor.isZero();
  if (motion.was_loop || motion.floor.isZero() || was_there) return {};
  Finding finding;
  finding.check = "on-the-spot";
  finding.last = motion.frame_count() - 1;
  finding.measured = motion.floor.norm();
  finding.threshold = slowest_treadmill_m_s;
  finding.unit = "m/s";
  finding.sentence =
      "Walks in place: the floor would move at " + rounded(motion.floor.norm(), 2) + " m/s.";
  return {finding};
}

Findings find_drift(const LintMotion& motion, const LintOptions& options,
                    const LintMotion* original) {
  Findings findings;
  if (motion.was_loop) return findings;
  Levels levels = options.skate_metres;
  if (original) levels = raised_levels(levels, std::array{largest_slide(*original)});
  for (const FootPlant& stance : double_stances(motion)) {
    const double way = common_slide(motion, stance);
    if (!(way > levels.warning)) continue;
    Finding finding = drift_of(stance.first, stance.last, way, levels);
    finding.sentence =
        "The whole body slides by " + rounded(100.0 * way, 1) + " cm while it stands on both feet.";
    add_finding(findings, motion, std::move(finding));
  }
  return findings;
}

Findings find_rise(const LintMotion& motion, const LintMotion* original) {
  if (motion.was_loop) return {};
  Levels levels = take_limits.rise_metres;
  if (original) levels = raised_levels(levels, std::array{std::abs(steady_rise(*original))});
  const double rise = steady_rise(motion);
  if (!(std::abs(rise) > levels.warning)) return {};
  Finding finding = drift_of(0, motion.frame_count() - 1, std::abs(rise), levels);
  finding.sentence = std::string("The whole body ") + (rise > 0.0 ? "rises" : "sinks") +
                     " steadily, by " + rounded(100.0 * std::abs(rise), 1) + " cm over the take.";
  return {finding};
}

}  // namespace mien::motion
