// Rays a second of the tracer's two ray queries against a bare loop over Embree's own spheres and
// round curves, same rays, same scene, one thread; and whole pictures a second. The rates of rays
// are per second of processor time.

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <vector>

#include <benchmark/benchmark.h>

#include "render/geometry/embree_api.h"
#include "render/geometry/embree_scene.h"
#include "render/light/floor.h"
#include "render/light/light.h"
#include "render/tracer/tracer.h"

namespace {

using namespace mien::render;

constexpr float infinity = std::numeric_limits<float>::infinity();
const Camera camera{
    .position = {1.0f, 1.4f, 4.0f}, .target = {0.0f, 0.9f, 0.0f}, .width = 1280, .height = 720};

struct Joint {
  Vec3 place;
  int parent;
};

/// A standing figure of 21 joints: trunk, then arm and leg of either side.
std::vector<Joint> figure() {
  std::vector<Joint> joints{{{0.0f, 0.95f, 0.0f}, -1},
                            {{0.0f, 1.1f, 0.0f}, 0},
                            {{0.0f, 1.3f, 0.0f}, 1},
                            {{0.0f, 1.48f, 0.0f}, 2},
                            {{0.0f, 1.65f, 0.02f}, 3}};
  for (const float side : {1.0f, -1.0f}) {
    const auto limb = [&](int root, std::array<Vec3, 4> places) {
      for (const Vec3& place : places) {
        joints.push_back({{side * place.x(), place.y(), side * place.z()}, root});
        root = static_cast<int>(joints.size()) - 1;
      }
    };
    limb(2, {Vec3{0.18f, 1.42f, 0.0f},
             {0.25f, 1.15f, 0.0f},
             {0.28f, 0.9f, 0.1f},
             {0.29f, 0.8f, 0.13f}});
    limb(0, {Vec3{0.1f, 0.92f, 0.0f},
             {0.11f, 0.5f, -0.12f},
             {0.12f, 0.09f, -0.25f},
             {0.13f, 0.03f, -0.12f}});
  }
  return joints;
}

Scene standing_figure() {
  Scene scene;
  scene.materials = {Material{}};
  const std::vector<Joint> joints = figure();
  for (const Joint& joint : joints) scene.solids.spheres.push_back({joint.place, 0.06f});
  for (const Joint& joint : joints)
    if (joint.parent >= 0)
      scene.solids.round_cones.push_back(
          {.start = joints[static_cast<std::size_t>(joint.parent)].place,
           .end = joint.place,
           .start_radius = 0.05f,
           .end_radius = 0.04f});
  scene.lights = {
      softbox({2.0f, 4.0f, 2.0f}, {0.0f, 1.0f, 0.0f}, 1.5f, 1.5f, Color::Constant(8.0f))};
  return scene;
}

/// The same solids as shapes that Embree intersects itself.
class BareScene {
 public:
  BareScene(const EmbreeDevice& device, const Scene& scene) : scene_(rtcNewScene(device.get())) {
    std::vector<float> balls, curves;
    std::vector<unsigned> starts;
    for (const Sphere& sphere : scene.solids.spheres) append(balls, sphere.centre, sphere.radius);
    for (const RoundCone& round_cone : scene.solids.round_cones) {
      starts.push_back(static_cast<unsigned>(curves.size() / 4));
      append(curves, round_cone.start, round_cone.start_radius);
      append(curves, round_cone.end, round_cone.end_radius);
    }
    attach(device, RTC_GEOMETRY_TYPE_SPHERE_POINT, balls, {});
    attach(device, RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE, curves, starts);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(scene_);
  }
  ~BareScene() { rtcReleaseScene(scene_); }
  BareScene(const BareScene&) = delete;
  BareScene& operator=(const BareScene&) = delete;

  RTCScene get() const { return scene_; }

 private:
  static void append(std::vector<float>& vertices, const Vec3& place, float radius) {
    vertices.insert(vertices.end(), {place.x(), place.y(), place.z(), radius});
  }

  void attach(const EmbreeDevice& device, RTCGeometryType type, const std::vector<float>& vertices,
              const std::vector<unsigned>& starts) {
    RTCGeometry geometry = rtcNewGeometry(device.get(), type);
    std::memcpy(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 16,
                                        vertices.size() / 4),
                vertices.data(), 4 * vertices.size());
    if (!starts.empty())
      std::memcpy(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, 4,
                                          starts.size()),
                  starts.data(), 4 * starts.size());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
  }

  RTCScene scene_;
};

