#include "motion/biomechanics/weight_bearing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "motion/biomechanics/body_dynamics.h"
#include "motion/biomechanics/body_mass.h"
#include "motion/gait/contact.h"
#include "motion/math/filter.h"
#include "motion/math/percentile.h"
#include "motion/skeleton/sole.h"

namespace mien::motion {

namespace {

constexpr double near_metres = 0.04;     // above where a point of the sole is lowest
constexpr double falling_press = 0.5;    // body weights
constexpr double unsure_seconds = 0.1;   // at either end, where accelerations are guesses
constexpr double shortest_stance = 0.1;  // seconds
constexpr double alike_speed = 0.15;     // m/s; by which both feet slide alike
constexpr double none = std::numeric_limits<double>::infinity();

/// A joint that can rest on the floor, and how high it then is at most, metres at 1.75 m.
struct Rest {
  BodyJoint joint;
  double height;
};

constexpr std::array<Rest, 5> rests = {
    {{LeftKnee, 0.12}, {RightKnee, 0.12}, {LeftWrist, 0.12}, {RightWrist, 0.12}, {Pelvis, 0.2}}};

std::vector<bool> falling(const LintMotion& motion) {
  std::vector<Vec3> centre;
  for (const JointTransforms& world : motion.world) {
    centre.push_back(centre_of_mass(motion.clip.body, world));
  }
  const double rate = motion.rate();
  const std::vector<Vec3> smooth = low_pass(centre, gait_cutoff_hz(rate), rate);
  const std::vector<Vec3> acceleration = derivative(derivative(smooth, rate), rate);
  const int count = motion.frame_count();
  const int ends =
      std::min(static_cast<int>(std::lround(unsure_seconds * rate)) + 1, (count - 1) / 2);
  std::vector<bool> falls;
  for (int t = 0; t < count; ++t) {
    const int sure = std::clamp(t, ends, count - 1 - ends);
    falls.push_back(1.0 + acceleration[sure].y() / gravity < falling_press);
  }
  return falls;
}

/// Horizontal speed of the stillest point of a sole that is near where it is lowest; infinite while
/// none is.
std::vector<double> floor_speeds(const LintMotion& motion, bool left) {
  std::vector<double> stillest(motion.world.size(), none);
  const std::vector<SolePoints> soles = sole_paths(motion.clip, left);
  const double cutoff = std::min(10.0, 0.3 * motion.rate());
  for (const auto point : {&SolePoints::heel, &SolePoints::ball, &SolePoints::tip}) {
    std::vector<Vec3> path;
    std::vector<double> heights;
    for (const SolePoints& sole : soles) {
      path.push_back(sole.*point);
      heights.push_back(path.back().y());
    }
    const double rest = percentile(heights, 3);
    const std::vector<Vec3> velocity =
        derivative(low_pass(path, cutoff, motion.rate()), motion.rate());
    for (size_t t = 0; t < path.size(); ++t) {
      if (heights[t] - rest > near_metres * motion.scale) continue;
      stillest[t] = std::min(stillest[t], horizontal(velocity[t]).norm());
    }
  }
  return stillest;
}

void add_planted(const LintMotion& motion, WeightBearing& bearing) {
  for (const FootPlant& plant : foot_plants(motion.clip)) {
    std::vector<bool>& foot = plant.left ? bearing.left : bearing.right;
    const int last = std::min(plant.last, motion.frame_count() - 1);
    for (int t = plant.first; t <= last; ++t) foot[t] = bearing.planted[t] = true;
  }
}

/// Where neither foot is planted, the stiller one bears, or both.
void add_sliding(const LintMotion& motion, WeightBearing& bearing) {
  const std::vector<double> left = floor_speeds(motion, true);
  const std::vector<double> right = floor_speeds(motion, false);
  for (int t = 0; t < motion.frame_count(); ++t) {
    const double still = std::min(left[t], right[t]);
    if (!bearing.is_unsupported(t) || still == none) continue;
    bearing.left[t] = left[t] <= still + alike_speed;
    bearing.right[t] = right[t] <= still + alike_speed;
  }
}

void add_stretches(const std::vector<bool>& bears, bool left, double rate,
                   std::vector<FootPlant>& stretches) {
  const int count = static_cast<int>(bears.size());
  for (int first = 0; first < count; ++first) {
    if (!bears[first]) continue;
    int last = first;
    while (last + 1 < count && bears[last + 1]) ++last;
    if (last - first + 1 >= shortest_stance * rate) stretches.push_back({left, first, last});
    first = last;
  }
}

}  // namespace

std::vector<BodyJoint> other_contacts(const LintMotion& motion, int frame) {
  std::vector<BodyJoint> found;
  for (const Rest& rest : rests) {
    const double height = motion.world[frame].positions[rest.joint].y();
    if (height < rest.height * motion.scale) found.push_back(rest.joint);
  }
  return found;
}

WeightBearing weight_bearing_of(const LintMotion& motion) {
  const auto count = motion.world.size();
  WeightBearing bearing;
  bearing.left.assign(count, false);
  bearing.right.assign(count, false);
  bearing.planted.assign(count, false);
  for (int t = 0; t < motion.frame_count(); ++t) {
    bearing.elsewhere.push_back(!other_contacts(motion, t).empty());
  }
  bearing.falls = falling(motion);
  add_planted(motion, bearing);
  add_sliding(motion, bearing);
  return bearing;
}

std::vector<FootPlant> weight_bearing_feet(const WeightBearing& bearing, double frames_per_second) {
  std::vector<FootPlant> stretches;
  add_stretches(bearing.left, true, frames_per_second, stretches);
  add_stretches(bearing.right, false, frames_per_second, stretches);
  std::stable_sort(stretches.begin(), stretches.end(),
                   [](const FootPlant& a, const FootPlant& b) { return a.first < b.first; });
  return stretches;
}

}  // namespace mien::motion
