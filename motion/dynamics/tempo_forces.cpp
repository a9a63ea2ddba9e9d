#include "motion/dynamics/tempo_forces.h"

#include <algorithm>
#include <cmath>

#include "motion/biomechanics/body_dynamics.h"
#include "motion/gait/foot_path.h"
#include "motion/gait/foot_placement.h"
#include "motion/math/filter.h"
#include "motion/skeleton/body.h"

namespace mien::motion {

namespace {

constexpr double steps_by_cadence = 0.42 / (1.0 - 0.42);
constexpr double froude_of_running = 0.5;
constexpr double longest_steps = 1.6;      // of runs, relative to the original
constexpr double ordinary_speed = 1.35;    // m/s (walk_style.h)
constexpr double support_by_speed = 0.18;  // of the time, at ordinary_speed more
constexpr double least_support = 0.12;
constexpr double most_support = 0.4;
constexpr double longest_flight = 0.8;         // seconds
constexpr double contact_join_seconds = 0.04;  // over which stretched contacts pass into others
constexpr double slow_path_hz = 0.5;           // in the original's time
constexpr double most_fall = 0.7;              // of gravity, in a walk

/// How many feet stand in each interval between frames.
std::vector<int> feet_down(const std::vector<FootPlant>& plants, int frames, bool loops) {
  std::vector<int> feet(static_cast<size_t>(interval_count(frames, loops)), 0);
  for (const FootPlant& plant : plants) {
    for (int f = plant.first; f < plant.last; ++f) {
      if (loops || f < frames - 1) ++feet[static_cast<size_t>(loops ? f % frames : f)];
    }
  }
  return feet;
}

std::vector<double> smoothed(const std::vector<double>& values, int half_width, bool loops) {
  const int count = static_cast<int>(values.size());
  std::vector<double> result(values.size(), 0.0);
  for (int i = 0; i < count; ++i) {
    for (int k = -half_width; k <= half_width; ++k) {
      const int at = loops ? (((i + k) % count) + count) % count : std::clamp(i + k, 0, count - 1);
      result[static_cast<size_t>(i)] +=
          values[static_cast<size_t>(at)] * (half_width + 1 - std::abs(k));
    }
    result[static_cast<size_t>(i)] /= (half_width + 1) * (half_width + 1);
  }
  return result;
}

/// Share of double support at a tempo, relative to that of the original.
double support_factor(double tempo, const Carriage& carriage) {
  const double own = carriage.double_support;
  const double faster = carriage.speed * (tempo * step_factor(tempo, carriage) - 1.0);
  const double wanted = own - support_by_speed * faster / ordinary_speed;
  return std::clamp(wanted, std::min(own, least_support), std::max(own, most_support)) / own;
}

/// Speed factor of the tempo at each new frame.
std::vector<double> factors_of(const Tempo& tempo, const Retiming& retiming) {
  std::vector<double> factors;
  const int steps = std::max(1, interval_count(retiming.frames_before(), retiming.loops));
  for (const double source : retiming.sources)
    factors.push_back(factor_at(tempo, source / steps, retiming.loops));
  return factors;
}

/// The largest downward acceleration of heights, m/s².
double largest_fall(const std::vector<double>& heights, double rate, bool loops) {
  const std::vector<double> smooth = low_pass(heights, gait_cutoff_hz(rate), rate,
                                              loops ? SignalEnds::periodic : SignalEnds::open);
  const size_t count = smooth.size();
  double largest = 0.0;
  for (size_t f = loops ? 0 : 1; f < (loops ? count : count - 1); ++f) {
    const double bend = smooth[(f + count - 1) % count] - 2.0 * smooth[f] + smooth[(f + 1) % count];
    largest = std::max(largest, -bend * rate * rate);
  }
  return largest;
}

}  // namespace

std::vector<Airborne> retimed(const std::vector<Airborne>& flights, const Retiming& retiming) {
  std::vector<Airborne> result;
  for (const Airborne& flight : flights) {
    const int take_off = static_cast<int>(std::floor(retiming.target(flight.take_off) + 1e-9));
    const int landing = static_cast<int>(std::ceil(retiming.target(flight.landing) - 1e-9));
    if (landing > take_off + 1) result.push_back({take_off, landing});
  }
  return result;
}

Carriage carriage_of(const Clip& clip, const std::vector<FootPlant>& plants, double way) {
  Carriage carriage{.plants = plants, .travels = way > 0.0, .leg = leg_length(clip.body)};
  const double seconds = clip.duration_seconds();
  if (carriage.travels && seconds > 0.0) carriage.speed = way / seconds;
  const int count = clip.frame_count();
  std::vector<FootPlant> unrolled = plants;
  if (clip.loops) {
    unrolled.clear();
    for (int lap = 0; lap < 3; ++lap) {
      for (const FootPlant& plant : plants)
        unrolled.push_back({plant.left, plant.first + lap * count, plant.last + lap * count});
    }
  }
  for (const Flight& flight : flights(clip.loops ? repeated(clip, 3) : clip, unrolled)) {
    Airborne between = {flight.first - 1, flight.last + 1};
    if (clip.loops) {
      if (between.take_off < count || between.take_off >= 2 * count) continue;
      between = {between.take_off - count, between.landing - count};
    }
    // Jumps from both feet are found once for each of them.
    const auto overlaps = [&](const Airborne& other) {
      return between.take_off < other.landing && other.take_off < between.landing;
    };
    if (std::none_of(carriage.flights.begin(), carriage.flights.end(), overlaps))
      carriage.flights.push_back(between);
  }
  const std::vector<int> feet = feet_down(plants, count, clip.loops);
  if (!feet.empty()) {
    const auto both = std::count_if(feet.begin(), feet.end(), [](int n) { return n > 1; });
    carriage.double_support = static_cast<double>(both) / static_cast<double>(feet.size());
  }
  return carriage;
}

double step_factor(double tempo, const Carriage& carriage) {
  if (!carriage.travels) return 1.0;
  const double factor = std::pow(tempo, steps_by_cadence);
  if (factor <= 1.0) return factor;
  if (!carriage.walks()) return std::min(factor, longest_steps);
  const double fastest = std::sqrt(froude_of_running * gravity * carriage.leg);
  return std::min(factor, std::max(1.0, fastest / (carriage.speed * tempo)));
}

std::vector<double> stretched_contacts(int frame_count, double frames_per_second, bool loops,
                                       const Tempo& tempo, const Carriage& carriage) {
  std::vector<double> stretch(static_cast<size_t>(std::max(0, interval_count(frame_count, loops))),
                              1.0);
  const auto factor = [&](size_t i) {
    return factor_at(tempo, (static_cast<double>(i) + 0.5) / static_cast<double>(stretch.size()),
                     loops);
  };
  if (carriage.walks() && carriage.double_support > 0.0 && carriage.double_support < 1.0) {
    const std::vector<int> feet = feet_down(carriage.plants, frame_count, loops);
    for (size_t i = 0; i < stretch.size(); ++i) {
      const double both = support_factor(factor(i), carriage);
      const double one = (1.0 - both * carriage.double_support) / (1.0 - carriage.double_support);
      stretch[i] = feet[i] > 1 ? both : one;
    }
    const int half_width = static_cast<int>(std::lround(contact_join_seconds * frames_per_second));
    stretch = smoothed(stretch, half_width, loops);
  }
  for (const Airborne& flight : carriage.flights) {
    const double before = (flight.landing - flight.take_off) / frames_per_second;
    for (int f = flight.take_off; f < flight.landing; ++f) {
      const auto i = static_cast<size_t>(f % std::max(1, frame_count));
      if (i >= stretch.size()) continue;
      stretch[i] *= std::min(1.0, std::max(before, longest_flight) * factor(i) / before);
    }
  }
  return stretch;
}

Clip with_steps_at_tempo(const Clip& clip, const Tempo& tempo, const Retiming& retiming,
                         const Carriage& carriage) {
  if (!carriage.travels || clip.frame_count() < 2) return clip;
  const std::vector<double> factors = factors_of(tempo, retiming);
  const std::vector<Vec3> directions = walking_directions(clip);
  std::vector<FootTrajectory> stretches;
  double mean = 0.0;
  for (const bool left : {true, false}) {
    const FootPath path = foot_path(clip, left);
    stretches.push_back({left, 0, {}});
    for (int f = 0; f < clip.frame_count(); ++f) {
      const auto at = static_cast<size_t>(f);
      stretches.back().places.push_back({path.ankle[at], path.rotation[at]});
      mean += (path.ankle[at] - clip.poses[at].root_position).dot(directions[at]) /
              (2.0 * clip.frame_count());
    }
  }
  for (FootTrajectory& stretch : stretches) {
    for (size_t f = 0; f < stretch.places.size(); ++f) {
      Vec3& ankle = stretch.places[f].ankle;
      const double ahead = (ankle - clip.poses[f].root_position).dot(directions[f]) - mean;
      ankle += (step_factor(factors[f], carriage) - 1.0) * ahead * directions[f];
    }
  }
  return with_feet_placed(clip, stretches);
}

Clip with_gravity_kept(const Clip& clip, const std::vector<double>& played, const Tempo& tempo,
                       const Retiming& retiming, const Carriage& carriage) {
  if (clip.frame_count() < 3) return clip;
  const double rate = clip.frames_per_second;
  const auto slow_part = [&](const std::vector<double>& heights) {
    return low_pass(heights, slow_path_hz * retiming.factor, rate,
                    clip.loops ? SignalEnds::periodic : SignalEnds::open);
  };
  const std::vector<double> slow = slow_part(played);
  std::vector<double> heights = slow_part(body_heights(clip));
  const double most =
      carriage.walks() ? most_fall * gravity / std::max(0.1, largest_fall(played, rate, clip.loops))
                       : INFINITY;
  const std::vector<double> factors = factors_of(tempo, retiming);
  for (size_t f = 0; f < heights.size(); ++f) {
    const double scale = carriage.walks() ? step_factor(factors[f], carriage) : 1.0 / factors[f];
    heights[f] += std::min(most, scale * scale) * (played[f] - slow[f]);
  }
  return with_body_heights(clip, std::move(heights), retimed(carriage.plants, retiming),
                           retimed(carriage.flights, retiming),
                           carriage.walks() ? FeetStay::all : FeetStay::planted);
}

}  // namespace mien::motion
