#pragma once

#include <string_view>
#include <vector>

#include "motion/skeleton/clip.h"

namespace mien::motion {

/// Frames in which two bodies are in each other, and where they are deepest.
struct PeopleOverlap {
  int first = 0;  ///< frame
  int last = 0;   ///< frame
  double depth_m = 0.0;
  std::string_view part;   ///< of the first person: "left forearm" (collision_shapes.h)
  std::string_view other;  ///< of the second person
};

/// Returns when two people in one space are deeper in each other than `tolerated_m`, in the order
/// of time. Hands and forearms may touch each other, as in a handshake. Empty unless both have the
/// canonical body. Both clips have equally many frames.
std::vector<PeopleOverlap> people_overlaps(const Clip& one, const Clip& other, double tolerated_m);

/// The moment at which a hand of one person is nearest to a hand of the other.
struct NearestHands {
  int frame = 0;
  double distance_m = 0.0;  ///< between the wrists, or the palms if these are nearer
};

/// Returns that moment, the first if there are several. Both have the canonical body and equally
/// many frames.
NearestHands nearest_hands(const Clip& one, const Clip& other);

}  // namespace mien::motion
