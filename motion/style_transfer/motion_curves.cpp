#include "motion/style_transfer/motion_curves.h"

#include <algorithm>
#include <cmath>

#include "motion/error.h"
#include "motion/interpolation/blend.h"
#include "motion/math/filter.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/body.h"
#include "motion/skeleton/straighten.h"

namespace mien::motion {

namespace {

/// Styles change tempo no faster than this.
constexpr double timing_cutoff_hz = 4.0;

void require_curves(const Clip& clip) {
  if (!is_body(clip.body)) {
    throw Error("the motion \"" + clip.name + "\" does not have the canonical body",
                "use the motion of a human figure");
  }
  if (clip.frame_count() < 4) {
    throw Error("the motion \"" + clip.name + "\" has fewer than 4 frames", "use a longer one");
  }
}

Quat rotation_in(const Clip& clip, const Quat& heading, int frame, int joint) {
  const Quat& rotation = clip.poses[frame].rotations[joint];
  return joint == Pelvis ? (heading.conjugate() * rotation).normalized() : rotation;
}

/// From frame 0 to the frame after the last of a loop, to the last of a take; horizontal.
Vec3 way_of(const Clip& clip) {
  Vec3 way = clip.loops ? clip.cycle_displacement
                        : Vec3(clip.poses.back().root_position - clip.poses.front().root_position);
  way.y() = 0.0;
  return way;
}

/// Share of the way that is gone by a frame.
double way_share(bool loops, int frames, int frame) {
  return static_cast<double>(frame) / (loops ? frames : frames - 1);
}

}  // namespace

Eigen::MatrixXd with_closing_frame(const MotionCurves& curves) {
  if (!curves.timing.loops) return curves.values;
  Eigen::MatrixXd closed(curves.frame_count() + 1, curve_count);
  closed << curves.values, curves.values.row(0);
  return closed;
}

double frame_span(const MotionCurves& curves) {
  return curves.timing.loops ? curves.frame_count() : curves.frame_count() - 1;
}

std::vector<double> smoothed_times(const std::vector<double>& times, const MotionCurves& from,
                                   const MotionCurves& to) {
  const double even = frame_span(to) / frame_span(from);
  std::vector<double> ahead;
  for (int i = 0; i < from.frame_count(); ++i) ahead.push_back(times[i] - even * i);
  ahead = low_pass(ahead, timing_cutoff_hz, from.timing.frames_per_second,
                   from.timing.loops ? SignalEnds::periodic : SignalEnds::open);
  for (size_t i = 0; i < ahead.size(); ++i) ahead[i] += even * static_cast<double>(i);
  return ahead;
}

Vec3 unwrapped(const Vec3& vector, const Vec3& previous) {
  const double angle = vector.norm();
  if (angle < 1e-9) return vector;
  const Vec3 other = vector * (1.0 - 2.0 * pi / angle);
  return (other - previous).norm() < (vector - previous).norm() ? other : vector;
}

std::vector<Quat> mean_rotations(const Clip& clip) {
  require_curves(clip);
  const Quat towards = heading(mean_direction(clip));
  const std::vector<double> weights(clip.poses.size(), 1.0 / clip.frame_count());
  std::vector<Quat> means;
  std::vector<Quat> rotations(clip.poses.size());
  for (int joint = 0; joint < body_joint_count; ++joint) {
    for (int i = 0; i < clip.frame_count(); ++i) {
      rotations[i] = rotation_in(clip, towards, i, joint);
    }
    means.push_back(blend_rotations(rotations, weights, RotationBlend::karcher_mean));
  }
  return means;
}

MotionCurves to_curves(const Clip& clip) { return to_curves(clip, mean_rotations(clip)); }

MotionCurves to_curves(const Clip& clip, const std::vector<Quat>& means) {
  require_curves(clip);
  MotionCurves curves;
  curves.timing = clip;
  curves.timing.poses.clear();
  curves.heading = heading(mean_direction(clip));
  curves.way = curves.heading.conjugate() * way_of(clip);
  curves.means = means;
  const int frames = clip.frame_count();
  curves.values.resize(frames, curve_count);

  std::vector<Vec3> places;
  curves.origin = Vec3::Zero();
  for (int i = 0; i < frames; ++i) {
    places.push_back(clip.poses[i].root_position -
                     way_share(clip.loops, frames, i) * (curves.heading * curves.way));
    curves.origin += places.back() / frames;
  }
  curves.origin.y() = 0.0;
  for (int i = 0; i < frames; ++i) {
    curves.values.block<1, 3>(i, 0) =
        (curves.heading.conjugate() * (places[i] - curves.origin)).transpose();
    for (int joint = 0; joint < body_joint_count; ++joint) {
      const Quat rotation = rotation_in(clip, curves.heading, i, joint);
      Vec3 vector = log(rotation * means[joint].conjugate());
      if (i > 0) {
        vector =
            unwrapped(vector, curves.values.block<1, 3>(i - 1, first_curve(joint)).transpose());
      }
      curves.values.block<1, 3>(i, first_curve(joint)) = vector.transpose();
    }
  }
  return curves;
}

Clip to_clip(const MotionCurves& curves) {
  Clip clip = curves.timing;
  const int frames = curves.frame_count();
  const Vec3 way = curves.heading * curves.way;
  if (clip.loops) {
    clip.cycle_displacement.x() = way.x();
    clip.cycle_displacement.z() = way.z();
  }
  clip.poses.resize(static_cast<size_t>(frames));
  for (int i = 0; i < frames; ++i) {
    Pose& pose = clip.poses[i];
    const Vec3 place = curves.values.block<1, 3>(i, 0).transpose();
    pose.root_position =
        curves.heading * place + curves.origin + way_share(clip.loops, frames, i) * way;
    for (int joint = 0; joint < body_joint_count; ++joint) {
      const Vec3 vector = curves.values.block<1, 3>(i, first_curve(joint)).transpose();
      Quat rotation = exp(vector) * curves.means[joint];
      if (joint == Pelvis) rotation = curves.heading * rotation;
      rotation.normalize();
      pose.rotations.push_back(
          i > 0 ? in_hemisphere_of(clip.poses[i - 1].rotations[joint], rotation) : rotation);
    }
  }
  return clip;
}

Eigen::RowVectorXd curves_at(const MotionCurves& curves, double share) {
  const int frames = curves.frame_count();
  const bool loops = curves.timing.loops;
  double frame = share * (loops ? frames : frames - 1);
  if (std::abs(frame - std::round(frame)) < 1e-9) frame = std::round(frame);
  const auto row = [&](int index) -> Eigen::RowVectorXd {
    if (loops) return curves.values.row(((index % frames) + frames) % frames);
    return curves.values.row(std::clamp(index, 0, frames - 1));
  };
  const int whole = static_cast<int>(std::floor(frame));
  const double t = frame - whole;
  if (t == 0.0) return row(whole);
  const Eigen::RowVectorXd from = row(whole);
  const Eigen::RowVectorXd to = row(whole + 1);
  const Eigen::RowVectorXd start = 0.5 * (to - row(whole - 1));
  const Eigen::RowVectorXd end = 0.5 * (row(whole + 2) - from);
  return from + t * (to - from) +
         t * (1.0 - t) * ((1.0 - t) * (start - (to - from)) - t * (end - (to - from)));
}

MotionCurves resampled(const MotionCurves& curves, int frames) {
  if (frames == curves.frame_count()) return curves;
  MotionCurves result = curves;
  result.values.resize(frames, curves.values.cols());
  for (int i = 0; i < frames; ++i) {
    result.values.row(i) = curves_at(curves, way_share(curves.timing.loops, frames, i));
  }
  return result;
}

}  // namespace mien::motion
