#pragma once

#include "motion/skeleton/clip.h"

namespace mien::scenes {

/// Whether figures have fingers (motion/skeleton/hand.h).
enum class Hands {
  automatic,  ///< where the motion has them
  drawn,      ///< always: human motions without fingers get relaxed hands (relaxed_fingers)
  hidden      ///< never: each hand is one piece
};

/// Whether a clip gets relaxed hands because its motion has no fingers.
bool gets_relaxed_hands(const motion::Clip& clip, Hands hands);

/// The clip with the fingers that its figure is to have, or without any.
motion::Clip with_shown_hands(motion::Clip clip, Hands hands);

}  // namespace mien::scenes
