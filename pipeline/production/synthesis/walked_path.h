#pragma once

#include <cstddef>
#include <string>

#include "motion/error.h"
#include "motion/steered_walk/scripted_walk.h"
#include "pipeline/manifest/stimulus.h"
#include "pipeline/manifest/walk_path.h"

namespace mien::pipeline {

/// A step of a script, usually a turn, that the motions of a graph cannot perform.
class UnwalkableStep : public Error {
 public:
  UnwalkableStep(std::size_t step, std::string wrong, std::string remedy)
      : Error(wrong, remedy), step_(step), wrong_(std::move(wrong)), remedy_(std::move(remedy)) {}

  /// Returns the error with a position in the manifest.
  Error at(const Place& place) const { return {place, wrong_, remedy_}; }
  std::size_t step() const { return step_; }

 private:
  std::size_t step_;
  std::string wrong_, remedy_;
};

/// Returns the walk along a stimulus's path by the steered walker on the standard body: a clip that
/// does not loop, and the plants of its feet. A turn without a pace of its own continues at the
/// pace of the step before it; at the beginning and after standing, it is made on the spot. With a
/// graph, the walk is assembled from the motions of the graph's files, on the body of the first
/// motion; for moods, every motion is modified by the recipe of each emotion used, and these
/// versions are blended along the path. Throws Error; UnwalkableStep if the heading after a step of
/// the script deviates by more than 10°.
motion::WalkedClip walked(const Stimulus& stimulus);

/// Returns the path with each mood that is given by adjectives replaced by weights of the built-in
/// walks of the path's set. These are the blend weights of a stimulus with these adjectives or, if
/// they are infeasible, with the nearest feasible values. They are based on the built-in ratings of
/// the walks. Moods given by walks are unchanged. Throws Error if the method cannot handle that
/// many adjectives.
WalkPath in_walks(WalkPath path);

}  // namespace mien::pipeline
