#include "scenes/point_light/point_light.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "motion/error.h"
#include "motion/math/random_number.h"
#include "motion/skeleton/hand.h"
#include "motion/skeleton/recorded_hands.h"
#include "scenes/point_light/dot_joints.h"

namespace mien::scenes {

namespace {

using motion::Vec3;

/// In [0, 1).
double uniform(std::uint64_t seed, const std::string& name, std::size_t index) {
  const double number = motion::random_number(seed, name, index);
  return std::min(0.5 * (number + 1.0), std::nextafter(1.0, 0.0));
}

std::vector<Dot> joint_dots(const motion::Clip& clip, const std::vector<DotJoint>& joints) {
  std::vector<Dot> dots;
  for (const DotJoint& joint : joints) dots.push_back({joint.name, {}});
  const bool has_hands = motion::has_fingers(clip);
  const motion::Skeleton body = has_hands ? motion::with_fingers(clip.body) : clip.body;
  for (const motion::Pose& pose : clip.poses) {
    const motion::JointTransforms world =
        motion::world_transforms(body, has_hands ? motion::with_fingers(pose) : pose);
    for (std::size_t d = 0; d < joints.size(); ++d) {
      const auto j = static_cast<std::size_t>(joints[d].joint);
      const auto& tip = body.joints[j].tip;
      const Vec3 aside = joints[d].along * tip.value_or(Vec3::Zero());
      dots[d].path.push_back(world.positions[j] + world.rotations[j] * aside);
    }
  }
  return dots;
}

/// The room that a figure on the spot takes: along the picture, upwards, and in depth.
struct Extent {
  Vec3 least = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 most = -least;
  Eigen::Matrix3d axes;  ///< columns: across, up, depth

  Vec3 place(const Vec3& share) const { return axes * (least + share.cwiseProduct(most - least)); }
  Vec3 share_of(const Vec3& point) const {
    const Vec3 size = (most - least).cwiseMax(1e-9);
    return (axes.transpose() * point - least).cwiseQuotient(size);
  }
};

Extent extent_of(const std::vector<Dot>& dots, const DotStage& stage) {
  Extent extent;
  extent.axes.col(0) = stage.across;
  extent.axes.col(1) = Vec3::UnitY();
  extent.axes.col(2) = stage.across.cross(Vec3::UnitY());
  for (const Dot& dot : dots) {
    for (const Vec3& point : without_travel(dot.path, stage.step)) {
      const Vec3 inside = extent.axes.transpose() * point;
      extent.least = extent.least.cwiseMin(inside);
      extent.most = extent.most.cwiseMax(inside);
    }
  }
  return extent;
}

Vec3 mean_of(const DotPath& path) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& point : path) sum += point;
  return sum / static_cast<double>(path.size());
}

/// A random place in the extent.
Vec3 random_place(const Extent& extent, std::uint64_t seed, const std::string& name,
                  std::size_t index) {
  return extent.place({uniform(seed, name + " across", index), uniform(seed, name + " up", index),
                       uniform(seed, name + " depth", index)});
}

/// The path whose mean, travel aside, is at `place`.
DotPath put_at(const DotPath& path, const Vec3& place, const Vec3& step) {
  return shifted(path, place - mean_of(without_travel(path, step)));
}

/// Each dot's motion at a random place, such that all of them together take the same room as the
/// figure: along each axis, places are stretched until the outermost dots reach its ends.
void scatter(std::vector<Dot>& dots, const Extent& extent, const Vec3& step, std::uint64_t seed) {
  std::vector<Extent> rooms;
  std::vector<Vec3> shares;
  Vec3 least = Vec3::Ones();
  Vec3 most = Vec3::Zero();
  for (std::size_t d = 0; d < dots.size(); ++d) {
    DotStage own;
    own.across = extent.axes.col(0);
    own.step = step;
    rooms.push_back(extent_of({dots[d]}, own));
    shares.emplace_back(uniform(seed, "scrambled across", d), uniform(seed, "scrambled up", d),
                        uniform(seed, "scrambled depth", d));
    least = least.cwiseMin(shares.back());
    most = most.cwiseMax(shares.back());
  }
  for (std::size_t d = 0; d < dots.size(); ++d) {
    const Extent& room = rooms[d];
    const Vec3 share = (shares[d] - least).cwiseQuotient((most - least).cwiseMax(1e-9));
    const Vec3 free = (extent.most - extent.least) - (room.most - room.least);
    const Vec3 begin = extent.least + share.cwiseProduct(free);
    dots[d].path = shifted(dots[d].path, extent.axes * (begin - room.least));
  }
}

