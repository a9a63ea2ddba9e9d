#include "render/light/floor_sky.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "render/light/sky_cone.h"
#include "render/math/constants.h"
#include "render/math/lanes.h"
#include "render/math/sampler.h"

namespace mien::render {
namespace {

constexpr float unit = 1.0f / 64.0f;  // metres; the smallest cell
constexpr int root_side = 64 * 128;   // units

constexpr float furthest = 1e5f;  // from the world's origin that a figure may be, metres

float metres(int units) { return static_cast<float>(units) * unit; }

int floored_multiple(float x, int side) {
  return static_cast<int>(std::floor(x / metres(side))) * side;
}

}  // namespace

FloorSky::FloorSky(const Shapes& shapes, const BoundingSphere& bounds, const Quality& quality,
                   const std::array<HalfSpace, 4>& view)
    : bounds_(bounds), quality_(quality), view_(view) {
  cells_.push_back({});
  if (shapes.empty()) return;
  if (!(bounds.centre.cwiseAbs().maxCoeff() + bounds.radius < furthest)) {
    // Cells would be lost in rounding.
    cells_[0].known = false;
    return;
  }
  pieces_ = pieces_of(shapes);
  // The figure is near the middle: at least a quarter of the root from its rim, wherever it is.
  origin_x_ = floored_multiple(bounds.centre.x() - metres(root_side / 4), root_side / 2);
  origin_z_ = floored_multiple(bounds.centre.z() - metres(root_side / 4), root_side / 2);
  branches_.resize(1);
  divide(0, {origin_x_, origin_z_, root_side});
}

// What has a silhouette of area a, at height h and distance d, occludes a h / (π d³) of the sky.
// Its second derivative along the floor is at most 12 / d² of that, and bilinear interpolation errs
// by an eighth of it times the side squared.
float FloorSky::interpolation_error(const Square& square) const {
  const float side = metres(square.side);
  const Vec3 centre{metres(square.x) + 0.5f * side, 0.0f, metres(square.z) + 0.5f * side};
  float error = 0.0f;
  for (const auto& [sphere, silhouette] : pieces_) {
    const Vec3 towards = sphere.centre - centre;
    const float squared = towards.squaredNorm();
    const float distance = std::sqrt(squared);
    const float gap = distance - sphere.radius - 0.71f * side;
    if (gap <= 0.25f * side) return 1.0f;
    const float height = std::max(towards.y(), 0.0f) + sphere.radius;
    const float seen = std::min(silhouette / pi * height / (squared * distance), 0.5f);
    error += 1.5f * seen * side * side / (gap * gap);
    if (error > quality_.floor_sky_tolerance) return error;  // how much more is of no account
  }
  return error;
}

// Within a sphere nothing is gained by division: what a long wall is bounded by would be divided
// into millions of cells of which none is known.
bool FloorSky::is_within_sphere(const Square& square) const {
  const float side = metres(square.side);
  const Vec3 centre{metres(square.x) + 0.5f * side, 0.0f, metres(square.z) + 0.5f * side};
  return std::any_of(pieces_.begin(), pieces_.end(), [&](const FigurePiece& piece) {
    const float inside = piece.sphere.radius - 0.71f * side;
    return inside > 0.0f && (piece.sphere.centre - centre).squaredNorm() < inside * inside;
  });
}

bool FloorSky::is_in_view(const Square& square) const {
  const float x = metres(square.x), z = metres(square.z), side = metres(square.side);
  for (const HalfSpace& half : view_) {
    // The corner furthest on the inner side.
    const Vec3 corner{half.normal.x() > 0.0f ? x + side : x, 0.0f,
                      half.normal.z() > 0.0f ? z + side : z};
    if (half.normal.dot(corner) < half.offset - 1e-3f) return false;
  }
  return true;
}

void FloorSky::divide(std::size_t branch, const Square& square) {
  const float tolerance = quality_.floor_sky_tolerance;
  Cell cell{metres(square.x), metres(square.z), 1.0f / metres(square.side), false};
  if (!is_in_view(square)) return end_with(branch, cell);
  if (interpolation_error(square) > tolerance) {
    const int half = square.side / 2;
    const bool divides = half >= 1 && metres(half) >= quality_.floor_sky_cell && tolerance > 0.0f;
    if (divides && !is_within_sphere(square)) {
      const std::size_t first = branches_.size();
      branches_[branch] = static_cast<int>(first);
      branches_.resize(first + 4);
      for (int k = 0; k < 4; ++k)
        divide(first + static_cast<std::size_t>(k),
               {square.x + (k & 1) * half, square.z + (k >> 1) * half, half});
      return;
    }
    if (divides || !quality_.floor_sky_smooth || tolerance == 0.0f) return end_with(branch, cell);
  }
  cell.known = true;
  for (int k = 0; k < 4; ++k)
    cell.corners[k] =
        corner_of(square.x + (k & 1) * square.side, square.z + (k >> 1) * square.side);
  end_with(branch, cell);
}

void FloorSky::end_with(std::size_t branch, const Cell& cell) {
  branches_[branch] = ~static_cast<int>(cells_.size());
  cells_.push_back(cell);
}

int FloorSky::corner_of(int x, int z) {
  const std::uint64_t key = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32) |
                            static_cast<std::uint32_t>(z);
  const auto [place, is_new] = corner_numbers_.try_emplace(key, static_cast<int>(corners_.size()));
  if (is_new) corners_.push_back({metres(x), metres(z)});
  return place->second;
}

