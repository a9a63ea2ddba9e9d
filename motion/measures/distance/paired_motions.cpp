#include "motion/measures/distance/paired_motions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "motion/error.h"
#include "motion/rig/joint_word.h"

namespace mien::motion {

namespace {

void require_frames(const Clip& clip) {
  if (clip.poses.empty())
    throw Error(Place{clip.name}, "it holds no frames", "give a motion of at least one frame");
}

bool is_finite_pose(const Pose& pose) {
  const auto finite = [](const Vec3& v) { return v.allFinite(); };
  return pose.root_position.allFinite() &&
         std::ranges::all_of(pose.rotations,
                             [](const Quat& q) { return q.coeffs().allFinite(); }) &&
         std::ranges::all_of(pose.offsets, finite);
}

void require_numbers(const Clip& clip) {
  const auto broken = std::ranges::find_if_not(clip.poses, is_finite_pose);
  if (broken == clip.poses.end()) return;
  throw Error(Place{clip.name},
              "frame " + std::to_string(broken - clip.poses.begin()) +
                  " holds an invalid number (not finite)",
              "make the motion again; mien motion lint shows where it is faulty");
}

/// Joints by their side and word, in the skeleton's order: what stands opposite to what.
using SideKey = std::pair<std::string, JointWord::Side>;

JointWord::Side other_side(JointWord::Side side) {
  return side == JointWord::Side::left ? JointWord::Side::right : JointWord::Side::left;
}

/// The n-th joint that a word names on the left stands opposite to the n-th on the right.
void set_opposites(std::vector<SharedJoint>& joints) {
  std::map<SideKey, std::vector<int>> by_side;
  std::vector<std::pair<SideKey, std::size_t>> ranks;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const JointWord word = joint_word(joints[j].name);
    std::vector<int>& alike = by_side[{word.word, word.side}];
    ranks.push_back({{word.word, word.side}, alike.size()});
    alike.push_back(static_cast<int>(j));
  }
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const auto& [key, rank] = ranks[j];
    joints[j].opposite = static_cast<int>(j);
    if (key.second == JointWord::Side::middle) continue;
    const auto found = by_side.find({key.first, other_side(key.second)});
    const bool is_there = found != by_side.end() && rank < found->second.size();
    joints[j].opposite = is_there ? found->second[rank] : -1;
  }
}

int nearest_shared_parent(const Skeleton& skeleton, const std::vector<int>& shared_of, int joint) {
  int above = skeleton.joints[joint].parent;
  while (above >= 0 && shared_of[above] < 0) above = skeleton.joints[above].parent;
  return above < 0 ? -1 : shared_of[above];
}

bool same_names(const Skeleton& a, const Skeleton& b) {
  return std::ranges::equal(a.joints, b.joints, {}, &Joint::name, &Joint::name);
}

void pair_joints(PairedMotions& pair, const Skeleton& before, const Skeleton& now) {
  const bool by_index = same_names(before, now);
  std::vector<int> shared_of(before.joints.size(), -1);
  std::vector<bool> taken(now.joints.size(), false);
  for (int j = 0; j < before.size(); ++j) {
    const std::string& name = before.joints[j].name;
    const int there = by_index ? j : find_joint(now, name);
    if (there < 0 || taken[there]) {
      pair.only_before.push_back(name);
      continue;
    }
    taken[there] = true;
    shared_of[j] = static_cast<int>(pair.joints.size());
    pair.joints.push_back({name, j, there, nearest_shared_parent(before, shared_of, j), -1});
  }
  for (int j = 0; j < now.size(); ++j) {
    if (!taken[j]) pair.only_now.push_back(now.joints[j].name);
  }
  set_opposites(pair.joints);
}

SampledMotion sampled_at(const Clip& clip, double frames_per_second) {
  SampledMotion result;
  if (same_rate(clip.frames_per_second, frames_per_second)) {
    result.poses = clip.poses;
  } else {
    const double wanted = clip.duration_seconds() * frames_per_second;
    const long frames = clip.loops ? std::max(1L, std::lround(wanted))
                                   : static_cast<long>(std::floor(wanted + 1e-6)) + 1;
    for (long i = 0; i < frames; ++i)
      result.poses.push_back(pose_at(clip, static_cast<double>(i) / frames_per_second));
  }
  for (const Pose& pose : result.poses) result.world.push_back(world_transforms(clip.body, pose));
  return result;
}

LocalFrame local_frame(const Skeleton& skeleton, const SampledMotion& motion, std::size_t frame,
                       int joint, int above) {
  const auto j = joint;
  const Pose& pose = motion.poses[frame];
  const JointTransforms& world = motion.world[frame];
  if (above < 0) return {world.positions[j], world.rotations[j]};
  if (skeleton.joints[j].parent == above)
    return {pose.offsets.empty() ? skeleton.joints[j].offset : pose.offsets[j], pose.rotations[j]};
  const auto p = above;
  const Quat back = world.rotations[p].conjugate();
  return {back * (world.positions[j] - world.positions[p]), back * world.rotations[j]};
}

}  // namespace

bool same_rate(double before, double now) { return std::abs(before - now) <= 1e-4 * before; }

PairedMotions paired(const Clip& before, const Clip& now) {
  for (const Clip* clip : {&before, &now}) {
    require_frames(*clip);
    require_numbers(*clip);
  }
  PairedMotions pair;
  pair_joints(pair, before.body, now.body);
  if (pair.joints.empty())
    throw Error(Place{now.name}, "has no joint of the same name as " + before.name,
                "compare motions of one rig, or of humans");
  pair.frames_per_second = before.frames_per_second;
  pair.before = sampled_at(before, before.frames_per_second);
  pair.now = sampled_at(now, before.frames_per_second);
  pair.frames = std::min(pair.before.frame_count(), pair.now.frame_count());
  return pair;
}

LocalFrame local_before(const PairedMotions& pair, const Skeleton& skeleton, int joint, int frame) {
  const SharedJoint& shared = pair.joints[joint];
  const int above = shared.parent < 0 ? -1 : pair.joints[shared.parent].before;
  return local_frame(skeleton, pair.before, frame, shared.before, above);
}

LocalFrame local_now(const PairedMotions& pair, const Skeleton& skeleton, int joint, int frame) {
  const SharedJoint& shared = pair.joints[joint];
  const int above = shared.parent < 0 ? -1 : pair.joints[shared.parent].now;
  return local_frame(skeleton, pair.now, frame, shared.now, above);
}

}  // namespace mien::motion
