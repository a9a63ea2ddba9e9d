#include "render/geometry/triangle.h"

#include <algorithm>

#include "render/math/constants.h"
#include "render/math/for_avx2.h"

namespace mien::render {

namespace {

/// Where a ray crosses the planes of the triangles, as the distance times the cosine between ray
/// and normal, and this cosine; whether ahead of its origin and within the triangle. Complete only
/// if any of them is.
struct Crossings {
  alignas(32) float scaled[patch_size];
  alignas(32) float facing[patch_size];
  alignas(32) int inside[patch_size];
};

struct Ray {
  float dx, dy, dz;
  float ox, oy, oz;
};

[[gnu::always_inline]] inline Ray ray_of(const RayLanes& rays, unsigned lane) {
  return {rays.direction_x[lane], rays.direction_y[lane], rays.direction_z[lane],
          rays.origin_x[lane],    rays.origin_y[lane],    rays.origin_z[lane]};
}

/// Whether the ray crosses the plane of any of the triangles ahead of its origin. Often it does
/// not: a ray that leaves a surface has the triangles around its origin behind it.
[[gnu::always_inline]] inline int cross_planes(const PatchVectors& a, const PatchVectors& normal,
                                               const Ray& ray, Crossings& found) {
  int any = 0;
#pragma omp simd reduction(| : any)
  for (std::size_t i = 0; i < patch_size; ++i) {
    const float nx = normal.x[i], ny = normal.y[i], nz = normal.z[i];
    const float scaled = nx * (a.x[i] - ray.ox) + ny * (a.y[i] - ray.oy) + nz * (a.z[i] - ray.oz);
    const float facing = nx * ray.dx + ny * ray.dy + nz * ray.dz;
    found.scaled[i] = scaled;
    found.facing[i] = facing;
    found.inside[i] = ((scaled > 0.0f) & (facing > 0.0f)) | ((scaled < 0.0f) & (facing < 0.0f));
    any |= found.inside[i];
  }
  return any;
}

/// Of the planes that are crossed ahead, whether within the triangles.
[[gnu::always_inline]] inline int cross_within(const PatchEdges& edges, const Ray& ray,
                                               Crossings& found) {
  const float mx = ray.oy * ray.dz - ray.oz * ray.dy, my = ray.oz * ray.dx - ray.ox * ray.dz;
  const float mz = ray.ox * ray.dy - ray.oy * ray.dx;
  int any = 0;
#pragma omp simd reduction(| : any)
  for (std::size_t i = 0; i < patch_size; ++i) {
    const auto side = [&](const PatchEdges::Edge& edge) {
      const PatchVectors &vector = edge.vector, &moment = edge.moment;
      return (ray.dx * moment.x[i] + mx * vector.x[i]) + (ray.dy * moment.y[i] + my * vector.y[i]) +
             (ray.dz * moment.z[i] + mz * vector.z[i]);
    };
    const float u = side(edges.bc), v = side(edges.ca), w = side(edges.ab);
    found.inside[i] &=
        ((u >= 0.0f) & (v >= 0.0f) & (w >= 0.0f)) | ((u <= 0.0f) & (v <= 0.0f) & (w <= 0.0f));
    any |= found.inside[i];
  }
  return any;
}

[[gnu::always_inline]] inline int cross(const TrianglePatch& patch, const Ray& ray,
                                        Crossings& found) {
  return cross_planes(patch.a, patch.normal, ray, found) == 0
             ? 0
             : cross_within(patch.edges, ray, found);
}

/// The nearest of the distances, which are infinite where a triangle is not hit.
[[gnu::always_inline]] inline float distances_of(const Crossings& found, float* distances) {
  float nearest = infinity;
  for (std::size_t i = 0; i < patch_size; ++i) {
    const float t = found.scaled[i] / found.facing[i];
    if (found.inside[i] == 0 || !(t > 0.0f)) continue;
    distances[i] = t;
    nearest = std::min(nearest, t);
  }
  return nearest;
}

// The moment is (p + q) / 2 × (q − p): smaller terms, and thus smaller rounding errors, than p × q.
[[gnu::always_inline]] inline void set_edge(const PatchVectors& p, const PatchVectors& q,
                                            std::size_t i, PatchEdges::Edge& edge) {
  const float ex = q.x[i] - p.x[i], ey = q.y[i] - p.y[i], ez = q.z[i] - p.z[i];
  const float sx = 0.5f * (q.x[i] + p.x[i]), sy = 0.5f * (q.y[i] + p.y[i]);
  const float sz = 0.5f * (q.z[i] + p.z[i]);
  edge.vector.x[i] = ex;
  edge.vector.y[i] = ey;
  edge.vector.z[i] = ez;
  edge.moment.x[i] = sy * ez - sz * ey;
  edge.moment.y[i] = sz * ex - sx * ez;
  edge.moment.z[i] = sx * ey - sy * ex;
}

[[gnu::always_inline]] inline void set_normals(const PatchCorners& corners, PatchVectors& normal) {
  // No structured binding: loops of OpenMP cannot use those.
  const auto &a = corners.a, &b = corners.b, &c = corners.c;
#pragma omp simd
  for (std::size_t i = 0; i < patch_size; ++i) {
    const float bx = b.x[i] - a.x[i], by = b.y[i] - a.y[i], bz = b.z[i] - a.z[i];
    const float cx = c.x[i] - a.x[i], cy = c.y[i] - a.y[i], cz = c.z[i] - a.z[i];
    normal.x[i] = by * cz - bz * cy;
    normal.y[i] = bz * cx - bx * cz;
    normal.z[i] = bx * cy - by * cx;
  }
}

[[gnu::always_inline]] inline void set_edges(const PatchCorners& corners, PatchEdges& edges) {
#pragma omp simd
  for (std::size_t i = 0; i < patch_size; ++i) {
    set_edge(corners.b, corners.c, i, edges.bc);
    set_edge(corners.c, corners.a, i, edges.ca);
    set_edge(corners.a, corners.b, i, edges.ab);
  }
}

[[gnu::always_inline]] inline void move(const PatchVectors& from, const PatchVectors& to,
                                        float time, PatchVectors& moved) {
#pragma omp simd
  for (std::size_t i = 0; i < patch_size; ++i) {
    moved.x[i] = from.x[i] + time * (to.x[i] - from.x[i]);
    moved.y[i] = from.y[i] + time * (to.y[i] - from.y[i]);
    moved.z[i] = from.z[i] + time * (to.z[i] - from.z[i]);
  }
}

}  // namespace

std::vector<PatchCorners> corners_of(const std::vector<Triangle>& triangles) {
  std::vector<PatchCorners> patches((triangles.size() + patch_size - 1) / patch_size,
                                    PatchCorners{});
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    PatchCorners& patch = patches[i / patch_size];
    patch.a.set(i % patch_size, triangles[i].a);
    patch.b.set(i % patch_size, triangles[i].b);
    patch.c.set(i % patch_size, triangles[i].c);
  }
  return patches;
}

