#include "motion/motion_graph/edge_steps.h"

#include <cmath>

#include "motion/motion_graph/walk_frames.h"

namespace mien::motion {

std::vector<EdgeSteps> edge_steps(const MotionGraph& graph) {
  std::vector<EdgeSteps> all;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const GraphEdge& edge = graph.edges[e];
    EdgeSteps way;
    for (const WalkFrame& frame : frames_of(graph, {{static_cast<int>(e)}})) {
      const Pose pose = posture_of(graph, frame, 0.0);
      const Vec3 forward = pose.rotations.front() * Vec3::UnitZ();
      way.steps.push_back(step_of(graph, frame, 0.0));
      way.facings.push_back(std::atan2(forward.x(), forward.z()));
      way.seconds.push_back(seconds_of(graph, frame));
    }
    if (edge.transition >= 0) {
      way.turn = graph.transitions[static_cast<std::size_t>(edge.transition)].turn;
    }
    all.push_back(std::move(way));
  }
  return all;
}

}  // namespace mien::motion
