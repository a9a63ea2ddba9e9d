#include "motion/live/live_bundle.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "motion/error.h"
#include "motion/live/bytes.h"
#include "motion/skeleton/body.h"

namespace mien::motion {

namespace {

constexpr std::size_t most_examples = 1000;
constexpr double longest_metres = 1000.0;

bool is_between(double value, double least, double most) { return value >= least && value <= most; }

bool is_near(const Vec3& v) { return v.cwiseAbs().maxCoeff() <= longest_metres; }

bool is_sound(const Skeleton& body) {
  return is_well_formed(body) && is_body(body) &&
         std::all_of(body.joints.begin(), body.joints.end(), [](const Joint& joint) {
           return is_near(joint.offset) && (!joint.tip || is_near(*joint.tip));
         });
}

bool ascend(const std::vector<double>& times) {
  for (std::size_t k = 1; k < times.size(); ++k) {
    if (!(times[k] > times[k - 1])) return false;
  }
  return true;
}

bool is_sound(const Example& example) {
  const Clip& clip = example.clip;
  if (!is_sound(clip.body) || !is_between(clip.frames_per_second, 1.0, 1000.0)) return false;
  if (clip.poses.size() < 2 || !is_near(clip.cycle_displacement)) return false;
  for (const Pose& pose : clip.poses) {
    if (pose.rotations.size() != clip.body.joints.size() || !is_near(pose.root_position)) {
      return false;
    }
  }
  const std::vector<double>& keytimes = example.keytimes;
  return keytimes.size() >= 2 && ascend(keytimes) && keytimes.front() == 0.0 &&
         std::abs(keytimes.back() - clip.duration_seconds()) < 1e-6;
}

bool is_sound(const ParameterTable& table, std::size_t examples) {
  return static_cast<std::size_t>(table.values.rows()) == table.names.size() &&
         (table.names.empty() || static_cast<std::size_t>(table.values.cols()) == examples) &&
         (table.values.size() == 0 || table.values.cwiseAbs().maxCoeff() <= 1e6);
}

bool is_sound(const InterpolationOptions& options) {
  const bool ways = is_between(options.nearest.neighbours, 0, 1000) &&
                    is_between(options.nearest.trials, 0, 10000) &&
                    is_between(options.nearest.least_distance, 0.0, 1.0) &&
                    is_between(options.power, 1e-6, 100.0) &&
                    is_between(options.grid_cells, 1, 64) &&
                    is_between(options.click_step, 1e-6, 100.0);
  return ways && is_between(options.kriging.nugget, 0.0, 1.0) &&
         is_between(options.pca.noise, 1e-9, 100.0) &&
         is_between(options.pca.variance_share, 1e-6, 1.0) &&
         is_between(options.pca.ridge, 0.0, 100.0) && is_between(options.pca.samples, 2, 1000);
}

bool is_sound(const Playback& playback) { return is_between(playback.cycles, 1, 1000); }

bool is_sound(const LiveTarget& target) {
  return is_sound(target.motion) && is_sound(target.playback) && target.shown_frames >= 0;
}

bool are_alike(const Example& a, const Example& b) {
  return a.keytimes.size() == b.keytimes.size() && a.clip.loops == b.clip.loops;
}

bool are_features(const std::vector<std::string>& names) {
  const std::vector<std::string> known = feature_parameter_names();
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return std::find(known.begin(), known.end(), name) != known.end();
  });
}

bool is_sound(const ModificationDimension& dimension) {
  try {
    check(dimension.recipe);
  } catch (const Error&) {
    return false;
  }
  constexpr double most = 1000.0;
  return dimension.low < dimension.high && is_between(dimension.low, -most, most) &&
         is_between(dimension.high, -most, most);
}

bool is_sound(const LiveModification& by, const std::vector<Example>& examples) {
  if (by.empty()) return true;
  const bool is_known = std::any_of(examples.begin(), examples.end(), [&](const Example& example) {
    return example.name == by.original;
  });
  return is_known && std::all_of(by.dimensions.begin(), by.dimensions.end(),
                                 [](const auto& dimension) { return is_sound(dimension); });
}

/// Whether motions can be made of what was read: what the code that makes them takes for granted
/// holds.
bool is_usable(const LiveBundle& bundle) {
  const std::vector<Example>& examples = bundle.examples.examples;
  if (examples.empty() || examples.size() > most_examples) return false;
  const bool sound_examples =
      std::all_of(examples.begin(), examples.end(), [&](const Example& example) {
        return is_sound(example) && are_alike(example, examples.front());
      });
  const bool sound_targets = std::all_of(bundle.targets.begin(), bundle.targets.end(),
                                         [](const LiveTarget& target) { return is_sound(target); });
  return sound_examples && sound_targets && is_sound(bundle.adjectives, examples.size()) &&
         is_sound(bundle.features, examples.size()) && are_features(bundle.features.names) &&
         is_sound(bundle.how.weights) && is_between(bundle.frames_per_second, 1.0, 1000.0) &&
         is_sound(bundle.playback) && is_sound(bundle.modification, examples);
}

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

/// All parts except the body.
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
void playback_parts(Bytes& bytes, S& playback) {
  bytes.whole(playback.cycles);
  bytes.flag(playback.in_place);
}

template <class Bytes, class T>
void target_parts(Bytes& bytes, T& target) {
  bytes.text(target.name);
  skeleton_parts(bytes, target.motion.clip.body);
  example_parts(bytes, target.motion);
  bytes.vector(target.weights);
  playback_parts(bytes, target.playback);
  bytes.whole(target.shown_frames);
}

template <class Bytes, class M>
void live_modification_parts(Bytes& bytes, M& modification) {
  bytes.text(modification.original);
  bytes.list(modification.dimensions, 200, [&](auto& dimension) {
    bytes.text(dimension.name);
    bytes.choice(dimension.value, 5);
    modification_parts(bytes, dimension.recipe);
    bytes.choice(dimension.unit, static_cast<int>(posture_units().size()));
    bytes.number(dimension.low);
    bytes.number(dimension.high);
  });
}

/// All parts except the modification, which not all bundles have, and the examples' body, which is
/// stored once.
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
  playback_parts(bytes, bundle.playback);
  bytes.list(bundle.targets, 64, [&](auto& target) { target_parts(bytes, target); });
}

}  // namespace

std::string to_bytes(const LiveBundle& bundle) {
  ByteWriter body;
  skeleton_parts(body, bundle.examples.examples.front().clip.body);
  bundle_parts(body, bundle);
  if (!bundle.modification.empty()) live_modification_parts(body, bundle.modification);
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
                "export them with the same version of mien as the page");
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
  if (reader.remaining() > 0) {
    live_modification_parts(reader, bundle.modification);
    if (bundle.modification.empty() || reader.remaining() > 0) ByteReader::refuse();
  }
  for (Example& example : bundle.examples.examples) example.clip.body = skeleton;
  if (!is_usable(bundle)) ByteReader::refuse();
  return bundle;
}

}  // namespace mien::motion
