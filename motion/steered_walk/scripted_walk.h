#pragma once

#include <span>
#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"
#include "motion/steered_walk/steered_walk.h"

namespace mien::motion {

/// One segment of a walker's script.
struct WalkSegment {
  enum class Kind {
    walk,   ///< for `seconds`, straight ahead or in a curve of `turn_rate_deg`
    turn,   ///< by `degrees`: on the spot, or while walking if `pace` is above 0; lasts until the
            ///< turn is complete
    stand,  ///< for `seconds` after coming to rest
  };
  Kind kind = Kind::stand;
  double seconds = 0.0;
  double degrees = 0.0;  ///< to the left; below 0 to the right
  double pace = 1.0;     ///< relative to the mood's own speed, 0–1.2; 0 for a turn on the spot
  double turn_rate_deg = 0.0;  ///< °/s to the left; of a walk only
  std::vector<double> moods;   ///< as in Steering, from the segment's start; empty: unchanged
};

/// A change of mood at a time, which the walker follows smoothly.
struct MoodChange {
  double seconds = 0.0;
  std::vector<double> moods;  ///< as in Steering
};

/// A walk and its foot plants.
struct WalkedClip {
  Clip clip;
  std::vector<FootPlant> plants;
  /// Of a script: the time of the clip at which each segment begins, seconds; otherwise empty.
  std::vector<double> segment_starts = {};
};

struct ScriptedWalkOptions {
  double frames_per_second = 30.0;
  std::vector<MoodChange> moods;  ///< in order of time; the first also applies before its time;
                                  ///< moods of segments override
  Vec3 place = Vec3::Zero();      ///< start position on the floor
  double heading = 0.0;           ///< start heading, radians about +Y from +Z
};

/// Runs a walker through a script, segment by segment, starting from standing, and records a clip
/// that does not loop. Throws mien::Error for an empty script, numbers that are not finite or out
/// of range, and for a result longer than an hour.
WalkedClip scripted_walk(const WalkerGaits& gaits, std::span<const WalkSegment> script,
                         const ScriptedWalkOptions& options = {});

/// A walker that starts on the first point of a path over the floor (x, z in metres; y is ignored),
/// walks along it at a pace, and stops at its end. It looks ahead along the path, so it cuts
/// corners by a few centimetres, and it slows down more in sharper corners; on a path with curve
/// radii above half a metre it deviates by less than 0.2 m. `options.place` and
/// `options.heading` are ignored. Throws as above, and for a path shorter than 0.1 m.
WalkedClip walk_along(const WalkerGaits& gaits, std::span<const Vec3> path, double pace = 1.0,
                      const ScriptedWalkOptions& options = {});

}  // namespace mien::motion
