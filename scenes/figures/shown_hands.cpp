#include "scenes/figures/shown_hands.h"

#include "motion/skeleton/body.h"
#include "motion/skeleton/hand.h"
#include "motion/skeleton/recorded_hands.h"

namespace mien::scenes {

bool gets_relaxed_hands(const motion::Clip& clip, Hands hands) {
  return hands == Hands::drawn && !motion::has_fingers(clip) && motion::is_body(clip.body);
}

motion::Clip with_shown_hands(motion::Clip clip, Hands hands) {
  if (hands == Hands::hidden) {
    for (motion::Pose& pose : clip.poses) pose.fingers.clear();
  } else if (gets_relaxed_hands(clip, hands)) {
    for (motion::Pose& pose : clip.poses) pose.fingers = motion::relaxed_fingers();
  }
  return clip;
}

}  // namespace mien::scenes