// Enough rays for the noise limit of the quality; with a low-discrepancy sequence noise falls
// slightly slower than in proportion to their number.
int FloorSky::rays_from(const Corner& corner) const {
  const std::optional<Cone> cone = cone_of(bounds_, {corner.x, 0.0f, corner.z});
  const float share = cone ? std::min(cone->solid_angle() / pi, 1.0f) : 1.0f;
  const float wanted = 0.32f * share / quality_.floor_sky_noise;
  const auto rays =
      static_cast<unsigned>(std::clamp(wanted * std::sqrt(std::sqrt(wanted)), 8.0f, 4096.0f));
  return static_cast<int>(std::bit_ceil(rays));
}

void FloorSky::sample_corner(std::size_t number, const EmbreeScene& figure,
                             const std::vector<float>& opacities) {
  Corner& corner = corners_[number];
  const Vec3 point{corner.x, 0.0f, corner.z};
  const PixelSampler sampler(quality_.seed, static_cast<int>(corner.x / unit),
                             static_cast<int>(corner.z / unit));
  const int rays = rays_from(corner);
  const float weight = 1.0f / static_cast<float>(rays);
  LaneVectors points, upwards;
  LaneWords index, seed;
  for (int i = 0; i < static_cast<int>(lanes); ++i) {
    points.set(i, point);
    upwards.set(i, Vec3::UnitY());
    seed[i] = sampler.seed(Dimension::CornerSky);
  }
  const bool moves = figure.shapes().move();
  const bool all_present = figure.shapes().all_present;
  for (int first = 0; first < rays; first += static_cast<int>(lanes)) {
    for (int i = 0; i < static_cast<int>(lanes); ++i)
      index[i] = static_cast<std::uint32_t>(first + i);
    const LaneSphereRays sky =
        rays_to_sphere(bounds_.centre, bounds_.radius, points, upwards, sample_points(index, seed));
    RayPacket packet;
    LaneFloats light;
    for (int i = 0; i < static_cast<int>(lanes); ++i) {
      if (sky.towards.y[i] <= 0.0f) continue;
      const float time =
          moves ? quality_.shutter * sampler.point(Dimension::Time, first + i).u : 0.0f;
      light[packet.count] = weight * sky.share[i];
      packet.push(point, sky.towards.at(i), std::numeric_limits<float>::infinity(), time,
                  all_present ? ~0u : present_figures(sampler, opacities, first + i));
    }
    const std::uint32_t blocked = packet.count > 0 ? figure.occluded(packet) : 0;
    for (int i = 0; i < packet.count; ++i) {
      if (((blocked >> i) & 1u) == 0) continue;
      corner.even += light[i];
      corner.rising += light[i] * packet.direction_y[i];
    }
  }
}

const FloorSky::Cell& FloorSky::cell_at(float x, float z) const {
  const float u = (x - metres(origin_x_)) / metres(root_side);
  const float v = (z - metres(origin_z_)) / metres(root_side);
  if (pieces_.empty() || !(u >= 0.0f && u < 1.0f && v >= 0.0f && v < 1.0f)) return cells_[0];
  Square square{origin_x_, origin_z_, root_side};
  int branch = branches_[0];
  while (branch >= 0) {
    square.side /= 2;
    const bool right = x >= metres(square.x + square.side);
    const bool far = z >= metres(square.z + square.side);
    if (right) square.x += square.side;
    if (far) square.z += square.side;
    branch = branches_[static_cast<std::size_t>(branch + (right ? 1 : 0) + (far ? 2 : 0))];
  }
  return cells_[static_cast<std::size_t>(~branch)];
}

void FloorSky::finish(const Sky& sky) {
  for (Cell& cell : cells_) {
    if (!cell.known || cell.inverse_side == 0.0f) continue;
    const auto light = [&](int k) -> Color {
      const Corner& corner = corners_[static_cast<std::size_t>(cell.corners[k])];
      return corner.even * sky.horizon + corner.rising * (sky.zenith - sky.horizon);
    };
    cell.at_corner = light(0);
    cell.along_x = light(1) - light(0);
    cell.along_z = light(2) - light(0);
    cell.along_both = light(3) - light(2) - light(1) + light(0);
  }
}

}  // namespace mien::render
