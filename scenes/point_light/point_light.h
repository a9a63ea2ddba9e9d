#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "motion/skeleton/clip.h"
#include "scenes/figures/point_light_options.h"
#include "scenes/point_light/dot_path.h"

namespace mien::scenes {

/// One dot of a point-light display.
struct Dot {
  std::string kind;  ///< the joint's name, "noise" or "mask"
  DotPath path;      ///< world space, one point a frame
};

/// What the dots have to know of the stage besides the clip.
struct DotStage {
  motion::Vec3 centre = motion::Vec3::Zero();   ///< of the action, on the floor
  motion::Vec3 across = motion::Vec3::UnitX();  ///< unit, level: to the right in the picture
  motion::Vec3 step = motion::Vec3::Zero();     ///< that the clip travels a frame (mean_step)
  std::uint64_t seed = 0;                       ///< unless the options have their own
};

/// The display's dots: a pure function of the clip, the options and the stage.
///
/// First each joint's path is gone at constant speed, from a random moment on, or backwards; then
/// it is turned, mirrored, put upside down and scrambled; then noise and mask join it. What is
/// placed at random is placed within the figure's extent, and its travel is kept: random places and
/// moments are those of a figure that walks on the spot. Scrambled dots together take the figure's
/// room, no more and no less, so that they have its size and its middle.
///
/// Throws Error for a joint that the clip's skeleton does not have, and for limited lifetimes of
/// dots that are scrambled or share no limb.
std::vector<Dot> point_light(const motion::Clip& clip, const PointLightOptions& options,
                             const DotStage& stage);

/// What becomes of the way of the figure as a whole.
DotPath changed_way(DotPath way, const PointLightOptions& options, const DotStage& stage);

/// DotStage::step after what is done to timing and places.
motion::Vec3 changed_step(const PointLightOptions& options, const DotStage& stage);

}  // namespace mien::scenes