/// The path made to end where it begins: what is missing is made up for evenly on the way.
DotPath closed(DotPath path) {
  if (path.size() < 3) return path;
  const std::size_t last = path.size() - 1;
  const Vec3 next = 2.0 * path[last] - path[last - 1];
  const Vec3 gap = next - path.front();
  for (std::size_t f = 0; f < path.size(); ++f) {
    path[f] -= static_cast<double>(f) / static_cast<double>(path.size()) * gap;
  }
  return path;
}

Dot begun_at_random(Dot dot, const Vec3& step, std::uint64_t seed, const std::string& name,
                    std::size_t index) {
  const auto count = static_cast<double>(dot.path.size());
  const int later = static_cast<int>(uniform(seed, name, index) * count);
  dot.path = with_travel(begun_at(closed(without_travel(dot.path, step)), later), step);
  if (!dot.shown.empty()) {
    std::rotate(dot.shown.begin(), dot.shown.begin() + later, dot.shown.end());
  }
  return dot;
}

Dot with_constant_speed(Dot dot) {
  const std::vector<PathPlace> places = places_at_constant_speed(dot.path);
  dot.path = at_places(dot.path, places);
  if (dot.shown.empty()) return dot;
  std::vector<bool> shown;
  for (const auto& [frame, share] : places) {
    shown.push_back(dot.shown[frame] && (share == 0.0 || dot.shown[frame + 1]));
  }
  dot.shown = std::move(shown);
  return dot;
}

Dot backwards(Dot dot) {
  dot.path = reversed(dot.path);
  std::reverse(dot.shown.begin(), dot.shown.end());
  return dot;
}

void change_timing(std::vector<Dot>& dots, const PointLightOptions& options, const DotStage& stage,
                   std::uint64_t seed) {
  for (std::size_t d = 0; d < dots.size(); ++d) {
    Dot& dot = dots[d];
    if (options.constant_speed) dot = with_constant_speed(std::move(dot));
    if (options.phase_scrambled)
      dot = begun_at_random(std::move(dot), stage.step, seed, "phase", d);
    if (options.reversed) dot = backwards(std::move(dot));
  }
}

void change_places(std::vector<Dot>& dots, const PointLightOptions& options,
                   const DotStage& stage) {
  const Extent extent = extent_of(dots, stage);
  const double middle = 0.5 * (extent.least.y() + extent.most.y());
  for (Dot& dot : dots) {
    if (options.rotated_degrees != 0.0) {
      dot.path = rotated(dot.path, stage.centre, options.rotated_degrees);
    }
    if (options.mirrored) dot.path = mirrored(dot.path, stage.centre, stage.across);
    if (options.inverted) dot.path = inverted(dot.path, middle);
  }
}

/// The dots with limited lifetimes. The display has as many dots as before; each life is spent at a
/// random place of a random limb, and the lives of the dots begin one after the other.
std::vector<Dot> with_limited_lifetime(const std::vector<Dot>& dots, const std::vector<Limb>& limbs,
                                       int lifetime, std::uint64_t seed) {
  const bool any_dark =
      std::ranges::any_of(dots, [](const Dot& dot) { return !dot.shown.empty(); });
  std::vector<Dot> result = dots;
  for (std::size_t d = 0; d < dots.size(); ++d) {
    result[d].kind = "limb";
    if (any_dark) result[d].shown.assign(dots[d].path.size(), true);
    const auto head_start = static_cast<int>(d * static_cast<std::size_t>(lifetime) / dots.size());
    for (std::size_t f = 0; f < dots[d].path.size(); ++f) {
      const auto life =
          (f + static_cast<std::size_t>(head_start)) / static_cast<std::size_t>(lifetime);
      const std::string name = "life of " + std::to_string(d);
      const double pick = uniform(seed, name + " limb", life) * static_cast<double>(limbs.size());
      const auto [near, far] = limbs[static_cast<std::size_t>(pick)];
      const double along = uniform(seed, name + " along", life);
      result[d].path[f] = (1.0 - along) * dots[near].path[f] + along * dots[far].path[f];
      if (any_dark) result[d].shown[f] = dots[near].is_shown(f) && dots[far].is_shown(f);
    }
  }
  return result;
}

/// 0 … 1 … 0 … as `way` grows: a wall at each end.
double between_walls(double way) {
  const double turn = way - 2.0 * std::floor(0.5 * way);
  return turn <= 1.0 ? turn : 2.0 - turn;
}

