#include "motion/measures/differences/timing_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include <Eigen/Core>

#include "motion/measures/differences/joint_difference.h"

namespace mien::motion {

namespace {

constexpr double nearly_all = 0.99;
constexpr double negligible_m2 = 1e-14;  ///< squared distances of less than arithmetic leaves

/// All points of one motion: a column a moment, three rows a point.
Eigen::MatrixXd point_paths(const SampledMotion& motion, const std::vector<int>& joints,
                            const std::vector<BoneAxes>& axes, bool from_root) {
  Eigen::MatrixXd paths(9 * static_cast<Eigen::Index>(joints.size()), motion.frame_count());
  for (int t = 0; t < motion.frame_count(); ++t) {
    const JointTransforms& world = motion.world[t];
    const Vec3 origin = from_root ? world.positions[joints.front()] : Vec3(Vec3::Zero());
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const JointPoints points = points_at(world, joints[j], axes[j]);
      const auto row = 9 * static_cast<Eigen::Index>(j);
      paths.block<3, 1>(row, t) = points.joint - origin;
      paths.block<3, 1>(row + 3, t) = points.side - origin;
      paths.block<3, 1>(row + 6, t) = points.up - origin;
    }
  }
  return paths;
}

/// Two motions as points, to be laid over each other with one of them later.
struct PointMotions {
  Eigen::MatrixXd before;
  Eigen::MatrixXd now;
  bool loops = false;       ///< both, of as many frames: then there is no end
  Vec3 way = Vec3::Zero();  ///< of the second in a cycle, from_root: none

  bool has(long frame) const { return loops || (frame >= 0 && frame < now.cols()); }

  /// Mean squared distance of the points at a frame of the first and another of the second.
  double cost(long frame, long there) const {
    const auto points = static_cast<double>(before.rows() / 3);
    const long count = now.cols();
    const long cycle = there >= 0 ? there / count : -((-there + count - 1) / count);
    if (cycle == 0) return (now.col(there) - before.col(frame)).squaredNorm() / points;
    const Vec3 travelled = static_cast<double>(cycle) * way;
    const Eigen::VectorXd column =
        now.col(there - cycle * count) + travelled.replicate(before.rows() / 3, 1);
    return (column - before.col(frame)).squaredNorm() / points;
  }

