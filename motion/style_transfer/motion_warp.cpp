#include "motion/style_transfer/motion_warp.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "motion/error.h"
#include "motion/interpolation/time_warp.h"
#include "motion/math/cubic_spline.h"
#include "motion/math/rotation.h"
#include "motion/style_transfer/motion_curves.h"

namespace mien::motion {

namespace {

/// A curve nearer to its mean than this cannot be scaled to anywhere else.
constexpr double least_scaled = 1.0 * radians_per_degree;
/// Two moments nearer than this are one.
constexpr double same_moment = 1e-6;

std::string seconds_text(double seconds) {
  return std::to_string(std::lround(1000.0 * seconds)) + " ms";
}

void require_keys(const Clip& motion, const std::vector<WarpKey>& keys,
                  const MotionWarpOptions& options, double new_duration) {
  const double duration = motion.duration_seconds();
  if (!(options.reach_seconds > 0.0)) {
    throw Error("the reach of a key is not positive", "give reach seconds greater than 0");
  }
  if (!(new_duration > 0.0)) {
    throw Error("the warped motion has no duration", "give a duration greater than 0");
  }
  double last_at = -1.0;
  for (size_t k = 0; k < keys.size(); ++k) {
    const WarpKey& key = keys[k];
    const std::string which = "the key at " + seconds_text(key.seconds);
    const bool inside = key.seconds >= 0.0 &&
                        (motion.loops ? key.seconds < duration : key.seconds <= duration + 1e-9);
    if (!inside) {
      throw Error(which + " is outside the motion, which lasts " + seconds_text(duration),
                  "move the key");
    }
    if (k > 0 && key.seconds - keys[k - 1].seconds < same_moment) {
      throw Error("two keys are at " + seconds_text(key.seconds), "put their joints into one key");
    }
    if (!key.at) continue;
    if (*key.at < 0.0 || *key.at > new_duration + 1e-9 || *key.at <= last_at) {
      throw Error(
          which + " is moved to " + seconds_text(*key.at) + ", outside the result or out of order",
          "move it to a time between those of its neighbours");
    }
    last_at = *key.at;
  }
}

/// What is added to three curves at a moment: a − 1, then b.
struct Knot {
  double seconds;
  Eigen::RowVectorXd change;
};

/// The knots as splines that are nothing away from them. In a loop, `cycle` > 0 is its duration.
std::vector<CubicSpline> splines_through(std::vector<Knot> knots, double reach, double cycle) {
  const auto spline_of = [&](const std::vector<Knot>& group, bool periodic) {
    std::vector<double> times;
    const auto rows = static_cast<Eigen::Index>(group.size());
    Eigen::MatrixXd values(rows, group.front().change.size());
    for (Eigen::Index k = 0; k < rows; ++k) {
      times.push_back(group[k].seconds);
      values.row(k) = group[k].change;
    }
    if (periodic) return periodic_spline(times, values, cycle);
    Eigen::MatrixXd padded = Eigen::MatrixXd::Zero(rows + 2, values.cols());
    padded.middleRows(1, rows) = values;
    times.insert(times.begin(), times.front() - reach);
    times.push_back(times.back() + reach);
    return level_spline(times, padded);
  };
  if (cycle > 0.0) {
    // Begin after a gap, so that no group is torn at the seam.
    size_t start = 0;
    const size_t count = knots.size();
    while (start < count) {
      const double before = knots[(start + count - 1) % count].seconds - (start == 0 ? cycle : 0.0);
      if (knots[start].seconds - before > 2.0 * reach) break;
      ++start;
    }
    if (start == count) return {spline_of(knots, true)};
    for (size_t k = 0; k < start; ++k) knots[k].seconds += cycle;
    std::rotate(knots.begin(), knots.begin() + static_cast<long>(start), knots.end());
  }
  std::vector<CubicSpline> splines;
  std::vector<Knot> group;
  for (const Knot& knot : knots) {
    if (!group.empty() && knot.seconds - group.back().seconds > 2.0 * reach) {
      splines.push_back(spline_of(group, false));
      group.clear();
    }
    group.push_back(knot);
  }
  splines.push_back(spline_of(group, false));
  return splines;
}

/// a − 1 and b of three curves at a moment.
Eigen::RowVectorXd change_at(const std::vector<CubicSpline>& splines, double seconds,
                             double cycle) {
  Eigen::RowVectorXd change = Eigen::RowVectorXd::Zero(6);
  for (const CubicSpline& spline : splines) {
    double time = seconds;
    if (cycle > 0.0) time += cycle * std::ceil((spline.times.front() - seconds) / cycle);
    if (time >= spline.times.front() && time <= spline.times.back()) {
      change += at_time(spline, time);
    }
  }
  return change;
}

double cycle_of(const Clip& motion) { return motion.loops ? motion.duration_seconds() : 0.0; }

void warp_curves(MotionCurves& curves, int column, const std::vector<Knot>& knots, double reach,
                 double cycle) {
  if (knots.empty()) return;
  const std::vector<CubicSpline> splines = splines_through(knots, reach, cycle);
  for (int i = 0; i < curves.frame_count(); ++i) {
    const Eigen::RowVectorXd change =
        change_at(splines, i / curves.timing.frames_per_second, cycle);
    auto cell = curves.values.block<1, 3>(i, column);
    cell = (cell.array() * (1.0 + change.head<3>().array()) + change.tail<3>().array()).eval();
  }
}

/// Scale − 1 and offset that take the joint's curves where the key wants them.
Eigen::RowVectorXd joint_change(const MotionCurves& curves, const Vec3& vector, const JointKey& key,
                                double amount) {
  Quat turn = exp(amount * log(key.turn));
  if (key.joint == Pelvis) turn = curves.heading.conjugate() * turn * curves.heading;
  const Vec3 target = unwrapped(log(turn * exp(vector)), vector);
  Eigen::RowVectorXd change = Eigen::RowVectorXd::Zero(6);
  for (int c = 0; c < 3; ++c) {
    if (key.by == WarpBy::scale && std::abs(vector[c]) >= least_scaled) {
      change[c] = target[c] / vector[c] - 1.0;
    } else {
      change[3 + c] = target[c] - vector[c];
    }
  }
  return change;
}

void warp_joint(MotionCurves& curves, const MotionCurves& before, int joint,
                const std::vector<WarpKey>& keys, const MotionWarpOptions& options, double cycle,
                double duration) {
  std::vector<Knot> knots;
  for (const WarpKey& key : keys) {
    for (const JointKey& wanted : key.joints) {
      if (wanted.joint != joint) continue;
      const Vec3 vector =
          curves_at(before, key.seconds / duration).segment<3>(first_curve(joint)).transpose();
      knots.push_back({key.seconds, joint_change(before, vector, wanted, options.amount)});
    }
  }
  warp_curves(curves, first_curve(joint), knots, options.reach_seconds, cycle);
}

void warp_root(MotionCurves& curves, const std::vector<WarpKey>& keys,
               const MotionWarpOptions& options, double cycle) {
  std::vector<Knot> knots;
  for (const WarpKey& key : keys) {
    if (key.root_shift.isZero(0.0)) continue;
    Knot knot{key.seconds, Eigen::RowVectorXd::Zero(6)};
    knot.change.tail<3>() =
        options.amount * (curves.heading.conjugate() * key.root_shift).transpose();
    knots.push_back(knot);
  }
  warp_curves(curves, 0, knots, options.reach_seconds, cycle);
}

MotionCurves retimed(const MotionCurves& curves, const std::vector<WarpKey>& keys, double duration,
                     double new_duration) {
  std::vector<double> from = {0.0};
  std::vector<double> to = {0.0};
  for (const WarpKey& key : keys) {
    if (!key.at || key.seconds < same_moment || key.seconds > duration - same_moment) continue;
    from.push_back(*key.at);
    to.push_back(key.seconds);
  }
  if (from.size() == 1 && new_duration == duration) return curves;
  from.push_back(new_duration);
  to.push_back(duration);
  const bool loops = curves.timing.loops;
  const TimeWarp warp = make_time_warp(from, to, WarpShape::monotone, loops);
  const int steps =
      std::max(4, static_cast<int>(std::lround(new_duration * curves.timing.frames_per_second)));
  MotionCurves result = curves;
  result.values.resize(loops ? steps : steps + 1, curve_count);
  for (int i = 0; i < result.frame_count(); ++i) {
    result.values.row(i) = curves_at(curves, warped(warp, i * (new_duration / steps)) / duration);
  }
  return result;
}

}  // namespace

Clip motion_warped(const Clip& motion, const std::vector<WarpKey>& given,
                   const MotionWarpOptions& options) {
  const double duration = motion.duration_seconds();
  const double new_duration =
      duration + options.amount * (options.duration_seconds.value_or(duration) - duration);
  std::vector<WarpKey> keys = given;
  for (WarpKey& key : keys) {
    if (key.at) key.at = key.seconds + options.amount * (*key.at - key.seconds);
  }
  std::stable_sort(keys.begin(), keys.end(),
                   [](const WarpKey& a, const WarpKey& b) { return a.seconds < b.seconds; });
  require_keys(motion, keys, options, new_duration);
  const MotionCurves before = to_curves(motion);
  MotionCurves curves = before;
  const double cycle = cycle_of(motion);
  warp_root(curves, keys, options, cycle);
  for (int joint = 0; joint < body_joint_count; ++joint) {
    warp_joint(curves, before, joint, keys, options, cycle, duration);
  }
  return to_clip(retimed(curves, keys, duration, new_duration));
}

std::vector<WarpKey> keys_towards(const Example& motion, const Example& styled) {
  if (motion.keytimes.size() != styled.keytimes.size() || motion.clip.loops != styled.clip.loops) {
    throw Error("\"" + motion.name + "\" and \"" + styled.name + "\" have different keytimes",
                "use two motions of the same kind, or specify keys");
  }
  std::vector<WarpKey> keys;
  const size_t count = motion.keytimes.size() - (motion.clip.loops ? 1 : 0);
  for (size_t k = 0; k < count; ++k) {
    WarpKey key;
    key.seconds = motion.keytimes[k];
    key.at = styled.keytimes[k];
    const Pose from = pose_at(motion.clip, motion.keytimes[k]);
    const Pose to = pose_at(styled.clip, styled.keytimes[k]);
    key.root_shift.y() = to.root_position.y() - from.root_position.y();
    for (int joint = 0; joint < body_joint_count; ++joint) {
      key.joints.push_back(
          {BodyJoint(joint), to.rotations[joint] * from.rotations[joint].conjugate()});
    }
    keys.push_back(std::move(key));
  }
  return keys;
}

Clip warped_towards(const Example& motion, const Example& styled,
                    const MotionWarpOptions& options) {
  MotionWarpOptions timed = options;
  if (!timed.duration_seconds) timed.duration_seconds = styled.clip.duration_seconds();
  MotionCurves curves = to_curves(motion_warped(motion.clip, keys_towards(motion, styled), timed));
  curves.way += options.amount * (to_curves(styled.clip).way - to_curves(motion.clip).way);
  return to_clip(curves);
}

}  // namespace mien::motion
