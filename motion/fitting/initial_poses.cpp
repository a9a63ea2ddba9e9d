#include "motion/fitting/initial_poses.h"

#include <array>

#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

using Rotations = std::vector<std::optional<Quat>>;  ///< frame by frame

/// The rotation that takes y exactly to `up` and x as near to `left` as possible.
std::optional<Quat> upright_frame(const Vec3& up, const Vec3& left) {
  const Vec3 x = left - up * up.dot(left);
  if (x.norm() < 1e-3) return std::nullopt;
  return frame_from(x, up);
}

/// The rotation that takes the unit vectors `rest` to `bone` and, as nearly as possible,
/// `rest_side` to `side`.
std::optional<Quat> aimed(const Vec3& rest, const Vec3& rest_side, const Vec3& bone,
                          const Vec3& side) {
  if (bone.norm() < 1e-6 || bone.normalized().cross(side).norm() < 1e-3) return std::nullopt;
  return (frame_from(bone, side) * frame_from(rest, rest_side).conjugate()).normalized();
}

/// World rotations of the segments where the tracks tell them.
class SegmentRotations {
 public:
  SegmentRotations(const BodyTracks& tracks, const Skeleton& body, std::size_t frame)
      : tracks_(tracks), body_(body), frame_(frame) {}

  std::array<std::optional<Quat>, body_joint_count> all() {
    set_trunk();
    for (const bool left : {true, false}) {
      set_arm(left);
      set_leg(left);
    }
    return world_;
  }

 private:
  using Known = std::optional<Vec3>;
  const Known& at(BodyJoint joint) const { return tracks_.joints[joint][frame_]; }
  const Known& axis(BodyJoint joint) const { return tracks_.axes[joint][frame_]; }

  Known bone(BodyJoint from, BodyJoint to) const { return between(at(from), at(to)); }
  static Known between(const Known& from, const Known& to) {
    if (!from || !to || (*to - *from).norm() < 1e-6) return std::nullopt;
    return Vec3((*to - *from).normalized());
  }

  void set_trunk() {
    const Known& pelvis_left = tracks_.pelvis_left[frame_];
    const Known& pelvis_up = tracks_.pelvis_up[frame_];
    const Known& chest_left = tracks_.chest_left[frame_];
    const Known& chest_up = tracks_.chest_up[frame_];
    if (pelvis_left && pelvis_up && pelvis_left->cross(*pelvis_up).norm() > 1e-3) {
      world_[Pelvis] = frame_from(*pelvis_left, *pelvis_up);
    }
    if (chest_left && chest_up) world_[Chest] = upright_frame(*chest_up, *chest_left);
    const Known lower = bone(Spine, Chest);
    if (lower && pelvis_left && chest_left) {
      world_[Spine] = upright_frame(*lower, *pelvis_left + *chest_left);
    }
    const Known neck = bone(Neck, Head);
    const std::optional<Quat>& head = tracks_.head[frame_];
    if (neck && chest_left) {
      const Vec3 head_left = head ? Vec3(*head * Vec3::UnitX()) : *chest_left;
      world_[Neck] = upright_frame(*neck, *chest_left + head_left);
    }
    world_[Head] = head ? head : world_[Neck];
  }

  void set_arm(bool left) {
    const BodyJoint clavicle = left ? LeftClavicle : RightClavicle;
    const BodyJoint shoulder = left ? LeftShoulder : RightShoulder;
    const BodyJoint elbow = left ? LeftElbow : RightElbow;
    const BodyJoint wrist = left ? LeftWrist : RightWrist;
    const Vec3 rest = left ? Vec3(1, 0, 0) : Vec3(-1, 0, 0);
    if (world_[Chest] && at(Chest) && at(shoulder)) {
      const Vec3 start = *at(Chest) + *world_[Chest] * body_.joints[clavicle].offset;
      const Vec3 along = world_[Chest]->conjugate() * (*at(shoulder) - start);
      if (along.norm() > 1e-3) world_[clavicle] = *world_[Chest] * turn_between(rest, along);
    }
    const Known upper = bone(shoulder, elbow);
    const Known lower = bone(elbow, wrist);
    const Known& hinge = axis(shoulder);
    const Known& thumb = axis(elbow);
    if (upper && hinge) world_[shoulder] = aimed(rest, Vec3::UnitY(), *upper, *hinge);
    if (lower && hinge) world_[elbow] = aimed(rest, Vec3::UnitY(), *lower, *hinge);
    if (lower && thumb) world_[elbow] = aimed(rest, Vec3::UnitZ(), *lower, *thumb);
    const Known hand = between(at(wrist), tracks_.tips[wrist][frame_]);
    if (world_[elbow] && hand) {
      world_[wrist] = aimed(rest, Vec3::UnitZ(), *hand, *world_[elbow] * Vec3::UnitZ());
    }
  }

