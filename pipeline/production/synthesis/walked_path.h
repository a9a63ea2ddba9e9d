#pragma once

#include <cstddef>
#include <string>

#include "motion/error.h"
#include "motion/steered_walk/scripted_walk.h"
#include "pipeline/manifest/stimulus.h"
#include "pipeline/manifest/walk_path.h"

namespace mien::pipeline {

/// A step of a script that a graph's motions do not make: a turn, mostly.
class UnwalkableStep : public Error {
 public:
  UnwalkableStep(std::size_t step, std::string wrong, std::string remedy)
      : Error(wrong, remedy), step_(step), wrong_(std::move(wrong)), remedy_(std::move(remedy)) {}

  /// The error at a place of the manifest.
  Error at(const Place& place) const { return {place, wrong_, remedy_}; }
  std::size_t step() const { return step_; }

 private:
  std::size_t step_;
  std::string wrong_, remedy_;
};

/// What a stimulus's path asks for, walked by a walker under control on the standard body, from the
/// first frame to the last: a clip that does not loop, and where its feet stand. A turn goes on at
/// the pace of the walk before it, and is on the spot where nothing is walked before. By a graph,
/// it is cut from the files' motions, on the body of the first; its moods are versions of all of
/// them, each given an emotion's recipe, mixed on the way. Throws Error; UnwalkableStep for a turn
/// of a script that comes out wrong by more than 10°.
motion::WalkedClip walked(const Stimulus& stimulus);

/// The path with its moods of adjectives turned into moods of the set's walks: the shares of the
/// blend that a stimulus of these adjectives would be, which has them or comes nearest to them, by
/// what is rated of the built-in walks on the built-in scales. Moods of walks stay as they are.
/// Throws Error when the method cannot take so many adjectives.
WalkPath in_walks(WalkPath path);

}  // namespace mien::pipeline
