#include "motion/modify/variation.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "motion/math/random_number.h"
#include "motion/modify/limb_timing.h"
#include "motion/modify/path_length.h"
#include "motion/skeleton/joint_curve.h"

namespace mien::motion {

namespace {

constexpr double path_share = 0.6;  // of the middle band
constexpr double timing_seconds = 0.08;

std::string_view name_of(Limb limb) {
  constexpr std::string_view names[] = {"head", "left hand", "right hand", "left foot",
                                        "right foot"};
  static_assert(std::size(names) == static_cast<size_t>(Limb::right_foot) + 1);
  return names[static_cast<size_t>(limb)];
}

/// What of a joint's directions is quicker than 1 Hz, that is what other gains than 1 would add.
std::vector<Directions> quick_part(const Clip& longer, const std::vector<Directions>& curve,
                                   int joint) {
  std::vector<Directions> part = direction_curve(longer, joint);
  for (size_t f = 0; f < part.size(); ++f) {
    part[f] = (part[f] - curve[f]) / (longest_middle_gain - 1.0);
  }
  return part;
}

}  // namespace

std::vector<double> smooth_random_curve(std::uint64_t seed, std::string_view name, int frame_count,
                                        double frames_per_second, bool loops, double knot_seconds) {
  const double frames = loops ? frame_count : std::max(1, frame_count - 1);
  const long spans =
      std::max(loops ? 3L : 1L, std::lround(frames / (knot_seconds * frames_per_second)));
  std::vector<Directions> knots;
  for (long k = 0; k < (loops ? spans : spans + 1); ++k) {
    knots.push_back(Directions::Constant(random_number(seed, name, static_cast<std::uint64_t>(k))));
  }
  std::vector<double> curve;
  for (int f = 0; f < frame_count; ++f) {
    curve.push_back(value_at(knots, f / frames * static_cast<double>(spans), loops)[0]);
  }
  return curve;
}

Clip with_variation(const Clip& clip, double variation, const Limbs& limbs, std::uint64_t seed) {
  Clip result = clip;
  if (variation == 0.0 || clip.frame_count() < 2) return result;
  PathGains quick = longest_path_gains();
  quick.high = 1.0;
  const Clip longer = with_path_gains(clip, quick, RotationSignal::direction_vectors);
  const double rate = clip.frames_per_second;
  // Knots that lie close would make time run backwards.
  const double knot_frames =
      clip.loops ? std::min(0.7 * rate, clip.frame_count() / 3.0) : 0.7 * rate;
  const double shift = variation * std::min(timing_seconds * rate, 0.2 * knot_frames);
  for (const Limb limb : all_limbs) {
    if (!has(limbs, limb)) continue;
    const std::string name(name_of(limb));
    const auto wander = [&](const char* what) {
      return smooth_random_curve(seed, name + what, clip.frame_count(), rate, clip.loops);
    };
    const std::vector<double> path = wander(" path");
    for (const BodyJoint joint : joints_of(limb)) {
      std::vector<Directions> curve = direction_curve(clip, joint);
      const std::vector<Directions> part = quick_part(longer, curve, joint);
      for (size_t f = 0; f < curve.size(); ++f) {
        curve[f] += variation * path_share * path[f] * part[f];
      }
      set_rotations(result, joint, curve);
    }
    std::vector<double> sources = wander(" time");
    for (size_t f = 0; f < sources.size(); ++f) {
      sources[f] = static_cast<double>(f) + shift * sources[f];
    }
    retime(result, limb, sources);
  }
  return result;
}

}  // namespace mien::motion
