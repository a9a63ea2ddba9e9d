#include "motion/measures/differences/recording_difference.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "motion/error.h"
#include "motion/lint/lint.h"
#include "motion/math/rotation.h"
#include "motion/measures/distance/body_part.h"
#include "motion/rig/body_mapping.h"
#include "motion/rig/recording_clip.h"

namespace mien::motion {

namespace {

constexpr double most_joints = 0.75;

std::set<std::string> names_in(const Skeleton& skeleton) {
  std::set<std::string> names;
  for (const Joint& joint : skeleton.joints) names.insert(joint.name);
  return names;
}

bool have_equal_structure(const Skeleton& a, const Skeleton& b) {
  return std::ranges::equal(a.joints, b.joints, [](const Joint& p, const Joint& q) {
    return p.name == q.name && p.parent == q.parent;
  });
}

bool have_common_joints(const Skeleton& a, const Skeleton& b) {
  if (have_equal_structure(a, b)) return true;
  const std::set<std::string> of_a = names_in(a);
  const std::set<std::string> of_b = names_in(b);
  const auto common =
      std::ranges::count_if(of_a, [&](const std::string& name) { return of_b.contains(name); });
  const int most = std::max(a.size(), b.size());
  return static_cast<double>(common) >= most_joints * most;
}

/// Whether two skeletons differ only in their names, within the rounding of files.
bool are_renamed(const Skeleton& a, const Skeleton& b) {
  constexpr double rounding = 1e-3;
  return std::ranges::equal(a.joints, b.joints, [](const Joint& p, const Joint& q) {
    return p.parent == q.parent &&
           (p.offset - q.offset).norm() <= rounding * (1.0 + p.offset.norm());
  });
}

/// The second with the first's names, so that joints are paired by their place in the figure.
Recording with_names_of(const Recording& before, Recording now) {
  for (int j = 0; j < now.skeleton.size(); ++j)
    now.skeleton.joints[j].name = before.skeleton.joints[j].name;
  return now;
}

/// How a file's numbers become metres with +Y up. Of what is no human the size of a glTF is known
/// by its standard, that of others a guess.
struct Frame {
  double metres_per_unit = 1.0;
  Quat to_y_up = Quat::Identity();
};

Frame frame_of(const Recording& recording, const RigAnalysis& rig) {
  if (!rig.human && recording.format == "gltf") return {};
  return {rig.metres_per_unit, rig.to_y_up};
}

Clip in_frame(const Recording& recording, const Frame& frame) {
  Clip clip;
  clip.name = recording.name;
  clip.body = recording.skeleton;
  clip.frames_per_second = recording.frames_per_second;
  clip.poses = recording.poses;
  to_metres(frame.metres_per_unit, frame.to_y_up, clip.body, clip.poses);
  return clip;
}

void compare_frames(ComparedRecordings& result, const Frame& before, const Frame& now) {
  std::ostringstream text;
  const double grown = now.metres_per_unit / before.metres_per_unit;
  if (std::abs(std::log(grown)) > 0.1) {
    text << "Judging by the figure's size, the unit of the file is " << now.metres_per_unit
         << " m now and was " << before.metres_per_unit
         << " m before; both are read with the earlier unit.";
    result.remarks.push_back(text.str());
  }
  if (angle_between(before.to_y_up, now.to_y_up) > 0.1)
    result.remarks.emplace_back(
        "Judging by the figure, a different axis points up now; both are read with the earlier "
        "axis.");
}

std::vector<std::string> parts_of(const Skeleton& skeleton,
                                  const std::optional<BodyMapping>& human) {
  std::vector<std::string> parts;
  for (const Joint& joint : skeleton.joints) parts.push_back(joint.name);
  if (!human) return parts;
  for (int j = 0; j < body_joint_count; ++j) {
    const MappedJoint& mapped = human->joints[j];
    if (mapped.at_tip) continue;
    for (const int rig_joint : mapped.group) parts[rig_joint] = part_name(BodyJoint(j));
  }
  return parts;
}

void add_bodies(ComparedRecordings& result, const Recording& before, const RigAnalysis& rig_before,
                const Recording& now, const RigAnalysis& rig_now) {
  if (!rig_before.human || !rig_now.human) return;
  const bool one_rig =
      have_equal_structure(before.skeleton, now.skeleton) && before.format == now.format;
  result.body_before = to_body(before, *rig_before.human);
  result.body_now = to_body(now, one_rig ? *rig_before.human : *rig_now.human);
}

void put_on_bodies(ComparedRecordings& result, const Recording& before, const Recording& now) {
  if (!result.body_before || !result.body_now)
    throw Error(Place{now.name},
                "has other joints than " + before.name + ", and they are not both human figures",
                "compare motions of one rig, or of humans");
  result.on_body = true;
  result.before = *result.body_before;
  result.now = *result.body_now;
  for (int j = 0; j < body_joint_count; ++j) result.parts.push_back(part_name(BodyJoint(j)));
}

/// Lint differences of the data as it was read, which mapping to the body would hide, and of the
/// body.
std::vector<LintChange> lint_differences(const ComparedRecordings& recordings,
                                         const LintOptions& options) {
  const Clip& before = recordings.before;
  const Clip& now = recordings.now;
  std::vector<LintChange> changes =
      lint_changes(lint(to_recording(before), options), before.frames_per_second,
                   lint(to_recording(now), options), now.frames_per_second);
  if (!recordings.body_before || !recordings.body_now) return changes;
  const auto of_body = lint_difference(*recordings.body_before, *recordings.body_now, options);
  changes.insert(changes.end(), of_body.begin(), of_body.end());
  return changes;
}

}  // namespace

ComparedRecordings compared_recordings(const Recording& before, const Recording& now) {
  ComparedRecordings result;
  const RigAnalysis rig_before = analyse_rig(before);
  const RigAnalysis rig_now = analyse_rig(now);
  add_bodies(result, before, rig_before, now, rig_now);
  if (!have_common_joints(before.skeleton, now.skeleton)) {
    if (before.format == now.format && are_renamed(before.skeleton, now.skeleton)) {
      result = compared_recordings(before, with_names_of(before, now));
      for (int j = 0; j < now.skeleton.size(); ++j) {
        const std::string& was = before.skeleton.joints[j].name;
        const std::string& is = now.skeleton.joints[j].name;
        if (was != is) result.renamed.emplace_back(was, is);
      }
      return result;
    }
    put_on_bodies(result, before, now);
    return result;
  }
  const Frame frame_before = frame_of(before, rig_before);
  const Frame frame_now = frame_of(now, rig_now);
  const bool one_format = before.format == now.format;
  if (one_format) compare_frames(result, frame_before, frame_now);
  result.before = in_frame(before, frame_before);
  result.now = in_frame(now, one_format ? frame_before : frame_now);
  result.parts = parts_of(before.skeleton, rig_before.human);
  return result;
}

MotionDifference motion_difference(const ComparedRecordings& recordings,
                                   const MotionDifferenceOptions& options) {
  MotionDifferenceOptions without_lint = options;
  without_lint.lint = false;
  MotionDifference result = motion_difference(recordings.before, recordings.now, without_lint);
  result.on_body = recordings.on_body;
  result.remarks = recordings.remarks;
  result.renamed = recordings.renamed;
  result.identical = result.identical && result.renamed.empty();
  for (JointDifference& joint : result.joints) joint.part = recordings.parts[joint.index];
  if (recordings.body_before && recordings.body_now)
    result.body = body_difference(*recordings.body_before, *recordings.body_now);
  if (options.lint && !result.identical)
    result.lint = lint_differences(recordings, options.lint_options);
  return result;
}

}  // namespace mien::motion
