#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

using Curve = std::vector<double>;
using Path = std::vector<Vec3>;

/// Curves over time of the trunk, then of limbs; those of limbs exist on both sides.
enum MovementCurve : int {
  TrunkForward,
  TrunkSideways,
  HeadForward,
  HeadSideways,
  ShoulderTurn,
  HipTurn,
  ShoulderRoll,
  HipRoll,
  PelvisHeight,
  HandForward,
  HandUp,
  HandOut,
  AnkleForward,
  AnkleUp,
  AnkleOut,
  UpperArmOut,
  ElbowBend,
  KneeBend,
  ShoulderUp,
  ShoulderForward,
  movement_curve_count
};

struct MovementCurveName {
  std::string_view id;  ///< "trunk-forward"
  bool changes_sign;    ///< under mirroring
};

inline constexpr std::array<MovementCurveName, movement_curve_count> movement_curves = {
    {{"trunk-forward", false}, {"trunk-sideways", true},   {"head-forward", false},
     {"head-sideways", true},  {"shoulder-turn", true},    {"hip-turn", true},
     {"shoulder-roll", true},  {"hip-roll", true},         {"pelvis-height", false},
     {"hand-forward", false},  {"hand-up", false},         {"hand-out", false},
     {"ankle-forward", false}, {"ankle-up", false},        {"ankle-out", false},
     {"upper-arm-out", false}, {"elbow-bend", false},      {"knee-bend", false},
     {"shoulder-up", false},   {"shoulder-forward", false}}};

/// A motion sampled at 30 Hz and low-pass filtered at 6 Hz, with the body's own directions in each
/// frame. Lengths are standing heights (standing_height, body.h) of the body.
struct Movement {
  std::vector<Path> joints;    ///< a path for each joint
  Path left_hand, right_hand;  ///< of the tips of the stretched hands (hand_tip.h)
  Path forward, left;

  std::size_t count() const { return left.size(); }
  Vec3 between(BodyJoint from, BodyJoint to, std::size_t f) const {
    return joints[to][f] - joints[from][f];
  }
  /// Forward, up and left parts of a vector.
  Vec3 own(const Vec3& v, std::size_t f) const {
    return {v.dot(forward[f]), v.y(), v.dot(left[f])};
  }
};

inline constexpr double movement_samples_per_second = 30.0;

/// Samples a motion; a loop is repeated for at least 4 s. Left is the horizontal part of the line
/// through hips and shoulders, low-pass filtered at 0.5 Hz (the mean for motions below 2 s). Throws
/// Error naming the clip if it has fewer than 8 samples or is not of the canonical body.
Movement sampled_movement(const Clip& clip);

/// A curve of the trunk, or that of the left and of the right limb, outwards positive. Angles in
/// radians, unwrapped.
std::vector<Curve> curves_of(const Movement& movement, MovementCurve curve);

/// Makes angles continuous, radians.
void unwrap(Curve& angles);

}  // namespace mien::motion
