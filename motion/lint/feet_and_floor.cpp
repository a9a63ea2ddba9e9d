#include <algorithm>
#include <cmath>

#include "motion/biomechanics/body_mass.h"
#include "motion/gait/contact.h"
#include "motion/lint/checks.h"
#include "motion/lint/stretches.h"
#include "motion/math/singular_values.h"
#include "motion/skeleton/sole.h"

namespace mien::motion {

namespace {

constexpr double shortest_seconds = 0.1;
constexpr double falling =
    -5.0;  // m/s²: half of free fall, for feet leave and meet the floor softly

std::vector<double> sole_heights(const LintSubject& subject, bool left) {
  std::vector<double> heights;
  for (const JointTransforms& world : subject.world) {
    const SolePoints sole = sole_points(subject.clip.body, world, left);
    heights.push_back(std::min({sole.heel.y(), sole.ball.y(), sole.tip.y()}) / subject.scale);
  }
  return heights;
}

std::vector<double> centre_heights(const LintSubject& subject) {
  std::vector<double> heights;
  for (const JointTransforms& world : subject.world) {
    heights.push_back(centre_of_mass(subject.clip.body, world).y());
  }
  return heights;
}

/// Acceleration, m/s², of the parabola that fits the values in [first, last] best.
double acceleration(const std::vector<double>& values, int first, int last, double rate) {
  Eigen::MatrixXd basis(last - first + 1, 3);
  Eigen::VectorXd measured(last - first + 1);
  for (int t = first; t <= last; ++t) {
    const double seconds = (t - 0.5 * (first + last)) / rate;
    basis.row(t - first) << 1.0, seconds, 0.5 * seconds * seconds;
    measured(t - first) = values[t];
  }
  return singular_values(basis).solve(measured, 1e-12)(2);
}

std::vector<bool> planted(const LintSubject& subject) {
  std::vector<bool> result(subject.world.size(), false);
  for (const FootPlant& plant : foot_plants(subject.clip)) {
    const int last = std::min(plant.last, subject.frame_count() - 1);
    for (int t = plant.first; t <= last; ++t) result[t] = true;
  }
  return result;
}

/// Leaves out the runs without a planted foot in which the body flies, and those too short to tell.
void without_flights(const LintSubject& subject, std::vector<double>& heights) {
  const std::vector<bool> stands = planted(subject);
  const std::vector<double> centre = centre_heights(subject);
  const int count = subject.frame_count();
  for (int first = 0; first < count; ++first) {
    if (stands[first]) continue;
    int last = first;
    while (last + 1 < count && !stands[last + 1]) ++last;
    const int from = std::max(first - 1, 0);
    const int to = std::min(last + 1, count - 1);
    const bool is_short = last - first + 1 < shortest_seconds * subject.rate() || to - from < 3;
    if (is_short || acceleration(centre, from, to, subject.rate()) < falling) {
      std::fill(heights.begin() + first, heights.begin() + last + 1, nothing);
    }
    first = last;
  }
}

/// Height of the lower sole wherever the body does not fly.
std::vector<double> hanging_heights(const LintSubject& subject) {
  std::vector<double> lower = sole_heights(subject, true);
  const std::vector<double> right = sole_heights(subject, false);
  for (size_t t = 0; t < lower.size(); ++t) lower[t] = std::min(lower[t], right[t]);
  without_flights(subject, lower);
  return lower;
}

std::vector<double> depths(const LintSubject& subject, bool left) {
  std::vector<double> values = sole_heights(subject, left);
  for (double& value : values) value = -value;
  return values;
}

}  // namespace

Findings find_sunken_feet(const LintSubject& subject, const LintOptions& options,
                          const LintSubject* original) {
  Findings findings;
  for (const bool left : {true, false}) {
    const auto sentence = [&](double worst) {
      return std::string("The ") + (left ? "left" : "right") + " foot sinks " +
             rounded(100.0 * worst, 1) + " cm into the floor.";
    };
    const std::string joint(name_of(left ? LeftAnkle : RightAnkle));
    const Levels levels = raised(options.penetration_metres,
                                 original ? depths(*original, left) : std::vector<double>());
    add_stretches(findings, subject, {"penetration", joint, "m", levels, 0, 2, sentence},
                  depths(subject, left));
  }
  return findings;
}

Findings find_floating(const LintSubject& subject, const LintOptions& options,
                       const LintSubject* original) {
  Findings findings;
  const auto sentence = [](double worst) {
    return "The body hangs in the air: the lower foot is " + rounded(100.0 * worst, 1) +
           " cm above the floor.";
  };
  const Levels levels = raised(options.floating_metres,
                               original ? hanging_heights(*original) : std::vector<double>());
  add_stretches(findings, subject, {"floating", "", "m", levels, shortest_seconds, 3, sentence},
                hanging_heights(subject));
  return findings;
}

}  // namespace mien::motion
