#pragma once

#include <cstddef>
#include <vector>

#include "motion/skeleton/clip.h"
#include "render/scene/camera.h"
#include "render/scene/scene.h"
#include "scenes/figures/figure.h"
#include "scenes/point_light/point_light.h"

namespace mien::scenes {

/// The markers of a motion that a figure shows.
struct ShownMarkers {
  std::vector<int> points;  ///< indices in Markers::points, ascending: one dot each
  std::vector<Limb> pairs;  ///< the dots that sticks join
};

/// The markers by the figure's patterns, without those that are dark in all frames. Throws Error
/// that names the clip if it has no markers, if all are dark, if a pattern fits no marker, or if a
/// pair names a marker that the clip does not have or the figure does not show.
ShownMarkers shown_markers(const motion::Clip& clip, const MarkersOptions& options);

/// The dots of these markers, with the manipulations of point lights (displayed_dots): first one
/// for each marker, then noise and mask. A marker that is dark in a frame moves, unseen, in a
/// straight line relative to the figure as a whole. Throws Error as shown_markers does, and for
/// pairs or a limited lifetime where there are no limbs.
std::vector<Dot> marker_dots(const motion::Clip& clip, const MarkersOptions& options,
                             const DotStage& stage);

/// Where these markers are, frame by frame, without those that are dark; for the cameras.
std::vector<std::vector<motion::Vec3>> marker_places(const motion::Clip& clip,
                                                     const MarkersOptions& options);

/// Appends the sticks between dots of the figure at a frame, in the colour of the dots and with 0.3
/// times their diameter. A stick to a dot that is dark is not shown.
void add_sticks(render::Scene& scene, const std::vector<Dot>& dots, const std::vector<Limb>& pairs,
                int frame, const PointLightOptions& options, const render::Camera& camera);

/// What a figure of markers shows of a motion.
struct MarkerCounts {
  std::size_t recorded = 0;   ///< markers of the motion
  std::size_t shown = 0;      ///< markers that the figure shows
  double dark_share = 0.0;    ///< share of the frames of the shown markers in which they are dark
  double filled_share = 0.0;  ///< share in which they are shown at filled-in positions
};

MarkerCounts marker_counts(const motion::Clip& clip, const MarkersOptions& options);

}  // namespace mien::scenes
