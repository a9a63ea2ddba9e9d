#include "motion/fitting/upper_body_tracks.h"

#include <initializer_list>

#include "motion/fitting/hinge_axis.h"
#include "motion/fitting/rigid_placement.h"
#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

using enum Landmark;

constexpr double neck_above_shoulders = 0.06;  // metres at 1.75 m, as the lengths below
constexpr double chest_below_neck = 0.24;
constexpr double spine_above_pelvis = 0.11;
constexpr double carrying_angle = 10.0 * radians_per_degree;

struct Arm {
  Side side;
  BodyJoint clavicle;
  BodyJoint shoulder;
  BodyJoint elbow;
  BodyJoint wrist;
  double outward;  ///< 1 if outward is the subject's left
};

constexpr Arm arms[] = {{Side::left, LeftClavicle, LeftShoulder, LeftElbow, LeftWrist, 1.0},
                        {Side::right, RightClavicle, RightShoulder, RightElbow, RightWrist, -1.0}};

Track both_sides(const PointTracks& points, Landmark landmark) {
  return middle_of(points.of(landmark, Side::left), points.of(landmark, Side::right));
}

Track jugular(const PointTracks& points) {
  return first_known(points.of(jugular_notch), both_sides(points, jugular_notch));
}

/// The line of the shoulders: their centres, or the acromia above them.
Landmark shoulder_line(const PointTracks& points) {
  return is_known(both_sides(points, shoulder)) ? shoulder : acromion;
}

/// The best known point at the top of the trunk.
Track top_of_trunk(const PointTracks& points) {
  for (const Track& top :
       {points.of(neck), points.of(mid_shoulders), both_sides(points, shoulder_line(points)),
        middle_of(points.of(cervical_7), jugular(points)), jugular(points),
        points.of(cervical_7)}) {
    if (is_known(top)) return top;
  }
  return Track(points.frame_count());
}

Track chest_direction(const PointTracks& points, const BodyTracks& body) {
  const Track low = middle_of(points.of(sternum), points.of(back));
  const Track high = middle_of(jugular(points), points.of(cervical_7));
  const Track by_markers = direction(low, high);
  if (is_known(by_markers)) return by_markers;
  const Track top = top_of_trunk(points);
  const Track centre = points.of(chest);
  if (is_known(centre)) return direction(centre, top);
  return direction(body.joints[Pelvis], top);
}

void add_trunk(const PointTracks& points, BodyTracks& body) {
  const double scale = body.scale;
  body.chest_up = chest_direction(points, body);
  const Landmark line = shoulder_line(points);
  body.chest_left = direction(points.of(line, Side::right), points.of(line, Side::left));
  const Track nape = points.of(cervical_7);
  if (!is_known(body.chest_left)) {
    body.chest_left =
        combined([](const Vec3& y, const Vec3& z) { return Vec3(y.cross(z).normalized()); },
                 body.chest_up, direction(nape, jugular(points)));
  }
  const Track above_shoulders =
      is_known(points.of(mid_shoulders)) ? points.of(mid_shoulders) : both_sides(points, line);
  const double rise = line == acromion && !is_known(points.of(mid_shoulders))
                          ? 0.01
                          : neck_above_shoulders;  // the acromion is 0.05 above the joint
  Track necks = points.of(neck);
  if (!is_known(necks)) {
    necks = first_known(shifted(middle_of(nape, jugular(points)), body.chest_up, 0.03 * scale),
                        shifted(above_shoulders, body.chest_up, rise * scale));
  }
  body.joints[Neck] = necks;
  body.joints[Chest] = is_known(points.of(chest))
                           ? points.of(chest)
                           : shifted(necks, body.chest_up, -chest_below_neck * scale);
  body.joints[Spine] = is_known(points.of(spine)) ? points.of(spine)
                                                  : shifted(body.joints[Pelvis], body.pelvis_up,
                                                            spine_above_pelvis * scale);
}

/// The axis of the elbow for an arm that hangs as it does at rest, turned with the chest.
Track expected_elbow_axis(const Track& shoulders, const Track& elbows, const Arm& arm,
                          const BodyTracks& body) {
  return combined(
      [&](const Vec3& s, const Vec3& e, const Vec3& left, const Vec3& up) {
        const Quat chest_turn = frame_from(left, up);
        const Vec3 along = chest_turn.conjugate() * Vec3(e - s);
        return Vec3(chest_turn *
                    (turn_between(arm.outward * Vec3::UnitX(), along) * Vec3::UnitY()));
      },
      shoulders, elbows, body.chest_left, body.chest_up);
}

Track shoulder_centre(const PointTracks& points, const Arm& arm, const BodyTracks& body) {
  constexpr double share = 0.17;  // of the distance between the acromia (Rab et al. 2002)
  const double width =
      median_distance(points.of(acromion, Side::left), points.of(acromion, Side::right))
          .value_or(0.37 * body.scale);
  return first_known(points.of(shoulder, arm.side),
                     shifted(points.of(acromion, arm.side), body.chest_up, -share * width));
}