/// Through the centre of every pixel, as far as the floor.
std::vector<RayPacket> primary_rays() {
  const CameraFrame frame = frame_of(camera);
  std::vector<RayPacket> packets;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      if (packets.empty() || packets.back().count == packet_size) packets.emplace_back();
      const Vec3 direction =
          frame.ray(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f).direction;
      packets.back().push(frame.position, direction,
                          distance_to_floor(frame.position, direction).value_or(infinity));
    }
  }
  return packets;
}

/// From what the primary rays meet, figure or floor, to points of the light.
std::vector<RayPacket> shadow_rays(const EmbreeScene& figure, const AreaLight& light) {
  std::vector<RayPacket> packets;
  std::uint32_t index = 0;
  for (const RayPacket& primaries : primary_rays()) {
    const Hits hits = figure.intersect(primaries);
    for (int i = 0; i < primaries.count; ++i) {
      if (!(hits.distance[i] < 20.0f)) continue;
      if (packets.empty() || packets.back().count == packet_size) packets.emplace_back();
      const Vec3 point = camera.position + (hits.distance[i] - 1e-3f) * primaries.direction(i);
      LaneVectors points;
      points.set(0, point);
      LaneWords number;
      number[0] = index++;
      const LaneLights chosen = sample(light, points, sample_points(number, {}));
      packets.back().push(point, chosen.towards.at(0), chosen.distance[0]);
    }
  }
  if (packets.back().count < packet_size) packets.pop_back();
  return packets;
}

RTCRay8 bare(const RayPacket& rays) {
  RTCRay8 out{};
  std::memcpy(out.org_x, rays.origin_x, sizeof rays.origin_x);
  std::memcpy(out.org_y, rays.origin_y, sizeof rays.origin_y);
  std::memcpy(out.org_z, rays.origin_z, sizeof rays.origin_z);
  std::memcpy(out.dir_x, rays.direction_x, sizeof rays.direction_x);
  std::memcpy(out.dir_y, rays.direction_y, sizeof rays.direction_y);
  std::memcpy(out.dir_z, rays.direction_z, sizeof rays.direction_z);
  std::memcpy(out.tfar, rays.reach, sizeof rays.reach);
  std::fill_n(out.mask, packet_size, ~0u);
  return out;
}

std::vector<RTCRay8> bare(const std::vector<RayPacket>& packets) {
  std::vector<RTCRay8> rays;
  for (const RayPacket& packet : packets) rays.push_back(bare(packet));
  return rays;
}

std::vector<RTCRay> one_by_one(const std::vector<RayPacket>& packets) {
  std::vector<RTCRay> rays;
  for (const RayPacket& packet : packets) {
    for (int i = 0; i < packet_size; ++i) {
      RTCRay ray{};
      ray.org_x = packet.origin_x[i];
      ray.org_y = packet.origin_y[i];
      ray.org_z = packet.origin_z[i];
      ray.dir_x = packet.direction_x[i];
      ray.dir_y = packet.direction_y[i];
      ray.dir_z = packet.direction_z[i];
      ray.tfar = packet.reach[i];
      ray.mask = ~0u;
      rays.push_back(ray);
    }
  }
  return rays;
}

#if RTC_VERSION_MAJOR >= 4
void intersect1(RTCScene scene, RTCRayHit& ray) { rtcIntersect1(scene, &ray); }
#else
void intersect1(RTCScene scene, RTCRayHit& ray) {
  RTCIntersectContext context = embree::context_for(true);
  rtcIntersect1(scene, &context, &ray);
}
#endif

alignas(32) constexpr std::array<int, packet_size> all_valid{-1, -1, -1, -1, -1, -1, -1, -1};