/// Goes straight, in the plane of the picture, as fast as the figure's dots do on average, and
/// turns back at the ends of the extent.
Dot noise_dot(const Extent& extent, const Vec3& step, double speed, std::size_t frames,
              std::uint64_t seed, std::size_t index) {
  const Vec3 start = extent.share_of(random_place(extent, seed, "noise", index));
  const double heading = 2.0 * motion::pi * uniform(seed, "noise heading", index);
  const Vec3 size = (extent.most - extent.least).cwiseMax(1e-9);
  const Vec3 pace = speed * Vec3(std::cos(heading) / size.x(), std::sin(heading) / size.y(), 0.0);
  Dot dot{"noise", {}};
  for (std::size_t f = 0; f < frames; ++f) {
    const Vec3 share = start + static_cast<double>(f) * pace;
    dot.path.push_back(extent.place(
        {between_walls(share.x()), between_walls(share.y()), between_walls(share.z())}));
  }
  dot.path = with_travel(dot.path, step);
  return dot;
}

/// In the plane of the picture, metres a frame, between frames in which a dot is shown.
double mean_speed(const std::vector<Dot>& dots, const Vec3& step, const Vec3& depth) {
  double way = 0.0;
  std::size_t steps = 0;
  for (const Dot& dot : dots) {
    DotPath path = without_travel(dot.path, step);
    for (Vec3& point : path) point -= point.dot(depth) * depth;
    double length = 0.0;
    for (std::size_t f = 1; f < path.size(); ++f) {
      if (!dot.is_shown(f - 1) || !dot.is_shown(f)) continue;
      length += (path[f] - path[f - 1]).norm();
      ++steps;
    }
    way += length;
  }
  return way / static_cast<double>(std::max<std::size_t>(steps, 1));
}

}  // namespace

DotPath changed_path(DotPath way, const PointLightOptions& options, const DotStage& stage) {
  if (options.reversed) way = reversed(way);
  if (options.rotated_degrees != 0.0) way = rotated(way, stage.centre, options.rotated_degrees);
  if (options.mirrored) way = mirrored(way, stage.centre, stage.across);
  return way;
}

Vec3 changed_step(const PointLightOptions& options, const DotStage& stage) {
  const DotPath way = changed_path({Vec3::Zero(), stage.step}, options, stage);
  return way[1] - way[0];
}

std::vector<Dot> displayed_dots(std::vector<Dot> dots, const std::vector<Limb>& limbs,
                                const PointLightOptions& options, const DotStage& stage) {
  if (options.scrambled && options.lifetime > 0) {
    throw Error("scrambled dots are not on limbs, as a limited lifetime requires",
                "omit scrambled or lifetime");
  }
  const std::uint64_t seed = options.seed.value_or(stage.seed);
  const std::size_t frames = dots.front().path.size();
  change_timing(dots, options, stage, seed);
  change_places(dots, options, stage);
  DotStage changed = stage;
  changed.step = changed_step(options, stage);
  const Extent extent = extent_of(dots, changed);
  const std::vector<Dot> figure = dots;
  if (options.scrambled) scatter(dots, extent, changed.step, seed);
  if (options.lifetime > 0) dots = with_limited_lifetime(dots, limbs, options.lifetime, seed);
  const double speed = mean_speed(figure, changed.step, extent.axes.col(2));
  for (std::size_t n = 0; n < static_cast<std::size_t>(options.noise); ++n) {
    dots.push_back(noise_dot(extent, changed.step, speed, frames, seed, n));
  }
  for (std::size_t n = 0; n < static_cast<std::size_t>(options.mask); ++n) {
    const Vec3 place = random_place(extent, seed, "mask", n);
    Dot mask = begun_at_random(figure[n % figure.size()], changed.step, seed, "mask phase", n);
    mask.kind = "mask";
    mask.path = put_at(mask.path, place, changed.step);
    dots.push_back(std::move(mask));
  }
  return dots;
}

std::vector<Dot> point_light(const motion::Clip& clip, const PointLightOptions& options,
                             const DotStage& stage) {
  const std::vector<DotJoint> joints = dot_joints(clip.body, motion::has_fingers(clip), options);
  std::vector<Limb> limbs;
  for (std::size_t d = 0; d < joints.size(); ++d) {
    if (joints[d].limb >= 0) limbs.push_back({d, static_cast<std::size_t>(joints[d].limb)});
  }
  if (options.lifetime > 0 && !options.scrambled && limbs.empty()) {
    throw Error("these dots are not on limbs, as a limited lifetime requires",
                "name both ends of a limb, such as LeftElbow and LeftWrist, or omit lifetime");
  }
  return displayed_dots(joint_dots(clip, joints), limbs, options, stage);
}

}  // namespace mien::scenes
