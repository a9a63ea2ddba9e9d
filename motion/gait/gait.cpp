#include "motion/gait/gait.h"

#include <algorithm>
#include <cmath>

#include "motion/gait/loop.h"
#include "motion/gait/steadiest_step.h"
#include "motion/gait/stride.h"
#include "motion/math/percentile.h"
#include "motion/math/rotation.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

namespace {

// Below it steps are no walk: climbing, dancing, standing.
constexpr double least_steadiness = 0.1;
constexpr double steady = 0.3;       // below it a walk visibly starts, stops or turns
constexpr double least_step = 0.08;  // m at 1.75 m
// Seam cost: a tenth of that between the extremes of a stride.
constexpr double alike_enough = 0.5;

/// Whether the ankle gets away from a place during the stride: feet that stand take no steps,
/// however the body sways over them.
bool takes_a_step(const Clip& clip, const Stride& stride, BodyJoint ankle) {
  Eigen::AlignedBox3d room;
  const int last =
      std::min(static_cast<int>(std::ceil(stride.next_strike)), clip.frame_count() - 1);
  for (int t = std::max(static_cast<int>(stride.strike), 0); t <= last; ++t) {
    room.extend(world_transform(clip.body, clip.poses[t], ankle).position);
  }
  return room.diagonal().norm() > least_step * relative_stature(clip.body);
}

std::optional<GaitCycle> cycle_of(const Clip& clip, const Stride& stride) {
  const auto keyframes = left_based_keyframes(stride);
  if (!keyframes) return std::nullopt;
  if (!takes_a_step(clip, stride, LeftAnkle) || !takes_a_step(clip, stride, RightAnkle)) {
    return std::nullopt;
  }
  const int last = clip.frame_count() - 1;
  GaitCycle cycle;
  cycle.start_frame = std::clamp(static_cast<int>(std::lround(stride.strike)), 0, last);
  cycle.end_frame = std::clamp(static_cast<int>(std::lround(stride.next_strike)), 0, last);
  cycle.starts_left = stride.left;
  cycle.left_strike = left_strike(stride);
  for (size_t k = 0; k < keyframes->size(); ++k) {
    cycle.keytimes[k] = (*keyframes)[k] / clip.frames_per_second;
  }
  const Vec3 travel = horizontal(clip.poses[cycle.end_frame].root_position -
                                 clip.poses[cycle.start_frame].root_position);
  cycle.speed_m_s = travel.norm() * clip.frames_per_second / (cycle.end_frame - cycle.start_frame);
  cycle.has_flight = has_flight(stride);
  if (!stride.confirmed) {
    cycle.warnings.push_back(
        "Foot contact does not agree with all heel strikes and toe offs of this cycle to 0.1 s.");
  }
  return cycle;
}

/// Mean horizontal velocity over 0.2 s around a frame.
Vec3 velocity_around(const Clip& clip, int frame) {
  const int reach = std::max(1, static_cast<int>(std::lround(0.1 * clip.frames_per_second)));
  const int before = std::max(0, frame - reach);
  const int after = std::min(clip.frame_count() - 1, frame + reach);
  return horizontal(clip.poses[after].root_position - clip.poses[before].root_position) *
         (clip.frames_per_second / std::max(1, after - before));
}

double heading_change(const Clip& clip, int from, int to) {
  const auto facing = [&](int frame) {
    return heading(clip.poses[frame].rotations[Pelvis] * Vec3::UnitZ());
  };
  return angle_between(facing(from), facing(to));
}

double median(std::vector<double> values) { return percentile(values, 50); }

/// How unlike the cycle is to steady straight walking, ≥ 0. Each term is 1 where it begins to show:
/// a tenth of the speed gained or lost, 5° turned, a twentieth of the period, a tenth of the speed
/// away from the take's typical one, a visible seam.
double unsteadiness(const Clip& clip, const GaitCycle& cycle, double typical_period,
                    double typical_speed) {
  const double speed = std::max(cycle.speed_m_s, 0.2);
  const double gained = (velocity_around(clip, cycle.end_frame).norm() -
                         velocity_around(clip, cycle.start_frame).norm()) /
                        speed;
  const double turned = heading_change(clip, cycle.start_frame, cycle.end_frame);
  const double period = cycle.keytimes.back() / typical_period - 1.0;
  const double pace = (cycle.speed_m_s - typical_speed) / std::max(typical_speed, 0.2);
  const auto square = [](double x) { return x * x; };
  return square(gained / 0.1) + square(turned / (5 * radians_per_degree)) + square(period / 0.05) +
         square(pace / 0.1) + seam_cost(clip, cycle.start_frame, cycle.end_frame) / 0.5;
}

void rate(const Clip& clip, std::vector<GaitCycle>& cycles) {
  if (cycles.empty()) return;
  std::vector<double> periods;
  std::vector<double> speeds;
  for (const GaitCycle& cycle : cycles) {
    periods.push_back(cycle.keytimes.back());
    speeds.push_back(cycle.speed_m_s);
  }
  const double typical_period = median(periods);
  const double typical_speed = median(speeds);
  for (GaitCycle& cycle : cycles) {
    const double cost = unsteadiness(clip, cycle, typical_period, typical_speed);
    cycle.steadiness = 1.0 / (1.0 + 0.1 * cost);
    if (cycle.steadiness < steady) {
      cycle.warnings.push_back(
          "The walk is not steady over this cycle: it starts, stops or turns.");
    }
  }
}

std::vector<GaitCycle> cycles_of_foot(const Clip& clip, const std::vector<GaitEvent>& events,
                                      const FootProgress& progress, bool left) {
  std::vector<GaitCycle> cycles;
  for (const Stride& stride : strides(events, progress, left)) {
    if (auto cycle = cycle_of(clip, stride)) cycles.push_back(*std::move(cycle));
  }
  return cycles;
}

/// The two moments with the most similar poses, half a second to two seconds apart.
std::optional<CycleRange> most_alike(const Clip& clip) {
  const int shortest = std::max(8, static_cast<int>(std::ceil(0.5 * clip.frames_per_second)));
  const int longest = static_cast<int>(2.0 * clip.frames_per_second);
  std::optional<CycleRange> best;
  double least = 0.0;
  for (int start = 0; start + shortest < clip.frame_count(); ++start) {
    const int last = std::min(clip.frame_count() - 1, start + longest);
    for (int end = start + shortest; end <= last; ++end) {
      const double cost = seam_cost(clip, start, end);
      if (best && cost >= least) continue;
      least = cost;
      best = CycleRange{start, end};
    }
  }
  return best;
}

/// For takes of about one cycle. Looking at every pair of frames of a long take would be slow and,
/// while a person stands, meaningless.
std::optional<GaitCycle> cycle_by_similarity(const Clip& clip) {
  if (clip.duration_seconds() > 4.0) return std::nullopt;
  const auto place = most_alike(clip);
  if (!place || seam_cost(clip, place->start, place->end) > alike_enough) return std::nullopt;
  auto cycle = cycle_of_loop(closed_loop(clip, place->start, place->end));
  if (!cycle) return std::nullopt;
  cycle->start_frame += place->start;
  cycle->end_frame += place->start;
  cycle->left_strike += place->start;
  cycle->starts_left = false;
  cycle->steadiness = 1.0 / (1.0 + 0.2 * seam_cost(clip, place->start, place->end));
  cycle->warnings.push_back(
      "The take is too short for two heel strikes of one foot; the cycle ends where the pose "
      "repeats.");
  return cycle;
}

/// The steadiest step of a run and its mirror image; empty if the take does not run or no step of
/// it is steady enough.
std::optional<GaitCycle> running_step(const Clip& clip) {
  auto step = steadiest_step(clip);
  if (!step || step->steadiness < least_steadiness) return std::nullopt;
  step->warnings.push_back(
      "The take contains no steady cycle of the run; its steadiest step and the mirror image of "
      "that step are used instead.");
  return step;
}

/// The last step of a take: one foot's strike to the other's next.
std::optional<GaitCycle> half_cycle(const Clip& clip) {
  std::vector<GaitEvent> strikes;
  for (const GaitEvent& event : gait_events(clip)) {
    if (event.kind == GaitEvent::Kind::heel_strike) strikes.push_back(event);
  }
  for (size_t i = strikes.size(); i-- > 1;) {
    const double seconds = (strikes[i].frame - strikes[i - 1].frame) / clip.frames_per_second;
    if (strikes[i].left == strikes[i - 1].left || seconds < 0.2 || seconds > 1.2) continue;
    const int start = static_cast<int>(std::lround(strikes[i - 1].frame));
    const int end = static_cast<int>(std::lround(strikes[i].frame));
    if (start < 0 || end >= clip.frame_count() || end - start < 4) continue;
    auto cycle = cycle_of_loop(mirrored_loop(clip, start, end));
    if (!cycle) continue;
    cycle->start_frame = start;
    cycle->end_frame = end;
    cycle->starts_left = strikes[i - 1].left;
    cycle->left_strike += start;
    cycle->is_half = true;
    cycle->steadiness = least_steadiness;
    cycle->warnings.push_back(
        "The take contains no full cycle; one step and its mirror image are used instead.");
    return cycle;
  }
  return std::nullopt;
}

}  // namespace

