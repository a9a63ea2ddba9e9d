#include "motion/formats/gltf/gltf_track.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "motion/formats/gltf/gltf_accessor.h"
#include "motion/formats/reading/frame_rate.h"
#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

using Part = GltfTrack::Part;
using Interpolation = GltfTrack::Interpolation;

std::optional<Part> part_of(const std::string& path) {
  if (path == "translation") return Part::translation;
  if (path == "rotation") return Part::rotation;
  if (path == "scale") return Part::scale;
  return std::nullopt;
}

size_t width_of(const GltfTrack& track) { return track.part == Part::rotation ? 4 : 3; }

size_t numbers_per_key(const GltfTrack& track) {
  return width_of(track) * (track.interpolation == Interpolation::cubic_spline ? 3 : 1);
}

Interpolation interpolation_of(const GltfFile& file, const std::string& name) {
  if (name.empty() || name == "LINEAR") return Interpolation::linear;
  if (name == "STEP") return Interpolation::step;
  if (name == "CUBICSPLINE") return Interpolation::cubic_spline;
  refuse(file, "an interpolation that glTF does not know", get_it_again);
}

/// First of the numbers of a key's value.
const double* value_at(const GltfTrack& track, size_t key) {
  const double* numbers = track.numbers.data() + key * numbers_per_key(track);
  return track.interpolation == Interpolation::cubic_spline ? numbers + width_of(track) : numbers;
}

void require_good_times(const GltfFile& file, const GltfTrack& track) {
  if (track.times.empty() || track.times.front() < 0.0) {
    refuse(file, "a track has no keys or begins before zero", get_it_again);
  }
  if (std::adjacent_find(track.times.begin(), track.times.end(), std::greater_equal<>()) !=
      track.times.end()) {
    refuse(file, "the key times of a track do not increase", get_it_again);
  }
}

void require_good_values(const GltfFile& file, const GltfTrack& track) {
  for (const double number : track.numbers) {
    if (std::abs(number) > 1e12) refuse(file, "the value of a key is too large", get_it_again);
  }
  if (track.part != Part::rotation) return;
  for (size_t key = 0; key < track.times.size(); ++key) {
    if (!(Quat(value_at(track, key)).norm() > 1e-6)) {
      refuse(file, "a key is a rotation of length zero", get_it_again);
    }
  }
}

GltfTrack parse_track(const GltfFile& file, const tinygltf::Animation& animation,
                      const tinygltf::AnimationChannel& channel, Part part) {
  const int index = channel.sampler;
  if (index < 0 || static_cast<size_t>(index) >= animation.samplers.size()) {
    refuse(file, "a track has no sampler", get_it_again);
  }
  if (static_cast<size_t>(channel.target_node) >= file.model.nodes.size()) {
    refuse(file, "a track moves a node that does not exist", get_it_again);
  }
  const tinygltf::AnimationSampler& sampler = animation.samplers[static_cast<size_t>(index)];
  GltfTrack track;
  track.node = channel.target_node;
  track.part = part;
  track.interpolation = interpolation_of(file, sampler.interpolation);
  track.times = accessor_numbers(file, sampler.input, 1, "key times");
  require_good_times(file, track);
  const size_t elements = accessor_count(file, sampler.output, "keys");
  if (elements != track.times.size() * numbers_per_key(track) / width_of(track)) {
    refuse(file, "a track has more or fewer values than key times", get_it_again);
  }
  track.numbers = accessor_numbers(file, sampler.output, width_of(track), "keys");
  require_good_values(file, track);
  return track;
}

std::vector<GltfTrack> parse_tracks_of(const GltfFile& file, const tinygltf::Animation& animation) {
  std::vector<GltfTrack> tracks;
  std::set<std::pair<int, Part>> moved;
  for (const tinygltf::AnimationChannel& channel : animation.channels) {
    const std::optional<Part> part = part_of(channel.target_path);
    if (!part || channel.target_node < 0) continue;
    if (!moved.emplace(channel.target_node, *part).second) {
      refuse(file, "two tracks move the same part of a node", get_it_again);
    }
    tracks.push_back(parse_track(file, animation, channel, *part));
  }
  return tracks;
}

void put(const GltfTrack& track, const Eigen::Vector4d& value, NodeTransform& transform) {
  if (track.part == Part::translation) transform.translation = value.head<3>();
  if (track.part == Part::scale) transform.scale = value.head<3>();
  if (track.part == Part::rotation) transform.rotation = Quat(value.data()).normalized();
}

Eigen::Vector4d vector_of(const double* numbers, size_t width) {
  return {numbers[0], numbers[1], numbers[2], width == 4 ? numbers[3] : 0.0};
}

Eigen::Vector4d spline(const GltfTrack& track, size_t key, double t, double seconds) {
  const size_t width = width_of(track);
  const auto part = [&](size_t of_key, size_t which) {
    return vector_of(track.numbers.data() + (of_key * 3 + which) * width, width);
  };
  const double t2 = t * t;
  const double t3 = t2 * t;
  const Eigen::Vector4d value =
      (2 * t3 - 3 * t2 + 1) * part(key, 1) + seconds * (t3 - 2 * t2 + t) * part(key, 2) +
      (-2 * t3 + 3 * t2) * part(key + 1, 1) + seconds * (t3 - t2) * part(key + 1, 0);
  // A rotation that passes through zero has no direction there.
  const bool vanishes = track.part == Part::rotation && !(value.norm() > 1e-9);
  return vanishes ? part(t < 0.5 ? key : key + 1, 1) : value;
}

