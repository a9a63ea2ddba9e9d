#include "pipeline/production/synthesis/motion_record.h"

#include <cstdint>
#include <stdexcept>
#include <string_view>

#include <nlohmann/json.hpp>

#include "motion/skeleton/clip_markers.h"

namespace mien::pipeline {

namespace {

void add(KeyBuilder& key, std::string_view name, const motion::Vec3& v) {
  key.add(name, v.x()).add(name, v.y()).add(name, v.z());
}

void add(KeyBuilder& key, std::string_view name, const motion::Quat& q) {
  key.add(name, q.w()).add(name, q.x()).add(name, q.y()).add(name, q.z());
}

void add(KeyBuilder& key, const motion::Skeleton& skeleton) {
  for (const motion::Joint& joint : skeleton.joints) {
    key.add("joint", joint.name).add("parent", std::int64_t{joint.parent});
    add(key, "offset", joint.offset);
    if (joint.tip) add(key, "tip", *joint.tip);
  }
}

void add(KeyBuilder& key, const motion::Markers& markers) {
  for (const std::string& point : markers.points) key.add("marker", point);
  for (std::size_t i = 0; i < markers.positions.size(); ++i) {
    if (!markers.is_known(i)) {
      key.add("m", "missing");
      continue;
    }
    add(key, markers.seen[i] ? "m" : "filled", markers.positions[i]);
  }
}

void add(KeyBuilder& key, const motion::Clip& clip) {
  key.add("clip", clip.name)
      .add("fps", clip.frames_per_second)
      .add("loops", std::int64_t{clip.loops});
  add(key, "displacement", clip.cycle_displacement);
  add(key, clip.body);
  for (const motion::Pose& pose : clip.poses) {
    add(key, "root", pose.root_position);
    for (const motion::Quat& rotation : pose.rotations) add(key, "r", rotation);
    for (const motion::Vec3& offset : pose.offsets) add(key, "o", offset);
    for (const motion::Quat& finger : pose.fingers) add(key, "f", finger);
  }
  if (const motion::Markers* markers = motion::markers_of(clip)) add(key, *markers);
}

void add(KeyBuilder& key, std::string_view name, const NamedValues& values) {
  for (const auto& [parameter, value] : values) key.add(name, parameter).add("value", value);
}

Hash digest_of(const Synthesis& synthesis, const motion::Clip& shown) {
  KeyBuilder key;
  key.add("name", synthesis.motion.name);
  add(key, synthesis.motion.clip);
  for (const double keytime : synthesis.motion.keytimes) key.add("keytime", keytime);
  for (const double weight : synthesis.weights) key.add("weight", weight);
  if (synthesis.expected_error_m) key.add("expected error", *synthesis.expected_error_m);
  add(key, "asked", synthesis.requested);
  add(key, "reached", synthesis.reached);
  add(key, "held", synthesis.held);
  add(key, "held reached", synthesis.held_reached);
  key.add("drift", synthesis.planted_drift_m);
  for (const std::string& warning : synthesis.warnings) key.add("warning", warning);
  for (const std::string& note : synthesis.notes) key.add("note", note);
  key.add("modified", synthesis.modified).add("share", synthesis.modified_share);
  for (const motion::Finding& finding : synthesis.findings) {
    key.add("check", finding.check)
        .add("joint", finding.joint)
        .add("first", std::int64_t{finding.first})
        .add("last", std::int64_t{finding.last})
        .add("measured", finding.measured)
        .add("severity", motion::name_of(finding.severity));
  }
  add(key, shown);
  return key.key();
}

}  // namespace

Hash digest_of(const motion::Clip& clip) {
  KeyBuilder key;
  add(key, clip);
  return key.key();
}

std::string motion_record(const Synthesis& synthesis, const motion::Clip& shown) {
  const nlohmann::ordered_json record = {{"digest", digest_of(synthesis, shown)},
                                         {"shown_frames", shown.frame_count()},
                                         {"warnings", synthesis.warnings}};
  return record.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

MotionRecord parse_motion_record(const std::string& json) {
  try {
    const nlohmann::json record = nlohmann::json::parse(json);
    return {record.at("digest"), record.at("shown_frames"), record.at("warnings")};
  } catch (const nlohmann::json::exception&) {
    throw std::runtime_error("a motion record is damaged");
  }
}

}  // namespace mien::pipeline