  void set_leg(bool left) {
    const BodyJoint hip = left ? LeftHip : RightHip;
    const BodyJoint knee = left ? LeftKnee : RightKnee;
    const BodyJoint ankle = left ? LeftAnkle : RightAnkle;
    const BodyJoint toe = left ? LeftToe : RightToe;
    const Known& hinge = axis(hip);
    if (!hinge) return;
    const Known thigh = bone(hip, knee);
    const Known shank = bone(knee, ankle);
    const Known foot = bone(ankle, toe);
    const Vec3 down(0, -1, 0);
    if (thigh) world_[hip] = aimed(down, Vec3::UnitX(), *thigh, *hinge);
    if (shank) world_[knee] = aimed(down, Vec3::UnitX(), *shank, *hinge);
    const Vec3& rest_foot = body_.joints[toe].offset;
    if (foot) world_[ankle] = aimed(rest_foot.normalized(), Vec3::UnitX(), *foot, *hinge);
    const Known tip = between(at(toe), tracks_.tips[toe][frame_]);
    if (tip) world_[toe] = aimed(Vec3::UnitZ(), Vec3::UnitX(), *tip, *hinge);
  }

  const BodyTracks& tracks_;
  const Skeleton& body_;
  std::size_t frame_;
  std::array<std::optional<Quat>, body_joint_count> world_;
};

/// The local rotation of an arm's joint when it hangs.
Quat hanging(int joint) {
  constexpr double down = 80.0 * radians_per_degree;
  if (joint == LeftShoulder) return exp(Vec3(0, 0, -down));
  if (joint == RightShoulder) return exp(Vec3(0, 0, down));
  return Quat::Identity();
}

/// Fills unknown frames between known ones by interpolation and holds the first and the last.
std::vector<Quat> completed(const Rotations& known, const Quat& otherwise) {
  std::vector<Quat> result(known.size(), otherwise);
  int last = -1;
  for (int frame = 0; frame < static_cast<int>(known.size()); ++frame) {
    if (!known[frame]) continue;
    result[frame] = last < 0 ? *known[frame] : in_hemisphere_of(result[last], *known[frame]);
    for (int gap = last + 1; gap < frame; ++gap) {
      const double t = last < 0 ? 1.0 : static_cast<double>(gap - last) / (frame - last);
      result[gap] = last < 0 ? result[frame] : slerp(result[last], result[frame], t);
    }
    last = frame;
  }
  for (int frame = last + 1; last >= 0 && frame < static_cast<int>(known.size()); ++frame) {
    result[frame] = result[last];
  }
  return result;
}

/// As `completed`, for a position that is known in the first and in the last frame.
std::vector<Vec3> completed_path(const Track& track, const FrameRange& range) {
  std::vector<Vec3> path(static_cast<std::size_t>(range.size()), Vec3::Zero());
  int last = 0;
  for (int i = 0; i < range.size(); ++i) {
    const std::optional<Vec3>& known = track[static_cast<std::size_t>(range.first + i)];
    if (!known) continue;
    path[i] = *known;
    for (int gap = last + 1; gap < i; ++gap) {
      path[gap] = path[last] + (path[i] - path[last]) * (gap - last) / (i - last);
    }
    last = i;
  }
  return path;
}

}  // namespace

FrameRange frames_with_pelvis(const BodyTracks& tracks) {
  FrameRange range;
  for (int frame = 0; frame < static_cast<int>(tracks.frame_count()); ++frame) {
    const std::size_t at = static_cast<std::size_t>(frame);
    if (!tracks.joints[Pelvis][at] || !tracks.pelvis_left[at] || !tracks.pelvis_up[at]) continue;
    if (range.past == 0) range.first = frame;
    range.past = frame + 1;
  }
  return range;
}

std::vector<Pose> initial_poses(const BodyTracks& tracks, const Skeleton& body,
                                const FrameRange& range) {
  const std::size_t count = static_cast<std::size_t>(range.size());
  std::vector<Pose> poses(count);
  std::vector<std::array<std::optional<Quat>, body_joint_count>> known;
  const std::vector<Vec3> path = completed_path(tracks.joints[Pelvis], range);
  for (std::size_t i = 0; i < count; ++i) {
    known.push_back(
        SegmentRotations(tracks, body, static_cast<std::size_t>(range.first) + i).all());
    poses[i].root_position = path[i];
    poses[i].rotations.resize(body_joint_count, Quat::Identity());
  }
  std::array<std::vector<Quat>, body_joint_count> world;
  for (int joint = 0; joint < body_joint_count; ++joint) {
    const int parent = body_parents[static_cast<std::size_t>(joint)];
    Rotations local(count);
    for (std::size_t i = 0; i < count; ++i) {
      if (!known[i][joint]) continue;
      local[i] = parent < 0 ? *known[i][joint]
                            : (world[parent][i].conjugate() * *known[i][joint]).normalized();
    }
    const std::vector<Quat> rotations = completed(local, hanging(joint));
    for (std::size_t i = 0; i < count; ++i) {
      poses[i].rotations[joint] = rotations[i];
      world[joint].push_back(parent < 0 ? rotations[i]
                                        : (world[parent][i] * rotations[i]).normalized());
    }
  }
  return poses;
}

}  // namespace mien::motion