/// Limits of the frame rate, as for BVH frame times.
constexpr double slowest_frame_rate = 0.49;
constexpr double fastest_frame_rate = 1e5;

/// Whether the keys are frames of a recording.
bool is_sampled(const std::vector<GltfTrack>& tracks) {
  constexpr size_t fewest_keys = 8;
  return tracks.front().times.size() >= fewest_keys &&
         std::ranges::all_of(tracks, [&](const GltfTrack& track) {
           return track.interpolation != Interpolation::cubic_spline &&
                  track.times == tracks.front().times;
         });
}

bool evenly_spaced(const std::vector<double>& times, double step) {
  for (size_t i = 0; i < times.size(); ++i) {
    const double expected = times.front() + step * static_cast<double>(i);
    // Key times are 32-bit floats, often rounded further.
    if (std::abs(times[i] - expected) > 0.02 * step + 1e-6 * std::abs(expected)) return false;
  }
  return true;
}

}  // namespace

std::vector<GltfTake> gltf_takes(const GltfFile& file) {
  std::vector<GltfTake> takes;
  std::set<std::string> names;
  for (size_t a = 0; a < file.model.animations.size(); ++a) {
    const tinygltf::Animation& animation = file.model.animations[a];
    const bool moves = std::ranges::any_of(animation.channels, [](const auto& channel) {
      return part_of(channel.target_path) && channel.target_node >= 0;
    });
    if (!moves) continue;
    const std::string own =
        animation.name.empty() ? "take " + std::to_string(a + 1) : animation.name;
    std::string name = own;
    for (int number = 2; !names.insert(name).second; ++number) {
      name = own + " " + std::to_string(number);
    }
    takes.push_back({static_cast<int>(a), name});
  }
  return takes;
}

std::vector<GltfTrack> parse_tracks(const GltfFile& file, int animation) {
  return parse_tracks_of(file, file.model.animations[static_cast<size_t>(animation)]);
}

double stated_frame_rate(const GltfFile& file, int animation) {
  const tinygltf::Value& extras = file.model.animations[static_cast<size_t>(animation)].extras;
  if (!extras.IsObject() || !extras.Has(gltf_rate_key)) return 0.0;
  const tinygltf::Value& rate = extras.Get(gltf_rate_key);
  const double stated = rate.IsNumber() ? rate.GetNumberAsDouble() : 0.0;
  return stated >= slowest_frame_rate && stated <= fastest_frame_rate ? stated : 0.0;
}

void apply(const GltfTrack& track, double seconds, NodeTransform& transform) {
  const auto after = std::upper_bound(track.times.begin(), track.times.end(), seconds);
  const size_t width = width_of(track);
  const size_t key =
      after == track.times.begin() ? 0 : static_cast<size_t>(after - track.times.begin()) - 1;
  const bool at_end = after == track.times.begin() || after == track.times.end();
  if (at_end || track.interpolation == Interpolation::step) {
    return put(track, vector_of(value_at(track, key), width), transform);
  }
  const double length = track.times[key + 1] - track.times[key];
  const double t = (seconds - track.times[key]) / length;
  if (track.interpolation == Interpolation::cubic_spline) {
    return put(track, spline(track, key, t, length), transform);
  }
  if (track.part == Part::rotation) {
    transform.rotation = slerp(Quat(value_at(track, key)).normalized(),
                               Quat(value_at(track, key + 1)).normalized(), t);
    return;
  }
  const Eigen::Vector4d from = vector_of(value_at(track, key), width);
  put(track, from + t * (vector_of(value_at(track, key + 1), width) - from), transform);
}

TrackTiming timing_of(const std::vector<GltfTrack>& tracks, double stated) {
  TrackTiming timing{
      tracks.front().times.front(), tracks.front().times.back(), stated > 0.0 ? stated : 30.0, {}};
  const std::vector<double>* longest = &tracks.front().times;
  for (const GltfTrack& track : tracks) {
    timing.first = std::min(timing.first, track.times.front());
    timing.last = std::max(timing.last, track.times.back());
    if (track.times.size() > longest->size()) longest = &track.times;
  }
  if (longest->size() < 2) return timing;
  const double step =
      (longest->back() - longest->front()) / static_cast<double>(longest->size() - 1);
  const double rate = 1.0 / step;
  const bool is_stated = std::abs(rate - stated) < 1e-3 * rate;
  if (!(rate >= slowest_frame_rate && rate <= fastest_frame_rate && evenly_spaced(*longest, step)))
    return timing;
  if (rate < 9.99 && !is_stated && !is_sampled(tracks)) return timing;
  timing.frames_per_second = is_stated ? stated : snapped_frame_rate(rate);
  const bool spans_all =
      longest->front() - timing.first < 0.1 * step && timing.last - longest->back() < 0.1 * step;
  if (spans_all) timing.keys = *longest;
  return timing;
}

size_t frame_count(const TrackTiming& timing) {
  if (!timing.keys.empty()) return timing.keys.size();
  const double steps = (timing.last - timing.first) * timing.frames_per_second;
  return static_cast<size_t>(std::lround(steps)) + 1;
}

double seconds_of_frame(const TrackTiming& timing, size_t frame) {
  if (frame < timing.keys.size()) return timing.keys[frame];
  return timing.first + static_cast<double>(frame) / timing.frames_per_second;
}

}  // namespace mien::motion
