#include "render/light/shading.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mien::render {
namespace {

float ggx(const Surface& surface, const Vec3& towards) {
  const Material& material = *surface.material;
  const float in = surface.normal.dot(towards);
  const float out = std::max(surface.normal.dot(surface.towards_eye), 1e-3f);
  if (in <= 0.0f) return 0.0f;
  const Vec3 half = (towards + surface.towards_eye).normalized();
  const float alpha = material.roughness * material.roughness;
  const float cosine = surface.normal.dot(half);
  const float spread = cosine * cosine * (alpha * alpha - 1.0f) + 1.0f;
  const float density = alpha * alpha * std::numbers::inv_pi_v<float> / (spread * spread);
  const float k = 0.5f * alpha;
  const float masking = (in * (1.0f - k) + k) * (out * (1.0f - k) + k);
  const float away = 1.0f - std::clamp(towards.dot(half), 0.0f, 1.0f);
  const float fifth = away * away * away * away * away;
  const float fresnel = material.specular_f0 + (1.0f - material.specular_f0) * fifth;
  return density * fresnel / (4.0f * masking);
}

float off_surface(const Vec3& point) { return 1e-4f * std::max(1.0f, point.cwiseAbs().maxCoeff()); }

Surface cone_surface(const PreparedCone& cone, const Vec3& point) {
  Surface surface;
  surface.point = point;
  surface.normal = normal_at(cone, point);
  surface.origin = point + off_surface(point) * surface.normal;
  surface.part = cone.part;
  return surface;
}

/// What belongs to the corners of a triangle.
template <class Value>
struct Corners {
  Value a;
  Value b;
  Value c;

  Value at(float wa, const Barycentric& w) const { return wa * a + w.b * b + w.c * c; }
};

Corners<Vec3> normals_of(const Mesh& mesh, const std::array<int, 3>& corners, float side) {
  const auto normal = [&](int k) -> Vec3 {
    return side * mesh.normals[static_cast<std::size_t>(corners[static_cast<std::size_t>(k)])];
  };
  return {normal(0), normal(1), normal(2)};
}

/// As std::floor, which is a call on machines without SSE 4.1.
float floored(float x) {
  constexpr float whole = 0x1p23f;  // from here on, all are whole numbers
  if (!(std::abs(x) < whole)) return x;
  const auto towards_zero = static_cast<float>(static_cast<int>(x));
  return towards_zero > x ? towards_zero - 1.0f : towards_zero;
}

/// From a corner's tangent plane, if the point lies below it.
Vec3 lifted(const Vec3& point, const Vec3& corner, const Vec3& normal) {
  return point - std::min(0.0f, (point - corner).dot(normal)) * normal;
}

using TextureCorners = Corners<Eigen::Vector2f>;

TextureCorners texture_corners(const Mesh& mesh, const std::array<int, 3>& corners) {
  const auto uv = [&](int k) {
    const auto& [u, v] = mesh.uv[static_cast<std::size_t>(corners[static_cast<std::size_t>(k)])];
    return Eigen::Vector2f(u, v);
  };
  return {uv(0), uv(1), uv(2)};
}

Color texture_at(const Texture& texture, const TextureCorners& uv, float wa, const Barycentric& w) {
  const Eigen::Vector2f place = uv.at(wa, w);
  return texel_at(texture, place.x(), place.y());
}

/// A smooth normal, on the front, bent by what a normal map says.
Vec3 bent_normal(const Vec3& normal, const Vec3& bend, const Triangle& triangle,
                 const TextureCorners& uv) {
  const Vec3 ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
  const float ub = uv.b[0] - uv.a[0], uc = uv.c[0] - uv.a[0];
  const float vb = uv.b[1] - uv.a[1], vc = uv.c[1] - uv.a[1];
  const float area = ub * vc - uc * vb;
  const Vec3 along_u = (vc * ab - vb * ac) * (area < 0.0f ? -1.0f : 1.0f);
  const Vec3 across = along_u - along_u.dot(normal) * normal;
  const float length = across.norm();
  if (area == 0.0f || !(length > 0.0f)) return normal;
  const Vec3 tangent = across / length;
  // Growing v lies to the left of growing u where the texture is not mirrored.
  const Vec3 falling_v = (area < 0.0f ? 1.0f : -1.0f) * normal.cross(tangent);
  const Vec3 bent = bend.x() * tangent + bend.y() * falling_v + bend.z() * normal;
  const float size = bent.norm();
  return size > 1e-6f ? Vec3(bent / size) : normal;
}

/// A normal that the eye can see: one that points away is turned until it is seen edge on.
Vec3 towards(const Vec3& normal, const Vec3& eye) {
  constexpr float least = 0.02f;
  const float cosine = normal.dot(eye);
  return cosine >= least ? normal : (normal + (least - cosine) * eye).normalized();
}

/// What the textures of a mesh's material do to its surface. `side` is −1 where its back is seen.
void paint(const Scene& scene, const TextureCorners& uv, const Triangle& triangle, float wa,
           const Barycentric& w, float side, Surface& surface) {
  const Material& material = *surface.material;
  const auto texture = [&](int index) -> const Texture& {
    return *scene.textures[static_cast<std::size_t>(index)];
  };
  if (material.texture >= 0) surface.albedo *= texture_at(texture(material.texture), uv, wa, w);
  if (material.normal_map < 0) return;
  const Color texel = texture_at(texture(material.normal_map), uv, wa, w);
  const Vec3 bend{material.normal_scale * (2.0f * texel.x() - 1.0f),
                  material.normal_scale * (2.0f * texel.y() - 1.0f), 2.0f * texel.z() - 1.0f};
  const Vec3 front = side * surface.normal;
  surface.normal = towards(side * bent_normal(front, bend, triangle, uv), surface.towards_eye);
}

}  // namespace

