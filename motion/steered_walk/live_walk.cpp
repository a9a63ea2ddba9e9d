#include "motion/steered_walk/live_walk.h"

#include <algorithm>
#include <cmath>

#include "motion/error.h"

namespace mien::motion {

namespace {

constexpr double longest_frame = 0.25;  // seconds
constexpr double fastest_turn = 180.0;  // °/s

bool is_sound(const WalkRequest& request) {
  bool sound = std::isfinite(request.pace) && std::isfinite(request.turn_deg_s) &&
               (!request.heading_deg || std::isfinite(*request.heading_deg));
  for (const double mood : request.moods) sound = sound && std::isfinite(mood) && mood >= 0.0;
  return sound;
}

Steering steering_of(const WalkRequest& request) {
  Steering steering;
  steering.pace = std::clamp(request.pace, 0.0, gait_paces.back());
  if (request.heading_deg)
    steering.heading = radians_per_degree * std::remainder(*request.heading_deg, 360.0);
  steering.turning =
      radians_per_degree * std::clamp(request.turn_deg_s, -fastest_turn, fastest_turn);
  steering.moods = request.moods;
  return steering;
}

}  // namespace

LiveWalk make_live_walk(std::span<const NamedStyle> moods, const Skeleton& body) {
  LiveWalk walk;
  std::vector<WalkStyle> styles;
  for (const NamedStyle& mood : moods) {
    walk.moods.push_back(mood.name);
    styles.push_back(mood.style);
  }
  walk.gaits = fit_walker(styles, body);
  walk.walker = standing_walker(walk.gaits);
  return walk;
}

Pose advance(LiveWalk& walk, double seconds, const WalkRequest& request) {
  if (!(seconds >= 0.0) || std::isinf(seconds)) {
    throw Error("a walker cannot go back in time", "give the seconds since the frame before");
  }
  if (!is_sound(request) || request.moods.size() > walk.moods.size()) {
    throw Error("a walker request with an invalid number, a mood below 0 or too many moods",
                "give pace, degrees, and a weight for each mood");
  }
  advance(walk.gaits, steering_of(request), std::min(seconds, longest_frame), walk.walker);
  return pose_of(walk.gaits, walk.walker);
}

}  // namespace mien::motion
