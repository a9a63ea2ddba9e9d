#include "motion/stream/streamed_modification.h"

#include <cassert>
#include <cstdio>

#include "motion/error.h"

namespace mien::motion {

namespace {

constexpr size_t most_bands = 12;

bool changes_paths(const Modification& modification) {
  return modification.gains.has_value() || modification.paths != 1.0;
}

bool changes_posture(const Modification& modification) {
  return !modification.posture.empty() || modification.pose_difference.has_value();
}

Error tempo_refused(double tempo) {
  char wrong[120];
  std::snprintf(wrong, sizeof wrong,
                tempo < 1.0 ? "tempo %g cannot be streamed: the motion would fall behind for ever"
                            : "tempo %g cannot be streamed: it would show what has not come yet",
                tempo);
  return Error(wrong,
               "leave the tempo out (--leave-out tempo), or modify the whole motion once it has "
               "been recorded");
}

}  // namespace

void check_streamable(const Modification& m) {
  check(m);
  if (m.tempo != 1.0) throw tempo_refused(m.tempo);
  if (m.variation != 0.0) {
    throw Error("variation cannot be streamed: its curves run over the whole motion",
                "leave the variation out (--leave-out variation), or modify the whole motion once "
                "it has been recorded");
  }
  if (m.acceleration != 0.0 && m.acceleration_place == AccelerationPlace::contacts) {
    throw Error(
        "acceleration at contacts cannot be streamed: contacts are found on the whole motion",
        "accelerate at pauses (acceleration_at: pauses)");
  }
  if (!changes_paths(m)) return;
  if (m.signal == RotationSignal::quaternions) {
    throw Error("paths by quaternions cannot be streamed: they need the mean of the whole motion",
                "let the signal be direction-vectors");
  }
  if (m.gains && m.gains->bands.size() > most_bands) {
    throw Error("gains of " + std::to_string(m.gains->bands.size()) + " bands cannot be streamed",
                "give those of at most " + std::to_string(most_bands) + " bands");
  }
}

StreamedModification::StreamedModification(const Skeleton& body, double frames_per_second,
                                           const Modification& modification,
                                           const StreamDelay& delay, PathScope scope) {
  check_streamable(modification);
  if (!is_body(body)) {
    throw Error("the stream does not move the canonical body", "map it to the body first");
  }
  if (is_identity(modification)) return;
  limits_ = modification.soft_joint_limits;
  if (changes_paths(modification)) {
    delay_.paths = delay.paths;
    PathMix mix = path_mix(modification);
    mix.legs = scope == PathScope::body;
    paths_.emplace(mix, frames_per_second, delay.paths);
  }
  if (modification.acceleration != 0.0) {
    delay_.timing = delay.timing;
    timing_.emplace(modification, body, frames_per_second, delay.timing);
  }
  if (changes_posture(modification)) {
    delay_.posture = delay.posture;
    posture_.emplace(modification, body, frames_per_second, delay.posture);
  }
}

void StreamedModification::expect(const Clip& known) {
  for (const Pose& pose : known.poses) widen(extremes_, pose);
}

std::optional<Pose> StreamedModification::push(const Pose& pose) {
  assert(pose.rotations.size() == body_joint_count);
  if (limits_) widen(extremes_, pose);
  return through_timing(paths_ ? paths_->push(pose) : pose);
}

std::optional<Pose> StreamedModification::through_timing(std::optional<Pose> pose) {
  if (pose && timing_) pose = timing_->push(*pose);
  return through_posture(std::move(pose));
}

std::optional<Pose> StreamedModification::through_posture(std::optional<Pose> pose) {
  if (pose && posture_) pose = posture_->push(std::move(*pose));
  if (!pose) return std::nullopt;
  return limited(std::move(*pose));
}

Pose StreamedModification::limited(Pose pose) const {
  if (limits_) limit_softly(pose, extremes_);
  return pose;
}

std::vector<Pose> StreamedModification::finish() {
  std::vector<Pose> rest;
  const auto give = [&](std::optional<Pose> pose) {
    if (pose) rest.push_back(std::move(*pose));
  };
  if (paths_) {
    for (const Pose& pose : paths_->finish()) give(through_timing(pose));
  }
  if (timing_) {
    for (const Pose& pose : timing_->finish()) give(through_posture(pose));
  }
  if (posture_) {
    for (Pose& pose : posture_->finish()) rest.push_back(limited(std::move(pose)));
  }
  return rest;
}

Clip streamed(const Clip& clip, const Modification& modification, const StreamDelay& delay,
              PathScope scope) {
  StreamedModification stream(clip.body, clip.frames_per_second, modification, delay, scope);
  Clip result = clip;
  result.poses.clear();
  for (const Pose& pose : clip.poses) {
    if (std::optional<Pose> given = stream.push(pose)) result.poses.push_back(std::move(*given));
  }
  for (Pose& pose : stream.finish()) result.poses.push_back(std::move(pose));
  return result;
}

}  // namespace mien::motion
