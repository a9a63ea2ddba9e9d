#include "motion/stream/posture_stream.h"

#include <cmath>

namespace mien::motion {

namespace {

/// After so long the smoothing at 4 Hz has forgotten what was, to 1e-12.
constexpr double remembered_seconds = 2.0;

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
  put_posture_on(pose, changes_, difference_,
                 smooth_strengths(known, frames_per_second_, SignalEnds::open)[now]);
  const auto remembered = static_cast<size_t>(std::ceil(remembered_seconds * frames_per_second_));
  if (now >= remembered) strengths_.pop_front();
  return pose;
}

}  // namespace mien::motion
