#include "motion/gait/gait_plants.h"

#include "motion/gait/contact.h"
#include "motion/gait/event_contact.h"
#include "motion/gait/gait_events.h"

namespace mien::motion {

bool has_flights(const Clip& clip) {
  const Clip unrolled = clip.loops ? repeated(clip, 3) : clip;
  return !flights(unrolled, foot_plants(unrolled, event_contact())).empty();
}

std::vector<FootPlant> gait_plants(const Clip& clip) {
  return has_flights(clip) ? foot_plants(clip, event_contact()) : foot_plants(clip);
}

}  // namespace mien::motion
