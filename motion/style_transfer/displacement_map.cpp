#include "motion/style_transfer/displacement_map.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "motion/error.h"
#include "motion/math/cubic_spline.h"
#include "motion/math/rotation.h"
#include "motion/style_transfer/motion_curves.h"

namespace mien::motion {

namespace {

std::string in_milliseconds(double seconds) {
  return std::to_string(std::lround(1000.0 * seconds)) + " ms";
}

void require_window(const Clip& motion, const std::vector<DisplacementKey>& keys,
                    const DisplacementMapOptions& window) {
  const double length = window.end_seconds - window.start_seconds;
  const double duration = motion.duration_seconds();
  if (!(length > 0.0)) {
    throw Error("the window of a displacement map ends before it begins",
                "give an end later than the start");
  }
  const bool outside = window.start_seconds < 0.0 || window.end_seconds > duration + 1e-9;
  if (motion.loops ? length > duration + 1e-9 : outside) {
    throw Error("the window of a displacement map goes beyond the motion, which lasts " +
                    in_milliseconds(duration),
                "shorten the window");
  }
  for (const DisplacementKey& key : keys) {
    if (key.seconds <= window.start_seconds || key.seconds >= window.end_seconds) {
      throw Error("the displacement of " + std::string(name_of(key.joint)) + " at " +
                      in_milliseconds(key.seconds) + " is not inside its window",
                  "move the key, or widen the window");
    }
    if (key.joint != Pelvis && !key.shift.isZero(0.0)) {
      throw Error("the displacement of " + std::string(name_of(key.joint)) + " has a shift",
                  "shift the Pelvis; other joints can only be turned");
    }
  }
}

/// Turn and shift of one joint over the window.
CubicSpline spline_of(std::vector<DisplacementKey> keys, const DisplacementMapOptions& window) {
  std::sort(keys.begin(), keys.end(), [](const DisplacementKey& a, const DisplacementKey& b) {
    return a.seconds < b.seconds;
  });
  std::vector<double> times = {window.start_seconds};
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(keys.size()) + 2, 6);
  for (const DisplacementKey& key : keys) {
    if (key.seconds <= times.back()) {
      throw Error("two displacements of " + std::string(name_of(key.joint)) + " are at " +
                      in_milliseconds(key.seconds),
                  "remove one of them");
    }
    const auto row = static_cast<Eigen::Index>(times.size());
    values.row(row) << key.turn.transpose(), key.shift.transpose();
    times.push_back(key.seconds);
  }
  times.push_back(window.end_seconds);
  return level_spline(std::move(times), window.amount * values);
}

/// The frame's time in the window, or outside it.
double time_in_window(const Clip& motion, int frame, const DisplacementMapOptions& window) {
  const double seconds = frame / motion.frames_per_second;
  if (!motion.loops) return seconds;
  const double cycle = motion.duration_seconds();
  return seconds + cycle * std::ceil((window.start_seconds - seconds) / cycle);
}

}  // namespace

Clip displaced(const Clip& motion, const std::vector<DisplacementKey>& keys,
               const DisplacementMapOptions& options) {
  require_window(motion, keys, options);
  std::map<int, std::vector<DisplacementKey>> by_joint;
  for (const DisplacementKey& key : keys) by_joint[key.joint].push_back(key);
  Clip result = motion;
  for (const auto& [joint, joint_keys] : by_joint) {
    const CubicSpline spline = spline_of(joint_keys, options);
    for (int i = 0; i < motion.frame_count(); ++i) {
      const double seconds = time_in_window(motion, i, options);
      if (seconds <= options.start_seconds || seconds >= options.end_seconds) continue;
      const Eigen::RowVectorXd change = at_time(spline, seconds);
      Pose& pose = result.poses[i];
      pose.rotations[joint] =
          (exp(change.head<3>().transpose()) * pose.rotations[joint]).normalized();
      pose.root_position += change.tail<3>().transpose();
    }
  }
  return result;
}

std::vector<DisplacementKey> displacements_between(const Clip& neutral, const Clip& styled,
                                                   const DisplacementMapOptions& window) {
  const std::vector<Quat> from = mean_rotations(neutral);
  const std::vector<Quat> to = mean_rotations(styled);
  const double lower =
      to_curves(styled).values.col(1).mean() - to_curves(neutral).values.col(1).mean();
  std::vector<DisplacementKey> keys;
  for (int joint = 0; joint < body_joint_count; ++joint) {
    DisplacementKey key;
    key.joint = BodyJoint(joint);
    key.turn = log(to[joint] * from[joint].conjugate());
    if (joint == Pelvis) key.shift = Vec3(0, lower, 0);
    for (const double share : {0.25, 0.5, 0.75}) {
      key.seconds = window.start_seconds + share * (window.end_seconds - window.start_seconds);
      keys.push_back(key);
    }
  }
  return keys;
}

}  // namespace mien::motion
