#pragma once

#include "scenes/character/character.h"

namespace mien::scenes {

/// The character with a plain grey oval over its face, fixed to its head: the ellipsoid whose
/// outline, seen from the front, is the ellipse of that of the head (front_of_head.h), 4 % larger,
/// and which is as flat as it can be if it encloses the face in the bind pose. What of the head is
/// outside this ellipse, such as hair, and what is behind the face, stays in view. Throws
/// mien::Error if no part of the mesh in front of the head's joint follows the head.
Character with_hidden_face(Character character);

}  // namespace mien::scenes
