#include "motion/modify/tempo.h"

#include <algorithm>
#include <cmath>

#include "motion/modify/joint_curve.h"

namespace mien::motion {

namespace {

/// Root place less the even way of a loop, so that it is periodic; the rest of the six numbers is
/// not used.
std::vector<Directions> root_curve(const Clip& clip) {
  std::vector<Directions> curve;
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    const double share = static_cast<double>(f) / clip.frame_count();
    Directions place = Directions::Zero();
    place.head<3>() = clip.poses[f].root_position - share * clip.cycle_displacement;
    curve.push_back(place);
  }
  return curve;
}

}  // namespace

Clip with_tempo(const Clip& clip, double tempo) {
  const int steps = clip.loops ? clip.frame_count() : clip.frame_count() - 1;
  const int new_steps = std::max(clip.loops ? 3 : 1, static_cast<int>(std::lround(steps / tempo)));
  if (steps < 1 || new_steps == steps) return clip;
  Clip result = clip;
  result.poses.assign(static_cast<size_t>(clip.loops ? new_steps : new_steps + 1),
                      clip.poses.front());
  const auto source = [&](size_t f) { return static_cast<double>(f) * steps / new_steps; };
  for (int joint = 0; joint < clip.body.size(); ++joint) {
    const std::vector<Directions> curve = direction_curve(clip, joint);
    std::vector<Directions> played;
    for (size_t f = 0; f < result.poses.size(); ++f) {
      played.push_back(value_at(curve, source(f), clip.loops));
    }
    set_rotations(result, joint, played);
  }
  const std::vector<Directions> root = root_curve(clip);
  for (size_t f = 0; f < result.poses.size(); ++f) {
    result.poses[f].root_position = value_at(root, source(f), clip.loops).head<3>() +
                                    source(f) / clip.frame_count() * clip.cycle_displacement;
  }
  return result;
}

double frame_scale(int frames_before, int frames_after, bool loops) {
  return loops ? static_cast<double>(frames_after) / frames_before
               : (frames_after - 1.0) / std::max(1, frames_before - 1);
}

std::vector<FootPlant> with_tempo(const std::vector<FootPlant>& plants, int frames_before,
                                  int frames_after, bool loops) {
  const double scale = frame_scale(frames_before, frames_after, loops);
  std::vector<FootPlant> result = plants;
  for (FootPlant& plant : result) {
    // Within the plant: a foot that is half a frame too long on the floor would have to slide.
    const int first = static_cast<int>(std::ceil(plant.first * scale - 1e-9));
    const int last = static_cast<int>(std::floor(plant.last * scale + 1e-9));
    plant.first = std::min(first, last);
    plant.last = std::max(plant.first, last);
  }
  return result;
}

}  // namespace mien::motion
