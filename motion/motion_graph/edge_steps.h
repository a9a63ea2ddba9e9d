#pragma once

#include <vector>

#include "motion/motion_graph/motion_graph.h"

namespace mien::motion {

/// How an edge leads over the floor, in the frame of the clip that it leaves.
struct EdgeSteps {
  std::vector<Vec3> steps;      ///< of the pelvis, metres, a frame
  std::vector<double> facings;  ///< of the pelvis after each step, radians about +Y from +Z
  std::vector<double> seconds;  ///< that each step lasts
  double turn = 0.0;            ///< of the clip that it leads to on the one that it leaves, radians
};

/// Of every edge of the graph, as `motion_of` (graph_walk.h) plays it, feet unlocked.
std::vector<EdgeSteps> edge_steps(const MotionGraph& graph);

}  // namespace mien::motion
