#include "motion/fitting/leg_tracks.h"

#include <algorithm>

#include "motion/fitting/functional_joint.h"
#include "motion/fitting/hinge_axis.h"
#include "motion/fitting/hip_centres.h"
#include "motion/fitting/upper_body_tracks.h"

namespace mien::motion {

namespace {

using enum Landmark;

constexpr double standard_leg = 0.85;  // hip–knee–ankle, metres at 1.75 m

struct Leg {
  Side side;
  BodyJoint hip;
  BodyJoint knee;
  BodyJoint ankle;
  BodyJoint toe;
  double outward;  ///< 1 if outward is the subject's left
};

constexpr Leg legs[] = {{Side::left, LeftHip, LeftKnee, LeftAnkle, LeftToe, 1.0},
                        {Side::right, RightHip, RightKnee, RightAnkle, RightToe, -1.0}};

/// The pelvic frame of hip_centres.h.
struct PelvicPlane {
  Track origin;
  Track left;
  Track up;
  Track forward;
};

PelvicPlane pelvic_plane(const Track& left_front, const Track& right_front, const Track& back) {
  PelvicPlane plane;
  plane.origin = middle_of(left_front, right_front);
  plane.left = direction(right_front, left_front);
  const Track ahead = direction(back, plane.origin);
  plane.up = combined([](const Vec3& f, const Vec3& x) { return Vec3(f.cross(x).normalized()); },
                      ahead, plane.left);
  plane.forward =
      combined([](const Vec3& x, const Vec3& y) { return Vec3(x.cross(y)); }, plane.left, plane.up);
  return plane;
}

/// Length from the front iliac spine over knee to ankle, if the file has them.
std::optional<double> leg_length(const PointTracks& points, const Leg& leg) {
  const Track front = points.of(front_iliac_spine, leg.side);
  const Track knees = first_known(points.of(outer_knee, leg.side), points.of(knee, leg.side));
  const Track ankles = first_known(points.of(outer_ankle, leg.side), points.of(ankle, leg.side));
  const std::optional<double> upper = median_distance(front, knees);
  const std::optional<double> lower = median_distance(knees, ankles);
  if (!upper || !lower) return std::nullopt;
  return *upper + *lower;
}

/// A point that is fixed in the pelvic frame: `place` is (left, up, forward).
Track placed(const PelvicPlane& plane, const Vec3& place) {
  return combined(
      [&](const Vec3& o, const Vec3& x, const Vec3& y, const Vec3& z) {
        return Vec3(o + x * place.x() + y * place.y() + z * place.z());
      },
      plane.origin, plane.left, plane.up, plane.forward);
}

/// Where a track lies in the pelvic frame, median over the frames.
std::optional<Vec3> place_in(const PelvicPlane& plane, const Track& track) {
  const Track local = combined(
      [](const Vec3& p, const Vec3& o, const Vec3& x, const Vec3& y) {
        const Vec3 from = p - o;
        return Vec3(x.dot(from), y.dot(from), x.cross(y).dot(from));
      },
      track, plane.origin, plane.left, plane.up);
  return median_of(local);
}

void add_hips_from_spines(const PointTracks& points, const PelvicPlane& plane, double depth,
                          BodyTracks& body) {
  const Track left_front = points.of(front_iliac_spine, Side::left);
  const Track right_front = points.of(front_iliac_spine, Side::right);
  const double width = median_distance(left_front, right_front).value_or(0.0);
  for (const Leg& leg : legs) {
    const std::optional<Vec3> known = place_in(plane, body.joints[leg.hip]);
    const PelvisMeasures measures{width, depth > 0.0 ? depth : 0.66 * width,
                                  leg_length(points, leg)};
    const Vec3 place = known.value_or(hip_centre(measures, leg.side == Side::left));
    body.joints[leg.hip] = first_known(body.joints[leg.hip], placed(plane, place));
  }
}

/// Without points on the back of the pelvis: as if it were upright, a depth behind the front.
Track upright_back(const Track& front, const Track& left) {
  return combined(
      [](const Vec3& f, const Vec3& x) {
        const Vec3 forward = x.cross(Vec3::UnitY()).normalized();
        const double lean = 10.0 * radians_per_degree;
        return Vec3(f - std::cos(lean) * forward + std::sin(lean) * Vec3::UnitY());
      },
      front, left);
}

/// Angle by which the pelvic plane leans forward at rest: so far that the pelvis is in line with
/// the trunk in most frames, since markers are placed at heights that differ between laboratories
/// by 10° and more; 0–20°, 10° if the trunk is unknown.
double forward_lean(const PointTracks& points, const PelvicPlane& plane, const Track& hips) {
  const Track leans = combined(
      [](const Vec3& trunk, const Vec3& y, const Vec3& z) {
        return Vec3(std::atan2(-trunk.dot(z), trunk.dot(y)), 0.0, 0.0);
      },
      trunk_direction(points, hips), plane.up, plane.forward);
  const double usual = 10.0 * radians_per_degree;
  const std::optional<Vec3> lean = median_of(leans);
  return lean ? std::clamp(lean->x(), 0.0, 2.0 * usual) : usual;
}

void add_pelvis_from_spines(const PointTracks& points, BodyTracks& body) {
  const Track left_front = points.of(front_iliac_spine, Side::left);
  const Track right_front = points.of(front_iliac_spine, Side::right);
  const Track front = middle_of(left_front, right_front);
  const Track both_backs =
      middle_of(points.of(back_iliac_spine, Side::left), points.of(back_iliac_spine, Side::right));
  Track back = is_known(both_backs) ? both_backs : points.of(sacrum);
  const double depth = median_distance(front, back).value_or(0.0);
  if (depth <= 0.0) back = upright_back(front, direction(right_front, left_front));
  const PelvicPlane plane = pelvic_plane(left_front, right_front, back);
  body.pelvis_left = plane.left;
  add_hips_from_spines(points, plane, depth, body);
  const double lean =
      forward_lean(points, plane, middle_of(body.joints[LeftHip], body.joints[RightHip]));
  body.pelvis_up = combined(
      [&](const Vec3& y, const Vec3& z) { return Vec3(std::cos(lean) * y - std::sin(lean) * z); },
      plane.up, plane.forward);
}

void add_pelvis(const PointTracks& points, BodyTracks& body) {
  for (const Leg& leg : legs) body.joints[leg.hip] = points.of(hip, leg.side);
  const bool has_spines = is_known(middle_of(points.of(front_iliac_spine, Side::left),
                                             points.of(front_iliac_spine, Side::right)));
  if (has_spines) add_pelvis_from_spines(points, body);
  const Track hips = middle_of(body.joints[LeftHip], body.joints[RightHip]);
  const Track centre = points.of(pelvis);
  if (!has_spines) {
    body.pelvis_left = direction(body.joints[RightHip], body.joints[LeftHip]);
    const Track inner = first_known(points.of(spine), points.of(chest));
    body.pelvis_up = is_known(inner) ? direction(is_known(centre) ? centre : hips, inner)
                                     : trunk_direction(points, is_known(centre) ? centre : hips);
    if (!is_known(body.pelvis_up)) {
      body.pelvis_up = combined([](const Vec3&) { return Vec3(Vec3::UnitY()); }, hips);
    }
  }
  body.joints[Pelvis] = is_known(centre) ? centre : hips;  // raised when the scale is known
}

/// The points at one leg: joint centres in the file, and points beside the joints.
struct LegPoints {
  Track knee;
  Track outer_knee;
  Track inner_knee;
  Track ankle;
  Track outer_ankle;
  Track inner_ankle;
};

LegPoints leg_points(const PointTracks& points, const Leg& leg, const BodyTracks& body) {
  LegPoints at{points.of(knee, leg.side),        points.of(outer_knee, leg.side),
               points.of(inner_knee, leg.side),  points.of(ankle, leg.side),
               points.of(outer_ankle, leg.side), points.of(inner_ankle, leg.side)};
  add_functional_joints(points, leg.side, body.joints[leg.hip], at.knee, at.ankle);
  at.knee = first_known(at.knee, middle_of(at.outer_knee, at.inner_knee));
  at.ankle = first_known(at.ankle, middle_of(at.outer_ankle, at.inner_ankle));
  return at;
}

/// Centres of the knee and the ankle, in frames in which they are not known, inward from the outer
/// points by a marker's radius and half the joint's width.
void add_joints_beside(LegPoints& at, const Leg& leg, const BodyTracks& body) {
  const Track& hips = body.joints[leg.hip];
  const Track knees = is_known(at.knee) ? at.knee : at.outer_knee;
  const Track ankles = is_known(at.ankle) ? at.ankle : at.outer_ankle;
  const double length =
      median_distance(hips, knees).value_or(0.43) + median_distance(knees, ankles).value_or(0.42);
  const double knee_inward = -leg.outward * (marker_radius + 0.0625 * length);
  const double ankle_inward = -leg.outward * (marker_radius + 0.0425 * length);
  const Limb limb{ankles, !is_known(at.ankle), ankle_inward, body.pelvis_left};
  at.knee = first_known(at.knee, joint_beside(hips, at.outer_knee, limb, knee_inward, Hinge{}));
  // The axis with the knee as it is now; that of the ankle's outer point is near enough to its own.
  const Track axis = hinge_axis(
      hips, at.knee, limb.end_is_outer ? shifted(ankles, body.pelvis_left, ankle_inward) : ankles,
      body.pelvis_left, Hinge{});
  at.ankle = first_known(at.ankle, shifted(at.outer_ankle, axis, ankle_inward));
}

Track knee_axis(const LegPoints& at, const Leg& leg, const BodyTracks& body) {
  const Track bend = hinge_axis(body.joints[leg.hip], at.knee, at.ankle, body.pelvis_left, Hinge{});
  const Track across = leg.side == Side::left ? direction(at.inner_knee, at.outer_knee)
                                              : direction(at.outer_knee, at.inner_knee);
  const auto count = [](const Track& track) {
    return std::count_if(track.begin(), track.end(), [](const auto& v) { return v.has_value(); });
  };
  return 2 * count(across) > count(at.knee) ? first_known(across, bend) : bend;
}

void add_ball_of_foot(const PointTracks& points, const Leg& leg, BodyTracks& body) {
  const bool is_on_skin =
      !is_known(points.of(ankle, leg.side)) || is_known(points.of(outer_ankle, leg.side));
  const Track tip = points.of(toe_tip, leg.side);
  const Track heels = points.of(heel, leg.side);
  const Track first = points.of(first_metatarsal, leg.side);
  const Track fifth = points.of(fifth_metatarsal, leg.side);
  Track ball = points.of(toe, leg.side);
  if (is_known(ball)) {
    body.joints[leg.toe] = ball;
    body.tips[leg.toe] = tip;
    return;
  }
  ball = points.of(second_metatarsal, leg.side);
  if (!is_known(ball)) ball = middle_of(first, fifth);
  const bool is_metatarsal = is_known(ball);
  if (!is_metatarsal && is_known(middle_of(heels, tip))) {
    ball =
        combined([](const Vec3& h, const Vec3& t) { return Vec3(h + 0.75 * (t - h)); }, heels, tip);
  } else if (!is_metatarsal) {
    ball = shifted(tip, direction(body.joints[leg.ankle], tip), -0.06 * body.scale);
  }
  if (is_metatarsal || is_on_skin) {
    const Track along = direction(is_known(heels) ? heels : body.joints[leg.ankle], ball);
    const Track up = combined([](const Vec3& z, const Vec3& x) { return Vec3(z.cross(x)); }, along,
                              body.axes[leg.hip]);
    ball = shifted(ball, up, -0.02 * body.scale);
  }
  body.joints[leg.toe] = ball;
  if (is_metatarsal) body.tips[leg.toe] = tip;
}

void add_leg(const PointTracks& points, const Leg& leg, BodyTracks& body) {
  LegPoints at = leg_points(points, leg, body);
  add_joints_beside(at, leg, body);
  body.axes[leg.hip] = knee_axis(at, leg, body);
  body.joints[leg.knee] = at.knee;
  body.joints[leg.ankle] = at.ankle;
}

double scale_of(const BodyTracks& body) {
  double length = 0.0;
  int count = 0;
  for (const Leg& leg : legs) {
    const auto thigh_length = median_distance(body.joints[leg.hip], body.joints[leg.knee]);
    const auto shank_length = median_distance(body.joints[leg.knee], body.joints[leg.ankle]);
    if (!thigh_length || !shank_length) continue;
    length += *thigh_length + *shank_length;
    ++count;
  }
  return count > 0 ? length / count / standard_leg : 1.0;
}

}  // namespace

void add_pelvis_and_legs(const PointTracks& points, BodyTracks& body) {
  add_pelvis(points, body);
  for (const Leg& leg : legs) add_leg(points, leg, body);
  body.scale = scale_of(body);
  if (!is_known(points.of(pelvis))) {
    body.joints[Pelvis] = shifted(middle_of(body.joints[LeftHip], body.joints[RightHip]),
                                  body.pelvis_up, 0.03 * body.scale);
  }
  for (const Leg& leg : legs) add_ball_of_foot(points, leg, body);
}

}  // namespace mien::motion
