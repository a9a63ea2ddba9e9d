#include "motion/steered_walk/scripted_walk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/error.h"
#include "motion/steered_walk/floor_path.h"
#include "motion/steered_walk/step_plan.h"

namespace mien::motion {

namespace {

constexpr double longest_seconds = 3600.0;

void require_number(bool good, const char* wrong, const char* remedy) {
  if (!good) throw Error(wrong, remedy);
}

/// A walker and the clip that is made of it.
struct Filming {
  const WalkerGaits& gaits;
  const ScriptedWalkOptions& options;
  SteeredWalk walker;
  Clip clip;
  std::vector<FootPlant> plants = {};  ///< until now
  std::vector<double> moods = {};      ///< of the last segment that named any
};

/// Takes the pose of now as the next frame.
void expose(Filming& film) {
  const int frame = film.clip.frame_count();
  for (std::size_t side = 0; side < 2; ++side) {
    if (film.walker.legs[side].swinging) continue;
    const auto open = std::find_if(
        film.plants.rbegin(), film.plants.rend(),
        [&](const auto& plant) { return plant.left == (side == 0) && plant.last == frame - 1; });
    if (open == film.plants.rend())
      film.plants.push_back({side == 0, frame, frame});
    else
      open->last = frame;
  }
  film.clip.poses.push_back(pose_of(film.gaits, film.walker));
}

Filming filming(const WalkerGaits& gaits, const ScriptedWalkOptions& options, const Vec3& place,
                double heading) {
  require_number(options.frames_per_second > 0.0 && std::isfinite(options.frames_per_second),
                 "the frame rate of a walk is not positive", "give it in 1/s");
  const std::vector<double> first =
      options.moods.empty() ? std::vector<double>{} : options.moods.front().moods;
  Filming film{gaits, options, standing_walker(gaits, place, heading, first), {}};
  film.clip.body = gaits.body;
  film.clip.frames_per_second = options.frames_per_second;
  expose(film);
  return film;
}

std::vector<double> moods_at(const ScriptedWalkOptions& options, double seconds) {
  std::vector<double> moods =
      options.moods.empty() ? std::vector<double>{} : options.moods.front().moods;
  for (const MoodChange& from : options.moods) {
    if (from.seconds <= seconds) moods = from.moods;
  }
  return moods;
}

void film_frame(Filming& film, Steering steering) {
  steering.moods =
      film.moods.empty() ? moods_at(film.options, film.clip.duration_seconds()) : film.moods;
  advance(film.gaits, steering, 1.0 / film.clip.frames_per_second, film.walker);
  expose(film);
  if (film.clip.duration_seconds() > longest_seconds) {
    throw Error("a walk of more than an hour", "make the script or the path shorter");
  }
}

void film_for(Filming& film, const Steering& steering, double seconds) {
  const auto frames = std::lround(seconds * film.clip.frames_per_second);
  for (long i = 0; i < frames; ++i) film_frame(film, steering);
}

bool faces(const SteeredWalk& walker, double heading) {
  return std::abs(std::remainder(walker.root.heading - heading, 2.0 * pi)) <
         radians_per_degree * 6.0;
}

void check_segment(const WalkSegment& segment) {
  const bool numbers = std::isfinite(segment.seconds) && std::isfinite(segment.degrees) &&
                       std::isfinite(segment.pace) && std::isfinite(segment.turn_rate_deg);
  require_number(numbers && segment.seconds >= 0.0,
                 "a walk script with an invalid number, or a time below 0",
                 "give seconds, degrees and weights");
  require_number(segment.pace >= 0.0 && segment.pace <= gait_paces.back(),
                 "a walk's pace is not between 0 and 1.2",
                 "1 is the style's own speed; choose a faster style for more");
}

/// Does one segment; `heading` is what the walker is to face, before and after.
void film_segment(Filming& film, const WalkSegment& segment, double& heading) {
  Steering steering;
  steering.heading = heading;
  if (segment.kind == WalkSegment::Kind::walk) {
    steering.pace = segment.pace;
    if (segment.turn_rate_deg != 0.0) {
      steering.heading.reset();
      steering.turning = radians_per_degree * segment.turn_rate_deg;
    }
    film_for(film, steering, segment.seconds);
    if (!steering.heading) heading = film.walker.root.heading + coasting_turn(film.walker.root);
    return;
  }
  if (segment.kind == WalkSegment::Kind::turn) {
    // More than half a turn is made in parts: a heading is turned to the shorter way.
    double left = radians_per_degree * segment.degrees;
    steering.pace = segment.pace;
    while (left != 0.0) {
      const double part = std::clamp(left, -0.9 * pi, 0.9 * pi);
      left -= part;
      heading += part;
      steering.heading = heading;
      while (!faces(film.walker, heading) ||
             (segment.pace == 0.0 && left == 0.0 && film.walker.stepping)) {
        film_frame(film, steering);
      }
    }
    return;
  }
  while (!at_rest(film.walker)) film_frame(film, steering);
  film_for(film, steering, segment.seconds);
}

/// Fastest that a curve can be walked, m/s (limits: step_plan.h).
double speed_for(double curvature) {
  constexpr double margin = 0.8;
  const double turning = margin * fastest_turning / std::max(curvature, 1e-3);
  const double sideways =
      std::sqrt(margin * most_sideways_acceleration / std::max(curvature, 1e-3));
  return std::min(turning, sideways);
}

/// Steers back onto the path and along it: pure pursuit (Coulter 1992) of a point ahead, from where
/// the walker will be when it has answered.
Steering steering_along(const FloorPath& path, double way, const RootMotion& root, double pace,
                        double own) {
  constexpr double answer = 0.35;  // seconds
  const double speed = std::max(0.15, root.speed.value);
  RootMotion then = root;
  then.place += speed * answer * forward_of(root);
  then.heading = root.heading + coasting_turn(root);
  const double ahead = 0.3 + 0.25 * speed;
  const Vec3 goal = to_local(then, point_at(path, way + speed * answer + ahead));
  const double distance = std::max(0.1, goal.norm());
  const double angle = std::atan2(goal.x(), goal.z());
  const double curvature = largest_curvature(path, way - 0.2, way + 0.4 + 0.8 * speed);
  Steering steering;
  steering.pace = std::clamp(std::min(pace, speed_for(curvature) / own), 0.05, pace);
  steering.turning = 2.0 * speed * std::sin(std::clamp(angle, -1.5, 1.5)) / distance;
  return steering;
}

}  // namespace

WalkedClip scripted_walk(const WalkerGaits& gaits, std::span<const WalkSegment> script,
                         const ScriptedWalkOptions& options) {
  require_number(!script.empty(), "an empty script for a walk", "give at least one segment");
  double heading = options.heading;
  Filming film = filming(gaits, options, options.place, heading);
  std::vector<double> starts;
  for (const WalkSegment& segment : script) {
    check_segment(segment);
    starts.push_back(film.clip.duration_seconds());
    if (!segment.moods.empty()) film.moods = segment.moods;
    film_segment(film, segment, heading);
  }
  return {std::move(film.clip), std::move(film.plants), std::move(starts)};
}

WalkedClip walk_along(const WalkerGaits& gaits, std::span<const Vec3> polyline, double pace,
                      const ScriptedWalkOptions& options) {
  require_number(pace > 0.0 && pace <= gait_paces.back(), "a walk's pace is not between 0 and 1.2",
                 "1 is the style's own speed; choose a faster style for more");
  const FloorPath path = floor_path(polyline);
  const double length = path.length();
  Filming film = filming(gaits, options, path.points.front(), heading_at(path, 0.2));
  double way = 0.0;
  while (length - way > coasting_distance(film.walker.root) + 0.02) {
    const RootMotion& root = film.walker.root;
    const double own = own_speed(gaits, shares_of(film.walker.gaits));
    film_frame(film, steering_along(path, way, root, pace, own));
    way = nearest_way(path, film.walker.root.place, way);
  }
  Steering stop;
  stop.heading = heading_at(path, length);
  while (!at_rest(film.walker)) film_frame(film, stop);
  return {std::move(film.clip), std::move(film.plants)};
}

}  // namespace mien::motion
