#include "motion/fitting/fit.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "motion/error.h"
#include "motion/fitting/attachments.h"
#include "motion/fitting/body_tracks.h"
#include "motion/fitting/fitted_floor.h"
#include "motion/fitting/fitted_proportions.h"
#include "motion/fitting/fitted_set.h"
#include "motion/fitting/hip_origin.h"
#include "motion/fitting/initial_poses.h"
#include "motion/fitting/least_squares_pass.h"
#include "motion/fitting/segment_gaps.h"
#include "motion/math/percentile.h"
#include "motion/points/gaps.h"
#include "motion/points/marker_sets.h"
#include "motion/text/excerpt.h"

namespace mien::motion {

namespace {

std::string in_words(double value, int decimals) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

/// Refuses recordings in which a part that a body needs is never seen.
void require_parts(const PointRecording& recording, const BodyTracks& tracks,
                   const FrameRange& range) {
  std::vector<std::string> unseen;
  if (range.size() == 0) unseen.emplace_back("pelvis");
  for (const BodyJoint joint : {LeftKnee, RightKnee, LeftAnkle, RightAnkle}) {
    if (!is_known(tracks.joints[joint])) unseen.emplace_back(name_of(joint));
  }
  if (unseen.empty()) return;
  throw Error(Place{recording.name},
              "the points of these parts are missing in all frames: " + listed(unseen),
              points_a_body_needs());
}

struct SquareSum {
  double sum = 0.0;
  int count = 0;
  void add(double square) {
    sum += square;
    ++count;
  }
  double root_mean() const { return count > 0 ? std::sqrt(sum / count) : 0.0; }
};

void note_far(int frame, FittedPoint& point) {
  if (!point.first_far) point.first_far = frame;
  point.last_far = frame;
}

/// Distances of the points from the fitted body.
void set_residuals(const PointTracks& points, const std::vector<bool>& filled_values,
                   std::span<const Attachment> attached, const FrameRange& range,
                   FittedMotion& fitted) {
  constexpr double mm = 1000.0;
  constexpr double far_mm2 = far_from_points_mm * far_from_points_mm;
  std::vector<SquareSum> by_point(points.recording.points.size());
  SquareSum all;
  for (int i = 0; i < range.size(); ++i) {
    const JointTransforms world =
        world_transforms(fitted.clip.body, fitted.clip.poses[static_cast<std::size_t>(i)]);
    SquareSum in_frame;
    for (const Attachment& attachment : attached) {
      const std::size_t at = points.recording.at(range.first + i, attachment.point);
      if (!points.recording.seen[at] || filled_values[at]) continue;
      const Vec3 place =
          world.positions[attachment.joint] + world.rotations[attachment.joint] * attachment.place;
      const double square = (place - points.recording.positions[at]).squaredNorm() * mm * mm;
      if (square > far_mm2)
        note_far(range.first + i, fitted.points[static_cast<std::size_t>(attachment.point)]);
      by_point[static_cast<std::size_t>(attachment.point)].add(square);
      in_frame.add(square);
      all.add(square);
    }
    fitted.frame_residual_mm.push_back(in_frame.count > 0 ? std::optional(in_frame.root_mean())
                                                          : std::nullopt);
  }
  for (std::size_t point = 0; point < by_point.size(); ++point) {
    fitted.points[point].residual_mm = by_point[point].root_mean();
    if (by_point[point].count > 0) fitted.points[point].use = PointUse::used;
  }
  fitted.residual_mm = all.root_mean();
}

/// A gap is filled as a whole or not at all.
std::vector<PointGap> gaps_in(const PointRecording& recording, int point,
                              const std::vector<bool>& filled_values) {
  std::vector<PointGap> gaps;
  for (int frame = 0; frame < recording.frame_count(); ++frame) {
    const std::size_t at = recording.at(frame, point);
    if (recording.seen[at]) continue;
    if (gaps.empty() || gaps.back().past != frame)
      gaps.push_back({frame, frame, filled_values[at]});
    gaps.back().past = frame + 1;
  }
  return gaps;
}

std::vector<FittedPoint> described_points(const PointRecording& recording, const MarkerSet& set,
                                          const std::vector<bool>& filled_values) {
  const GapSummary gaps = gaps_of(recording);
  std::vector<FittedPoint> points;
  for (std::size_t point = 0; point < recording.points.size(); ++point) {
    FittedPoint described;
    described.name = recording.points[point];
    described.missing_share = gaps.points[point].missing_share;
    described.gaps = gaps_in(recording, static_cast<int>(point), filled_values);
    int count = 0;
    for (const PointGap& gap : described.gaps) count += gap.filled ? gap.past - gap.first : 0;
    described.filled_share = static_cast<double>(count) / recording.frame_count();
    if (set.roles[point]) {
      described.role = words_for(*set.roles[point]);
      described.use = PointUse::missing;
    }
    points.push_back(std::move(described));
  }
  return points;
}

void warn_of_parts_at_rest(const BodyTracks& tracks, FittedMotion& fitted) {
  for (const bool left : {true, false}) {
    const std::string side = left ? "left" : "right";
    if (!is_known(tracks.joints[left ? LeftElbow : RightElbow])) {
      fitted.warnings.push_back("The " + side + " arm has no points: it hangs beside the trunk.");
    } else if (!is_known(tracks.joints[left ? LeftWrist : RightWrist])) {
      fitted.warnings.push_back("The " + side + " wrist has no points: the forearm is straight.");
    }
    if (!is_known(tracks.joints[left ? LeftToe : RightToe])) {
      fitted.warnings.push_back("The " + side +
                                " foot has no points in front of the ankle: it lies flat while "
                                "the ankle is low, and otherwise is at a right angle to the "
                                "shank.");
    }
  }
  if (!is_known(tracks.chest_up)) {
    fitted.warnings.emplace_back("The trunk has no points: it moves with the pelvis.");
  }
  if (!is_known(tracks.joints[Head])) {
    fitted.warnings.emplace_back("The head has no points: it moves with the trunk.");
  }
}

/// Feet that point backwards: left and right are exchanged, by names or by the file's axes.
void warn_of_exchanged_sides(const BodyTracks& tracks, FittedMotion& fitted) {
  int ahead = 0;
  int behind = 0;
  for (std::size_t frame = 0; frame < tracks.frame_count(); ++frame) {
    const auto& left = tracks.pelvis_left[frame];
    for (const BodyJoint toe : {LeftToe, RightToe}) {
      const auto& end = tracks.joints[toe][frame];
      const auto& start = tracks.joints[body_parents[toe]][frame];
      if (!left || !end || !start) continue;
      ++(left->cross(Vec3::UnitY()).dot(*end - *start) > 0.0 ? ahead : behind);
    }
  }
  if (behind <= ahead) return;
  fitted.warnings.emplace_back(
      "The feet point backwards: left and right seem to be exchanged in the names of the points, "
      "or the file's axes are left-handed.");
}

void warn_of_residuals(FittedMotion& fitted) {
  if (fitted.residual_mm > far_from_points_mm) {
    fitted.warnings.push_back("The fitted body is " + in_words(fitted.residual_mm, 0) +
                              " mm (RMS) away from the points.");
  }
  std::vector<std::string> missing;
  std::vector<std::string> far;
  for (const FittedPoint& point : fitted.points) {
    if (point.use == PointUse::missing)
      missing.push_back(in_quotes(point.name) + " (" + point.role + ")");
    if (point.residual_mm > far_from_points_mm)
      far.push_back(in_quotes(point.name) + " (" + in_words(point.residual_mm, 0) + " mm)");
  }
  if (!missing.empty())
    fitted.warnings.push_back("Points that are missing in all frames: " + listed(missing) + ".");
  if (!far.empty())
    fitted.warnings.push_back("Points that are more than " + in_words(far_from_points_mm, 0) +
                              " mm (RMS) away from the fitted body: " + listed(far) +
                              ". They may be mislabelled or have moved on the skin.");
}

std::string note_on_people(const PointRecording& recording, const std::string& fitted) {
  return "The body is fitted to the points of " + in_quotes(fitted) + ", one of " +
         std::to_string(recording.subjects.size()) + " people.";
}

void add_notes(const PointRecording& recording, const FrameRange& range, FittedMotion& fitted) {
  if (!fitted.axes.note.empty()) fitted.notes.push_back(fitted.axes.note);
  if (range.size() < recording.frame_count()) {
    fitted.notes.push_back("The motion has frames " + std::to_string(range.first) + " to " +
                           std::to_string(range.past - 1) + " (counted from 0) of " +
                           std::to_string(recording.frame_count()) +
                           "; in the others the pelvis is not seen.");
  }
  if (fitted.is_relative_to_hips) {
    fitted.notes.emplace_back(
        "The positions are relative to the hips, which are at the origin in every frame: the "
        "motion is in place, and its lower foot is put on the floor in each frame, so that flights "
        "of running and jumping are not seen.");
  } else if (std::abs(fitted.raised) >= 0.005) {
    fitted.notes.push_back(
        "The motion was " + std::string(fitted.raised > 0 ? "raised" : "lowered") + " by " +
        in_words(std::abs(fitted.raised) * 100.0, 1) + " cm so that the feet stand on the floor.");
  }
}

}  // namespace

FittedMotion fit_body(const PointRecording& recording, const FitOptions& options) {
  const FittedSet chosen = fitted_set(recording);
  const MarkerSet& set = chosen.set;
  FittedMotion fitted;
  fitted.marker_set = set.name;
  if (!chosen.subject.empty()) fitted.notes.push_back(note_on_people(recording, chosen.subject));
  fitted.axes = point_axes(recording);
  fitted.is_relative_to_hips = !fitted.axes.is_up_by_floor &&
                               has_origin_at_hips(recording, set, fitted.axes.metres_per_unit);
  FilledPoints complete = filled(recording, options.max_gap_seconds);
  complete.recording = in_metres_y_up(std::move(complete.recording), fitted.axes);
  const PointTracks points{complete.recording, set};
  const PointRecording with_whole_segments = with_segments_completed(points);
  const BodyTracks tracks = body_tracks(PointTracks{with_whole_segments, set});
  const FrameRange range = frames_with_pelvis(tracks);
  require_parts(recording, tracks, range);
  fitted.frames_per_second = recording.frames_per_second;
  fitted.recorded_frames = recording.frame_count();
  fitted.first_frame = range.first;
  fitted.points = described_points(recording, set, complete.filled);

  Clip& clip = fitted.clip;
  clip.name = recording.name;
  clip.frames_per_second = recording.frames_per_second;
  clip.body = fitted_proportions(tracks);
  const std::vector<Pose> first_poses = initial_poses(tracks, clip.body, range);
  const auto attached = [&] { return attachments(points, clip.body, clip.poses, range); };
  clip.poses = first_poses;
  clip.poses = least_squares_pass(points, clip.body, attached(), first_poses, range);
  set_residuals(points, complete.filled, attached(), range, fitted);
  fitted.raised_by_frame.assign(clip.poses.size(), 0.0);
  if (!fitted.axes.is_up_by_floor) put_on_floor(tracks, fitted);
  fitted.raised = percentile(fitted.raised_by_frame, 50.0);
  bend_unknown_toes(tracks, clip);
  add_notes(recording, range, fitted);
  if (!fitted.axes.is_up_by_floor) warn_of_exchanged_sides(tracks, fitted);
  warn_of_parts_at_rest(tracks, fitted);
  warn_of_residuals(fitted);
  return fitted;
}

}  // namespace mien::motion
