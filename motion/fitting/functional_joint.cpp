#include "motion/fitting/functional_joint.h"

#include <algorithm>
#include <initializer_list>

#include "motion/fitting/rigid_placement.h"
#include "motion/math/linear_system.h"

namespace mien::motion {

namespace {

using Placements = std::vector<std::optional<Placement>>;

/// The points of a segment in the first frame in which most of them are known.
std::vector<std::optional<Vec3>> shape_of(const std::vector<Track>& points) {
  std::vector<std::optional<Vec3>> best;
  std::size_t most = 0;
  for (std::size_t frame = 0; !points.empty() && frame < points.front().size(); ++frame) {
    std::vector<std::optional<Vec3>> shape;
    std::size_t count = 0;
    for (const Track& point : points) {
      shape.push_back(point[frame]);
      count += point[frame].has_value();
    }
    if (count <= most) continue;
    most = count;
    best = std::move(shape);
  }
  return best;
}

Placements placements_of(const std::vector<Track>& points) {
  if (points.empty()) return {};
  const std::vector<std::optional<Vec3>> shape = shape_of(points);
  Placements placements(points.front().size());
  for (std::size_t frame = 0; frame < placements.size(); ++frame) {
    std::vector<Vec3> local;
    std::vector<Vec3> world;
    for (std::size_t i = 0; i < shape.size(); ++i) {
      if (!shape[i] || !points[i][frame]) continue;
      local.push_back(*shape[i] - *shape.front());
      world.push_back(*points[i][frame]);
    }
    placements[frame] = rigid_placement(local, world);
  }
  return placements;
}

std::vector<Track> tracks_of(const PointTracks& points, std::initializer_list<Landmark> landmarks,
                             Side side) {
  std::vector<Track> tracks;
  for (const Landmark landmark : landmarks) {
    for (const int point : points.set.points_of(landmark, side)) {
      Track track = points.of_point(point);
      if (is_known(track)) tracks.push_back(std::move(track));
    }
  }
  return tracks;
}

Track mean_track(const std::vector<Track>& tracks) {
  Track mean(tracks.front().size());
  for (std::size_t frame = 0; frame < mean.size(); ++frame) {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (const Track& track : tracks) {
      if (!track[frame]) continue;
      sum += *track[frame];
      ++count;
    }
    if (count > 0) mean[frame] = Vec3(sum / count);
  }
  return mean;
}

/// Heel, ankle and ball as the ankle's guess: 0.3 of the way forward and a little above the heel.
Track ankle_guess(const std::vector<Track>& foot_points, const Track& heels, const Track& shanks) {
  const Track forefoot = mean_track(foot_points);
  const Track above = is_known(heels) ? heels : forefoot;
  return combined(
      [](const Vec3& h, const Vec3& f, const Vec3& s) {
        return Vec3(h + 0.5 * (f - h) + 0.05 * (s - h).normalized());
      },
      above, forefoot, shanks);
}

}  // namespace

Track functional_joint(const std::vector<Track>& upper, const std::vector<Track>& lower,
                       const Track& guess, double guess_weight) {
  const Placements above = placements_of(upper);
  const Placements below = placements_of(lower);
  Track centre(guess.size());
  if (above.empty() || below.empty()) return centre;
  // Unknown: the centre in both segments' coordinates (a, b). Each frame asks A a + p = B b + q.
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(6, 6);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(6, 1);
  for (std::size_t frame = 0; frame < guess.size(); ++frame) {
    if (!above[frame] || !below[frame] || !guess[frame]) continue;
    Eigen::Matrix<double, 3, 6> row;
    row.leftCols<3>() = above[frame]->rotation.toRotationMatrix();
    row.rightCols<3>() = -below[frame]->rotation.toRotationMatrix();
    normal += row.transpose() * row + guess_weight * Eigen::MatrixXd::Identity(6, 6);
    right += row.transpose() * (below[frame]->position - above[frame]->position);
    const Vec3 in_upper =
        above[frame]->rotation.conjugate() * (*guess[frame] - above[frame]->position);
    const Vec3 in_lower =
        below[frame]->rotation.conjugate() * (*guess[frame] - below[frame]->position);
    right.topRows<3>() += guess_weight * in_upper;
    right.bottomRows<3>() += guess_weight * in_lower;
  }
  if (normal.trace() <= 0.0) return centre;
  const Eigen::MatrixXd places = solve_symmetric(normal, right);
  const Vec3 a = places.topRows<3>();
  const Vec3 b = places.bottomRows<3>();
  for (std::size_t frame = 0; frame < guess.size(); ++frame) {
    if (!above[frame] || !below[frame]) continue;
    centre[frame] = Vec3(0.5 * (*above[frame] * a + *below[frame] * b));
  }
  return centre;
}

void add_functional_joints(const PointTracks& points, Side side, const Track& hips, Track& knees,
                           Track& ankles) {
  using enum Landmark;
  const std::vector<Track> thighs = tracks_of(points, {thigh}, side);
  const std::vector<Track> shanks = tracks_of(points, {shank}, side);
  const bool has_ankle = is_known(ankles) || is_known(points.of(outer_ankle, side));
  const bool has_knee = is_known(knees) || is_known(points.of(outer_knee, side));
  if (!has_ankle && shanks.size() >= 3) {
    const std::vector<Track> feet = tracks_of(
        points, {heel, foot, toe_tip, first_metatarsal, second_metatarsal, fifth_metatarsal}, side);
    if (feet.size() >= 3) {
      const Track guess = ankle_guess(feet, points.of(heel, side), mean_track(shanks));
      ankles = functional_joint(shanks, feet, guess, 0.03);
    }
  }
  if (!has_knee && thighs.size() >= 3 && shanks.size() >= 3) {
    const Track ends = first_known(ankles, points.of(outer_ankle, side));
    knees = functional_joint(thighs, shanks, middle_of(hips, ends), 0.003);
  }
}

}  // namespace mien::motion
