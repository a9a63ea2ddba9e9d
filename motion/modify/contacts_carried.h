#pragma once

#include <vector>

#include "motion/gait/foot_plant.h"
#include "motion/skeleton/clip.h"

namespace mien::motion {

/// The original of a restyled motion in the restyled motion's time.
struct TimedOriginal {
  Clip still;                     ///< feet locked (foot_repair.h); one frame per restyled frame
  std::vector<FootPlant> plants;  ///< the original's contacts, in the restyled motion's frames
};

/// `original` resampled to the time of a motion that was made from it. `source_frames` holds the
/// corresponding (fractional) frame of the original for each frame of that motion, ascending, less
/// than the number of frames of a loop. Contacts are those of the original, so that they do not
/// depend on what the change did to the feet.
TimedOriginal timed_original(const Clip& original, const std::vector<double>& source_frames);

/// `frames` frames that divide the original evenly.
std::vector<double> even_source_frames(const Clip& original, int frames);

/// The restyled motion with the contacts of its original. Planted feet keep the rotations that the
/// style gave them, stand as high as in the original, and roll without slipping over those parts
/// (heel, ball or toes) over which they roll in the original, near where the restyled legs put
/// them; the root follows them (hip_shift.h, foot_reach.h), and the legs reach them by inverse
/// kinematics (foot_placement.h). Swinging feet clear the floor as in the original (foot_repair.h).
/// Both motions have the same number of frames and frame rate, and neither walks in place.
Clip with_contacts_carried(const Clip& restyled, const TimedOriginal& original);

/// How far feet slide while planted, metres, maximum over all contacts of the original: the
/// horizontal way, from frame to frame, of that part of the sole within 1 cm of the floor which
/// moves least. A foot that rolls from heel to toes, or turns on its ball, does not slide.
double contact_slide(const Clip& restyled, const TimedOriginal& original);

/// The largest difference, metres, in the height of planted soles from those of the original.
double contact_height_error(const Clip& restyled, const TimedOriginal& original);

}  // namespace mien::motion