/// Both loops must meet the same things as often for their rates to be comparable.
void report(benchmark::State& state, std::size_t packets, std::size_t met) {
  const auto rays = static_cast<double>(packets * packet_size);
  state.counters["Mrays/s"] = benchmark::Counter(
      1e-6 * rays * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["met %"] = 100.0 * static_cast<double>(met) / rays;
}

void primary(benchmark::State& state) {
  const EmbreeDevice device("");
  const EmbreeScene figure(device, figure_shapes(standing_figure()));
  const std::vector<RayPacket> packets = primary_rays();
  std::size_t met = 0;
  for (auto _ : state) {
    met = 0;
    for (const RayPacket& packet : packets) {
      const Hits hits = figure.intersect(packet);
      for (int i = 0; i < packet_size; ++i) met += hits.shape[i] >= 0;
    }
    benchmark::DoNotOptimize(met);
  }
  report(state, packets.size(), met);
}
BENCHMARK(primary)->Unit(benchmark::kMillisecond);

void primary_bare_embree_by_8(benchmark::State& state) {
  const EmbreeDevice device("");
  const BareScene figure(device, standing_figure());
  const std::vector<RTCRay8> packets = bare(primary_rays());
  std::size_t met = 0;
  for (auto _ : state) {
    met = 0;
    for (const RTCRay8& packet : packets) {
      RTCRayHit8 rays;
      rays.ray = packet;
      std::fill_n(rays.hit.geomID, packet_size, RTC_INVALID_GEOMETRY_ID);
      std::fill_n(rays.hit.instID[0], packet_size, RTC_INVALID_GEOMETRY_ID);
      embree::intersect8(all_valid.data(), figure.get(), &rays, true);
      for (const unsigned id : rays.hit.geomID) met += id != RTC_INVALID_GEOMETRY_ID;
    }
    benchmark::DoNotOptimize(met);
  }
  report(state, packets.size(), met);
}
BENCHMARK(primary_bare_embree_by_8)->Unit(benchmark::kMillisecond);

void primary_bare_embree_by_1(benchmark::State& state) {
  const EmbreeDevice device("");
  const BareScene figure(device, standing_figure());
  const std::vector<RTCRay> rays = one_by_one(primary_rays());
  std::size_t met = 0;
  for (auto _ : state) {
    met = 0;
    for (const RTCRay& ray : rays) {
      RTCRayHit hit;
      hit.ray = ray;
      hit.hit.geomID = hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      intersect1(figure.get(), hit);
      met += hit.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
    benchmark::DoNotOptimize(met);
  }
  report(state, rays.size() / packet_size, met);
}
BENCHMARK(primary_bare_embree_by_1)->Unit(benchmark::kMillisecond);

void shadow(benchmark::State& state) {
  const Scene scene = standing_figure();
  const EmbreeDevice device("");
  const EmbreeScene figure(device, figure_shapes(scene));
  const std::vector<RayPacket> packets = shadow_rays(figure, scene.lights[0]);
  std::size_t met = 0;
  for (auto _ : state) {
    met = 0;
    for (const RayPacket& packet : packets)
      met += static_cast<std::size_t>(std::popcount(figure.occluded(packet)));
    benchmark::DoNotOptimize(met);
  }
  report(state, packets.size(), met);
}
BENCHMARK(shadow)->Unit(benchmark::kMillisecond);

void shadow_bare_embree_by_8(benchmark::State& state) {
  const Scene scene = standing_figure();
  const EmbreeDevice device("");
  const BareScene figure(device, scene);
  const EmbreeScene seen(device, figure_shapes(scene));
  const std::vector<RTCRay8> packets = bare(shadow_rays(seen, scene.lights[0]));
  std::size_t met = 0;
  for (auto _ : state) {
    met = 0;
    for (const RTCRay8& packet : packets) {
      RTCRay8 rays = packet;
      embree::occluded8(all_valid.data(), figure.get(), &rays, false);
      for (const float reach : rays.tfar) met += reach < 0.0f;
    }
    benchmark::DoNotOptimize(met);
  }
  report(state, packets.size(), met);
}
BENCHMARK(shadow_bare_embree_by_8)->Unit(benchmark::kMillisecond);

void shadow_bare_embree_by_1(benchmark::State& state) {
  const Scene scene = standing_figure();
  const EmbreeDevice device("");
  const BareScene figure(device, scene);
  const EmbreeScene seen(device, figure_shapes(scene));
  const std::vector<RTCRay> rays = one_by_one(shadow_rays(seen, scene.lights[0]));
  std::size_t met = 0;
  for (auto _ : state) {
    met = 0;
    for (RTCRay ray : rays) {
      embree::occluded1(figure.get(), &ray);
      met += ray.tfar < 0.0f;
    }
    benchmark::DoNotOptimize(met);
  }
  report(state, rays.size() / packet_size, met);
}
BENCHMARK(shadow_bare_embree_by_1)->Unit(benchmark::kMillisecond);

void picture(benchmark::State& state, const Quality& quality) {
  const Scene scene = standing_figure();
  Tracer tracer;
  for (auto _ : state) benchmark::DoNotOptimize(tracer.trace(scene, camera, quality));
  state.counters["frames/s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["threads"] = tracer.threads();
}
BENCHMARK_CAPTURE(picture, draft, draft_quality())
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(picture, standard, standard_quality())
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
