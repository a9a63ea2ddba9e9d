#include "render/tracer/layer_pass.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "render/light/floor.h"
#include "render/light/unshadowed_background.h"
#include "render/math/constants.h"
#include "render/tracer/camera_rays.h"

namespace mien::render {
namespace {

/// The hit of a primary ray.
struct Seen {
  Color albedo = Color::Zero();
  Vec3 normal = Vec3::Zero();
  Vec3 position = Vec3::Zero();
  bool something = false;
  bool ground = false;
  int shape = -1;  // of the figure
  int part = -1;   // of the figure
};

class LayerPainter {
 public:
  LayerPainter(const PreparedScene& prepared, const Scene* next, const Camera* next_camera,
               Layers& layers)
      : prepared_(prepared),
        next_(next),
        next_camera_(next_camera),
        layers_(layers),
        unshadowed_(prepared.scene, prepared.camera) {}

  void draw(int x, int y);

 private:
  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(layers_.albedo.width) +
           static_cast<std::size_t>(x);
  }
  Seen look(const CameraRay& ray, std::uint32_t present) const;
  void take_samples(int x, int y);
  void take_centre(int x, int y);
  std::optional<Vec3> next_place(const Seen& seen) const;

  const PreparedScene& prepared_;
  const Scene* next_;
  const Camera* next_camera_;
  Layers& layers_;
  const UnshadowedBackground unshadowed_;
};

Seen LayerPainter::look(const CameraRay& ray, std::uint32_t present) const {
  const std::optional<float> floor =
      prepared_.scene.has_ground ? distance_to_floor(ray.origin, ray.direction) : std::nullopt;
  RayPacket rays;
  rays.push(ray.origin, ray.direction, floor.value_or(infinity), 0.0f, present);
  const FirstHit hit = first_hits(prepared_, rays).front();
  Seen seen;
  if (hit.exists()) {
    const Surface surface = surface_at(prepared_, rays, 0, hit);
    seen = {surface.albedo, surface.normal, surface.point, true};
    if (hit.of_figure) {
      seen.shape = hit.shape;
      seen.part = surface.part;
    }
    return seen;
  }
  if (!floor) return seen;
  LaneRays shown;
  for (int i = 0; i < static_cast<int>(lanes); ++i) {
    shown.origin.set(i, ray.origin);
    shown.direction.set(i, ray.direction);
  }
  const LaneBackground background = unshadowed_.along(shown);
  if (background.share[0] > 0.0f)
    seen = {background.visible_albedo.at(0), Vec3::UnitY(), background.point.at(0), true, true};
  return seen;
}

void put_ranks(const std::map<int, float>& shares, const std::vector<std::string>& names,
               Coverage* ranks) {
  std::vector<Coverage> found;
  for (const auto& [index, share] : shares)
    found.push_back({layer_id(names[static_cast<std::size_t>(index)]), share});
  std::stable_sort(found.begin(), found.end(),
                   [](const Coverage& a, const Coverage& b) { return a.share > b.share; });
  std::copy_n(found.begin(), std::min(found.size(), covered_ranks), ranks);
}

void LayerPainter::take_samples(int x, int y) {
  const int spp = prepared_.quality.samples_per_pixel;
  const float share = 1.0f / static_cast<float>(spp);
  const PixelSampler sampler = prepared_.sampler.for_pixel(x, y);
  Color albedo = Color::Zero();
  Vec3 normal = Vec3::Zero();
  std::map<int, float> parts, figures;
  for (int i = 0; i < spp; ++i) {
    const Point2 u = sampler.point(Dimension::PixelPosition, i);
    const CameraRay ray =
        prepared_.camera.ray(static_cast<float>(x) + 0.5f + prepared_.filter.offset(u.u),
                             static_cast<float>(y) + 0.5f + prepared_.filter.offset(u.v));
    const Seen seen = look(ray, present_figures(sampler, prepared_.opacities, i));
    albedo += share * seen.albedo;
    normal += share * seen.normal;
    if (seen.part < 0) continue;
    parts[seen.part] += share;
    figures[prepared_.scene.parts[static_cast<std::size_t>(seen.part)].figure] += share;
  }
  std::copy_n(albedo.data(), 3, layers_.albedo.at(x, y));
  std::copy_n(normal.data(), 3, layers_.normal.at(x, y));
  layers_.samples[place(x, y)] = static_cast<float>(spp);
  put_ranks(parts, layers_.parts.names, &layers_.parts.ranks[covered_ranks * place(x, y)]);
  put_ranks(figures, layers_.figures.names, &layers_.figures.ranks[covered_ranks * place(x, y)]);
}

/// The shortest turn from one unit direction to another.
Eigen::Quaternionf turn_between(const Vec3& from, const Vec3& to) {
  const float cosine = from.dot(to);
  if (cosine < -0.999999f) {
    const Vec3 axis = from.unitOrthogonal();
    return {0.0f, axis.x(), axis.y(), axis.z()};
  }
  const Vec3 axis = from.cross(to);
  return Eigen::Quaternionf(1.0f + cosine, axis.x(), axis.y(), axis.z()).normalized();
}

/// A point of a round cone carried along as the cone turns and stretches.
Vec3 carried(const PreparedCone& from, const PreparedCone& to, const Vec3& point) {
  if (from.axis_squared == 0.0f || to.axis_squared == 0.0f) return to.a + (point - from.a);
  const Vec3 offset = point - from.a;
  const float along = offset.dot(from.axis) / from.axis_squared;
  const Vec3 aside = offset - along * from.axis;
  return to.a + along * to.axis +
         turn_between(from.axis.normalized(), to.axis.normalized()) * aside;
}

std::optional<Vec3> LayerPainter::next_place(const Seen& seen) const {
  if (!seen.something) return std::nullopt;
  if (next_ == nullptr) return seen.position;
  if (seen.ground) {
    const Ground &from = prepared_.scene.ground, &to = next_->ground;
    return seen.position + Vec3(to.offset_x - from.offset_x, 0.0f, to.offset_z - from.offset_z);
  }
  if (seen.shape < 0) return seen.position;
  const Shapes& shapes = prepared_.figure.shapes();
  const Shapes& later = *prepared_.next_shapes;
  const auto index = static_cast<std::size_t>(seen.shape);
  if (index < shapes.cones.size())
    return carried(shapes.cones[index], later.cones[index], seen.position);
  const Triangle& from = shapes.triangles[index - shapes.cones.size()];
  const Triangle& to = later.triangles[index - shapes.cones.size()];
  const Barycentric w = barycentric(from, seen.position);
  return (1.0f - w.b - w.c) * to.a + w.b * to.b + w.c * to.c;
}

void LayerPainter::take_centre(int x, int y) {
  const auto centre_x = static_cast<float>(x) + 0.5f, centre_y = static_cast<float>(y) + 0.5f;
  const CameraRay ray = prepared_.camera.ray(centre_x, centre_y);
  const Seen seen = look(ray, ~0u);
  std::copy_n(seen.position.data(), 3, layers_.position.at(x, y));
  layers_.depth[place(x, y)] =
      seen.something ? (seen.position - prepared_.camera.position).dot(prepared_.camera.forward)
                     : infinity;
  if (next_camera_ == nullptr) return;
  const std::optional<Vec3> later = next_place(seen);
  // The backdrop is so far off that only turns of the camera move it.
  const Vec3 there = later ? *later : next_camera_->position + 1e4f * ray.direction;
  if (const auto image_point = project(*next_camera_, there)) {
    layers_.motion[2 * place(x, y)] = image_point->x() - centre_x;
    layers_.motion[2 * place(x, y) + 1] = image_point->y() - centre_y;
  }
}

void LayerPainter::draw(int x, int y) {
  const bool solid =
      prepared_.pixel_mask.may_intersect(x, y) || prepared_.background.may_show_solid(x, y);
  take_centre(x, y);
  if (solid) return take_samples(x, y);
  // The floor or backdrop of the whole pixel.
  const Color albedo = prepared_.background.floor_albedo(x, y);
  std::copy_n(albedo.data(), 3, layers_.albedo.at(x, y));
  if (prepared_.background.shows_floor(x, y)) layers_.normal.at(x, y)[1] = 1.0f;
}

}  // namespace

Layers empty_layers(const Scene& scene, int width, int height) {
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  Layers layers;
  layers.albedo = layers.normal = layers.position = Framebuffer(width, height);
  layers.depth.assign(pixels, infinity);
  layers.motion.assign(2 * pixels, 0.0f);
  layers.samples.assign(pixels, 0.0f);
  layers.variance.assign(pixels, 0.0f);
  for (const Figure& figure : scene.figures) layers.figures.names.push_back(figure.name);
  for (const Part& part : scene.parts)
    layers.parts.names.push_back(scene.figures[static_cast<std::size_t>(part.figure)].name + "/" +
                                 part.name);
  layers.figures.ranks.assign(covered_ranks * pixels, {});
  layers.parts.ranks.assign(covered_ranks * pixels, {});
  return layers;
}

void draw_layers(const PreparedScene& prepared, const Scene* next, const Camera* next_camera,
                 const Window& part, Layers& layers) {
  LayerPainter painter(prepared, next, next_camera, layers);
  for (int y = part.y; y < part.y_end(); ++y)
    for (int x = part.x; x < part.x_end(); ++x) painter.draw(x, y);
}

}  // namespace mien::render
