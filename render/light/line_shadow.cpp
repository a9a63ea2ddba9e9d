#include "render/light/line_shadow.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "render/geometry/shadow_mask.h"
#include "render/math/constants.h"
#include "render/math/directions.h"
#include "render/math/for_avx2.h"

namespace mien::render {
namespace {

// Vectors of the compiler's, which leave no doubt that eight lanes go through one instruction:
// loops as in lanes.cpp have too many choices to be made vector code.
using Eight = float __attribute__((vector_size(4 * lanes)));
using Choice = int __attribute__((vector_size(4 * lanes)));  // all bits of a lane or none
#define MIEN_LANES [[gnu::always_inline]] inline

MIEN_LANES Eight eight(float value) { return Eight{} + value; }
MIEN_LANES Eight eight(const LaneFloats& values) {
  Eight result;
  std::memcpy(&result, values.lane, sizeof result);
  return result;
}
MIEN_LANES Choice all(bool chosen) { return Choice{} - (chosen ? 1 : 0); }
MIEN_LANES Eight greater(Eight a, Eight b) { return a > b ? a : b; }
MIEN_LANES Eight less(Eight a, Eight b) { return a < b ? a : b; }

/// Square root of eight numbers; zero for negative ones.
MIEN_LANES Eight root(Eight square) {
  LaneFloats roots;
  square = greater(square, Eight{});
  std::memcpy(roots.lane, &square, sizeof square);
  for (float& each : roots.lane) each = std::sqrt(each);
  return eight(roots);
}

struct Triple {
  Eight x;
  Eight y;
  Eight z;
};

MIEN_LANES Triple triple(const Vec3& v) { return {eight(v.x()), eight(v.y()), eight(v.z())}; }
MIEN_LANES Triple triple(const LaneVectors& v) { return {eight(v.x), eight(v.y), eight(v.z)}; }
MIEN_LANES Triple cross(const Triple& a, const Triple& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
MIEN_LANES Eight dot(const Triple& a, const Triple& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
MIEN_LANES Triple sum(const Triple& a, const Triple& b, Eight times) {
  return {a.x + times * b.x, a.y + times * b.y, a.z + times * b.z};
}

/// Parts of lines L(t) = start + t·along that are hidden from the origin; empty where low > high.
struct Span {
  Eight low;
  Eight high;
};

MIEN_LANES Span hull(const Span& a, const Span& b) {
  return {less(b.low, a.low), greater(b.high, a.high)};
}

// A ball hides where f(t) = r²|L|² − |c × L|² ≥ 0 and it is in front: a quadratic, worked out at
// its extremum so that a ball that is small against its distance keeps its digits; but from f(0)
// where the line runs so nearly along the ball's outline that the extremum is far off.
MIEN_LANES Span hidden_by_ball(const Triple& centre, float radius, const Triple& start,
                               const Triple& along) {
  const Eight none = eight(infinity), squared = eight(radius * radius);
  const Triple a = cross(centre, start), b = cross(centre, along);
  const Eight bend = squared * dot(along, along) - dot(b, b);
  const Eight slope = squared * dot(start, along) - dot(a, b);
  const Eight middle = -slope / bend;
  const Triple there = sum(start, along, middle);
  const Triple aside = cross(centre, there);
  const Eight height = squared * dot(there, there) - dot(aside, aside);
  const Eight half = root(-height / bend);
  const Choice within = (bend < 0.0f) & (height > 0.0f) & (dot(centre, there) > 0.0f);

  const Eight at_start = squared * dot(start, start) - dot(a, a);
  const Eight reach = root(slope * slope - bend * at_start);
  const Eight q = slope > 0.0f ? -slope - reach : reach - slope;
  const Eight bound = eight(0.02f) * dot(centre, centre) * dot(along, along);
  const Choice far_off = (bend < bound) & (bend > -bound);
  const Eight one = far_off ? at_start / q : middle - half;
  const Eight other = far_off ? q / bend : middle + half;
  const Eight lower = less(one, other), upper = greater(one, other);

  // The line goes off inside the ball's outline.
  const Choice onward = bend >= 0.0f;
  const Choice forward = dot(centre, along) > 0.0f;
  const Choice inside = dot(centre, centre) <= squared;
  const Eight low = onward ? (forward ? upper : -none) : (within ? lower : none);
  const Eight high = onward ? (forward ? none : lower) : (within ? upper : -none);
  return {inside ? -none : low, inside ? none : high};
}

/// Where a tangent plane of both spheres crosses the line, between where it touches them; not where
/// it is almost parallel to the line, whose ends decide then (hide_ends).
MIEN_LANES Span crossing_of(const Triple& normal, const Triple& a, const Triple& b, float sign,
                            Choice is_there, const Triple& start, const Triple& along) {
  const Eight none = eight(infinity);
  const Eight t = -dot(normal, start) / dot(normal, along);
  const Triple there = sum(start, along, t);
  const Choice meets = is_there & (t < 1e3f) & (t > -1e3f) &
                       (sign * dot(there, cross(normal, a)) >= 0.0f) &
                       (sign * dot(there, cross(normal, b)) <= 0.0f);
  return {meets ? t : none, meets ? t : -none};
}

/// Whether a direction, from outside the solid, meets its side: the ball on the axis that hides the
/// most of it, the least of |c(s) × d|² − r(s)²|d|², lies between the ends and hides it.
MIEN_LANES Choice side_hides(const PreparedCone& solid, const Triple& a, const Triple& direction) {
  const Triple axis = triple(solid.axis);
  const Triple from = cross(a, direction), step = cross(axis, direction);
  const Eight squared = dot(direction, direction);
  const Eight slope = dot(from, step) + solid.radius_a * solid.slope * squared;
  const Eight bend = dot(step, step) - solid.slope * solid.slope * squared;
  const Eight s = -slope / bend;
  const Triple aside = sum(from, step, s);
  const Eight radius = solid.radius_a - solid.slope * s;
  return (bend > 0.0f) & (s > 0.0f) & (s < 1.0f) &
         (dot(aside, aside) <= radius * radius * squared) &
         (dot(sum(a, axis, s), direction) > 0.0f);
}

/// Whether the origin lies between the spheres, within the ball whose surface is nearest.
MIEN_LANES Choice is_within_side(const PreparedCone& solid, const Triple& a) {
  const Triple axis = triple(solid.axis);
  const bool is_long = solid.side_squared > 0.0f;
  const Eight share =
      (-dot(a, axis) - solid.radius_a * solid.slope) / (is_long ? solid.side_squared : 1.0f);
  const Triple nearest = sum(a, axis, share);
  const Eight radius = solid.radius_a - solid.slope * share;
  return all(is_long) & (share > 0.0f) & (share < 1.0f) &
         (dot(nearest, nearest) <= radius * radius);
}

/// Where the planes cross the line that pass through the origin at distance ra of a and rb of b:
/// their normals n, with n·a = ra, n·b = rb, |n| = 1, here times |a × b|².
MIEN_LANES Span hidden_by_side(const PreparedCone& solid, const Triple& a, const Triple& b,
                               const Triple& start, const Triple& along) {
  const Triple axis = triple(solid.axis);
  const Triple across = cross(a, axis);
  const Eight determinant = dot(across, across);
  const Eight weight_a = solid.radius_b * dot(b, axis) + solid.slope * dot(b, b);
  const Eight weight_b = -solid.radius_b * dot(a, axis) - solid.slope * dot(a, b);
  const Eight rest = determinant - (weight_a * solid.radius_a + weight_b * solid.radius_b);
  const Choice is_seen = all(solid.side_squared > 0.0f) & (rest > 0.0f) & (determinant > 0.0f);
  const Eight aside = root(rest);
  const Triple middle = sum({weight_a * a.x, weight_a * a.y, weight_a * a.z}, b, weight_b);
  return hull(crossing_of(sum(middle, across, aside), a, b, 1.0f, is_seen, start, along),
              crossing_of(sum(middle, across, -aside), a, b, -1.0f, is_seen, start, along));
}

/// Twice the integral of (1 + x²)⁻² from 0.
float bell(float x) {
  const float secant = std::sqrt(1.0f + x * x);
  const float angle = std::copysign(arc_sine(std::min(std::abs(x) / secant, 1.0f)), x);
  return x / (1.0f + x * x) + angle;
}

MIEN_LANES Triple unit(const Triple& v) {
  const Eight scale = 1.0f / root(dot(v, v));
  return {scale * v.x, scale * v.y, scale * v.z};
}

MIEN_LANES void keep(const Triple& v, LaneVectors& lanes_of) {
  std::memcpy(lanes_of.x.lane, &v.x, sizeof v.x);
  std::memcpy(lanes_of.y.lane, &v.y, sizeof v.y);
  std::memcpy(lanes_of.z.lane, &v.z, sizeof v.z);
}

MIEN_FOR_AVX2_TOO void find_sides(LightLines& lines) {
  const Triple start = triple(lines.start), along = triple(lines.along);
  const Triple plane = cross(start, along);
  keep(unit(plane), lines.plane);
  keep(unit(cross(plane, start)), lines.start_side);
  keep(unit(cross(sum(start, along, eight(1.0f)), plane)), lines.end_side);
}

/// Whether a solid lies beyond none of the sides of what point and line span: where it does, it
/// hides nothing. All bits of a lane or none.
MIEN_FOR_AVX2_TOO bool find_met(const PreparedCone& solid, const LaneVectors& points,
                                const LightLines& lines, LaneWords& met) {
  const Triple from = triple(points);
  const Triple a = sum(triple(solid.a), from, eight(-1.0f));
  const Triple b = sum(a, triple(solid.axis), eight(1.0f));
  // More than rounding can be.
  const Eight slack = 1e-4f + 1e-5f * (dot(a, a) + dot(b, b));
  const Eight radius_a = solid.radius_a + slack, radius_b = solid.radius_b + slack;
  const Triple plane = triple(lines.plane);
  const Eight above_a = dot(plane, a), above_b = dot(plane, b);
  const Triple start_side = triple(lines.start_side), end_side = triple(lines.end_side);
  // Comparisons with NaN, where there is no triangle, are false: nothing is excluded.
  const Choice apart = ((above_a > radius_a) & (above_b > radius_b)) |
                       ((above_a < -radius_a) & (above_b < -radius_b)) |
                       ((dot(start_side, a) < -radius_a) & (dot(start_side, b) < -radius_b)) |
                       ((dot(end_side, a) < -radius_a) & (dot(end_side, b) < -radius_b));
  const Choice meets = ~apart;
  std::memcpy(met.lane, &meets, sizeof meets);
  std::uint32_t any = 0;
  for (const std::uint32_t lane : met.lane) any |= lane;
  return any != 0;
}

MIEN_FOR_AVX2_TOO void find_outline(const PreparedCone& solid, const LaneVectors& points,
                                    const LightLines& lines, const LaneWords& met,
                                    LineIntervals& parts) {
  const Triple from = triple(points), start = triple(lines.start), along = triple(lines.along);
  const Triple a = sum(triple(solid.a), from, eight(-1.0f));
  Span hidden = hidden_by_ball(a, solid.radius_a, start, along);
  if (solid.side_squared > 0.0f) {
    const Triple b = sum(a, triple(solid.axis), eight(1.0f));
    hidden = hull(hull(hidden, hidden_by_ball(b, solid.radius_b, start, along)),
                  hidden_by_side(solid, a, b, start, along));
    const Choice inside = is_within_side(solid, a);
    hidden.low = inside ? eight(0.0f) : hidden.low;
    hidden.high = inside ? eight(1.0f) : hidden.high;
  }
  Choice meets;
  std::memcpy(&meets, met.lane, sizeof meets);
  const Eight first = meets ? greater(hidden.low, eight(0.0f)) : eight(1.0f);
  const Eight last = meets ? less(hidden.high, eight(1.0f)) : eight(0.0f);
  std::memcpy(parts.first.lane, &first, sizeof first);
  std::memcpy(parts.last.lane, &last, sizeof last);
}

// Ends of lines that the side hides. Elsewhere the hidden part is bounded by the spheres' outlines
// or the tangent planes, of which one is missed only where the line's direction itself is hidden.
MIEN_FOR_AVX2_TOO void hide_ends(const PreparedCone& solid, const LaneVectors& points,
                                 const LightLines& lines, LineIntervals& parts) {
  const Triple from = triple(points), start = triple(lines.start), along = triple(lines.along);
  const Triple a = sum(triple(solid.a), from, eight(-1.0f));
  const Choice from_start = side_hides(solid, a, start);
  const Choice to_end = side_hides(solid, a, sum(start, along, eight(1.0f)));
  const Eight first = from_start ? eight(0.0f) : eight(parts.first);
  const Eight last = to_end ? eight(1.0f) : eight(parts.last);
  std::memcpy(parts.first.lane, &first, sizeof first);
  std::memcpy(parts.last.lane, &last, sizeof last);
}

#undef MIEN_LANES

}  // namespace

bool has_line_shadows(const AreaLight& light, std::span<const PreparedCone> solids) {
  constexpr float nearest = 1e-3f;  // metres
  const float half_height = std::abs(light.half_u.y()) + std::abs(light.half_v.y());
  if (light.centre.y() - half_height < nearest) return false;
  const Vec3 front = light.half_u.cross(light.half_v).normalized();
  return std::ranges::all_of(solids, [&](const PreparedCone& solid) {
    return is_behind(light, solid) ||
           (front.dot(solid.a - light.centre) - solid.radius_a > nearest &&
            front.dot(solid.b() - light.centre) - solid.radius_b > nearest);
  });
}

LightLines lines_across(const AreaLight& light, const LaneVectors& points, const LaneFloats& v) {
  LightLines lines;
  lines.along = 2.0f * light.half_u;
  lines.normal = 4.0f * light.half_u.cross(light.half_v);
  const Vec3 edge = light.centre - light.half_u;
  for (int i = 0; i < static_cast<int>(lanes); ++i)
    lines.start.set(i, edge + (2.0f * v[i] - 1.0f) * light.half_v - points.at(i));
  find_sides(lines);
  return lines;
}

std::optional<LineIntervals> hidden_part(const PreparedCone& solid, const LaneVectors& points,
                                         const LightLines& lines) {
  LaneWords met;
  if (!find_met(solid, points, lines, met)) return std::nullopt;
  LineIntervals parts;
  find_outline(solid, points, lines, met, parts);
  const float lowest = std::min(solid.a.y() - solid.radius_a, solid.b().y() - solid.radius_b);
  if (solid.side_squared > 0.0f && (lines.along.y() != 0.0f || lowest <= 0.0f))
    hide_ends(solid, points, lines, parts);
  return parts;
}

// With the line's nearest point to the floor's at t = m and distance h, and x = (t − m)|along|/h,
// the integral of cos θ · facing / distance² is one of (y + x·rise) / (1 + x²)².
float irradiance_of(const LightLines& lines, int lane, LineInterval part) {
  const Vec3 start = lines.start.at(lane);
  const float facing = -lines.normal.dot(start);
  if (facing <= 0.0f || part.first >= part.last) return 0.0f;
  const float squared = lines.along.squaredNorm();
  const float length = std::sqrt(squared);
  const float nearest = -start.dot(lines.along) / squared;
  const Vec3 there = start + nearest * lines.along;
  const float height_squared = there.squaredNorm();
  const float height = std::sqrt(height_squared);
  const float from = (part.first - nearest) * length / height;
  const float to = (part.last - nearest) * length / height;
  const float rise = lines.along.y() * height / length;
  const float even = there.y() * (bell(to) - bell(from));
  const float rising = rise * (1.0f / (1.0f + from * from) - 1.0f / (1.0f + to * to));
  return 0.5f * facing * (even + rising) / (pi * length * height_squared * height);
}

float irradiance_of_union(const LightLines& lines, int lane, std::vector<LineInterval>& parts) {
  if (parts.empty()) return 0.0f;
  std::ranges::sort(parts, {}, &LineInterval::first);
  float light = 0.0f;
  LineInterval joined = parts.front();
  for (const LineInterval& part : parts) {
    if (part.first > joined.last) {
      light += irradiance_of(lines, lane, joined);
      joined = part;
    }
    joined.last = std::max(joined.last, part.last);
  }
  return light + irradiance_of(lines, lane, joined);
}

}  // namespace mien::render
