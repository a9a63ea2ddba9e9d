#include "motion/modify/gesture_change.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/biomechanics/soft_limits.h"
#include "motion/error.h"
#include "motion/gestures/acting_hand.h"
#include "motion/math/filter.h"
#include "motion/math/rotation.h"
#include "motion/modify/arm_reach.h"
#include "motion/modify/nine_grid.h"
#include "motion/modify/turn_curve.h"
#include "motion/modify/value_range.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

namespace {

constexpr double most_height = 2.0, most_width = 3.0, least_speed = 0.25, most_speed = 4.0;
constexpr int most_repetitions = 10;
constexpr double transition_seconds = 0.12;  // between two strokes, on both sides
constexpr double free_rise = 1.2;            // arm lengths above where the hand hangs
constexpr double highest_rise = 1.75;        // as above
constexpr double free_reach = 0.9;           // of the arm's length, from the shoulder
constexpr double farthest_reach = 0.98;      // as above
constexpr double least_flexion = 10.0 * radians_per_degree;  // of elbows that were bent more
constexpr double speed_change_seconds = 0.25;
constexpr double wrist_course_hz =
    0.5;  // below it, the hand turns for other reasons than its strokes

/// A stroke there and back, in whole frames.
struct Stroke {
  int from = 0;
  int to = 0;
};

/// How unlike two poses are: the mean angle between their rotations, radians.
double unlikeness(const Pose& a, const Pose& b) {
  double sum = 0.0;
  for (size_t j = 0; j < a.rotations.size(); ++j)
    sum += angle_between(a.rotations[j], b.rotations[j]);
  return sum / static_cast<double>(a.rotations.size());
}

/// The stroke whose ends are most alike, so that it can be repeated.
std::optional<Stroke> best_stroke(const Clip& clip, const Gesture& gesture) {
  std::optional<Stroke> best;
  double least = 0.0;
  for (size_t i = 1; i < gesture.strokes.size(); ++i) {
    const Stroke stroke{static_cast<int>(std::lround(gesture.strokes[i - 1])),
                        static_cast<int>(std::lround(gesture.strokes[i]))};
    const double away = unlikeness(clip.poses[static_cast<size_t>(stroke.from)],
                                   clip.poses[static_cast<size_t>(stroke.to)]);
    if (best && away >= least) continue;
    best = stroke;
    least = away;
  }
  return best;
}

const Pose& pose_near(const Clip& clip, int frame) {
  return clip.poses[static_cast<size_t>(std::clamp(frame, 0, clip.frame_count() - 1))];
}

/// From frame `before` on, the clip goes on as from frame `after`; the transition is smooth.
Clip joined(const Clip& clip, int before, int after) {
  const int reach = std::max(
      1, std::min({static_cast<int>(std::lround(transition_seconds * clip.frames_per_second)),
                   before, clip.frame_count() - 1 - after}));
  Clip result = clip;
  result.poses.assign(clip.poses.begin(), clip.poses.begin() + before);
  result.poses.insert(result.poses.end(), clip.poses.begin() + after, clip.poses.end());
  for (int u = -reach + 1; u < reach; ++u) {
    const int at = before + u;
    if (at < 0 || at >= result.frame_count()) continue;
    const double share = smooth_step(0.5 * (u + reach) / reach);
    const std::array<const Pose*, 2> poses = {&pose_near(clip, before + u),
                                              &pose_near(clip, after + u)};
    const std::array<double, 2> weights = {1.0 - share, share};
    result.poses[static_cast<size_t>(at)] = mean_pose(poses, weights, *poses[0]);
  }
  return result;
}

void leave_out(ChangedGesture& made, const Stroke& stroke) {
  made.clip = joined(made.clip, stroke.from, stroke.to);
  for (double& frame : made.frames)
    frame = frame < stroke.from ? frame
                                : std::max<double>(stroke.from, frame - (stroke.to - stroke.from));
}

void repeat(ChangedGesture& made, const Stroke& stroke) {
  made.clip = joined(made.clip, stroke.to, stroke.from);
  for (double& frame : made.frames)
    if (frame >= stroke.to) frame += stroke.to - stroke.from;
}

void change_repetitions(ChangedGesture& made, int repetitions) {
  for (int i = 0; i < std::abs(repetitions); ++i) {
    const std::optional<Gesture> gesture = acting_hand(made.clip);
    const std::optional<Stroke> stroke =
        gesture ? best_stroke(made.clip, *gesture) : std::optional<Stroke>();
    if (!stroke) {
      made.remarks.push_back(i == 0
                                 ? "the gesture has no strokes that repeat, so their number stays"
                                 : "one stroke of the gesture was left");
      return;
    }
    if (repetitions > 0) {
      repeat(made, *stroke);
    } else {
      leave_out(made, *stroke);
    }
  }
}

/// How fast the source goes on at a frame of it.
double rate_at(double frame, const Gesture& gesture, double speed, double ramp) {
  const double in = smooth_step((frame - gesture.first) / ramp + 0.5);
  const double out = smooth_step((gesture.last - frame) / ramp + 0.5);
  return 1.0 + (speed - 1.0) * in * out;
}

void change_speed(ChangedGesture& made, const Gesture& gesture, double speed) {
  constexpr int parts = 8;  // of a frame, in the integral
  const Clip source = made.clip;
  const double ramp = speed_change_seconds * source.frames_per_second;
  std::vector<double> when = {0.0};  // output frame of each source frame
  for (int f = 1; f < source.frame_count(); ++f) {
    double step = 0.0;
    for (int p = 0; p < parts; ++p)
      step += 1.0 / parts / rate_at(f - 1 + (p + 0.5) / parts, gesture, speed, ramp);
    when.push_back(when.back() + step);
  }
  // The last frame is reached exactly.
  const double whole = std::max(1.0, std::round(when.back()));
  for (double& frame : when) frame *= whole / std::max(when.back(), 1e-9);
  const auto source_of = [&](double frame) {
    const auto next = std::lower_bound(when.begin() + 1, when.end() - 1, frame);
    const double share = (frame - *(next - 1)) / (*next - *(next - 1));
    return static_cast<double>(next - 1 - when.begin()) + std::clamp(share, 0.0, 1.0);
  };
  made.clip.poses.clear();
  for (int f = 0; f <= static_cast<int>(whole); ++f)
    made.clip.poses.push_back(pose_at(source, source_of(f) / source.frames_per_second));
  for (double& frame : made.frames) {
    const auto at = std::min(static_cast<size_t>(frame), when.size() - 2);
    frame = when[at] + (frame - static_cast<double>(at)) * (when[at + 1] - when[at]);
  }
}

/// The hand turns more or less about its course, too: a small wave may be the wrist's alone.
void multiply_wrist(Clip& clip, const Gesture& gesture, double most_away, double factor) {
  const BodyJoint wrist = gesture.left ? LeftWrist : RightWrist;
  TurnCurve curve = turn_curve(clip, wrist);
  const std::vector<Vec3> course = low_pass(curve.turns, wrist_course_hz, clip.frames_per_second);
  for (size_t f = 0; f < curve.turns.size(); ++f) {
    const double raised = smooth_step(gesture.away[f].norm() / most_away);
    curve.turns[f] += (factor - 1.0) * raised * (curve.turns[f] - course[f]);
  }
  set_rotations(clip, wrist, curve);
}

/// The height above where the hand hangs: multiplied, but with a bend in the elbow overhead, for an
/// arm that is stretched there turns abruptly.
double changed_rise(double rise, double factor, double arm_length) {
  const double limited =
      softly_limited(factor * rise, free_rise * arm_length, highest_rise * arm_length);
  return factor > 1.0 ? std::max(rise, limited) : factor * rise;
}

struct Bones {
  double upper, lower;  // metres
};

/// The flexion of the elbow, radians, of a hand that is `distance` metres from the shoulder.
double elbow_flexion(double distance, const Bones& arm) {
  const double cosine = (distance * distance - arm.upper * arm.upper - arm.lower * arm.lower) /
                        (2.0 * arm.upper * arm.lower);
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

/// The same for distances out of reach, too: elbows stop softly before they are straight.
double soft_elbow_flexion(double distance, const Bones& arm) {
  const double length = arm.upper + arm.lower;
  return elbow_flexion(softly_limited(distance, free_reach * length, farthest_reach * length), arm);
}

/// A place for a hand that was at `before`, both seen from the shoulder, brought within reach.
Vec3 within_reach(const Vec3& place, const Vec3& before, const Bones& arm) {
  const double was = elbow_flexion(before.norm(), arm);
  const double asked =
      was + soft_elbow_flexion(place.norm(), arm) - soft_elbow_flexion(before.norm(), arm);
  const double flexion = -softly_limited(-asked, -std::min(was, least_flexion), 0.0);
  const double distance = std::sqrt(arm.upper * arm.upper + arm.lower * arm.lower +
                                    2.0 * arm.upper * arm.lower * std::cos(std::min(flexion, pi)));
  return distance * place.normalized();
}

void move_hand(Clip& clip, const Gesture& gesture, const GestureChange& change) {
  double most_away = 0.0;
  for (const Vec3& place : gesture.away) most_away = std::max(most_away, place.norm());
  const auto& joints = clip.body.joints;
  const Arm arm = arm_of(gesture.left);
  const Bones bones{joints[arm.elbow].offset.norm(), joints[arm.wrist].offset.norm()};
  const double length = bones.upper + bones.lower;
  if (change.width != 1.0) multiply_wrist(clip, gesture, most_away, change.width);
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    const Vec3& away = gesture.away[f];
    const double raised = smooth_step(away.norm() / most_away);
    Vec3 shift = (change.width - 1.0) * raised * horizontal(away - gesture.centre);
    shift.y() = changed_rise(away.y(), change.height, length) - away.y();
    const Vec3 reach = away - length * Vec3::UnitY();
    shift = within_reach(reach + shift, reach, bones) - reach;
    Pose& pose = clip.poses[f];
    pose = with_wrist_moved(clip.body, pose, gesture.left,
                            heading(pose.rotations[Pelvis] * Vec3::UnitZ()) * shift);
  }
}

}  // namespace

