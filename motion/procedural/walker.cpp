#include "motion/procedural/walker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "motion/error.h"
#include "motion/math/rotation.h"
#include "motion/procedural/leg_cycle.h"
#include "motion/procedural/upper_body.h"
#include "motion/procedural/walker_legs.h"

namespace mien::motion {

namespace {

struct Walker {
  PelvisPath pelvis;
  std::array<LegCycle, 2> legs;  ///< left, right
};

std::string rounded(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

void require(bool holds, std::string_view wrong, std::string_view remedy) {
  if (!holds) throw Error(wrong, remedy);
}

void check(const WalkStyle& style, double frames_per_second) {
  require(frames_per_second > 0.0, "the frame rate of a walk is not positive", "give it in 1/s");
  require(style.speed_m_s > 0.0 && style.cadence_steps_min > 0.0,
          "speed or cadence of a walk is not positive", "give them in m/s and steps/min");
  require(style.stance_share > 0.5 && style.stance_share < 0.85,
          "stance_share " + rounded(style.stance_share) + " leaves no walk",
          "choose it above 0.5 and below 0.85");
  require(style.heel_strike_deg >= 0.0 && style.toe_off_deg >= 0.0,
          "a walk's heel_strike_deg or toe_off_deg is negative", "use 0 for a flat foot");
}

Walker make_walker(const WalkStyle& style, double cycle_seconds, const Skeleton& body) {
  PelvisPath pelvis;
  pelvis.style = style;
  pelvis.stride_m = style.speed_m_s * cycle_seconds;
  Walker walker;
  walker.legs = {make_leg(body, pelvis, true), make_leg(body, pelvis, false)};
  fit_stance(walker.legs);
  for (LegCycle& leg : walker.legs) leg = fit_swing(leg);
  walker.pelvis = walker.legs[0].pelvis;
  return walker;
}

Pose pose_of(const Walker& walker, double phase, const Skeleton& body) {
  Pose pose;
  pose.rotations.assign(body_joint_count, Quat::Identity());
  pose.root_position = pelvis_position(walker.pelvis, phase);
  pose.rotations[Pelvis] = pelvis_rotation(walker.pelvis, phase);
  set_upper_body(walker.pelvis.style, phase, pose.rotations[Pelvis], pose);
  for (const LegCycle& leg : walker.legs) set_leg(leg, foot_at(leg, phase), body, pose);
  for (Quat& rotation : pose.rotations) {
    rotation = in_hemisphere_of(Quat::Identity(), rotation.normalized());
  }
  return pose;
}

/// Phase between `from` and `to` at which the swinging ankle overtakes the standing one.
double passing_phase(const LegCycle& standing, const LegCycle& swinging, double from, double to) {
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (from + to);
    const bool behind = foot_at(swinging, middle).ankle.z() < foot_at(standing, middle).ankle.z();
    (behind ? from : to) = middle;
  }
  return 0.5 * (from + to);
}

std::vector<double> keytimes(const Walker& walker, double cycle_seconds) {
  const double stance = walker.pelvis.style.stance_share;
  const auto& [left, right] = walker.legs;
  const std::array<double, 7> phases = {
      0.0, stance - 0.5, passing_phase(left, right, stance - 0.5, 0.5),
      0.5, stance,       passing_phase(right, left, stance, 1.0),
      1.0};
  std::vector<double> seconds;
  for (const double phase : phases) seconds.push_back(phase * cycle_seconds);
  return seconds;
}

}  // namespace

Example walk(const WalkStyle& style, double frames_per_second, const Skeleton& body) {
  check(style, frames_per_second);
  const double cycle_wanted = 120.0 / style.cadence_steps_min;
  const int frames = std::max(8, static_cast<int>(std::lround(cycle_wanted * frames_per_second)));
  const double cycle_seconds = frames / frames_per_second;
  WalkStyle own = scaled_to(body, style);
  own.speed_m_s *= cycle_wanted / cycle_seconds;
  const Walker walker = make_walker(own, cycle_seconds, body);

  Example example;
  example.clip.body = body;
  example.clip.frames_per_second = frames_per_second;
  example.clip.loops = true;
  example.clip.cycle_displacement = Vec3(0, 0, walker.pelvis.stride_m);
  const double start = pelvis_position(walker.pelvis, 0.0).z();
  for (int i = 0; i < frames; ++i) {
    Pose pose = pose_of(walker, static_cast<double>(i) / frames, body);
    pose.root_position.z() -= start;
    example.clip.poses.push_back(std::move(pose));
  }
  example.keytimes = keytimes(walker, cycle_seconds);
  return example;
}

}  // namespace mien::motion
