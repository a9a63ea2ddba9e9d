#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "motion/skeleton/clip.h"
#include "scenes/figures/figure.h"
#include "scenes/point_light/dot_path.h"

namespace mien::scenes {

/// One dot of a point-light display.
struct Dot {
  /// The name of the joint or marker, "limb" (limited lifetime), "noise" or "mask".
  std::string kind;
  DotPath path;                  ///< world space, metres; one point per frame
  std::vector<bool> shown = {};  ///< whether it is shown in each frame; empty: it always is

  bool is_shown(std::size_t frame) const { return shown.empty() || shown[frame]; }
};

/// Indices of the dots at both ends of a limb.
using Limb = std::array<std::size_t, 2>;

/// The properties of the stage that the dots depend on in addition to the clip.
struct DotStage {
  motion::Vec3 centre = motion::Vec3::Zero();   ///< centre of the action, on the floor, metres
  motion::Vec3 across = motion::Vec3::UnitX();  ///< unit, horizontal; to the right in the picture
  motion::Vec3 step = motion::Vec3::Zero();     ///< mean travel per frame, metres (mean_step)
  std::uint64_t seed = 0;                       ///< used unless the options have a seed
};

/// The display's dots: a pure function of the clip, the options and the stage.
///
/// First timing (constant speed, random phase, reversal), then geometry (rotation, mirroring,
/// inversion, scrambling), then limited lifetimes, noise and mask dots. Random positions lie within
/// the figure's extent, and travel is preserved: it is removed before positions and phases are
/// randomised, and added again afterwards. Scrambled dots together have the extent and the centre
/// of the figure.
///
/// Throws Error for a joint that the clip's skeleton does not have, and for limited lifetimes of
/// dots that are scrambled or share no limb.
std::vector<Dot> point_light(const motion::Clip& clip, const PointLightOptions& options,
                             const DotStage& stage);

/// As above, for any dots: `figure` are those without manipulations, at least one, which `limbs`
/// join. A dot that is dark in some frames is dark in what is made of them.
std::vector<Dot> displayed_dots(std::vector<Dot> figure, const std::vector<Limb>& limbs,
                                const PointLightOptions& options, const DotStage& stage);

/// The path `way` of the figure as a whole after the manipulations that change its travel:
/// reversal, rotation and mirroring.
DotPath changed_path(DotPath way, const PointLightOptions& options, const DotStage& stage);

/// DotStage::step after these manipulations.
motion::Vec3 changed_step(const PointLightOptions& options, const DotStage& stage);

}  // namespace mien::scenes