bool is_identity(const GestureChange& change) {
  return change.height == 1.0 && change.width == 1.0 && change.speed == 1.0 &&
         change.repetitions == 0;
}

GestureChange scaled(GestureChange change, double strength) {
  change.height = std::clamp(std::pow(change.height, strength), 0.0, most_height);
  change.width = std::clamp(std::pow(change.width, strength), 0.0, most_width);
  change.speed = std::clamp(std::pow(change.speed, strength), least_speed, most_speed);
  change.repetitions = static_cast<int>(std::lround(
      std::clamp(strength * change.repetitions, -1.0 * most_repetitions, 1.0 * most_repetitions)));
  return change;
}

void check(const GestureChange& change) {
  check_range("gesture.height", change.height, 0.0, most_height);
  check_range("gesture.width", change.width, 0.0, most_width);
  check_range("gesture.speed", change.speed, least_speed, most_speed);
  check_range("gesture.repetitions", change.repetitions, -most_repetitions, most_repetitions);
}

double moved_by_gesture(const std::vector<double>& frames, double frame) {
  if (frames.size() < 2) return frame;
  const auto at =
      static_cast<size_t>(std::clamp(frame, 0.0, static_cast<double>(frames.size() - 2)));
  return frames[at] + (frame - static_cast<double>(at)) * (frames[at + 1] - frames[at]);
}

ChangedGesture with_gesture(const Clip& clip, const GestureChange& change) {
  ChangedGesture made{clip, {}, {}};
  for (int f = 0; f < clip.frame_count(); ++f) made.frames.push_back(f);
  if (is_identity(change)) return made;
  if (!acting_hand(clip)) {
    made.remarks.emplace_back("no single hand makes a gesture, so its change had no effect");
    return made;
  }
  change_repetitions(made, change.repetitions);
  if (const auto gesture = acting_hand(made.clip); gesture && change.speed != 1.0)
    change_speed(made, *gesture, change.speed);
  if (const auto gesture = acting_hand(made.clip);
      gesture && (change.height != 1.0 || change.width != 1.0))
    move_hand(made.clip, *gesture, change);
  return made;
}

}  // namespace mien::motion
