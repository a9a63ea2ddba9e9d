#pragma once

#include <optional>
#include <span>
#include <vector>

#include "render/geometry/prepared_cone.h"
#include "render/math/lanes.h"
#include "render/scene/scene.h"

namespace mien::render {

// Soft shadows by line sampling (Billen & Dutré 2016) instead of shadow rays: the part of a line
// across a light that a round cone occludes is known in closed form, and so is the light from the
// rest of the line. Only the position of the line on the light is random.

/// Lines across a light, one per lane, each seen from its own point of the floor (y = 0).
struct LightLines {
  LaneVectors start;          ///< from the point to the line's start
  Vec3 along = Vec3::Zero();  ///< from the line's start to its end
  /// The light's normal, on the side that emits; its length is the area of the light, m².
  Vec3 normal = Vec3::Zero();

  /// Unit normals of the triangle that the point and the line span: of its plane, and, pointing
  /// inwards, of its sides from the point to the line's start and end.
  LaneVectors plane;
  LaneVectors start_side;
  LaneVectors end_side;
};

/// Whether line sampling is exact for this light and these solids: no solid intersects the light's
/// plane, and all of the light lies above the floor. Solids behind the light occlude nothing.
bool has_line_shadows(const AreaLight& light, std::span<const PreparedCone> solids);

/// Returns lines along `half_u`; random numbers `v`, from 0 to below 1, give their positions along
/// `half_v`.
LightLines lines_across(const AreaLight& light, const LaneVectors& points, const LaneFloats& v);

/// An interval of a line, as fractions from start to end in [0, 1].
struct LineInterval {
  float first;
  float last;
};

/// Eight intervals, one per lane; empty where first ≥ last.
struct LineIntervals {
  LaneFloats first;
  LaneFloats last;
};

/// Returns the interval of each line that a solid occludes; seen from inside the solid, the whole
/// line.
///
/// The solid is convex, so its silhouette from a point consists of arcs of two circles and of the
/// two planes tangent to both spheres, and the occluded part lies between the outermost
/// intersections with these. Returns nothing when no line is occluded, which is quickly decided for
/// most solids.
std::optional<LineIntervals> hidden_part(const PreparedCone& solid, const LaneVectors& points,
                                         const LightLines& lines);

/// Returns 1/π times the irradiance of the floor by an interval of a lane's line, as an estimator
/// for a light of radiance 1: the expectation of irradiance_of({0, 1}) over `v` is 1/π times the
/// irradiance by the whole light.
float irradiance_of(const LightLines& lines, int lane, LineInterval part);

/// As `irradiance_of`, for the union of several intervals; sorts `parts`.
float irradiance_of_union(const LightLines& lines, int lane, std::vector<LineInterval>& parts);

}  // namespace mien::render
