#include "motion/skeleton/clip_markers.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "motion/math/cubic_spline.h"

namespace mien::motion {

namespace {

/// A digest of numbers, in which every bit of each affects every bit (SplitMix64's mixing, Steele,
/// Lea & Flood 2014).
struct Digest {
  std::uint64_t value = 0;

  void add(std::uint64_t bits) {
    value += 0x9e3779b97f4a7c15ull;
    value ^= bits;
    value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ull;
    value = (value ^ (value >> 27)) * 0x94d049bb133111ebull;
    value ^= value >> 31;
  }
  void add(double number) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);  // Emscripten's library has no std::bit_cast yet
    add(bits);
  }
  void add(const Vec3& vector) {
    for (const double number : vector) add(number);
  }
};

/// Changes with anything that moves a joint.
std::uint64_t motion_key(const Clip& clip) {
  Digest digest;
  digest.add(clip.frames_per_second);
  digest.add(std::uint64_t{clip.loops});
  digest.add(clip.cycle_displacement);
  for (const Joint& joint : clip.body.joints) digest.add(joint.offset);
  digest.add(std::uint64_t{clip.poses.size()});
  for (const Pose& pose : clip.poses) {
    digest.add(pose.root_position);
    for (const Quat& rotation : pose.rotations) {
      for (const double number : rotation.coeffs()) digest.add(number);
    }
    for (const Vec3& offset : pose.offsets) digest.add(offset);
  }
  return digest.value;
}

/// A position, and how it is known.
struct Sighting {
  Vec3 position = Vec3::Zero();
  bool seen = false;
  bool known = false;
};

/// The markers of the endless motion: loops go on, others stay at their ends.
struct Timeline {
  const Clip& clip;
  const Markers& markers;

  Sighting at(long frame, int point) const {
    const long count = clip.frame_count();
    long cycle = 0;
    if (clip.loops) {
      cycle = frame >= 0 ? frame / count : -((-frame + count - 1) / count);
    } else {
      frame = std::clamp(frame, 0L, count - 1);
    }
    const std::size_t index = markers.at(static_cast<int>(frame - cycle * count), point);
    if (!markers.is_known(index)) return {};
    return {markers.positions[index] + static_cast<double>(cycle) * clip.cycle_displacement,
            markers.seen[index], true};
  }
};

Sighting between(const Timeline& timeline, double frame, int point) {
  const double whole = std::floor(frame);
  const auto index = static_cast<long>(whole);
  const double t = frame - whole;
  const Sighting from = timeline.at(index, point);
  if (t == 0.0) return from;
  const Sighting to = timeline.at(index + 1, point);
  if (!from.known || !to.known) return {};
  const Sighting before = timeline.at(index - 1, point);
  const Sighting after = timeline.at(index + 2, point);
  // Beside a gap the path goes on straight.
  const Vec3 earlier = before.known ? before.position : 2.0 * from.position - to.position;
  const Vec3 later = after.known ? after.position : 2.0 * to.position - from.position;
  return {catmull_rom(earlier, from.position, to.position, later, t), from.seen && to.seen, true};
}

}  // namespace

const Markers* markers_of(const Clip& clip) {
  if (!clip.markers || clip.markers->motion_key != motion_key(clip)) return nullptr;
  return &*clip.markers;
}

void attach(Clip& clip, Markers markers) {
  assert(markers.frame_count() == clip.frame_count() &&
         markers.seen.size() == markers.positions.size() &&
         markers.filled.size() == markers.positions.size());
  markers.motion_key = motion_key(clip);
  clip.markers = std::move(markers);
}

void carry_markers_at(const Clip& clip, Clip& changed, std::span<const double> frames) {
  const Markers* own = markers_of(clip);
  if (own == nullptr || static_cast<std::size_t>(changed.frame_count()) != frames.size()) return;
  const Timeline timeline{clip, *own};
  Markers sampled;
  sampled.points = own->points;
  sampled.positions.reserve(frames.size() * own->points.size());
  for (const double frame : frames) {
    for (int point = 0; point < own->point_count(); ++point) {
      const Sighting one = between(timeline, frame, point);
      sampled.positions.push_back(one.position);
      sampled.seen.push_back(one.seen);
      sampled.filled.push_back(one.known && !one.seen);
    }
  }
  attach(changed, std::move(sampled));
}

Clip clip_of_markers(const std::string& name, double frames_per_second, const Markers& markers) {
  Clip clip;
  clip.name = name;
  clip.frames_per_second = frames_per_second;
  clip.body.joints.emplace_back();
  clip.body.joints.front().name = "Markers";
  Pose pose;
  pose.rotations.assign(1, Quat::Identity());
  clip.poses.assign(static_cast<std::size_t>(markers.frame_count()), pose);
  int known_points = 0;
  for (int point = 0; point < markers.point_count(); ++point) {
    std::vector<Vec3> path;
    std::vector<bool> known;
    for (int frame = 0; frame < markers.frame_count(); ++frame) {
      path.push_back(markers.positions[markers.at(frame, point)]);
      known.push_back(markers.is_known(markers.at(frame, point)));
    }
    if (std::find(known.begin(), known.end(), true) == known.end()) continue;
    ++known_points;
    path = bridged(std::move(path), known);
    for (std::size_t f = 0; f < path.size(); ++f) clip.poses[f].root_position += path[f];
  }
  for (Pose& one : clip.poses) one.root_position /= std::max(known_points, 1);
  attach(clip, markers);
  return clip;
}

}  // namespace mien::motion
