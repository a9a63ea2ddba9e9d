#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/gait/gait_events.h"
#include "motion/lint/checks.h"
#include "motion/lint/threshold_findings.h"

namespace mien::motion {

namespace {

constexpr double standing_speed = 0.1;  // m/s, of the centre of mass
constexpr double standing_seconds = 0.3;
constexpr double falling_seconds = 0.15;
constexpr double pendulum_by_leg = 1.2;  // Hof 2005: leaning with the legs, from the trochanter

double level_speed(const BodyDynamics& moment) {
  return std::hypot(moment.velocity.x(), moment.velocity.z());
}

/// How far the centre of mass is outside the support while the body stands.
std::vector<double> standing_margins(const LintMotion& motion, const BodyOnFloor& body) {
  std::vector<double> values(body.moments.size(), no_value);
  for (size_t t = 0; t < values.size(); ++t) {
    const Support& support = body.supports[t];
    if (support.empty() || level_speed(body.moments[t]) > standing_speed) continue;
    values[t] =
        signed_distance_to_hull(body.moments[t].centre_of_mass, support.all()) / motion.scale;
  }
  return values;
}

double farthest(const std::vector<Vec3>& corners, const Vec3& direction) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Vec3& corner : corners) most = std::max(most, corner.dot(direction));
  return most;
}

/// How far the extrapolated centre of mass is outward of the outer edge of the standing foot.
std::vector<double> lateral_margins(const LintMotion& motion, const BodyOnFloor& body) {
  const double pendulum = pendulum_by_leg * leg_length(motion.clip.body);
  const double seconds = std::sqrt(pendulum / gravity);
  const std::vector<Vec3> directions = walking_directions(motion.clip);
  std::vector<double> values(body.moments.size(), no_value);
  for (size_t t = 0; t < values.size(); ++t) {
    const Support& support = body.supports[t];
    const bool on_feet = !support.empty() && support.elsewhere.empty();
    if (!on_feet || level_speed(body.moments[t]) <= standing_speed) continue;
    const BodyDynamics& moment = body.moments[t];
    const Vec3 extrapolated = moment.centre_of_mass + seconds * moment.velocity;
    const Vec3 to_left = Vec3::UnitY().cross(directions[t]);
    const double left = extrapolated.dot(to_left) - farthest(support.left, to_left);
    const double right = -extrapolated.dot(to_left) - farthest(support.right, -to_left);
    const bool on_both = !support.left.empty() && !support.right.empty();
    const double outside = support.right.empty() ? left : right;
    values[t] = (on_both ? std::max(left, right) : outside) / motion.scale;
  }
  return values;
}

std::vector<double> pressure_margins(const LintMotion& motion, const BodyOnFloor& body) {
  std::vector<double> values(body.moments.size(), no_value);
  for (size_t t = 0; t < values.size(); ++t) {
    if (body.supports[t].empty()) continue;
    const Vec3& point = body.moments[t].zero_moment_point;
    values[t] = signed_distance_to_hull(point, body.supports[t].all()) / motion.scale;
  }
  mask_ends(motion, values);
  return values;
}

}  // namespace

Findings find_lost_balance(const LintMotion& motion, const BodyOnFloor& body,
                           const LintOptions& options, const LintMotion* original,
                           const BodyOnFloor* original_body) {
  Findings findings;
  const auto add = [&](const auto& margins, const Levels& levels, double seconds,
                       const std::string& where, const std::string& after) {
    const std::vector<double> before =
        original ? margins(*original, *original_body) : std::vector<double>();
    const auto sentence = [&](double worst) { return where + rounded(100.0 * worst, 0) + after; };
    add_threshold_findings(
        findings, motion, {"balance", "", "m", raised_levels(levels, before), seconds, 3, sentence},
        margins(motion, body));
  };
  add(standing_margins, options.standing_margin_metres, standing_seconds,
      "The body would fall: while standing, its centre of mass is ", " cm outside its feet.");
  add(lateral_margins, options.lateral_margin_metres, falling_seconds,
      "The body would fall sideways: its centre of mass moves ",
      " cm over the outer edge of its foot.");
  add(pressure_margins, options.pressure_margin_metres, falling_seconds,
      "The body moves as if supported from outside: the floor would have to push ",
      " cm beside its feet.");
  return findings;
}

}  // namespace mien::motion
