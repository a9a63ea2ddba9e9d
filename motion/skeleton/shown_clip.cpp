#include "motion/skeleton/shown_clip.h"

#include "motion/skeleton/straighten.h"

namespace mien::motion {

Clip shown_clip(const Clip& clip, const Showing& showing) {
  if (!clip.loops) return showing.in_place ? kept_in_place(clip) : clip;
  return repeated(showing.in_place ? in_place(clip) : clip, showing.cycles);
}

}  // namespace mien::motion
