#include <cmath>

#include "motion/biomechanics/body_dynamics.h"
#include "motion/dynamics/limb_dynamics.h"
#include "motion/math/filter.h"

namespace mien::motion {

namespace {

constexpr double periodic_metres = 1e-7;
constexpr int most_leg_cycles = 200;

/// Forces of the floor on the body in each frame, per mass: m/s².
std::vector<double> loads(const std::vector<double>& heights, double rate, SignalEnds ends) {
  std::vector<Vec3> path;
  for (const double height : low_pass(heights, gait_cutoff_hz(rate), rate, ends))
    path.emplace_back(0.0, height, 0.0);
  std::vector<double> result;
  for (const Vec3& acceleration : derivative(derivative(path, rate, ends), rate, ends))
    result.push_back(std::max(0.0, gravity + acceleration.y()));
  return result;
}

/// How far the body is above its heights on a spring that holds a share of its loads.
std::vector<double> offsets(const std::vector<double>& heights, const std::vector<double>& loads,
                            double share, const SpringDamper& spring, double rate, bool loops) {
  const std::size_t count = heights.size();
  std::vector<double> result(count, 0.0);
  SpringState state = {-share * loads.front() / (spring.frequency * spring.frequency), 0.0};
  for (int cycle = 0; cycle < (loops ? most_leg_cycles : 1); ++cycle) {
    const SpringState first = state;
    for (std::size_t f = 0; f < count; ++f) {
      result[f] = state.offset;
      const std::size_t next = (f + 1) % count;
      if (next == 0 && !loops) return result;
      const double speed = (heights[next] - heights[f]) * rate;
      const double load = 0.5 * (loads[f] + loads[next]);
      state = after(state, spring, speed, -share * load, 1.0 / rate);
    }
    if (std::abs(state.offset - first.offset) < periodic_metres &&
        std::abs(state.speed - first.speed) < periodic_metres * spring.frequency)
      break;
  }
  return result;
}

}  // namespace

Clip with_slack_legs(const Clip& clip, double stiffness, double weight,
                     const std::vector<FootPlant>& plants, const std::vector<Airborne>& flights) {
  if (clip.frame_count() < 3 || (stiffness >= 1.0 && weight == 1.0)) return clip;
  const double rate = clip.frames_per_second;
  const SignalEnds ends = clip.loops ? SignalEnds::periodic : SignalEnds::open;
  const std::vector<double> own = body_heights(clip);
  const std::vector<double> load = loads(own, rate, ends);
  std::vector<double> heights = own;
  if (stiffness < 1.0) {
    const std::vector<double> offset = offsets(own, load, (1.0 - stiffness) * weight,
                                               muscle_spring(stiffness, leg_hz), rate, clip.loops);
    for (std::size_t f = 0; f < heights.size(); ++f) heights[f] += offset[f];
  }
  const double muscles = 2.0 * pi * leg_hz;
  for (std::size_t f = 0; f < heights.size(); ++f)
    heights[f] -= (weight - 1.0) * load[f] / (muscles * muscles);
  return with_body_heights(clip, std::move(heights), plants, flights,
                           flights.empty() ? FeetStay::all : FeetStay::planted);
}

}  // namespace mien::motion