void add_arm(const PointTracks& points, const Arm& arm, BodyTracks& body) {
  body.joints[arm.clavicle] = points.of(clavicle, arm.side);
  const Track shoulders = shoulder_centre(points, arm, body);
  const Track thumb_side = points.of(thumb_side_of_wrist, arm.side);
  const Track finger_side = points.of(finger_side_of_wrist, arm.side);
  Track wrists = first_known(points.of(wrist, arm.side), middle_of(thumb_side, finger_side));
  if (!is_known(wrists)) wrists = is_known(thumb_side) ? thumb_side : finger_side;
  const Track outer = points.of(outer_elbow, arm.side);
  const Track inner = points.of(inner_elbow, arm.side);
  const Track given = points.of(elbow, arm.side);
  const Track known = first_known(given, middle_of(outer, inner));
  const Track expected = expected_elbow_axis(shoulders, first_known(known, outer), arm, body);
  const Hinge hinge{-arm.outward, carrying_angle};
  const double upper_arm_length =
      median_distance(shoulders, first_known(known, outer)).value_or(0.285 * body.scale);
  const double inward = -(marker_radius + 0.135 * upper_arm_length);
  const Limb limb{wrists, false, 0.0, expected};
  Hinge rough = hinge;  // while the joint itself is sought
  rough.noise_metres = 0.05;
  const Track elbows = first_known(known, joint_beside(shoulders, outer, limb, inward, rough));
  const Track bend = hinge_axis(shoulders, elbows, wrists, expected, hinge);
  const Track across = direction(inner, outer);
  body.joints[arm.shoulder] = shoulders;
  body.joints[arm.elbow] = elbows;
  body.axes[arm.shoulder] = is_known(across) ? first_known(across, bend) : bend;
  body.joints[arm.wrist] = wrists;
  body.tips[arm.wrist] = points.of(hand, arm.side);
  body.axes[arm.elbow] = direction(finger_side, thumb_side);
}

/// Places of an average head in the frame of the head joint, metres at 1.75 m.
struct HeadPlace {
  Landmark landmark;
  Side side;
  Vec3 place;
};

const std::vector<HeadPlace>& head_shape() {
  static const std::vector<HeadPlace> shape = {
      {nose, Side::middle, {0, 0.035, 0.10}},         {eye, Side::left, {0.032, 0.07, 0.085}},
      {eye, Side::right, {-0.032, 0.07, 0.085}},      {ear, Side::left, {0.075, 0.05, 0}},
      {ear, Side::right, {-0.075, 0.05, 0}},          {mouth, Side::left, {0.025, -0.01, 0.09}},
      {mouth, Side::right, {-0.025, -0.01, 0.09}},    {head_centre, Side::middle, {0, 0.07, 0}},
      {head_top, Side::middle, {0, 0.17, 0}},         {head_front, Side::left, {0.07, 0.11, 0.08}},
      {head_front, Side::right, {-0.07, 0.11, 0.08}}, {head_back, Side::left, {0.07, 0.11, -0.08}},
      {head_back, Side::right, {-0.07, 0.11, -0.08}}, {head_side, Side::left, {0.078, 0.07, 0.02}},
      {head_side, Side::right, {-0.078, 0.07, 0.02}}, {head_front, Side::middle, {0, 0.11, 0.10}},
  };
  return shape;
}

/// Position and rotation of the head; the neck is taken as part of it if there are too few points.
std::vector<std::optional<Placement>> head_placements(const PointTracks& points,
                                                      const BodyTracks& body) {
  std::vector<std::pair<Vec3, Track>> places;
  for (const auto& [landmark, side, place] : head_shape()) {
    Track track = points.of(landmark, side);
    if (is_known(track)) places.emplace_back(place * body.scale, std::move(track));
  }
  if (is_known(points.of(head))) places.emplace_back(Vec3::Zero(), points.of(head));
  if (places.size() < 3) places.emplace_back(Vec3(0, -0.10, 0) * body.scale, body.joints[Neck]);
  std::vector<std::optional<Placement>> placements(points.frame_count());
  for (std::size_t frame = 0; frame < placements.size(); ++frame) {
    std::vector<Vec3> shape;
    std::vector<Vec3> measured;
    for (const auto& [place, track] : places) {
      if (!track[frame]) continue;
      shape.push_back(place);
      measured.push_back(*track[frame]);
    }
    placements[frame] = rigid_placement(shape, measured);
  }
  return placements;
}

/// The head joint on the line from the neck to a point above it.
Track between(const Track& low, const Track& high, double share) {
  return combined([&](const Vec3& l, const Vec3& h) { return Vec3(l + share * (h - l)); }, low,
                  high);
}

void add_head(const PointTracks& points, BodyTracks& body) {
  const std::vector<std::optional<Placement>> placements = head_placements(points, body);
  Track placed(points.frame_count());
  for (std::size_t frame = 0; frame < placements.size(); ++frame) {
    if (!placements[frame]) continue;
    body.head[frame] = placements[frame]->rotation;
    placed[frame] = placements[frame]->position;
  }
  for (const Track& joint :
       {points.of(head), placed, between(body.joints[Neck], points.of(head_centre), 0.10 / 0.17),
        between(body.joints[Neck], points.of(head_top), 0.10 / 0.27)}) {
    if (!is_known(joint)) continue;
    body.joints[Head] = joint;
    break;
  }
  body.tips[Head] = points.of(head_top);
}

}  // namespace

Track trunk_direction(const PointTracks& points, const Track& base) {
  return direction(base, top_of_trunk(points));
}

void add_upper_body(const PointTracks& points, BodyTracks& body) {
  add_trunk(points, body);
  for (const Arm& arm : arms) add_arm(points, arm, body);
  add_head(points, body);
}

}  // namespace mien::motion
