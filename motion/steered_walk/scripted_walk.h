#pragma once

#include <span>
#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"
#include "motion/steered_walk/steered_walk.h"

namespace mien::motion {

/// One thing after another that a walker does.
struct WalkSegment {
  enum class Kind {
    walk,   ///< for `seconds` straight on, or in a curve of `turn_rate_deg`
    turn,   ///< by `degrees`: on the spot, or on the way at a `pace` above 0; until it is done
    stand,  ///< for `seconds` from when it has come to stand
  };
  Kind kind = Kind::stand;
  double seconds = 0.0;
  double degrees = 0.0;        ///< to the left; below 0 to the right
  double pace = 1.0;           ///< of the mood's own speed, 0–1.2; of a turn 0 is on the spot
  double turn_rate_deg = 0.0;  ///< °/s to the left, of a walk
  std::vector<double> moods;   ///< from its beginning on, as in Steering; none: as before
};

/// What mood the walker is in from a moment on; between moments as the walker itself follows.
struct MoodFrom {
  double seconds = 0.0;
  std::vector<double> moods;  ///< as in Steering
};

/// A walk, and where its feet stand in it.
struct WalkedClip {
  Clip clip;
  std::vector<FootPlant> plants;
};

struct ScriptedWalkOptions {
  double frames_per_second = 30.0;
  std::vector<MoodFrom> moods;  ///< by time, until a segment names its own; before the first of
                                ///< them its mood
  Vec3 place = Vec3::Zero();    ///< where it begins to stand, on the floor
  double heading = 0.0;         ///< which way it faces then, radians about +Y from +Z
};

/// A walker that stands, does what the script says, segment by segment, and is filmed all the
/// while, from frame to frame: a clip that does not loop. Throws mien::Error for an empty script,
/// numbers that are none or out of range, and for a result longer than an hour.
WalkedClip scripted_walk(const WalkerGaits& gaits, std::span<const WalkSegment> script,
                         const ScriptedWalkOptions& options = {});

/// A walker that starts on the first point of a path over the floor (x, z in metres; y is not
/// looked at), walks along it at a pace, and stops at its end. It looks ahead along the path, so it
/// rounds corners by some centimetres, slower the sharper they are, and leaves a path whose curves
/// are wider than half a metre by less than 0.2 m. `options.place` and `heading` are not looked
/// at. Throws as above, and for a path shorter than 0.1 m.
WalkedClip walk_along(const WalkerGaits& gaits, std::span<const Vec3> path, double pace = 1.0,
                      const ScriptedWalkOptions& options = {});

}  // namespace mien::motion
