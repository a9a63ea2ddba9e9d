#pragma once

#include "scenes/character/character.h"

namespace mien::scenes {

/// The character with a plain grey oval (an ellipsoid) over its face, fixed to its head: of all
/// vertices that follow the head mainly, it encloses those in front of the head's joint in the bind
/// pose. Hair may show behind it. Throws mien::Error if no vertex in front follows the head.
Character with_hidden_face(Character character);

}  // namespace mien::scenes
