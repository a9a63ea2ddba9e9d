#include "motion/modify/limb_timing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "motion/math/filter.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/joint_curve.h"
#include "motion/skeleton/pose.h"
#include "motion/skeleton/recorded_hands.h"

namespace mien::motion {

namespace {

constexpr double standstill = 0.05;  // m/s
constexpr double set_seconds = 0.15;
constexpr double rounding_seconds = 0.1;

struct LimbParts {
  bool Limbs::*is_meant;
  BodyJoint first;  ///< joints are numbered down each chain
  BodyJoint last;
  BodyJoint end;
};

const LimbParts& parts_of(Limb limb) {
  static constexpr LimbParts limbs[] = {
      {&Limbs::head, Neck, Head, Head},
      {&Limbs::left_hand, LeftClavicle, LeftWrist, LeftWrist},
      {&Limbs::right_hand, RightClavicle, RightWrist, RightWrist},
      {&Limbs::left_foot, LeftHip, LeftToe, LeftAnkle},
      {&Limbs::right_foot, RightHip, RightToe, RightAnkle},
  };
  static_assert(std::size(limbs) == static_cast<size_t>(Limb::right_foot) + 1);
  return limbs[static_cast<size_t>(limb)];
}

/// Where each of `count` equal parts of `whole` begins; the end of the last too.
std::vector<long> parts(long whole, long count) {
  std::vector<long> borders;
  for (long k = 0; k <= count; ++k) {
    borders.push_back(std::lround(static_cast<double>(whole * k) / static_cast<double>(count)));
  }
  return borders;
}

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Output time minus frame at which each frame of the original is shown; zero at segment borders.
std::vector<double> shown_at(std::span<const double> durations, double segment_frames) {
  const auto whole = static_cast<long>(durations.size());
  const long count =
      std::clamp(std::lround(static_cast<double>(whole) / segment_frames), 1L, std::max(1L, whole));
  const std::vector<long> borders = parts(whole, count);
  std::vector<double> times(durations.size() + 1, 0.0);
  for (size_t s = 0; s + 1 < borders.size(); ++s) {
    const auto first = static_cast<size_t>(borders[s]);
    const auto length = static_cast<size_t>(borders[s + 1]) - first;
    const std::span<const double> within = durations.subspan(first, length);
    const double scale =
        static_cast<double>(length) / std::accumulate(within.begin(), within.end(), 0.0);
    times[first] = static_cast<double>(first);
    for (size_t i = first; i + 1 < first + length; ++i)
      times[i + 1] = times[i] + scale * durations[i];
    times[first + length] = static_cast<double>(first + length);
  }
  return times;
}

/// A mean over neighbours, by a raised cosine. What lies beyond open ends is the curve turned half
/// round them. All weights are positive, so that what never decreases still does not.
std::vector<double> rounded_off(const std::vector<double>& shift, long half_width, bool loops) {
  const auto count = static_cast<long>(shift.size());
  const auto at = [&](long i) {
    if (loops) return shift[static_cast<size_t>(((i % count) + count) % count)];
    if (i < 0) return -shift[static_cast<size_t>(std::min(-i, count - 1))];
    if (i >= count) return -shift[static_cast<size_t>(std::max(2 * (count - 1) - i, 0L))];
    return shift[static_cast<size_t>(i)];
  };
  std::vector<double> smooth;
  for (long i = 0; i < count; ++i) {
    double sum = 0.0;
    double weight = 0.0;
    for (long k = -half_width; k <= half_width; ++k) {
      const double w =
          1.0 + std::cos(pi * static_cast<double>(k) / static_cast<double>(half_width + 1));
      sum += w * at(i + k);
      weight += w;
    }
    smooth.push_back(sum / weight);
  }
  return smooth;
}

/// Everywhere, or only near `moments`.
Clip accelerated(const Clip& clip, const Limbs& limbs, const std::span<const int>* moments) {
  Clip result = clip;
  for (const Limb limb : all_limbs) {
    if (!has(limbs, limb)) continue;
    std::vector<double> durations =
        accelerated_durations(limb_speeds(clip, limb), clip.frames_per_second, clip.loops);
    if (moments) durations = near_only(durations, *moments, clip.frames_per_second, clip.loops);
    retime(
        result, limb,
        source_frames(durations, acceleration_segment_seconds, clip.frames_per_second, clip.loops));
  }
  return result;
}

}  // namespace

bool has(const Limbs& limbs, Limb limb) { return limbs.*parts_of(limb).is_meant; }

std::vector<BodyJoint> joints_of(Limb limb) {
  std::vector<BodyJoint> joints;
  for (int j = parts_of(limb).first; j <= parts_of(limb).last; ++j) joints.push_back(BodyJoint(j));
  return joints;
}

BodyJoint end_of(Limb limb) { return parts_of(limb).end; }

std::vector<double> limb_speeds(const Clip& clip, Limb limb) {
  std::vector<Vec3> path;
  for (const Pose& pose : clip.poses) {
    path.push_back(world_transform(clip.body, pose, end_of(limb)).position - pose.root_position);
  }
  const double rate = clip.frames_per_second;
  path = low_pass(path, std::min(12.5, 0.3 * rate), rate,
                  clip.loops ? SignalEnds::periodic : SignalEnds::open);
  std::vector<double> speeds;
  for (size_t i = 0; i + 1 < path.size(); ++i)
    speeds.push_back(rate * (path[i + 1] - path[i]).norm());
  if (clip.loops) speeds.push_back(rate * (path.front() - path.back()).norm());
  return speeds;
}

std::vector<double> constant_speed_durations(std::span<const double> speeds) {
  std::vector<double> durations(speeds.size(), 1.0);
  if (speeds.empty()) return durations;
  const double average = mean(speeds);
  const double top = *std::max_element(speeds.begin(), speeds.end());
  const double pause = std::max(standstill, 0.1 * top);
  for (size_t i = 0; i < speeds.size(); ++i) {
    if (speeds[i] >= pause) durations[i] = std::max(speeds[i] / average, 0.05);
  }
  return durations;
}

std::vector<double> accelerated_durations(std::span<const double> speeds, double frames_per_second,
                                          bool loops, double pause_factor) {
  std::vector<double> durations(speeds.size(), 1.0);
  const long set = std::max(3L, std::lround(set_seconds * frames_per_second));
  const auto whole = static_cast<long>(speeds.size());
  const long count = std::lround(static_cast<double>(whole) / static_cast<double>(set));
  if (count < 3) return durations;
  const std::vector<long> borders = parts(whole, count);
  const auto of_set = [&](long k) {
    k = (k + count) % count;
    const long first = borders[static_cast<size_t>(k)];
    return speeds.subspan(static_cast<size_t>(first),
                          static_cast<size_t>(borders[static_cast<size_t>(k + 1)] - first));
  };
  for (long k = loops ? 0 : 1; k < (loops ? count : count - 1); ++k) {
    const std::span<const double> own = of_set(k);
    const bool slower = mean(own) < mean(of_set(k - 1)) && mean(own) < mean(of_set(k + 1));
    if (!slower || *std::max_element(own.begin(), own.end()) <= standstill) continue;
    std::fill(durations.begin() + borders[static_cast<size_t>(k)],
              durations.begin() + borders[static_cast<size_t>(k + 1)], pause_factor);
  }
  return durations;
}

std::vector<double> near_only(std::span<const double> durations, std::span<const int> moments,
                              double frames_per_second, bool loops) {
  const auto count = static_cast<double>(durations.size());
  std::vector<double> result;
  for (size_t i = 0; i < durations.size(); ++i) {
    double nearest = 1e9;
    for (const int moment : moments) {
      double away = std::abs(static_cast<double>(i) + 0.5 - moment);
      if (loops) away = std::min(away, count - std::min(away, count));
      nearest = std::min(nearest, away / frames_per_second);
    }
    const double share = 1.0 - smooth_step(nearest / 0.1 - 1.0);
    result.push_back(1.0 + share * (durations[i] - 1.0));
  }
  return result;
}

std::vector<double> source_frames(std::span<const double> durations, double segment_seconds,
                                  double frames_per_second, bool loops) {
  const size_t count = loops ? durations.size() : durations.size() + 1;
  if (durations.empty()) return std::vector<double>(count, 0.0);
  const std::vector<double> times = shown_at(durations, segment_seconds * frames_per_second);
  std::vector<double> shift;
  size_t i = 0;
  for (size_t f = 0; f < count; ++f) {
    const auto t = static_cast<double>(f);
    while (i + 1 < times.size() - 1 && times[i + 1] <= t) ++i;
    const double within = (t - times[i]) / (times[i + 1] - times[i]);
    shift.push_back(static_cast<double>(i) + within - t);
  }
  const long half_width = std::max(1L, std::lround(rounding_seconds * frames_per_second));
  shift = rounded_off(shift, half_width, loops);
  for (size_t f = 0; f < count; ++f) shift[f] += static_cast<double>(f);
  return shift;
}

std::vector<int> contact_frames(const std::vector<FootPlant>& plants, int frame_count) {
  std::vector<int> frames;
  for (const FootPlant& plant : plants) {
    // One that has stood from the beginning does not come to the floor.
    if (plant.first > 0) frames.push_back(plant.first % frame_count);
  }
  return frames;
}

namespace {

/// Fingers go along with their hand.
void retime_fingers(Clip& clip, bool left, const std::vector<double>& sources) {
  if (!has_fingers(clip)) return;
  const Clip before = clip;
  for (size_t f = 0; f < sources.size(); ++f) {
    const Pose played = pose_at(before, sources[f] / clip.frames_per_second);
    for (int joint = 0; joint < finger_joint_count; ++joint) {
      const auto at = static_cast<size_t>(joint);
      if (is_left_finger(joint) != left) continue;
      Quat& finger = clip.poses[f].fingers[at];
      finger = in_hemisphere_of(finger, played.fingers[at]);
    }
  }
}

}  // namespace

void retime(Clip& clip, Limb limb, const std::vector<double>& sources) {
  if (limb == Limb::left_hand || limb == Limb::right_hand)
    retime_fingers(clip, limb == Limb::left_hand, sources);
  for (const BodyJoint joint : joints_of(limb)) {
    const std::vector<Directions> curve = direction_curve(clip, joint);
    std::vector<Directions> retimed;
    retimed.reserve(curve.size());
    for (const double source : sources) retimed.push_back(value_at(curve, source, clip.loops));
    set_rotations(clip, joint, retimed);
  }
}

Clip with_constant_speed(const Clip& clip, const Limbs& limbs) {
  Clip result = clip;
  for (const Limb limb : all_limbs) {
    if (!has(limbs, limb)) continue;
    const std::vector<double> durations = constant_speed_durations(limb_speeds(clip, limb));
    retime(result, limb,
           source_frames(durations, constant_segment_seconds, clip.frames_per_second, clip.loops));
  }
  return result;
}

Clip with_acceleration(const Clip& clip, const Limbs& limbs) {
  return accelerated(clip, limbs, nullptr);
}

Clip with_acceleration_near(const Clip& clip, const Limbs& limbs, std::span<const int> moments) {
  return moments.empty() ? clip : accelerated(clip, limbs, &moments);
}

}  // namespace mien::motion
