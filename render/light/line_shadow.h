#pragma once

#include <optional>
#include <span>
#include <vector>

#include "render/geometry/prepared_cone.h"
#include "render/light/lanes.h"

namespace mien::render {

// Soft shadows by line sampling (Billen & Dutré 2016) instead of shadow rays: which part of a line
// across a light a round cone hides is known in closed form, and so is the light of the rest. Only
// the position of the line on the light is random.

/// Lines across a light, one a lane, each seen from its own point of the floor (y = 0).
struct LightLines {
  LaneVectors start;           ///< from the point to the line's start
  Vec3 along = Vec3::Zero();   ///< from there to its end
  Vec3 normal = Vec3::Zero();  ///< towards where it shines; its length is the light's area

  /// Unit normals of the sides of what the point and the line span, a flat triangle: of its plane,
  /// and inwards of the sides to the line's start and to its end.
  LaneVectors plane;
  LaneVectors start_side;
  LaneVectors end_side;
};

/// Whether line sampling is exact for this light and these solids: no solid intersects the light's
/// plane, and all of the light lies above the floor. Solids behind the light hide nothing.
bool has_line_shadows(const AreaLight& light, std::span<const PreparedCone> solids);

/// Lines along `half_u` whose places along `half_v` are the random numbers `v`.
LightLines lines_across(const AreaLight& light, const LaneVectors& points, const LaneFloats& v);

/// An interval of a line, as fractions from start to end in [0, 1].
struct LineInterval {
  float first;
  float last;
};

/// Eight intervals, one a lane; empty where first ≥ last.
struct LineIntervals {
  LaneFloats first;
  LaneFloats last;
};

/// The interval of each line that a solid hides. From a point inside the solid all is hidden.
///
/// Seen from a point the solid is convex: its outline are two circles' arcs and the two tangent
/// planes that both spheres share, so the hidden part lies between the extreme crossings of these.
/// Returns nothing when it hides nothing of any line, which is quickly decided for most solids.
std::optional<LineIntervals> hidden_part(const PreparedCone& solid, const LaneVectors& points,
                                         const LightLines& lines);

/// Irradiance over π on the floor from an interval of a lane's line, as an estimator for the whole
/// light (of radiance 1): E[irradiance_of({0, 1})] over `v` is that of the light.
float irradiance_of(const LightLines& lines, int lane, LineInterval part);

/// As `irradiance_of`, for the union of some intervals, which are sorted.
float irradiance_of_union(const LightLines& lines, int lane, std::vector<LineInterval>& parts);

}  // namespace mien::render
