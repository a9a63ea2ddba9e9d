#include "motion/points/gaps.h"

#include <algorithm>
#include <utility>

#include "motion/math/cubic_spline.h"

namespace mien::motion {

namespace {

/// Frames [first, past) in which a point is missing.
struct Gap {
  int first = 0;
  int past = 0;
  int length() const { return past - first; }
};

std::vector<Gap> gaps_of_point(const PointRecording& recording, int point) {
  std::vector<Gap> gaps;
  for (int frame = 0; frame < recording.frame_count(); ++frame) {
    if (recording.seen[recording.at(frame, point)]) continue;
    if (gaps.empty() || gaps.back().past != frame) gaps.push_back({frame, frame});
    gaps.back().past = frame + 1;
  }
  return gaps;
}

/// Up to four frames in which the point is seen, beginning beside the gap and going away from it
/// (`step` −1 or 1) by at least `stride` frames each time, no farther than a few strides.
std::vector<int> knots_beside(const PointRecording& recording, int point, int start, int step,
                              int stride) {
  constexpr int most = 4;
  std::vector<int> frames;
  for (int away = 0; away <= 2 * most * stride; ++away) {
    const int frame = start + away * step;
    if (frame < 0 || frame >= recording.frame_count()) break;
    if (!recording.seen[recording.at(frame, point)]) continue;
    if (!frames.empty() && std::abs(frame - frames.back()) < stride) continue;
    frames.push_back(frame);
    if (static_cast<int>(frames.size()) == most) break;
  }
  return frames;
}

void fill(const PointRecording& from, int point, const Gap& gap, FilledPoints& to) {
  const int stride = std::max(1, gap.length() / 3);
  std::vector<int> knots = knots_beside(from, point, gap.first - 1, -1, stride);
  std::reverse(knots.begin(), knots.end());
  const std::vector<int> after = knots_beside(from, point, gap.past, 1, stride);
  knots.insert(knots.end(), after.begin(), after.end());
  Eigen::MatrixXd values(static_cast<Eigen::Index>(knots.size()), 3);
  std::vector<double> times;
  for (const int frame : knots) {
    values.row(static_cast<Eigen::Index>(times.size())) =
        from.positions[from.at(frame, point)].transpose();
    times.push_back(frame);
  }
  const CubicSpline spline = level_spline(std::move(times), values);
  for (int frame = gap.first; frame < gap.past; ++frame) {
    const std::size_t at = from.at(frame, point);
    to.recording.positions[at] = at_time(spline, frame).transpose();
    to.recording.seen[at] = true;
    to.filled[at] = true;
  }
}

}  // namespace

GapSummary gaps_of(const PointRecording& recording) {
  GapSummary summary;
  const double frames = std::max(1, recording.frame_count());
  for (int point = 0; point < recording.point_count(); ++point) {
    PointGaps gaps;
    for (const Gap& gap : gaps_of_point(recording, point)) {
      gaps.missing_share += gap.length() / frames;
      gaps.longest_gap_seconds =
          std::max(gaps.longest_gap_seconds, gap.length() / recording.frames_per_second);
    }
    summary.missing_share += gaps.missing_share / recording.point_count();
    summary.longest_gap_seconds = std::max(summary.longest_gap_seconds, gaps.longest_gap_seconds);
    summary.points.push_back(gaps);
  }
  return summary;
}

FilledPoints filled(const PointRecording& recording, double max_gap_seconds) {
  FilledPoints result{recording, std::vector<bool>(recording.positions.size(), false)};
  const double longest = max_gap_seconds * recording.frames_per_second + 1e-9;  // frames
  for (int point = 0; point < recording.point_count(); ++point) {
    for (const Gap& gap : gaps_of_point(recording, point)) {
      const bool is_inside = gap.first > 0 && gap.past < recording.frame_count();
      if (is_inside && gap.length() <= longest) fill(recording, point, gap, result);
    }
  }
  return result;
}

}  // namespace mien::motion
