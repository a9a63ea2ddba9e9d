#pragma once

#include "motion/skeleton/pose.h"
#include "scenes/mannequin/mannequin_flesh.h"
#include "scenes/mannequin/surface_nets.h"

namespace mien::scenes {

/// Sizes of the cells in which hands with fingers are modelled, metres at a hand of 0.189 m.
struct HandCells {
  double along = 0.0050;    ///< the fingers
  double across = 0.0027;   ///< the palm, from finger to finger
  double through = 0.0031;  ///< the palm, from its back
};

/// The hand and the end of the forearm as a closed surface of its own, in cells along the hand, for
/// a bind pose that includes fingers. It ends within the forearm: below the surface that
/// `without_hands` leaves there.
Surface hand_surface(const Flesh& flesh, const motion::JointTransforms& pose, bool left,
                     double scale, const HandCells& cells);

/// The field of a body whose forearms end within its hands: above the surface of `hand_surface` up
/// to the wrist, below it from there on.
SignedDistance without_hands(const Flesh& flesh, const motion::JointTransforms& pose, double scale);

/// Gives the surface the normals of the flesh near the wrists, so that no shading shows where one
/// surface gives way to the other.
void smooth_seams(Surface& surface, const Flesh& flesh, const motion::JointTransforms& pose,
                  double scale);

}  // namespace mien::scenes
