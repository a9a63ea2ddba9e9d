#include "motion/motion_graph/transition_checks.h"

#include <algorithm>
#include <cmath>

namespace mien::motion {

FootStands foot_stands(const MotionGraph& graph) {
  FootStands stands;
  for (std::size_t c = 0; c < graph.clips.size(); ++c) {
    std::vector<std::array<bool, 2>> clip(graph.clips[c].poses.size(), {false, false});
    for (const FootPlant& plant : graph.plants[c]) {
      const int last = std::min(plant.last, graph.clips[c].frame_count() - 1);
      for (int f = plant.first; f <= last; ++f) {
        clip[static_cast<std::size_t>(f)][plant.left] = true;
      }
    }
    stands.push_back(std::move(clip));
  }
  return stands;
}

double contact_change(const FootStands& stands, const DistanceMinimum& minimum, int window) {
  const auto& a = stands[static_cast<std::size_t>(minimum.clip_a)];
  const auto& b = stands[static_cast<std::size_t>(minimum.clip_b)];
  std::array<int, 2> changes = {0, 0};
  for (int f = 0; f < window; ++f) {
    for (std::size_t side = 0; side < 2; ++side) {
      changes[side] += a[static_cast<std::size_t>(minimum.frame_a + f)][side] !=
                       b[static_cast<std::size_t>(minimum.frame_b + f)][side];
    }
  }
  return static_cast<double>(std::max(changes[0], changes[1])) / window;
}

double facing_change(const MotionGraph& graph, const GraphTransition& transition) {
  const auto facing_in = [&](int clip, int frame) {
    const Clip& played = graph.clips[static_cast<std::size_t>(clip)];
    const Vec3 forward =
        played.poses[static_cast<std::size_t>(frame)].rotations.front() * Vec3::UnitZ();
    return std::atan2(forward.x(), forward.z());
  };
  double sum = 0.0;
  for (int f = 0; f < graph.window; ++f) {
    const double change = facing_in(transition.to_clip, transition.to_frame + f) + transition.turn -
                          facing_in(transition.from_clip, transition.from_frame + f);
    sum += std::remainder(change, 2.0 * pi);
  }
  return sum / graph.window;
}

}  // namespace mien::motion
