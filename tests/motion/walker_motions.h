#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "motion/steered_walk/scripted_walk.h"

namespace mien::motion::test {

namespace walker_take {

using Kind = WalkSegment::Kind;

/// A script and which part of its film is the motion.
struct Take {
  std::string name;
  std::vector<WalkSegment> script;
  double skipped_seconds = 0.0;  ///< at the beginning
};

inline std::vector<Take> takes() {
  const WalkSegment stand = {.kind = Kind::stand, .seconds = 0.6};
  const auto walk = [](double seconds, double turn_rate = 0.0) {
    return WalkSegment{.kind = Kind::walk, .seconds = seconds, .turn_rate_deg = turn_rate};
  };
  const auto turn = [](double degrees) {
    return WalkSegment{.kind = Kind::turn, .degrees = degrees, .pace = 0.0};
  };
  constexpr double steady = 3.0;  // seconds until the walk is that of its style
  std::vector<Take> takes = {
      {"stand", {{.kind = Kind::stand, .seconds = 4.0}}},
      {"start", {stand, walk(4.5)}},
      {"walk", {walk(steady + 4.5)}, steady},
      {"stop", {walk(steady + 1.5), stand}, steady},
  };
  for (const auto& [side, sign] : {std::pair{"left", 1.0}, std::pair{"right", -1.0}}) {
    takes.push_back({std::string("curve-") + side,
                     {walk(steady + 1.0), walk(4.0, 45.0 * sign), walk(2.5)},
                     steady});
    takes.push_back({std::string("wide-") + side,
                     {walk(steady + 1.0), walk(4.0, 20.0 * sign), walk(2.5)},
                     steady});
    takes.push_back({std::string("turn-") + side, {stand, turn(90.0 * sign), stand}});
  }
  takes.push_back({"about-turn", {stand, turn(160.0), stand}});
  return takes;
}

inline Clip cut(Clip clip, double skipped_seconds) {
  const auto first = std::lround(skipped_seconds * clip.frames_per_second);
  clip.poses.erase(clip.poses.begin(), clip.poses.begin() + first);
  const Vec3 start = horizontal(clip.poses.front().root_position);
  for (Pose& pose : clip.poses) pose.root_position -= start;
  return clip;
}

}  // namespace walker_take

/// What a walker does besides walking on, as takes that do not loop, each beginning and ending in
/// standing or in a steady walk, along +Z from the origin: "stand" (4 s), "start", "walk", "stop",
/// "curve-left" and "curve-right" (at 45°/s), "wide-left" and "wide-right" (at 20°/s), "turn-left",
/// "turn-right" (90° on the spot) and "about-turn". For a motion graph. Throws as `fit_walker`
/// (walker_gaits.h), and for frame rates that are not positive.
inline std::vector<Clip> walker_motions(const WalkStyle& style, double frames_per_second,
                                        const Skeleton& body) {
  const WalkerGaits gaits = fit_walker({&style, 1}, body);
  ScriptedWalkOptions options;
  options.frames_per_second = frames_per_second;
  std::vector<Clip> clips;
  for (const walker_take::Take& take : walker_take::takes()) {
    Clip clip =
        walker_take::cut(scripted_walk(gaits, take.script, options).clip, take.skipped_seconds);
    clip.name = take.name;
    clips.push_back(std::move(clip));
  }
  return clips;
}

}  // namespace mien::motion::test
