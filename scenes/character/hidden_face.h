#pragma once

#include "scenes/character/character.h"

namespace mien::scenes {

/// The character with a plain grey oval (an ellipsoid) over its face, fixed to its head: of all
/// vertices that follow the head mainly, it encloses those that in the bind pose are in front of
/// the head's joint and no farther below it than 0.35 of its distance to the crown, where a chin
/// is. Hair and neck may show beside it. Throws mien::Error if no vertex in front follows the head.
Character with_hidden_face(Character character);

}  // namespace mien::scenes
