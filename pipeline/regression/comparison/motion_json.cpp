#include "motion/measures/differences/difference_sentence.h"
#include "pipeline/regression/comparison/compared_motions.h"

namespace mien::pipeline {

namespace {

using motion::JointDifference;
using motion::MotionDifference;
using nlohmann::ordered_json;

ordered_json as_json(const motion::MotionLength& length) {
  return {{"frames", length.frames},
          {"frames_per_second", length.frames_per_second},
          {"seconds", length.seconds},
          {"loops", length.loops}};
}

ordered_json as_json(const motion::TimingDifference& timing) {
  ordered_json result = {{"before", as_json(timing.before)}, {"now", as_json(timing.now)}};
  result["shift"] = nullptr;
  if (const auto& shift = timing.shift)
    result["shift"] = {{"frames", shift->frames},
                       {"seconds", shift->seconds},
                       {"explained", shift->explained},
                       {"path_too", shift->path_too}};
  result["gap"] = nullptr;
  if (const auto& gap = timing.gap)
    result["gap"] = {{"frame", gap->frame}, {"frames", gap->frames}, {"explained", gap->explained}};
  result["other_pace"] = timing.other_pace;
  result["reversed"] = timing.reversed;
  result["every"] = timing.every;
  return result;
}

ordered_json as_json(const motion::WholeBodyChange& whole) {
  if (whole.kind == motion::WholeChange::none) return nullptr;
  return {{"kind", name_of(whole.kind)},
          {"scale", whole.scale},
          {"turn_rad", whole.turn_radians},
          {"shift_m", {whole.shift.x(), whole.shift.y(), whole.shift.z()}},
          {"before", whole.before},
          {"left", whole.remaining}};
}

ordered_json worst_as_json(const MotionDifference& difference,
                           std::vector<double> JointDifference::*curve, const char* unit) {
  const motion::WorstJoint worst = worst_joint(difference, curve);
  return {{"worst", worst.peak.value},
          {"joint", difference.joints[static_cast<std::size_t>(worst.joint)].name},
          {"frame", worst.peak.frame},
          {"seconds", worst.peak.frame / difference.frames_per_second()},
          {"rms", root_mean_square(difference, curve)},
          {"unit", unit}};
}

ordered_json as_json(const motion::RootDifference& root, const MotionDifference& difference) {
  return {{"joint", difference.joints[static_cast<std::size_t>(root.joint)].name},
          {"only", is_root_only(difference)},
          {"path_m", root.path_m},
          {"height_m", root.height_m},
          {"heading_rad", root.heading_radians},
          {"tilt_rad", root.tilt_radians}};
}

ordered_json as_json(const JointDifference& joint) {
  return {{"joint", joint.name},
          {"part", joint.part},
          {"differs_itself", joint.differs_itself()},
          {"position_m", joint.position_m},
          {"point_m", joint.point_m},
          {"aligned_m", joint.aligned_m},
          {"velocity_m_s", joint.velocity_m_s},
          {"turn_rad", joint.turn_radians},
          {"twist_rad", joint.twist_radians},
          {"offset_m", joint.offset_m}};
}

const char* name_of_kind(motion::ContactChange::Kind kind) {
  constexpr const char* names[] = {"shifted", "gone", "new"};
  return names[static_cast<std::size_t>(kind)];
}

ordered_json as_json(const motion::FootDifference& foot) {
  ordered_json changes = ordered_json::array();
  for (const motion::ContactChange& change : foot.changes)
    changes.push_back({{"kind", name_of_kind(change.kind)},
                       {"begin_s", change.begin_seconds},
                       {"end_s", change.end_seconds},
                       {"begin_shift_s", change.begin_shift},
                       {"end_shift_s", change.end_shift}});
  return {{"frames", foot.frames},
          {"changes", changes},
          {"slide_m", foot.slide_m},
          {"slide_at_s", foot.slide_seconds}};
}

ordered_json as_json(const motion::BodyDifference& body) {
  return {{"d_m", body.d_m},
          {"mpjpe_m", body.mpjpe_m},
          {"left_foot", as_json(body.feet[0])},
          {"right_foot", as_json(body.feet[1])}};
}

ordered_json as_json(const motion::LintChange& change) {
  return {{"change", name_of(change.kind)},     {"check", change.finding.check},
          {"joint", change.finding.joint},      {"first", change.finding.first},
          {"last", change.finding.last},        {"severity", name_of(change.finding.severity)},
          {"sentence", change.finding.sentence}};
}

/// Values that are not known are written as null.
ordered_json as_json(const motion::FeatureDifference& change) {
  const motion::MotionFeature& feature =
      motion::motion_features()[static_cast<std::size_t>(change.feature)];
  return {{"feature", feature.id},
          {"before", change.before},
          {"now", change.now},
          {"unit", motion::symbol_of(feature.unit)},
          {"notable", change.is_notable()}};
}

ordered_json as_json(const motion::Excess& excess) {
  return {{"measure", excess.measure},
          {"measured", excess.measured},
          {"tolerance", excess.tolerance},
          {"unit", excess.unit}};
}

template <class Values>
ordered_json list_of(const Values& values) {
  ordered_json list = ordered_json::array();
  for (const auto& value : values) list.push_back(as_json(value));
  return list;
}

std::vector<std::string> cause_names(const MotionDifference& difference) {
  std::vector<std::string> names;
  for (const int joint : causes(difference))
    names.push_back(difference.joints[static_cast<std::size_t>(joint)].name);
  return names;
}

}  // namespace

ordered_json as_json(const ComparedMotions& motions) {
  const MotionDifference& difference = motions.difference;
  ordered_json result = {
      {"before", motions.before},
      {"now", motions.now},
      {"take_before", motions.take_before},
      {"take_now", motions.take_now},
      {"person_before", motions.person_before},
      {"person_now", motions.person_now},
      {"alike", motions.are_alike()},
      {"identical", difference.identical},
      {"largest_change", motion::largest_change(difference)},
      {"excesses", list_of(motions.excesses)},
      {"on_body", difference.on_body},
      {"remarks", difference.remarks},
      {"timing", as_json(difference.timing)},
      {"whole", as_json(difference.whole)},
      {"position", worst_as_json(difference, &JointDifference::point_m, "m")},
      {"rotation", worst_as_json(difference, &JointDifference::turn_radians, "rad")},
      {"velocity", worst_as_json(difference, &JointDifference::velocity_m_s, "m/s")},
      {"mpjpe_m", difference.errors.mpjpe},
      {"rooted_mpjpe_m", difference.errors.root_relative_mpjpe},
      {"pa_mpjpe_m", difference.errors.pa_mpjpe},
      {"causes", cause_names(difference)},
      {"joints_gone", difference.only_before},
      {"joints_new", difference.only_now},
      {"joints_renamed", difference.renamed}};
  result["body"] = difference.body ? as_json(*difference.body) : ordered_json(nullptr);
  result["lint"] = list_of(difference.lint);
  result["features"] = list_of(difference.features);
  result["root"] = as_json(difference.root, difference);
  result["joints"] = list_of(difference.joints);
  return result;
}

}  // namespace mien::pipeline