std::vector<GaitCycle> gait_cycles(const Clip& clip) {
  if (clip.loops) {
    const auto cycle = cycle_of_loop(clip);
    return cycle ? std::vector<GaitCycle>{*cycle} : std::vector<GaitCycle>{};
  }
  const std::vector<GaitEvent> events = gait_events(clip);
  const FootProgress progress = foot_progress(clip);
  std::vector<GaitCycle> cycles = cycles_of_foot(clip, events, progress, true);
  if (cycles.empty()) cycles = cycles_of_foot(clip, events, progress, false);
  rate(clip, cycles);
  return cycles;
}

std::optional<GaitCycle> steadiest_cycle(const Clip& clip) {
  const std::vector<GaitCycle> cycles = gait_cycles(clip);
  if (cycles.empty() && clip.loops) return std::nullopt;
  if (cycles.empty()) {
    if (auto alike = cycle_by_similarity(clip)) return alike;
    const auto step = running_step(clip);
    return step ? step : half_cycle(clip);
  }
  const GaitCycle& best = *std::max_element(
      cycles.begin(), cycles.end(),
      [](const GaitCycle& a, const GaitCycle& b) { return a.steadiness < b.steadiness; });
  if (best.steadiness < steady) {
    const auto step = running_step(clip);
    if (step && step->steadiness > best.steadiness) return step;
  }
  if (best.steadiness < least_steadiness) return std::nullopt;
  return best;
}

std::optional<GaitCycle> cycle_of_loop(const Clip& loop) {
  const int frames = loop.frame_count();
  const Clip laps = repeated(loop, 4);
  const std::vector<GaitEvent> events = gait_events(laps);
  for (const Stride& stride : strides(events, foot_progress(laps), true)) {
    const bool in_second_lap = stride.strike >= frames - 0.5 && stride.strike < 2 * frames - 0.5;
    if (!in_second_lap || std::abs(stride.period() - frames) > 0.1 * frames) continue;
    auto cycle = cycle_of(laps, stride);
    if (!cycle) continue;
    const double scale = frames / stride.period();
    for (double& keytime : cycle->keytimes) keytime *= scale;
    cycle->keytimes.back() = loop.duration_seconds();
    cycle->start_frame = 0;
    cycle->end_frame = frames;
    cycle->left_strike = std::fmod(stride.strike, frames);
    cycle->speed_m_s = loop.cycle_displacement.norm() / loop.duration_seconds();
    cycle->steadiness = 1.0;
    return cycle;
  }
  return std::nullopt;
}

}  // namespace mien::motion
