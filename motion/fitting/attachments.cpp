#include "motion/fitting/attachments.h"

namespace mien::motion {

namespace {

/// A joint of the left arm or leg, or its counterpart.
BodyJoint on_side(BodyJoint left, Side side) { return side == Side::right ? mirrored(left) : left; }

/// The canonical joint that a role marks exactly.
std::optional<BodyJoint> joint_at(const Role& role) {
  switch (role.landmark) {
    case Landmark::pelvis:
      return Pelvis;
    case Landmark::spine:
      return Spine;
    case Landmark::chest:
      return Chest;
    case Landmark::neck:
      return Neck;
    case Landmark::head:
      return Head;
    case Landmark::clavicle:
      return on_side(LeftClavicle, role.side);
    case Landmark::shoulder:
      return on_side(LeftShoulder, role.side);
    case Landmark::elbow:
      return on_side(LeftElbow, role.side);
    case Landmark::wrist:
      return on_side(LeftWrist, role.side);
    case Landmark::hip:
      return on_side(LeftHip, role.side);
    case Landmark::knee:
      return on_side(LeftKnee, role.side);
    case Landmark::ankle:
      return on_side(LeftAnkle, role.side);
    case Landmark::toe:
      return on_side(LeftToe, role.side);
    default:
      return std::nullopt;
  }
}

/// The joint whose segment carries the point.
BodyJoint segment_of(const Role& role) {
  switch (role.landmark) {
    case Landmark::mid_shoulders:
    case Landmark::cervical_7:
    case Landmark::back:
    case Landmark::trunk:
    case Landmark::jugular_notch:
    case Landmark::sternum:
      return Chest;
    case Landmark::head_centre:
    case Landmark::head_top:
    case Landmark::nose:
    case Landmark::eye:
    case Landmark::ear:
    case Landmark::mouth:
    case Landmark::head_front:
    case Landmark::head_back:
    case Landmark::head_side:
      return Head;
    case Landmark::acromion:
      return on_side(LeftClavicle, role.side);
    case Landmark::upper_arm:
    case Landmark::outer_elbow:
    case Landmark::inner_elbow:
      return on_side(LeftShoulder, role.side);
    case Landmark::forearm:
    case Landmark::thumb_side_of_wrist:
    case Landmark::finger_side_of_wrist:
      return on_side(LeftElbow, role.side);
    case Landmark::hand:
      return on_side(LeftWrist, role.side);
    case Landmark::trochanter:
    case Landmark::thigh:
    case Landmark::outer_knee:
    case Landmark::inner_knee:
      return on_side(LeftHip, role.side);
    case Landmark::shank:
    case Landmark::outer_ankle:
    case Landmark::inner_ankle:
      return on_side(LeftKnee, role.side);
    case Landmark::heel:
    case Landmark::first_metatarsal:
    case Landmark::second_metatarsal:
    case Landmark::fifth_metatarsal:
    case Landmark::foot:
      return on_side(LeftAnkle, role.side);
    case Landmark::toe_tip:
      return on_side(LeftToe, role.side);
    default:
      return Pelvis;
  }
}

}  // namespace

std::optional<BodyJoint> rigid_segment_of(const Role& role) {
  if (role.landmark == Landmark::pelvis || role.landmark == Landmark::hip) return Pelvis;
  if (joint_at(role)) return std::nullopt;
  return segment_of(role);
}

std::vector<Attachment> attachments(const PointTracks& points, const Skeleton& body,
                                    std::span<const Pose> poses, const FrameRange& range) {
  const std::size_t point_count = points.recording.points.size();
  std::vector<Track> places(point_count, Track(poses.size()));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const JointTransforms world = world_transforms(body, poses[i]);
    for (std::size_t point = 0; point < point_count; ++point) {
      const std::size_t at =
          points.recording.at(range.first + static_cast<int>(i), static_cast<int>(point));
      if (!points.set.roles[point] || !points.recording.seen[at]) continue;
      const BodyJoint joint = segment_of(*points.set.roles[point]);
      places[point][i] = Vec3(world.rotations[joint].conjugate() *
                              (points.recording.positions[at] - world.positions[joint]));
    }
  }
  std::vector<Attachment> result;
  for (std::size_t point = 0; point < point_count; ++point) {
    const std::optional<Vec3> place = median_of(places[point]);
    if (!place) continue;
    const Role& role = *points.set.roles[point];
    const std::optional<BodyJoint> centre = joint_at(role);
    result.push_back({static_cast<int>(point), centre.value_or(segment_of(role)),
                      centre ? Vec3(Vec3::Zero()) : *place});
  }
  return result;
}

}  // namespace mien::motion
