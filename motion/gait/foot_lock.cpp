#include "motion/gait/foot_lock.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "motion/gait/foot_path.h"
#include "motion/gait/foot_placement.h"
#include "motion/math/filter.h"
#include "motion/math/rotation.h"

namespace mien::motion {

namespace {

/// A foot that is just leaving the floor may move: drift is measured a little below the height at
/// which the lock lets go.
constexpr double standing_share = 0.7;

Quat mean_rotation(const FootPath& path, int first, int last) {
  Quat mean = path.rotation_at((first + last) / 2);
  for (int iteration = 0; iteration < 3; ++iteration) {
    Vec3 step = Vec3::Zero();
    for (int f = first; f <= last; ++f) step += log(mean.conjugate() * path.rotation_at(f));
    mean = (mean * exp(step / (last - first + 1))).normalized();
  }
  return mean;
}

/// The rotation of a foot that stands, without the lift of the toes that a badly calibrated capture
/// gives it: people do not stand on their heels.
Quat without_toe_lift(const Quat& sole, const FootPath& path) {
  const Vec3 along = sole * (path.ball_in_foot - path.heel_in_foot);
  if (along.y() <= 0.0) return sole;
  return (turn_between(along, Vec3(along.x(), 0.0, along.z())) * sole).normalized();
}

/// Where the foot stands at each frame of its stance, in unrolled coordinates. Over the floor the
/// pivot stays where it is; its height is the input's, so that a foot may roll on over its toes.
std::vector<FootPlace> standing(const FootPath& path, const Stance& stance, double turn_frames) {
  const Quat sole =
      without_toe_lift(mean_rotation(path, stance.flat_first, stance.flat_last), path);
  Vec3 ball = Vec3::Zero();
  for (int f = stance.flat_first; f <= stance.flat_last; ++f) ball += path.ball_at(f);
  ball /= stance.flat_last - stance.flat_first + 1;
  const Vec3 heel = ball + sole * (path.heel_in_foot - path.ball_in_foot);
  const double ball_lift = ball.y() - path.ball_at(stance.flat_last).y();
  const double heel_lift = heel.y() - path.heel_at(stance.flat_first).y();

  std::vector<FootPlace> places;
  for (int f = stance.first; f <= stance.last; ++f) {
    const int edge = std::clamp(f, stance.flat_first, stance.flat_last);
    const Vec3 flatten = log(sole * path.rotation_at(edge).conjugate());
    const double share = fade(std::abs(f - edge) / turn_frames);
    const Quat turned = f == edge ? sole : exp(share * flatten) * path.rotation_at(f);
    const bool on_heel = f < stance.flat_first;
    Vec3 pivot = on_heel ? heel : ball;
    if (on_heel) pivot.y() = std::max(heel.y(), path.heel_at(f).y() + share * heel_lift);
    if (f > stance.flat_last)
      pivot.y() = std::max(ball.y(), path.ball_at(f).y() + share * ball_lift);
    places.push_back({pivot - turned * (on_heel ? path.heel_in_foot : path.ball_in_foot), turned});
  }
  return places;
}

std::vector<FootPlant> plants_of(const std::vector<FootPlant>& plants, bool left) {
  std::vector<FootPlant> own;
  std::copy_if(plants.begin(), plants.end(), std::back_inserter(own),
               [&](const FootPlant& plant) { return plant.left == left; });
  return own;
}

/// How far a foot hangs above the floor (y = 0), or is below it, while it stands flat. Mean over
/// its plants; nothing without any.
std::optional<double> hang(const Clip& clip, const std::vector<FootPlant>& plants, bool left,
                           const FootLockOptions& options) {
  const FootPath path = foot_path(clip, left);
  const std::vector<FootPlant> own = plants_of(plants, left);
  if (own.empty()) return std::nullopt;
  double sum = 0.0;
  for (const FootPlant& plant : own) {
    const Stance stance = stance_of(path, plant, options.flat_metres, options.lifted_metres);
    double height = 0.0;
    for (int f = stance.flat_first; f <= stance.flat_last; ++f) {
      height += path.ball_at(f).y();  // on which it comes to stand
    }
    sum += height / (stance.flat_last - stance.flat_first + 1) - path.sole_depth;
  }
  return sum / static_cast<double>(own.size());
}

/// The clip moved up or down until its feet, on the average, stand on the floor.
Clip grounded(const Clip& clip, const std::vector<FootPlant>& plants,
              const FootLockOptions& options) {
  const auto left = hang(clip, plants, true, options);
  const auto right = hang(clip, plants, false, options);
  if (!left && !right) return clip;
  const double height = ((left ? *left : *right) + (right ? *right : *left)) / 2.0;
  Clip result = clip;
  for (Pose& pose : result.poses) pose.root_position.y() -= height;
  return result;
}

/// Where each plant of the foot stands, from heel strike to lift.
void add_stances(std::vector<FootTrajectory>& stretches, const Clip& clip,
                 const std::vector<FootPlant>& plants, bool left, const FootLockOptions& options) {
  const FootPath path = foot_path(clip, left);
  const double turn_frames = std::max(1.0, 0.1 * clip.frames_per_second);
  for (const FootPlant& plant : plants_of(plants, left)) {
    const Stance stance = stance_of(path, plant, options.flat_metres, options.lifted_metres);
    stretches.push_back({left, stance.first, standing(path, stance, turn_frames)});
  }
}

}  // namespace

Clip foot_locked(const Clip& free, const std::vector<FootPlant>& plants,
                 const FootLockOptions& options) {
  const Clip clip = grounded(free, plants, options);
  std::vector<FootTrajectory> stretches;
  std::array<double, 2> lowered = {0.0, 0.0};
  for (const bool left : {true, false}) {
    add_stances(stretches, clip, plants, left, options);
    lowered[left ? 0 : 1] = hang(clip, plants, left, options).value_or(0.0);
  }
  return with_feet_placed(clip, stretches, options, lowered);
}

double planted_drift(const Clip& clip, const std::vector<FootPlant>& plants,
                     const FootLockOptions& options) {
  double largest = 0.0;
  const auto across = [](const Vec3& v) { return std::hypot(v.x(), v.z()); };
  if (plants.empty()) return largest;
  const FootPath left = foot_path(clip, true);
  const FootPath right = foot_path(clip, false);
  for (const FootPlant& plant : plants) {
    const FootPath& path = plant.left ? left : right;
    const Stance stance =
        stance_of(path, plant, options.flat_metres, standing_share * options.lifted_metres);
    for (int f = stance.first; f <= stance.last; ++f) {
      const double drift = f < stance.flat_first
                               ? across(path.heel_at(f) - path.heel_at(stance.flat_first))
                               : across(path.ball_at(f) - path.ball_at(stance.flat_first));
      largest = std::max(largest, drift);
    }
  }
  return largest;
}

}  // namespace mien::motion
