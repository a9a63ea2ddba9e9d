#include "motion/modify/contacts_carried.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "motion/gait/foot_path.h"
#include "motion/gait/foot_placement.h"
#include "motion/gait/gait_plants.h"
#include "motion/math/rotation.h"
#include "motion/modify/foot_reach.h"
#include "motion/modify/foot_repair.h"
#include "motion/modify/hip_shift.h"
#include "motion/skeleton/sole_height.h"

namespace mien::motion {

namespace {

constexpr double near_floor = 0.01;     // metres above the lowest part of a sole
constexpr double hardly_more = 0.0005;  // metres from frame to frame

/// The frames of the restyled motion whose source frames lie in a plant of the original. Frames of
/// a loop may run on into the next cycle.
std::optional<FootPlant> timed_plant(const FootPlant& plant, const std::vector<double>& source,
                                     int original_frames, bool loops) {
  const auto frames = static_cast<int>(source.size());
  std::optional<FootPlant> timed;
  for (int f = 0; f < (loops ? 2 * frames : frames); ++f) {
    const double at = source[static_cast<size_t>(f % frames)] + (f / frames) * original_frames;
    if (at < plant.first - 1e-9 || at > plant.last + 1e-9) continue;
    if (!timed) timed = FootPlant{plant.left, f, f};
    timed->last = f;
  }
  if (timed && timed->first >= frames) {
    timed->first -= frames;
    timed->last -= frames;
  }
  return timed;
}

/// The sole of one foot in each frame; frames of a loop may run on into the next cycles.
struct Soles {
  std::vector<SolePoints> points;
  bool loops = false;
  Vec3 displacement = Vec3::Zero();

