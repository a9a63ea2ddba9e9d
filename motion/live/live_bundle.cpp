#include "motion/live/live_bundle.h"

#include <cstdint>

#include "motion/error.h"
#include "motion/live/bytes.h"
#include "motion/live/live_bundle_check.h"

namespace mien::motion {

namespace {

constexpr std::string_view magic = "MIENLIVE";
constexpr std::size_t head_bytes = 8 + 4 + 4 + 8 + 8;

template <class Bytes, class S>
void skeleton_parts(Bytes& bytes, S& skeleton) {
  bytes.list(skeleton.joints, 36, [&](auto& joint) {
    bytes.text(joint.name);
    bytes.whole(joint.parent);
    bytes.vector(joint.offset);
    bytes.maybe(joint.tip, [&](auto& tip) { bytes.vector(tip); });
  });
}

/// But for its body.
template <class Bytes, class E>
void example_parts(Bytes& bytes, E& example) {
  bytes.text(example.name);
  auto& clip = example.clip;
  bytes.number(clip.frames_per_second);
  bytes.flag(clip.loops);
  bytes.vector(clip.cycle_displacement);
  bytes.numbers(example.keytimes);
  bytes.list(clip.poses, 24, [&](auto& pose) {
    bytes.vector(pose.root_position);
    bytes.list(pose.rotations, 32, [&](auto& rotation) { bytes.rotation(rotation); });
  });
}

template <class Bytes, class T>
void table_parts(Bytes& bytes, T& table) {
  bytes.list(table.names, 4, [&](auto& name) { bytes.text(name); });
  bytes.matrix(table.values);
  bytes.flag(table.simulated);
}

template <class Bytes, class O>
void weight_option_parts(Bytes& bytes, O& options) {
  bytes.choice(options.method, 9);
  bytes.whole(options.nearest.neighbours);
  bytes.whole(options.nearest.trials);
  bytes.number(options.nearest.least_distance);
  bytes.seed(options.nearest.seed);
  bytes.number(options.power);
  bytes.whole(options.grid_cells);
  bytes.choice(options.grid_source, 2);
  bytes.flag(options.kriging.linear_drift);
  bytes.number(options.kriging.nugget);
  bytes.choice(options.pca.estimate, 2);
  bytes.number(options.pca.noise);
  bytes.number(options.pca.variance_share);
  bytes.number(options.pca.ridge);
  bytes.whole(options.pca.samples);
  bytes.number(options.click_step);
}

template <class Bytes, class O>
void option_parts(Bytes& bytes, O& options) {
  weight_option_parts(bytes, options.weights);
  bytes.choice(options.rotations, 3);
  bytes.choice(options.time_warp, 2);
  bytes.flag(options.foot_lock);
}

template <class Bytes, class S>
void scale_parts(Bytes& bytes, S& scale) {
  for (auto& origin : scale.origin) bytes.number_or_nan(origin);
  for (auto& span : scale.span) bytes.number_or_nan(span);
  bytes.number(scale.of_constant);
}

template <class Bytes, class S>
void showing_parts(Bytes& bytes, S& showing) {
  bytes.whole(showing.cycles);
  bytes.flag(showing.in_place);
}

template <class Bytes, class T>
void target_parts(Bytes& bytes, T& target) {
  bytes.text(target.name);
  skeleton_parts(bytes, target.motion.clip.body);
  example_parts(bytes, target.motion);
  bytes.vector(target.weights);
  showing_parts(bytes, target.showing);
  bytes.whole(target.shown_frames);
}

/// But for the examples' body, which is there once.
template <class Bytes, class B>
void bundle_parts(Bytes& bytes, B& bundle) {
  bytes.text(bundle.info);
  bytes.text(bundle.examples.name);
  bytes.flag(bundle.examples.simulated);
  bytes.list(bundle.examples.examples, 64, [&](auto& example) { example_parts(bytes, example); });
  table_parts(bytes, bundle.adjectives);
  table_parts(bytes, bundle.features);
  scale_parts(bytes, bundle.feature_scale);
  option_parts(bytes, bundle.how);
  bytes.number(bundle.frames_per_second);
  showing_parts(bytes, bundle.showing);
  bytes.list(bundle.targets, 64, [&](auto& target) { target_parts(bytes, target); });
}

}  // namespace

std::string to_bytes(const LiveBundle& bundle) {
  ByteWriter body;
  skeleton_parts(body, bundle.examples.examples.front().clip.body);
  bundle_parts(body, bundle);
  ByteWriter head;
  head.whole(live_bundle_version);
  head.whole(0);
  head.put(static_cast<std::uint64_t>(body.bytes().size()));
  head.put(checksum(body.bytes()));
  return std::string(magic) + head.bytes() + body.bytes();
}

LiveBundle parse_live_bundle(std::string_view bytes) {
  if (bytes.size() < head_bytes || bytes.substr(0, magic.size()) != magic) ByteReader::refuse();
  ByteReader head(bytes.substr(magic.size(), head_bytes - magic.size()));
  int version = 0, reserved = 0;
  head.whole(version);
  head.whole(reserved);
  if (version != live_bundle_version) {
    throw Error("the motions for the browser are of version " + std::to_string(version) + " and " +
                    std::to_string(live_bundle_version) + " is read here",
                "export them with the same mien as the page");
  }
  const std::string_view body = bytes.substr(head_bytes);
  if (reserved != 0 || head.take<std::uint64_t>() != body.size() ||
      head.take<std::uint64_t>() != checksum(body)) {
    ByteReader::refuse();
  }
  ByteReader reader(body);
  LiveBundle bundle;
  Skeleton skeleton;
  skeleton_parts(reader, skeleton);
  bundle_parts(reader, bundle);
  if (reader.left() > 0) ByteReader::refuse();
  for (Example& example : bundle.examples.examples) example.clip.body = skeleton;
  if (!is_usable(bundle)) ByteReader::refuse();
  return bundle;
}

}  // namespace mien::motion
