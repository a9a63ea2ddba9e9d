#include "render/light/static_background.h"

#include <algorithm>
#include <string_view>

#include <xxhash.h>

namespace mien::render {
namespace {

/// Appends numbers one after the other.
class Key {
 public:
  void add(float value) { values_.push_back(value); }
  void add(int value) {
    // Exact for every count and index that fits into memory: two halves of 16 bits.
    values_.push_back(static_cast<float>(value >> 16));
    values_.push_back(static_cast<float>(value & 0xffff));
  }
  void add(bool value) { values_.push_back(value ? 1.0f : 0.0f); }
  void add(const Vec3& v) { values_.insert(values_.end(), v.data(), v.data() + 3); }
  void add(const Color& c) { values_.insert(values_.end(), c.data(), c.data() + 3); }
  template <class First, class... Rest>
  void add(const First& first, const Rest&... rest) {
    add(first);
    (add(rest), ...);
  }
  std::vector<float> take() { return std::move(values_); }

 private:
  std::vector<float> values_;
};

void add_camera(Key& key, const Camera& camera) {
  key.add(camera.position, camera.target, camera.up, camera.vertical_field_of_view,
          camera.parallel_height, camera.shift_x, camera.shift_y, camera.width, camera.height);
}

void add_set(Key& key, const Scene& scene) {
  for (const AreaLight& light : scene.lights)
    for (const float number : numbers_of(light)) key.add(number);
  const Sky& sky = scene.sky;
  key.add(sky.zenith, sky.horizon, sky.below, sky.backdrop_horizon, sky.backdrop_zenith,
          scene.has_ground);
  const Ground& ground = scene.ground;
  key.add(ground.albedo, ground.line_albedo, ground.line_spacing, ground.line_width,
          ground.major_every, ground.major_albedo, ground.fade_start, ground.fade_end);
  // Without lines it looks the same wherever it is.
  if (ground.line_spacing > 0.0f) key.add(ground.offset_x, ground.offset_z);
}

/// Adds static solids, and lists their materials in the order in which they are first met: what
/// figures are made of is no matter, and neither is how many figures there are.
void add_solids(Key& key, const Solids& solids, std::vector<int>& used) {
  const auto number_of = [&](int material) {
    const auto place = std::find(used.begin(), used.end(), material);
    const auto number = static_cast<int>(place - used.begin());
    if (place == used.end()) used.push_back(material);
    return number;
  };
  key.add(static_cast<int>(solids.spheres.size()), static_cast<int>(solids.round_cones.size()),
          static_cast<int>(solids.meshes.size()));
  for (const Sphere& sphere : solids.spheres)
    key.add(sphere.centre, sphere.radius, number_of(sphere.material));
  for (const RoundCone& round_cone : solids.round_cones)
    key.add(round_cone.start, round_cone.end, round_cone.start_radius, round_cone.end_radius,
            number_of(round_cone.material));
  for (const Mesh& mesh : solids.meshes) {
    key.add(number_of(mesh.material), static_cast<int>(mesh.positions.size()),
            static_cast<int>(mesh.triangles.size()), static_cast<int>(mesh.uv.size()));
    for (const Vec3& position : mesh.positions) key.add(position);
    for (const Vec3& normal : mesh.normals) key.add(normal);
    for (const auto& [u, v] : mesh.uv) key.add(u, v);
    for (const auto& [a, b, c] : mesh.triangles) key.add(a, b, c);
  }
}

void add_texture(Key& key, const Scene& scene, int index) {
  key.add(index >= 0);
  if (index < 0) return;
  const Texture& texture = *scene.textures[static_cast<std::size_t>(index)];
  key.add(texture.width, texture.height);
  for (const Color& texel : texture.texels) key.add(texel);
}

}  // namespace

std::vector<float> static_background_key(const Scene& scene, const Camera& camera,
                                         const Quality& quality) {
  Key key;
  add_camera(key, camera);
  add_set(key, scene);
  if (scene.static_solids.empty()) return key.take();
  std::vector<int> used;
  add_solids(key, scene.static_solids, used);
  for (const int number : used) {
    const Material& material = scene.materials[static_cast<std::size_t>(number)];
    key.add(material.albedo, material.specular_f0, material.roughness, material.emission,
            material.normal_scale);
    add_texture(key, scene, material.texture);
    add_texture(key, scene, material.normal_map);
  }
  key.add(quality.static_samples, quality.sky_rays, quality.floor_sky_noise,
          quality.floor_sky_tolerance, quality.floor_sky_cell, quality.filter_width,
          static_cast<int>(quality.seed), static_cast<int>(quality.seed >> 32));
  return key.take();
}

std::string static_background_name(const std::vector<float>& key) {
  const XXH128_hash_t hash = XXH3_128bits(key.data(), key.size() * sizeof(float));
  constexpr std::string_view digits = "0123456789abcdef";
  std::string name;
  for (const XXH64_hash_t half : {hash.high64, hash.low64})
    for (int shift = 60; shift >= 0; shift -= 4) name += digits[(half >> shift) & 15u];
  return name;
}

StaticBackground blank_background(int width, int height, const CameraFrame& camera,
                                  StaticBackground used) {
  StaticBackground background = std::move(used);
  background.camera = camera;
  background.solid.clear();
  if (background.radiance.width == width && background.radiance.height == height) return background;
  background.radiance = background.albedo = Framebuffer(width, height);
  background.floor.assign(background.radiance.channels.size() / 3, 0);
  return background;
}

namespace {

void put(const LaneColors& colors, int count, float* out) {
  for (int i = 0; i < count; ++i) {
    out[3 * i] = colors.red[i];
    out[3 * i + 1] = colors.green[i];
    out[3 * i + 2] = colors.blue[i];
  }
}

}  // namespace

void render_unshadowed_row(const UnshadowedBackground& open, int y, StaticBackground& background) {
  const int width = background.radiance.width;
  const UnshadowedRow row(open, y, width);
  for (int first = 0; first < width; first += static_cast<int>(lanes)) {
    const int count = std::min(static_cast<int>(lanes), width - first);
    const LaneBackground pixels = row.pixels(first);
    put(pixels.radiance, count, background.radiance.at(first, y));
    put(pixels.visible_albedo, count, background.albedo.at(first, y));
    const std::size_t place = background.place_of(first, y);
    for (int i = 0; i < count; ++i)
      background.floor[place + static_cast<std::size_t>(i)] = pixels.share[i] > 0.0f ? 1 : 0;
  }
}

}  // namespace mien::render
