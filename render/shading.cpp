#include "render/shading.h"

#include <algorithm>
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
  const float fresnel = material.sheen + (1.0f - material.sheen) * fifth;
  return density * fresnel / (4.0f * masking);
}

}  // namespace

Color reflectance(const Surface& surface, const Vec3& towards) {
  const Color diffuse = surface.material->albedo * std::numbers::inv_pi_v<float>;
  if (surface.material->sheen <= 0.0f) return diffuse;
  return diffuse + ggx(surface, towards);
}

Vec3 ray_origin(const Surface& surface) {
  const float offset = 1e-4f * std::max(1.0f, surface.point.cwiseAbs().maxCoeff());
  return surface.point + offset * surface.normal;
}

}  // namespace mien::render
