#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// A change of a gesture of one hand (acting_hand.h), in the actor's own terms.
struct GestureChange {
  double height = 1.0;  ///< factor on how far the hand rises above where it hangs, 0–2;
                        ///< overhead the elbow stays bent
  double width = 1.0;  ///< factor on the horizontal extent of its strokes and on the turning of the
                       ///< wrist, 0–3
  double speed = 1.0;  ///< tempo while it is raised, 0.25–4; raising and lowering keep theirs
  int repetitions = 0;  ///< strokes added, or left out if negative, −10 to 10; one is always left
};

bool is_identity(const GestureChange& change);

/// The change at a strength: factors to that power within their limits, repetitions times it,
/// rounded.
GestureChange scaled(GestureChange change, double strength);

/// Throws mien::Error for a number outside its range.
void check(const GestureChange& change);

struct ChangedGesture {
  Clip clip;
  /// The frame (fractional) to which each frame of the original came; ascending.
  std::vector<double> frames;
  std::vector<std::string> remarks;  ///< sentences
};

/// The frame to which a (fractional) frame of the original came, by `ChangedGesture::frames`.
double moved_by_gesture(const std::vector<double>& frames, double frame);

/// The clip with its gesture changed: strokes repeated or left out (with transitions of 0.12 s), at
/// another speed (changing over 0.25 s), and the wrist moved, as far as the arm reaches, by inverse
/// kinematics; the hand keeps its orientation. A clip without a gesture is unchanged, with a
/// remark.
ChangedGesture with_gesture(const Clip& clip, const GestureChange& change);

}  // namespace mien::motion
