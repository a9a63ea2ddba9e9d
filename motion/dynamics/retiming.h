#pragma once

#include <span>
#include <vector>

#include "motion/dynamics/tempo_curve.h"
#include "motion/gait/foot_plant.h"
#include "motion/gestures/hand_hits.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Intervals between frames: of a loop as many as frames, of any other motion one less.
int interval_count(int frames, bool loops);

/// Where the moments of a motion lie after a change of tempo. Frames are fractional.
struct Retiming {
  std::vector<double> sources;  ///< for each new frame: the frame of the original
  std::vector<double> targets;  ///< for each frame of the original: the new frame
  bool loops = false;
  double factor = 1.0;   ///< duration before / after, not rounded to whole frames
  bool is_even = false;  ///< by one factor

  int frames_before() const { return static_cast<int>(targets.size()); }
  int frames_after() const { return static_cast<int>(sources.size()); }

  /// The new frame of a frame of the original, also beyond the ends of a loop.
  double target(double frame) const;
};

/// The retiming by one factor. The duration is rounded to whole frames (of a loop, at least 3).
Retiming even_retiming(int frame_count, bool loops, double factor);

/// The retiming of a motion by as much as leads from one number of frames to another.
Retiming retiming_between(int frames_before, int frames_after, bool loops);

/// The retiming by a tempo. Each interval between two frames of the original (of a loop as many as
/// frames, else one less) lasts as long as the tempo says, times its `stretch` if there are any.
Retiming retiming(int frame_count, bool loops, const Tempo& tempo,
                  std::span<const double> stretch = {});

/// The clip in another time at the same frame rate; rotations (as direction vectors) and root
/// positions are interpolated by splines. The cycle displacement is unchanged.
Clip retimed(const Clip& clip, const Retiming& retiming);

/// The plants in another time. They lie within the frames in which the foot stands there: a foot
/// that is half a frame too long on the floor would have to slide.
std::vector<FootPlant> retimed(const std::vector<FootPlant>& plants, const Retiming& retiming);

/// The hits in another time. Of hits of one hand that come to the same frame, only the first is
/// kept.
std::vector<HandHit> retimed(const std::vector<HandHit>& hits, const Retiming& retiming);

/// A moment of a motion, as a share of its duration, after a change of tempo.
double retimed_share(double share, const Retiming& retiming);

}  // namespace mien::motion