  SolePoints at(int frame) const {
    const auto count = static_cast<int>(points.size());
    if (!loops) return points[static_cast<size_t>(std::clamp(frame, 0, count - 1))];
    const int lap = frame >= 0 ? frame / count : -((-frame + count - 1) / count);
    SolePoints point = points[static_cast<size_t>(frame - lap * count)];
    for (Vec3* part : {&point.heel, &point.ball, &point.tip}) *part += lap * displacement;
    return point;
  }
};

Soles soles_of(const Clip& clip, bool left) {
  return {sole_paths(clip, left), clip.loops, clip.cycle_displacement};
}

constexpr std::array<Vec3 SolePoints::*, 3> sole_parts = {&SolePoints::heel, &SolePoints::ball,
                                                          &SolePoints::tip};

/// How high a part of the sole is above the lowest one in two frames, at most.
double lift(const SolePoints& from, const SolePoints& to, Vec3 SolePoints::*part) {
  return std::max((from.*part).y() - lowest_height(from), (to.*part).y() - lowest_height(to));
}

Vec3 way_of(const SolePoints& from, const SolePoints& to, Vec3 SolePoints::*part) {
  return horizontal(to.*part - from.*part);
}

/// The part about which a planted foot rolls from one frame to the next: of those near the floor
/// the one that moves least in the original, or the ball if it hardly moves more; the lowest part
/// if none is near the floor in both frames.
Vec3 SolePoints::*pivot(const SolePoints& from, const SolePoints& to, const SolePoints& known_from,
                        const SolePoints& known_to) {
  Vec3 SolePoints::*best = nullptr;
  double least = 0.0;
  for (const auto part : sole_parts) {
    if (lift(from, to, part) > near_floor) continue;
    const double way =
        way_of(known_from, known_to, part).norm() + (part == &SolePoints::ball ? 0.0 : hardly_more);
    if (best != nullptr && way >= least) continue;
    best = part;
    least = way;
  }
  if (best != nullptr) return best;
  return *std::min_element(sole_parts.begin(), sole_parts.end(),
                           [&](auto a, auto b) { return lift(from, to, a) < lift(from, to, b); });
}

/// How far a foot slips between two frames, horizontally: the way of that part near the floor (or
/// of the lowest) which moves least. A foot that rolls from heel to ball to toes, or turns on its
/// ball, does not slip.
Vec3 slip(const SolePoints& from, const SolePoints& to) {
  return way_of(from, to, pivot(from, to, from, to));
}

/// Where the planted foot goes: it keeps its rotation, rolls without slipping near where it is on
/// the average, and is as high above the floor as in the original.
FootTrajectory rolled(const FootPath& path, const Soles& soles, const Soles& known,
                      const FootPlant& plant) {
  FootTrajectory stretch{plant.left, plant.first, {}};
  std::vector<Vec3> moved = {Vec3::Zero()};
  Vec3 mean = Vec3::Zero();
  for (int f = plant.first; f < plant.last; ++f) {
    const SolePoints from = soles.at(f);
    const SolePoints to = soles.at(f + 1);
    moved.push_back(moved.back() - way_of(from, to, pivot(from, to, known.at(f), known.at(f + 1))));
    mean += moved.back();
  }
  mean /= static_cast<double>(moved.size());
  for (int f = plant.first; f <= plant.last; ++f) {
    Vec3 shift = moved[static_cast<size_t>(f - plant.first)] - mean;
    shift.y() = lowest_height(known.at(f)) - lowest_height(soles.at(f));
    stretch.places.push_back({path.ankle_at(f) + shift, path.rotation_at(f)});
  }
  return stretch;
}

}  // namespace

std::vector<double> even_source_frames(const Clip& original, int frames) {
  const double span = original.loops ? original.frame_count() : original.frame_count() - 1;
  const double intervals = original.loops ? frames : std::max(1, frames - 1);
  std::vector<double> source;
  for (int f = 0; f < frames; ++f) source.push_back(f * span / intervals);
  return source;
}

TimedOriginal timed_original(const Clip& original, const std::vector<double>& source_frames) {
  const std::vector<FootPlant> plants = gait_plants(original);
  const Clip still = with_still_feet(original, plants);
  TimedOriginal timed{still, {}};
  timed.still.poses.clear();
  for (const double frame : source_frames) {
    timed.still.poses.push_back(pose_at(still, frame / still.frames_per_second));
  }
  for (const FootPlant& plant : plants) {
    const auto found = timed_plant(plant, source_frames, original.frame_count(), original.loops);
    if (found) timed.plants.push_back(*found);
  }
  return timed;
}

Clip with_contacts_carried(const Clip& restyled, const TimedOriginal& original) {
  if (original.plants.empty()) return restyled;
  const Clip shifted = with_hip_shift(restyled, original.still, original.plants, HipPath::smooth);
  std::vector<FootTrajectory> stretches;
  for (const bool left : {true, false}) {
    const Soles soles = soles_of(shifted, left);
    const Soles known = soles_of(original.still, left);
    const FootPath path = foot_path(shifted, left);
    for (const FootPlant& plant : original.plants) {
      if (plant.left == left) stretches.push_back(rolled(path, soles, known, plant));
    }
  }
  FootLockOptions options;
  options.keep_velocity = true;
  const Clip in_reach = with_feet_in_reach(shifted, stretches);
  const Clip placed = with_feet_placed(in_reach, stretches, options);
  return with_toe_clearance(placed, original.still, original.plants);
}

double contact_slide(const Clip& restyled, const TimedOriginal& original) {
  double largest = 0.0;
  for (const bool left : {true, false}) {
    const Soles soles = soles_of(restyled, left);
    for (const FootPlant& plant : original.plants) {
      if (plant.left != left) continue;
      Vec3 way = Vec3::Zero();
      for (int f = plant.first; f < plant.last; ++f) {
        way += slip(soles.at(f), soles.at(f + 1));
        largest = std::max(largest, way.norm());
      }
    }
  }
  return largest;
}

double contact_height_error(const Clip& restyled, const TimedOriginal& original) {
  double largest = 0.0;
  for (const bool left : {true, false}) {
    const Soles soles = soles_of(restyled, left);
    const Soles known = soles_of(original.still, left);
    for (const FootPlant& plant : original.plants) {
      if (plant.left != left) continue;
      for (int f = plant.first; f <= plant.last; ++f) {
        largest =
            std::max(largest, std::abs(lowest_height(soles.at(f)) - lowest_height(known.at(f))));
      }
    }
  }
  return largest;
}

}  // namespace mien::motion
