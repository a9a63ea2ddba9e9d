#pragma once

#include <array>

#include "motion/skeleton/clip.h"
#include "motion/skeleton/hand.h"

namespace mien::motion {

/// Whether the poses of a clip have fingers.
bool has_fingers(const Clip& clip);

/// Adds the joints of both hands (hand.h) to a recording of the canonical body, whose poses have
/// fingers, and moves the fingers to the rotations. Joints are then depth first, as files hold
/// them: those of a hand follow its wrist.
void add_hands(Recording& recording);

/// Whether fingers never move and are straight to within 10°, as in files of programs that write
/// joints of hands whether or not anything is known of them. Thumbs have no such direction. The
/// poses have fingers, and there is at least one.
bool are_straight_and_still(const std::vector<Pose>& poses);

/// The skeleton without joints that have the names of finger joints (hand.h), and what hangs on
/// them.
Skeleton without_fingers(const Skeleton& skeleton);

/// Fingertips in the frame of their wrist, metres: of the left hand in the order of Finger, then of
/// the right. The pose has fingers.
std::array<Vec3, 2 * fingers_per_hand> fingertips(const Skeleton& body, const Pose& pose);

}  // namespace mien::motion
