#include "motion/measures/differences/joint_difference.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/math/rotation.h"
#include "motion/measures/distance/similarity.h"

namespace mien::motion {

namespace {

std::vector<int> joints_below(const Skeleton& skeleton) {
  std::vector<int> below(skeleton.joints.size(), 0);
  for (int j = skeleton.size() - 1; j > 0; --j) below[skeleton.joints[j].parent] += 1 + below[j];
  return below;
}

/// Towards the main child or the tip, in the joint's frame; zero when there is neither.
std::vector<Vec3> bones_of(const Skeleton& skeleton) {
  const std::vector<int> below = joints_below(skeleton);
  std::vector<Vec3> bones(skeleton.joints.size(), Vec3::Zero());
  std::vector<int> most(skeleton.joints.size(), -1);
  for (int j = 1; j < skeleton.size(); ++j) {
    const Joint& child = skeleton.joints[j];
    if (child.offset.norm() < 1e-9 || below[j] <= most[child.parent]) continue;
    most[child.parent] = below[j];
    bones[child.parent] = child.offset;
  }
  for (int j = 0; j < skeleton.size(); ++j) {
    if (most[j] < 0 && skeleton.joints[j].tip) bones[j] = *skeleton.joints[j].tip;
  }
  return bones;
}

/// Angle of the turn from one to the other; 0 exactly when they are the same.
double turn_angle(const Quat& difference) { return log(difference).norm(); }

bool same_turn(const Quat& a, const Quat& b) {
  return a.coeffs() == b.coeffs() || a.coeffs() == -b.coeffs();
}

/// Ways from the points of the first motion to those of the second.
using PointWays = std::array<Vec3, 3>;

PointWays ways(const JointPoints& before, const JointPoints& now) {
  return {now.joint - before.joint, now.side - before.side, now.up - before.up};
}

double longest(const PointWays& ways) {
  return std::max({ways[0].norm(), ways[1].norm(), ways[2].norm()});
}

void add_own_change(JointDifference& joint, const LocalFrame& before, const LocalFrame& now,
                    const BoneAxes& axes) {
  const bool is_root = joint.parent < 0;
  joint.offset_m.push_back(is_root ? 0.0 : (now.offset - before.offset).norm());
  if (same_turn(before.rotation, now.rotation)) {
    joint.turn_radians.push_back(0.0);
    joint.twist_radians.push_back(0.0);
    return;
  }
  const Quat difference = (before.rotation.conjugate() * now.rotation).normalized();
  joint.turn_radians.push_back(turn_angle(difference));
  joint.twist_radians.push_back(turn_angle(twist_about(difference, axes.along)));
}

/// Frame by frame the similarity that lays the second pose over the first.
void add_aligned(std::vector<JointDifference>& joints, const PairedMotions& pair, int frame) {
  std::vector<Vec3> before, now;
  for (const SharedJoint& shared : pair.joints) {
    before.push_back(pair.before.world[frame].positions[shared.before]);
    now.push_back(pair.now.world[frame].positions[shared.now]);
  }
  const Similarity onto = similarity_fit(now, before);
  for (std::size_t j = 0; j < joints.size(); ++j)
    joints[j].aligned_m.push_back((onto(now[j]) - before[j]).norm());
}

/// Central differences, one-sided at the ends; of one frame none.
void add_velocities(JointDifference& joint, const std::vector<PointWays>& apart, double rate) {
  const int frames = static_cast<int>(apart.size());
  for (int t = 0; t < frames; ++t) {
    const int from = std::max(t - 1, 0);
    const int to = std::min(t + 1, frames - 1);
    PointWays change;
    for (std::size_t k = 0; k < change.size(); ++k) change[k] = apart[to][k] - apart[from][k];
    joint.velocity_m_s.push_back(longest(change) * rate / std::max(to - from, 1));
  }
}

}  // namespace

std::vector<BoneAxes> bone_axes(const Skeleton& skeleton) {
  std::vector<BoneAxes> axes;
  for (const Vec3& bone : bones_of(skeleton)) {
    const Vec3 along = bone.norm() > 0.0 ? Vec3(bone.normalized()) : Vec3(Vec3::UnitY());
    int least = 0;
    along.cwiseAbs().minCoeff(&least);
    const Quat frame = frame_from(along, Vec3::Unit(least));
    axes.push_back({along, frame * Vec3::UnitY(), frame * Vec3::UnitZ()});
  }
  return axes;
}

JointPoints points_at(const JointTransforms& world, int joint, const BoneAxes& axes) {
  const Vec3& place = world.positions[joint];
  const Quat& turn = world.rotations[joint];
  return {place, place + turn * (virtual_point_m * axes.side),
          place + turn * (virtual_point_m * axes.up)};
}

CurvePeak peak_of(std::span<const double> curve) {
  CurvePeak peak;
  for (std::size_t t = 0; t < curve.size(); ++t) {
    if (curve[t] > peak.value) peak = {curve[t], static_cast<int>(t)};
  }
  return peak;
}

double root_mean_square(std::span<const double> curve) {
  double sum = 0.0;
  for (const double value : curve) sum += value * value;
  return curve.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(curve.size()));
}

bool JointDifference::differs_itself() const {
  return peak_of(turn_radians).value > 1e-4 || peak_of(offset_m).value > 1e-5;
}

std::vector<JointDifference> joint_differences(const PairedMotions& pair, const Skeleton& before,
                                               const Skeleton& now) {
  const std::vector<BoneAxes> axes = bone_axes(before);
  std::vector<JointDifference> joints;
  for (std::size_t j = 0; j < pair.joints.size(); ++j) {
    const SharedJoint& shared = pair.joints[j];
    const BoneAxes& bone = axes[shared.before];
    JointDifference& joint = joints.emplace_back();
    joint.name = shared.name;
    joint.index = shared.before;
    joint.part = shared.name;
    joint.parent = shared.parent;
    std::vector<PointWays> apart;
    for (int t = 0; t < pair.frames; ++t) {
      apart.push_back(ways(points_at(pair.before.world[t], shared.before, bone),
                           points_at(pair.now.world[t], shared.now, bone)));
      joint.position_m.push_back(apart.back().front().norm());
      joint.point_m.push_back(longest(apart.back()));
      add_own_change(joint, local_before(pair, before, static_cast<int>(j), t),
                     local_now(pair, now, static_cast<int>(j), t), bone);
    }
    add_velocities(joint, apart, pair.frames_per_second);
  }
  for (int t = 0; t < pair.frames; ++t) add_aligned(joints, pair, t);
  return joints;
}

}  // namespace mien::motion
