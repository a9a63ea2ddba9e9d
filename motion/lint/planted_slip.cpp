#include "motion/lint/planted_slip.h"

#include <algorithm>
#include <cmath>

#include "motion/skeleton/sole.h"

namespace mien::motion {

namespace {

constexpr double ends_seconds = 0.05;
constexpr double flat_metres = 0.01;

/// What the supporting part of a sole moves between two frames. Of a flat sole all of it bears, and
/// the point that moves least shows how far it slides.
Vec3 slide(const SolePoints& from, const SolePoints& to) {
  const double heel = 0.5 * (from.heel.y() + to.heel.y());
  const double ball = 0.5 * (from.ball.y() + to.ball.y());
  const Vec3 of_heel = horizontal(to.heel - from.heel);
  const Vec3 of_ball = horizontal(to.ball - from.ball);
  if (heel < ball - flat_metres) return of_heel;
  if (ball < heel - flat_metres) return of_ball;
  return of_heel.norm() < of_ball.norm() ? of_heel : of_ball;
}

}  // namespace

std::vector<Vec3> planted_track(const LintMotion& motion, const FootPlant& plant) {
  const int ends = static_cast<int>(std::lround(ends_seconds * motion.rate()));
  std::vector<Vec3> track(1, Vec3::Zero());
  const auto sole = [&](int t) {
    return sole_points(motion.clip.body, motion.world[t], plant.left);
  };
  const int last = std::min(plant.last - ends, motion.frame_count() - 1);
  for (int t = plant.first + ends; t < last; ++t) {
    track.push_back(track.back() + slide(sole(t), sole(t + 1)));
  }
  return track;
}

double planted_slip(const LintMotion& motion, const FootPlant& plant) {
  const std::vector<Vec3> track = planted_track(motion, plant);
  double farthest = 0.0;
  for (size_t a = 0; a < track.size(); ++a) {
    for (size_t b = 0; b < a; ++b) farthest = std::max(farthest, (track[a] - track[b]).norm());
  }
  return farthest;
}

}  // namespace mien::motion