  /// Mean over the frames that both have when the second is `lag` frames late.
  double cost_at_lag(long lag) const {
    double sum = 0.0;
    long frames = 0;
    for (long i = 0; i < before.cols(); ++i) {
      if (!has(i + lag)) continue;
      sum += cost(i, i + lag);
      ++frames;
    }
    return frames == 0 ? std::numeric_limits<double>::infinity()
                       : sum / static_cast<double>(frames);
  }
};

PointMotions point_motions(const Clip& before, const Clip& now, const PairedMotions& pair,
                           bool from_root) {
  const std::vector<BoneAxes> all_axes = bone_axes(before.body);
  std::vector<BoneAxes> axes;
  std::vector<int> of_before, of_now;
  for (const SharedJoint& shared : pair.joints) {
    axes.push_back(all_axes[shared.before]);
    of_before.push_back(shared.before);
    of_now.push_back(shared.now);
  }
  PointMotions motions;
  motions.before = point_paths(pair.before, of_before, axes, from_root);
  motions.now = point_paths(pair.now, of_now, axes, from_root);
  motions.loops = before.loops && now.loops && motions.before.cols() == motions.now.cols();
  if (!from_root) motions.way = now.cycle_displacement;
  return motions;
}

long longest_lag(const PointMotions& motions, double frames_per_second) {
  const long frames = std::min(motions.before.cols(), motions.now.cols());
  return std::min(frames / 4, static_cast<long>(std::ceil(0.5 * frames_per_second)));
}

/// The shortest of the lags that explain as much as the best does.
std::optional<TimeShift> shift_of(const PointMotions& motions, double frames_per_second) {
  const double unshifted = motions.cost_at_lag(0);
  if (unshifted <= negligible_m2) return std::nullopt;
  const long longest = longest_lag(motions, frames_per_second);
  std::optional<long> best;
  double least = (1.0 - nearly_all) * unshifted;
  for (long by = 1; by <= longest; ++by) {
    for (const long lag : {by, -by}) {
      const double cost = motions.cost_at_lag(lag);
      // What a longer lag explains beyond a shorter one has to be more than arithmetic.
      if (cost >= least - (best ? 1e-4 * unshifted : 0.0)) continue;
      least = cost;
      best = lag;
    }
  }
  if (!best) return std::nullopt;
  return TimeShift{static_cast<int>(*best), static_cast<double>(*best) / frames_per_second,
                   1.0 - least / unshifted, true};
}

/// The best frame from which the second motion is `lag` frames late, with the mean cost then.
FrameGap gap_at_lag(const PointMotions& motions, long lag, double unshifted) {
  const long frames = motions.before.cols();
  const long left_out = std::max(-lag, 0L);
  // rest[i]: from frame i on, late; a sum, so that every place of the gap is one look-up.
  std::vector<double> rest(static_cast<std::size_t>(frames) + 1, 0.0);
  for (long i = frames - 1; i >= 0; --i)
    rest[i] = rest[i + 1] + (motions.has(i + lag) ? motions.cost(i, i + lag) : 0.0);
  double until = 0.0;
  double least = std::numeric_limits<double>::infinity();
  FrameGap gap{0, static_cast<int>(lag), 0.0};
  for (long k = 1; k + left_out < frames; ++k) {
    if (!motions.has(k - 1)) break;
    until += motions.cost(k - 1, k - 1);
    const double cost = until + rest[k + left_out];
    if (cost >= least) continue;
    least = cost;
    gap.frame = static_cast<int>(k);
  }
  gap.explained = 1.0 - least / (unshifted * static_cast<double>(frames));
  return gap;
}

std::optional<FrameGap> gap_of(const PointMotions& motions, int more_frames) {
  const double unshifted = motions.cost_at_lag(0);
  const long frames = motions.before.cols();
  if (unshifted <= negligible_m2 || motions.loops || frames < 8) return std::nullopt;
  std::set<long> lags = {-3, -2, -1, 1, 2, 3};
  if (more_frames != 0 && std::abs(more_frames) <= frames / 4) lags.insert(more_frames);
  std::optional<FrameGap> best;
  for (const long lag : lags) {
    const FrameGap gap = gap_at_lag(motions, lag, unshifted);
    if (gap.frame > 0 && gap.explained >= nearly_all && (!best || gap.explained > best->explained))
      best = gap;
  }
  return best;
}

/// Whether the frames match one by one, though the frame rates differ.
bool has_other_pace(const Clip& before, const Clip& now, double cost_in_time) {
  if (before.frame_count() != now.frame_count() || before.frame_count() < 2 ||
      same_rate(before.frames_per_second, now.frames_per_second))
    return false;
  Clip at_pace = now;
  at_pace.frames_per_second = before.frames_per_second;
  const PairedMotions pair = paired(before, at_pace);
  const double cost = point_motions(before, at_pace, pair, false).cost_at_lag(0);
  return cost <= std::max(negligible_m2, (1.0 - nearly_all) * cost_in_time);
}

/// Frame i of the first is frame `there(i)` of the second, for as many as both have.
template <class There>
double cost_in_order(const PointMotions& motions, long frames, const There& there) {
  double sum = 0.0;
  for (long i = 0; i < frames; ++i) sum += motions.cost(i, there(i));
  return sum / static_cast<double>(std::max(frames, 1L));
}

bool is_reversed(const PointMotions& motions) {
  const long frames = motions.now.cols();
  if (frames != motions.before.cols() || frames < 3) return false;
  const double unchanged = motions.cost_at_lag(0);
  return unchanged > negligible_m2 && cost_in_order(motions, frames, [&](long i) {
                                        return frames - 1 - i;
                                      }) <= (1.0 - nearly_all) * unchanged;
}

/// A clip with every k-th frame of it alone, as an application that writes fewer makes it.
Clip thinned(const Clip& clip, int every) {
  Clip thin = clip;
  thin.poses.clear();
  for (std::size_t i = 0; i < clip.poses.size(); i += static_cast<std::size_t>(every))
    thin.poses.push_back(clip.poses[i]);
  thin.frames_per_second /= every;
  return thin;
}

/// How many frames of the quicker become one of the slower; 1 where the rates are no multiple.
int frames_for_one(double quicker, double slower) {
  const long times = std::lround(quicker / slower);
  return times >= 2 && times <= 8 && same_rate(quicker, slower * static_cast<double>(times))
             ? static_cast<int>(times)
             : 1;
}

bool has_every(const Clip& all, const Clip& few, int every) {
  const Clip thin = thinned(all, every);
  if (thin.frame_count() < 2 || std::abs(thin.frame_count() - few.frame_count()) > 1) return false;
  const PointMotions motions = point_motions(thin, few, paired(thin, few), false);
  // Files round to a tenth of a millimetre or so.
  constexpr double rounding_m2 = 1e-8;
  return cost_in_order(motions, std::min(thin.frame_count(), few.frame_count()),
                       [](long i) { return i; }) <= rounding_m2;
}

int every_of(const Clip& before, const Clip& now) {
  const int thinner = frames_for_one(before.frames_per_second, now.frames_per_second);
  if (thinner > 1 && has_every(before, now, thinner)) return thinner;
  const int denser = frames_for_one(now.frames_per_second, before.frames_per_second);
  return denser > 1 && has_every(now, before, denser) ? -denser : 1;
}

MotionLength length_of(const Clip& clip) {
  return {clip.frame_count(), clip.frames_per_second, clip.duration_seconds(), clip.loops};
}

}  // namespace

TimingDifference timing_difference(const Clip& before, const Clip& now, const PairedMotions& pair) {
  TimingDifference result;
  result.before = length_of(before);
  result.now = length_of(now);
  const PointMotions motions = point_motions(before, now, pair, false);
  result.other_pace = has_other_pace(before, now, motions.cost_at_lag(0));
  if (result.other_pace) return result;
  result.every = every_of(before, now);
  if (result.every != 1) return result;
  result.shift = shift_of(motions, pair.frames_per_second);
  if (!result.shift) {
    result.shift = shift_of(point_motions(before, now, pair, true), pair.frames_per_second);
    if (result.shift) result.shift->path_too = false;
  }
  if (!result.shift) result.reversed = is_reversed(motions);
  if (!result.shift && !result.reversed)
    result.gap = gap_of(motions, pair.now.frame_count() - pair.before.frame_count());
  return result;
}

}  // namespace mien::motion