MIEN_FOR_AVX2_TOO TrianglePatch prepared_patch(const PatchCorners& corners) {
  TrianglePatch patch;
  patch.a = corners.a;
  set_normals(corners, patch.normal);
  set_edges(corners, patch.edges);
  return patch;
}

MIEN_FOR_AVX2_TOO float intersect_patch(const TrianglePatch& patch, const RayLanes& rays,
                                        unsigned lane, float* distances) {
  Crossings found;
  std::fill_n(distances, patch_size, infinity);
  if (cross(patch, ray_of(rays, lane), found) == 0) return infinity;
  return distances_of(found, distances);
}

MIEN_FOR_AVX2_TOO float intersect_moving_patch(const PatchCorners& from, const PatchCorners& to,
                                               float time, const RayLanes& rays, unsigned lane,
                                               float* distances) {
  Crossings found;
  std::fill_n(distances, patch_size, infinity);
  const Ray ray = ray_of(rays, lane);
  PatchCorners moved;
  PatchVectors normal;
  move(from.a, to.a, time, moved.a);
  move(from.b, to.b, time, moved.b);
  move(from.c, to.c, time, moved.c);
  set_normals(moved, normal);
  if (cross_planes(moved.a, normal, ray, found) == 0) return infinity;
  PatchEdges edges;
  set_edges(moved, edges);
  if (cross_within(edges, ray, found) == 0) return infinity;
  return distances_of(found, distances);
}

MIEN_FOR_AVX2_TOO void occlude_by_patch(const TrianglePatch& patch, const RayLanes& rays,
                                        const int* valid, unsigned count, float* reach) {
  Crossings found;
  for (unsigned ray = 0; ray < count; ++ray) {
    if (valid[ray] == 0 || cross(patch, ray_of(rays, ray), found) == 0) continue;
    const float within = reach[ray];
    int blocked = 0;
#pragma omp simd reduction(| : blocked)
    for (std::size_t i = 0; i < patch_size; ++i) {
      const float t = found.scaled[i] / found.facing[i];
      blocked |= found.inside[i] & (t > 0.0f) & (t < within);
    }
    if (blocked != 0) reach[ray] = -infinity;
  }
}

}  // namespace mien::render
