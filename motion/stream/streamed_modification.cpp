#include "motion/stream/streamed_modification.h"

#include <cassert>
#include <cmath>
#include <cstdio>

#include "motion/error.h"

namespace mien::motion {

namespace {

/// After so long the smoothing at 4 Hz has forgotten what was, to 1e-12.
constexpr double remembered_seconds = 2.0;

constexpr size_t most_bands = 12;

bool changes_paths(const Modification& modification) {
  return modification.gains.has_value() || modification.paths != 1.0;
}

bool changes_posture(const Modification& modification) {
  return !modification.posture.empty() || modification.pose_difference.has_value();
}

Error tempo_refused(const Tempo& tempo) {
  if (!tempo.curve.empty()) {
    return Error("a curve of tempos cannot be streamed: its moments are shares of the whole motion",
                 "omit the tempo (--leave-out tempo), or modify the whole motion after recording");
  }
  char wrong[120];
  std::snprintf(wrong, sizeof wrong,
                tempo.factor < 1.0
                    ? "tempo %g cannot be streamed: the motion would fall behind without limit"
                    : "tempo %g cannot be streamed: it would need future frames",
                tempo.factor);
  return Error(wrong,
               "omit the tempo (--leave-out tempo), or modify the whole motion after recording");
}

}  // namespace

PostureStream::PostureStream(const Modification& modification, const Skeleton& body,
                             double frames_per_second, int look_ahead)
    : changes_(modification.posture),
      difference_(modification.pose_difference),
      fade_(body),
      frames_per_second_(frames_per_second),
      look_ahead_(look_ahead) {}

std::optional<Pose> PostureStream::push(Pose pose) {
  strengths_.push_back(fade_(pose));
  waiting_.push_back(std::move(pose));
  if (waiting_.size() <= static_cast<size_t>(look_ahead_)) return std::nullopt;
  return next();
}

std::vector<Pose> PostureStream::finish() {
  std::vector<Pose> rest;
  while (!waiting_.empty()) rest.push_back(next());
  return rest;
}

Pose PostureStream::next() {
  const size_t now = strengths_.size() - waiting_.size();
  const std::vector<LimbStrengths> known(strengths_.begin(), strengths_.end());
  Pose pose = std::move(waiting_.front());
  waiting_.pop_front();
  apply_posture(pose, changes_, difference_,
                smooth_strengths(known, frames_per_second_, SignalEnds::open)[now]);
  const auto remembered = static_cast<size_t>(std::ceil(remembered_seconds * frames_per_second_));
  if (now >= remembered) strengths_.pop_front();
  return pose;
}

void check_streamable(const Modification& m) {
  check(m);
  if (!is_unit(m.tempo)) throw tempo_refused(m.tempo);
  if (!is_unit(m.stiffness) || m.weight != 1.0) {
    throw Error("stiffness and weight cannot be streamed: slack limbs follow the finished motion",
                "omit them (--leave-out stiffness), or modify the whole motion after recording");
  }
  if (m.variation != 0.0) {
    throw Error(
        "variation cannot be streamed: its curves span the whole motion",
        "omit the variation (--leave-out variation), or modify the whole motion after recording");
  }
  if (!is_identity(m.relative) || !is_identity(m.gesture)) {
    throw Error(
        "changes in the actor's own terms (range, swing, sway, steps, gesture) cannot be streamed: "
        "they are worked out from the whole motion",
        "omit them (--leave-out relative), or use the recipes builtin@0.2, which have none");
  }
  if (m.acceleration != 0.0 && m.acceleration_place != AccelerationPlace::pauses) {
    throw Error(
        "acceleration at contacts or hits cannot be streamed: these are detected in the whole "
        "motion",
        "accelerate at pauses (acceleration_at: pauses), or omit it (--leave-out acceleration)");
  }
  if (!changes_paths(m)) return;
  if (m.signal == RotationSignal::quaternions) {
    throw Error("paths by quaternions cannot be streamed: they need the mean of the whole motion",
                "use the signal direction-vectors");
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
