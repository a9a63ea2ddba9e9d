#include "motion/motion_graph/transition_checks.h"

#include <algorithm>
#include <cmath>

#include "motion/motion_graph/walk_frames.h"

namespace mien::motion {

FootContacts foot_contacts(const MotionGraph& graph) {
  FootContacts contacts;
  for (std::size_t c = 0; c < graph.clips.size(); ++c) {
    std::vector<std::array<bool, 2>> clip(graph.clips[c].poses.size(), {false, false});
    for (const FootPlant& plant : graph.plants[c]) {
      const int last = std::min(plant.last, graph.clips[c].frame_count() - 1);
      for (int f = plant.first; f <= last; ++f) {
        clip[static_cast<std::size_t>(f)][plant.left] = true;
      }
    }
    contacts.push_back(std::move(clip));
  }
  return contacts;
}

double contact_change(const FootContacts& contacts, const DistanceMinimum& minimum, int window) {
  const auto& a = contacts[static_cast<std::size_t>(minimum.clip_a)];
  const auto& b = contacts[static_cast<std::size_t>(minimum.clip_b)];
  std::array<int, 2> changes = {0, 0};
  for (int f = 0; f < window; ++f) {
    for (std::size_t side = 0; side < 2; ++side) {
      changes[side] += a[static_cast<std::size_t>(minimum.frame_a + f)][side] !=
                       b[static_cast<std::size_t>(minimum.frame_b + f)][side];
    }
  }
  return static_cast<double>(std::max(changes[0], changes[1])) / window;
}

namespace {

/// Where the pelvis faces, radians about +Y.
double facing_in(const MotionGraph& graph, int clip, int frame) {
  const Clip& played = graph.clips[static_cast<std::size_t>(clip)];
  const Vec3 forward =
      played.poses[static_cast<std::size_t>(frame)].rotations.front() * Vec3::UnitZ();
  return std::atan2(forward.x(), forward.z());
}

/// In frame f of the window: from the first motion to the second.
double change_in(const MotionGraph& graph, const GraphTransition& transition, int f) {
  return std::remainder(facing_in(graph, transition.to_clip, transition.to_frame + f) +
                            transition.turn -
                            facing_in(graph, transition.from_clip, transition.from_frame + f),
                        2.0 * pi);
}

}  // namespace

double facing_change(const MotionGraph& graph, const GraphTransition& transition) {
  double sum = 0.0;
  for (int f = 0; f < graph.window; ++f) sum += change_in(graph, transition, f);
  return sum / graph.window;
}

double turn_beyond_motions(const MotionGraph& graph, const GraphTransition& transition) {
  const auto turn_of = [&](int clip, int frame) {
    return std::remainder(facing_in(graph, clip, frame) - facing_in(graph, clip, frame - 1),
                          2.0 * pi);
  };
  double most = 0.0;
  double part = 0.0;  // of the change, in the blend so far
  for (int f = 0; f < graph.window; ++f) {
    if (transition.from_frame + f < 1 || transition.to_frame + f < 1) continue;
    const double now = (1.0 - blend_share(f, graph.window)) * change_in(graph, transition, f);
    const double first = turn_of(transition.from_clip, transition.from_frame + f);
    const double second = turn_of(transition.to_clip, transition.to_frame + f);
    most =
        std::max(most, std::abs(first + now - part) - std::max(std::abs(first), std::abs(second)));
    part = now;
  }
  return most;
}

}  // namespace mien::motion