Surface surface_at(const Scene& scene, const Solids& solids, const Solids* closing,
                   const Shapes& shapes, int shape, const Vec3& point, const Vec3& direction,
                   float time) {
  const auto index = static_cast<std::size_t>(shape);
  if (index < shapes.cones.size()) {
    const PreparedCone cone = shapes.cone_at(index, time);
    Surface surface = cone_surface(cone, point);
    surface.towards_eye = -direction;
    surface.material = &scene.materials[static_cast<std::size_t>(cone.material)];
    surface.albedo = surface.material->albedo;
    return surface;
  }
  const std::size_t number = index - shapes.cones.size();
  const TriangleSource& source = shapes.sources[number];
  const Mesh& mesh = solids.meshes[static_cast<std::size_t>(source.mesh)];
  const auto& corners = mesh.triangles[static_cast<std::size_t>(source.triangle)];
  const Triangle triangle = shapes.triangle_at(number, time);
  Barycentric w = barycentric(triangle, point);
  w = {std::clamp(w.b, 0.0f, 1.0f), std::clamp(w.c, 0.0f, 1.0f - w.b)};
  const float wa = 1.0f - w.b - w.c;

  Vec3 flat = (triangle.b - triangle.a).cross(triangle.c - triangle.a).normalized();
  // The side that is seen.
  const float side = flat.dot(direction) > 0.0f ? -1.0f : 1.0f;
  flat *= side;
  Corners<Vec3> normals = normals_of(mesh, corners, side);
  if (closing != nullptr && time > 0.0f) {
    const Corners<Vec3> later =
        normals_of(closing->meshes[static_cast<std::size_t>(source.mesh)], corners, side);
    normals = {(1.0f - time) * normals.a + time * later.a,
               (1.0f - time) * normals.b + time * later.b,
               (1.0f - time) * normals.c + time * later.c};
  }
  Surface surface;
  surface.point = point;
  surface.normal = normals.at(wa, w);
  const float length = surface.normal.norm();
  surface.normal = length > 1e-6f ? Vec3(surface.normal / length) : flat;
  const Corners<Vec3> curved{lifted(point, triangle.a, normals.a),
                             lifted(point, triangle.b, normals.b),
                             lifted(point, triangle.c, normals.c)};
  surface.origin = curved.at(wa, w) + off_surface(point) * flat;
  surface.towards_eye = -direction;
  surface.material = &scene.materials[static_cast<std::size_t>(mesh.material)];
  surface.albedo = surface.material->albedo;
  if (!mesh.uv.empty())
    paint(scene, texture_corners(mesh, corners), triangle, wa, w, side, surface);
  surface.part = mesh.triangle_parts.empty()
                     ? mesh.part
                     : mesh.triangle_parts[static_cast<std::size_t>(source.triangle)];
  return surface;
}

Surface floor_surface(const Vec3& point, const Color& albedo) {
  static const Material diffuse;
  Surface floor;
  floor.point = floor.origin = point;
  floor.normal = floor.towards_eye = Vec3::UnitY();
  floor.albedo = albedo;
  floor.material = &diffuse;
  return floor;
}

Color texel_at(const Texture& texture, float u, float v) {
  const float x = (u - floored(u)) * static_cast<float>(texture.width) - 0.5f;
  const float y = (v - floored(v)) * static_cast<float>(texture.height) - 0.5f;
  const float left = floored(x), top = floored(y);
  // Both neighbours lie at most one texel outside.
  const auto wrapped = [](float at, int size) {
    const int i = static_cast<int>(at);
    return i < 0 ? i + size : i >= size ? i - size : i;
  };
  const auto texel = [&](float column, float row) -> const Color& {
    const int i = wrapped(column, texture.width), j = wrapped(row, texture.height);
    return texture.texels[static_cast<std::size_t>(j) * static_cast<std::size_t>(texture.width) +
                          static_cast<std::size_t>(i)];
  };
  const float fx = x - left, fy = y - top;
  return (1.0f - fy) * ((1.0f - fx) * texel(left, top) + fx * texel(left + 1.0f, top)) +
         fy * ((1.0f - fx) * texel(left, top + 1.0f) + fx * texel(left + 1.0f, top + 1.0f));
}

Color reflectance(const Surface& surface, const Vec3& towards) {
  const Color diffuse = surface.albedo * std::numbers::inv_pi_v<float>;
  if (surface.material->specular_f0 <= 0.0f) return diffuse;
  return diffuse + ggx(surface, towards);
}

}  // namespace mien::render
