#include "motion/procedural/knock.h"

#include <cmath>
#include <vector>

#include "motion/error.h"
#include "motion/math/rotation.h"
#include "motion/modify/posture.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/two_bone_ik.h"

namespace mien::motion {

namespace {

/// Where the wrist is to be at a moment, resting there.
struct Station {
  double seconds;
  Vec3 place;
};

void refuse_nonsense(const KnockStyle& style, double frames_per_second) {
  if (style.knocks >= 1 && style.still_seconds > 0.0 && style.raise_seconds > 0.0 &&
      style.knock_seconds > 0.0 && frames_per_second > 0.0) {
    return;
  }
  throw Error("a knock needs at least one hit, and times and a frame rate above 0",
              "correct the style");
}

/// The share of the way gone at a share of the time, with the least jerk.
double minimum_jerk(double t) { return t * t * t * (10.0 + t * (6.0 * t - 15.0)); }

Vec3 place_at(const std::vector<Station>& stations, double seconds) {
  for (std::size_t i = 1; i < stations.size(); ++i) {
    if (seconds >= stations[i].seconds) continue;
    const Station& from = stations[i - 1];
    const double t = (seconds - from.seconds) / (stations[i].seconds - from.seconds);
    return from.place + minimum_jerk(t) * (stations[i].place - from.place);
  }
  return stations.back().place;
}

/// Start, rise, back and forth, down, end.
std::vector<Station> stations_of(const KnockStyle& style, const Vec3& rest, const Vec3& shoulder,
                                 double arm) {
  const Vec3 door = shoulder + arm * Vec3(0.12, style.height, style.reach);
  const Vec3 back = door - arm * Vec3(0.0, -0.25 * style.swing, style.swing);
  double now = style.still_seconds;
  std::vector<Station> stations = {{0.0, rest}, {now, rest}};
  stations.push_back({now += style.raise_seconds, back});
  for (int k = 0; k < style.knocks; ++k) {
    stations.push_back({now += 0.5 * style.knock_seconds, door});
    stations.push_back({now += 0.5 * style.knock_seconds, back});
  }
  stations.push_back({now += 1.2 * style.raise_seconds, rest});
  stations.push_back({now + style.still_seconds, rest});
  return stations;
}

/// The pose with the right wrist at a place.
Pose reaching(const Skeleton& body, const Pose& pose, const Vec3& place) {
  const JointTransforms world = world_transforms(body, pose);
  const TwoBoneLimb arm = {world.positions[RightShoulder], world.positions[RightElbow],
                           world.positions[RightWrist]};
  const TwoBoneSolution solved = solve_two_bone(arm, place, Vec3(-0.5, -0.8, -0.3).normalized());
  const Quat upper = solved.upper_turn * world.rotations[RightShoulder];
  const Quat lower = solved.lower_turn * world.rotations[RightElbow];
  Pose result = pose;
  result.rotations[RightShoulder] =
      (world.rotations[RightClavicle].conjugate() * upper).normalized();
  result.rotations[RightElbow] = (upper.conjugate() * lower).normalized();
  return result;
}

}  // namespace

KnockStyle sad_knock() {
  return {.raise_seconds = 1.3,
          .knock_seconds = 0.5,
          .height = -0.05,
          .reach = 0.6,
          .swing = 0.08,
          .head_flexion_deg = 26.0,
          .chest_flexion_deg = 10.0};
}

KnockStyle angry_knock() {
  return {.knocks = 4,
          .raise_seconds = 0.5,
          .knock_seconds = 0.22,
          .height = 0.2,
          .reach = 0.78,
          .swing = 0.28,
          .head_flexion_deg = 8.0,
          .chest_flexion_deg = 8.0};
}

Example knock(const KnockStyle& style, double frames_per_second, const Skeleton& body) {
  refuse_nonsense(style, frames_per_second);
  Example example = stand(standing_pose(body), frames_per_second, body);
  example.clip =
      with_posture(example.clip, {{PostureUnit::head_flexion, style.head_flexion_deg},
                                  {PostureUnit::chest_flexion, style.chest_flexion_deg}});
  const Pose pose = example.clip.poses.front();
  const std::vector<Vec3> places = world_positions(body, pose);
  const double arm = body.joints[RightElbow].offset.norm() + body.joints[RightWrist].offset.norm();
  const std::vector<Station> stations =
      stations_of(style, places[RightWrist], places[RightShoulder], arm);
  const int steps =
      static_cast<int>(std::lround(std::ceil(stations.back().seconds * frames_per_second)));
  example.clip.poses.clear();
  for (int f = 0; f <= steps; ++f) {
    example.clip.poses.push_back(reaching(body, pose, place_at(stations, f / frames_per_second)));
  }
  const double first_hit = stations[3].seconds;
  example.keytimes = {0.0, first_hit, first_hit + (style.knocks - 1) * style.knock_seconds,
                      example.clip.duration_seconds()};
  if (style.knocks == 1) example.keytimes.erase(example.keytimes.begin() + 2);
  return example;
}

Example stand(const Pose& pose, double frames_per_second, const Skeleton& body) {
  Example example;
  example.clip.body = body;
  example.clip.frames_per_second = frames_per_second;
  const auto frames = static_cast<std::size_t>(std::lround(frames_per_second)) + 1;
  example.clip.poses.assign(frames, pose);
  example.keytimes = {0.0, example.clip.duration_seconds()};
  return example;
}

}  // namespace mien::motion
