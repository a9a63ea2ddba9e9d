#pragma once

#include <span>
#include <string>

#include "motion/skeleton/clip.h"
#include "motion/skeleton/markers.h"

namespace mien::motion {

// The markers of a recording beside the motion that was made from it. They belong to exactly that
// motion: a copy of a clip has them, but a clip whose motion was changed has none (markers_of),
// unless the change is one that the markers follow and carry_markers was called. So no function
// that makes one clip from another can show markers at positions that are not those of its motion.

/// The markers of a clip; null if it has none, or if its motion is another than when they were
/// attached.
const Markers* markers_of(const Clip& clip);

/// Gives a clip its markers, in its own space and with as many frames as it has poses.
void attach(Clip& clip, Markers markers);

/// Gives `changed`, which was made from `clip` frame by frame, the markers of `clip`, if it has
/// any; `place(frame, position)` is where the change moves a position in a frame.
template <class Place>
void carry_markers(const Clip& clip, Clip& changed, const Place& place) {
  const Markers* own = markers_of(clip);
  if (own == nullptr || changed.frame_count() != clip.frame_count()) return;
  Markers moved = *own;
  for (int frame = 0; frame < moved.frame_count(); ++frame) {
    for (int point = 0; point < moved.point_count(); ++point) {
      const std::size_t at = moved.at(frame, point);
      if (moved.is_known(at)) moved.positions[at] = place(frame, moved.positions[at]);
    }
  }
  attach(changed, std::move(moved));
}

/// Gives `changed`, whose frame i is the moment `frames[i]` of `clip` (in frames, from 0; beyond
/// the ends of a clip that loops its repetitions), the markers of `clip`, if it has any. Between
/// two frames a point is seen if it is in both, and known if it is in both: gaps stay gaps. Paths
/// are cubic (Catmull–Rom), as those of the root.
void carry_markers_at(const Clip& clip, Clip& changed, std::span<const double> frames);

/// A motion that consists of markers alone. Its body has one joint, in their centre; points in
/// gaps count at the position between their last and their next known one.
Clip clip_of_markers(const std::string& name, double frames_per_second, const Markers& markers);

}  // namespace mien::motion
