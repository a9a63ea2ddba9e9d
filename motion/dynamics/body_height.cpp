#include "motion/dynamics/body_height.h"

#include <algorithm>
#include <cmath>

#include "motion/biomechanics/body_dynamics.h"
#include "motion/biomechanics/body_mass.h"
#include "motion/biomechanics/soft_limits.h"
#include "motion/gait/foot_path.h"
#include "motion/gait/foot_placement.h"
#include "motion/math/filter.h"
#include "motion/skeleton/pose.h"

namespace mien::motion {

namespace {

constexpr double join_seconds = 0.2;      // on the floor, in which speeds are joined to a flight's
constexpr double longest_leg = 0.985;     // of its length
constexpr double lowest_pelvis = 0.55;    // of the legs' length
constexpr double lowering_seconds = 0.5;  // over which heights are lowered to where legs reach
constexpr int leg_rounds = 5;             // the legs' own masses move when the pelvis does

size_t wrapped(int frame, int count, bool loops) {
  return static_cast<size_t>(loops ? ((frame % count) + count) % count
                                   : std::clamp(frame, 0, count - 1));
}

double height(const Clip& clip, size_t frame) {
  return centre_of_mass(clip.body, world_transforms(clip.body, clip.poses[frame])).y();
}

/// Adds `speed` to the speed at the edge of a flight: to heights on the floor that lead to it
/// (direction −1 from the take-off) or away from it (+1 from the landing).
void join_speed(std::vector<double>& heights, int edge, int direction, double speed, int frames,
                double frames_per_second, bool loops) {
  const int count = static_cast<int>(heights.size());
  for (int away = 1; away < frames; ++away) {
    const int frame = edge + direction * away;
    if (!loops && (frame < 0 || frame >= count)) break;
    const double left = 1.0 - static_cast<double>(away) / frames;
    heights[wrapped(frame, count, loops)] +=
        direction * speed * away / frames_per_second * left * left;
  }
}

/// Speed per second at an edge, from the two frames on the floor beside it.
double edge_speed(const std::vector<double>& heights, int edge, int direction,
                  double frames_per_second, bool loops) {
  const auto at = [&](int away) {
    return heights[wrapped(edge + direction * away, static_cast<int>(heights.size()), loops)];
  };
  return direction * frames_per_second * 0.5 * (4.0 * at(1) - at(2) - 3.0 * at(0));
}

/// Frames on the floor beside the edge of a flight, up to the next flight.
int frames_on_floor(const std::vector<Airborne>& flights, int edge, int direction, int count,
                    bool loops, int most) {
  int frames = most;
  for (const Airborne& other : flights) {
    int away = direction > 0 ? other.take_off - edge : edge - other.landing;
    if (loops) away = ((away % count) + count) % count;
    if (away >= 0) frames = std::min(frames, away);
  }
  return frames;
}

/// Positions of one foot in the frames in which it stays.
std::vector<FootTrajectory> trajectories(const Clip& clip, const std::vector<FootPlant>& plants,
                                         FeetStay feet) {
  std::vector<FootTrajectory> stretches;
  for (const bool left : {true, false}) {
    const FootPath path = foot_path(clip, left);
    const auto add = [&](int first, int last) {
      FootTrajectory stretch{left, first, {}};
      for (int f = first; f <= last; ++f)
        stretch.places.push_back({path.ankle_at(f), path.rotation_at(f)});
      stretches.push_back(std::move(stretch));
    };
    if (feet == FeetStay::all) {
      add(0, clip.frame_count() - 1);
      continue;
    }
    for (const FootPlant& plant : plants) {
      if (plant.left == left) add(plant.first, plant.last);
    }
  }
  return stretches;
}

/// How much higher the pelvis may be in each frame for standing legs to reach the floor; what they
/// reach already, they may.
std::vector<double> room_above(const Clip& clip, const std::vector<FootTrajectory>& stretches) {
  std::vector<double> room(clip.poses.size(), INFINITY);
  std::vector<JointTransforms> worlds;
  for (const Pose& pose : clip.poses) worlds.push_back(world_transforms(clip.body, pose));
  for (const FootTrajectory& stretch : stretches) {
    const LegJoints leg = leg_joints(stretch.left);
    const double length =
        clip.body.joints[leg.knee].offset.norm() + clip.body.joints[leg.ankle].offset.norm();
    for (size_t i = 0; i < stretch.places.size(); ++i) {
      const size_t f = wrapped(stretch.first + static_cast<int>(i), clip.frame_count(), clip.loops);
      const Vec3 line = worlds[f].positions[leg.hip] - worlds[f].positions[leg.ankle];
      const double longest = std::max(longest_leg * length, line.norm());
      const double across = std::hypot(line.x(), line.z());
      const double most = std::sqrt(std::max(0.0, longest * longest - across * across));
      room[f] = std::min(room[f], most - line.y());
    }
  }
  return room;
}

/// The heights, lowered and raised to where the legs can carry the body.
std::vector<double> carried(const Clip& clip, std::vector<double> heights,
                            const std::vector<double>& now,
                            const std::vector<FootTrajectory>& stretches) {
  const std::vector<double> room = room_above(clip, stretches);
  const double lowest = lowest_pelvis * leg_length(clip.body);
  std::vector<double> excess(heights.size(), 0.0);
  for (size_t f = 0; f < heights.size(); ++f)
    excess[f] = std::max(0.0, heights[f] - now[f] - room[f]);
  const int half_width =
      std::max(1, static_cast<int>(std::lround(lowering_seconds * clip.frames_per_second)));
  const std::vector<double> lowered = smooth_envelope(excess, half_width, clip.loops);
  for (size_t f = 0; f < heights.size(); ++f) {
    const double drop = now[f] - heights[f] + lowered[f];
    const double depth = std::max(0.02, clip.poses[f].root_position.y() - lowest);
    heights[f] = now[f] - (drop > 0.0 ? softly_limited(drop, 0.6 * depth, depth) : drop);
  }
  return heights;
}

}  // namespace

std::vector<double> body_heights(const Clip& clip) {
  std::vector<double> heights;
  for (size_t f = 0; f < clip.poses.size(); ++f) heights.push_back(height(clip, f));
  return heights;
}

std::vector<double> ballistic(std::vector<double> heights, const std::vector<Airborne>& flights,
                              double frames_per_second, bool loops) {
  const int count = static_cast<int>(heights.size());
  const int join = std::max(2, static_cast<int>(std::lround(join_seconds * frames_per_second)));
  const std::vector<double> given = heights;
  for (const Airborne& flight : flights) {
    const double seconds = (flight.landing - flight.take_off) / frames_per_second;
    const double from = given[wrapped(flight.take_off, count, loops)];
    const double to = given[wrapped(flight.landing, count, loops)];
    for (int f = flight.take_off + 1; f < flight.landing; ++f) {
      const double time = (f - flight.take_off) / frames_per_second;
      heights[wrapped(f, count, loops)] =
          from + (to - from) * time / seconds + 0.5 * gravity * time * (seconds - time);
    }
    const double mean = (to - from) / seconds;
    for (const int direction : {-1, 1}) {
      const int edge = direction < 0 ? flight.take_off : flight.landing;
      const double speed = mean - direction * 0.5 * gravity * seconds;
      const double missing = speed - edge_speed(given, edge, direction, frames_per_second, loops);
      const int frames = frames_on_floor(flights, edge, direction, count, loops, join);
      join_speed(heights, edge, direction, missing, frames, frames_per_second, loops);
    }
  }
  return heights;
}

Clip with_body_heights(const Clip& clip, std::vector<double> heights,
                       const std::vector<FootPlant>& plants, const std::vector<Airborne>& flights,
                       FeetStay feet) {
  const std::vector<FootTrajectory> stretches = trajectories(clip, plants, feet);
  heights = carried(clip, std::move(heights), body_heights(clip), stretches);
  heights = ballistic(std::move(heights), flights, clip.frames_per_second, clip.loops);
  FootLockOptions options;
  options.keep_velocity = true;
  options.extension = 1.0;
  Clip result = clip;
  for (int round = 0; round < leg_rounds; ++round) {
    for (size_t f = 0; f < result.poses.size(); ++f)
      result.poses[f].root_position.y() += heights[f] - height(result, f);
    result = with_feet_placed(result, stretches, options);
  }
  // What the legs could not follow moves the edges of flights by fractions of a millimetre.
  const std::vector<double> reached = body_heights(result);
  const std::vector<double> falling =
      ballistic(reached, flights, clip.frames_per_second, clip.loops);
  for (const Airborne& flight : flights) {
    for (int frame = flight.take_off + 1; frame < flight.landing; ++frame) {
      const size_t f = wrapped(frame, clip.frame_count(), clip.loops);
      result.poses[f].root_position.y() += falling[f] - reached[f];
    }
  }
  return result;
}

}  // namespace mien::motion
