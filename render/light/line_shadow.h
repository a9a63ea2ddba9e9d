#pragma once

#include <optional>
#include <span>
#include <vector>

#include "render/geometry/round_cone.h"
#include "render/light/lanes.h"

namespace mien::render {

// Soft shadows by lines instead of points of a light: which part of a line a round cone hides is
// known in closed form, and so is the light of the rest. What is left to chance is where on the
// light the line lies (line sampling: Billen & Dutré 2016).

/// Lines across a light, one a lane, each seen from a point of its own on the floor (y = 0).
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

/// Whether all of these hide what `hidden_by` says from every point of the floor, or nothing where
/// they lie behind the light: none of them meets its plane, and all of it lies above the floor.
bool has_line_shadows(const AreaLight& light, std::span<const RoundCone> solids);

/// Lines along `half_u` whose places along `half_v` are the random numbers `v`.
LightLines lines_across(const AreaLight& light, const LaneVectors& points, const LaneFloats& v);

/// A part of a line, as shares from start to end in [0, 1].
struct LinePart {
  float first;
  float last;
};

/// One a lane; none where first ≥ last.
struct LineParts {
  LaneFloats first;
  LaneFloats last;
};

/// What a solid hides of each line. From a point inside the solid all is hidden.
///
/// Seen from a point the solid is convex: its outline are two circles' arcs and the two tangent
/// planes that both spheres share, so the hidden part lies between the extreme crossings of these.
/// Nothing when it hides nothing of any line, which is soon told of most.
std::optional<LineParts> hidden_by(const RoundCone& solid, const LaneVectors& points,
                                   const LightLines& lines);

/// Irradiance over π that a part of a lane's line gives a floor that faces up, if the whole light
/// (of radiance 1) were as that line is: E[light_of({0, 1})] over `v` is that of the light.
float light_of(const LightLines& lines, int lane, LinePart part);

/// The same of all that lies in any of some parts, which are put in order.
float light_of_all(const LightLines& lines, int lane, std::vector<LinePart>& parts);

}  // namespace mien::render
