#include "render/geometry/embree_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "render/error.h"
#include "render/geometry/box.h"
#include "render/geometry/embree_api.h"
#include "render/math/constants.h"

namespace mien::render {

struct EmbreeScene::Contents {
  explicit Contents(Shapes traced);

  Shapes shapes;
  std::vector<TrianglePatch> patches;         // of the triangles, if they do not move
  std::vector<PatchCorners> opening_patches;  // if they move: when the shutter opens
  std::vector<PatchCorners> closing_patches;  // if they move: when it closes

  /// Padded boxes of the primitives of Embree's two geometries, round cones and patches of
  /// triangles, when the shutter opens and, if they move, when it closes.
  std::array<std::vector<Box>, 2> cone_boxes;
  std::array<std::vector<Box>, 2> patch_boxes;
};

namespace {

using Contents = EmbreeScene::Contents;

const Contents& contents_of(const void* user) { return *static_cast<const Contents*>(user); }

template <class Shape>
std::vector<Box> boxes_of(const std::vector<Shape>& shapes, std::size_t together) {
  std::vector<Box> boxes;
  for (std::size_t first = 0; first < shapes.size(); first += together) {
    Box box = box_of(shapes[first]);
    for (std::size_t i = first + 1; i < std::min(first + together, shapes.size()); ++i)
      box = hull(box, box_of(shapes[i]));
    boxes.push_back(padded(box));
  }
  return boxes;
}

template <std::array<std::vector<Box>, 2> Contents::*boxes>
void bounds_of(const RTCBoundsFunctionArguments* arguments) {
  const auto& [opening, closing] = contents_of(arguments->geometryUserPtr).*boxes;
  const Box& box = (arguments->timeStep > 0 ? closing : opening)[arguments->primID];
  RTCBounds& bounds = *arguments->bounds_o;
  bounds.lower_x = box.lower.x();
  bounds.lower_y = box.lower.y();
  bounds.lower_z = box.lower.z();
  bounds.upper_x = box.upper.x();
  bounds.upper_y = box.upper.y();
  bounds.upper_z = box.upper.z();
}

bool machine_has(const std::string& instruction_set) {
  if (instruction_set == "sse2") return __builtin_cpu_supports("sse2");
  if (instruction_set == "sse4.2") return __builtin_cpu_supports("sse4.2");
  if (instruction_set == "avx") return __builtin_cpu_supports("avx");
  if (instruction_set == "avx2") return __builtin_cpu_supports("avx2");
  if (instruction_set == "avx512") return __builtin_cpu_supports("avx512f");
  throw Error("unknown instruction set \"" + instruction_set +
              "\"; Embree knows sse2, sse4.2, avx, avx2 and avx512");
}

// Embree's ray packets of N rays are arrays of N values, field by field.
struct PacketFields {
  float* fields;
  unsigned lanes;

  float* operator[](unsigned field) const { return fields + field * lanes; }
  RayLanes rays(unsigned from = 0) const {
    return {(*this)[0] + from, (*this)[1] + from, (*this)[2] + from,
            (*this)[4] + from, (*this)[5] + from, (*this)[6] + from};
  }
  const float* near_distance() const { return (*this)[3]; }
  const float* time() const { return (*this)[7]; }
  float* far_distance() const { return (*this)[8]; }
  std::uint32_t present(unsigned lane) const {
    std::uint32_t bits;
    std::memcpy(&bits, (*this)[10] + lane, sizeof bits);
    return bits;
  }
};

// First crossing of the surface beyond the near distance; infinity when there is none.
void cone_crossings(const Shapes& shapes, std::size_t index, const PacketFields& packet,
                    float* distances) {
  float enter[max_lanes], leave[max_lanes];
  if (shapes.closing_cones.empty()) {
    intersect_lines(shapes.cones[index], packet.rays(), packet.lanes, enter, leave);
  } else {
    for (unsigned i = 0; i < packet.lanes; ++i)
      intersect_lines(shapes.cone_at(index, packet.time()[i]), packet.rays(i), 1, enter + i,
                      leave + i);
  }
  crossings_beyond(packet.near_distance(), enter, leave, packet.lanes, distances);
}

/// As intersect_patch, at the time of the ray.
float patch_crossings(const Contents& scene, std::size_t index, const PacketFields& packet,
                      unsigned lane, float* distances) {
  if (scene.closing_patches.empty())
    return intersect_patch(scene.patches[index], packet.rays(), lane, distances);
  return intersect_moving_patch(scene.opening_patches[index], scene.closing_patches[index],
                                packet.time()[lane], packet.rays(), lane, distances);
}

bool is_there(const Shapes& shapes, std::size_t shape, const PacketFields& packet, unsigned lane) {
  return shapes.all_present || ((packet.present(lane) >> shapes.figures[shape]) & 1u) != 0;
}

/// The hits of a packet, with the number of a cone or triangle as Embree's primitive.
class PacketHits {
 public:
  explicit PacketHits(const RTCIntersectFunctionNArguments* arguments)
      : packet{reinterpret_cast<float*>(RTCRayHitN_RayN(arguments->rayhit, arguments->N)),
               arguments->N},
        hit_(RTCRayHitN_HitN(arguments->rayhit, arguments->N)),
        geometry_(arguments->geomID) {}

  /// Takes a crossing of a ray if it is the nearest so far; of equally near ones, that of the shape
  /// of the lower number.
  void offer(const Shapes& shapes, unsigned lane, unsigned number, float distance) {
    float& reach = packet.far_distance()[lane];
    unsigned& geometry = RTCHitN_geomID(hit_, packet.lanes, lane);
    unsigned& primitive = RTCHitN_primID(hit_, packet.lanes, lane);
    const bool earlier = geometry != RTC_INVALID_GEOMETRY_ID &&
                         (geometry_ < geometry || (geometry_ == geometry && number < primitive));
    if (!(distance < reach || (distance == reach && earlier))) return;
    if (!is_there(shapes, number + (geometry_ == 0 ? 0 : shapes.cones.size()), packet, lane))
      return;
    reach = distance;
    primitive = number;
    geometry = geometry_;
  }

  const PacketFields packet;

 private:
  RTCHitN* hit_;
  unsigned geometry_;
};

void intersect_cone(const RTCIntersectFunctionNArguments* arguments) {
  const Contents& scene = contents_of(arguments->geometryUserPtr);
  PacketHits hits(arguments);
  float distances[max_lanes];
  cone_crossings(scene.shapes, arguments->primID, hits.packet, distances);
  for (unsigned i = 0; i < hits.packet.lanes; ++i)
    if (arguments->valid[i] != 0) hits.offer(scene.shapes, i, arguments->primID, distances[i]);
}

void occlude_by_cone(const RTCOccludedFunctionNArguments* arguments) {
  const Contents& scene = contents_of(arguments->geometryUserPtr);
  const PacketFields packet{reinterpret_cast<float*>(arguments->ray), arguments->N};
  float distances[max_lanes];
  cone_crossings(scene.shapes, arguments->primID, packet, distances);
  float* reach = packet.far_distance();
  for (unsigned i = 0; i < packet.lanes; ++i)
    if (arguments->valid[i] != 0 && distances[i] < reach[i] &&
        is_there(scene.shapes, arguments->primID, packet, i))
      reach[i] = -infinity;
}

void intersect_triangles(const RTCIntersectFunctionNArguments* arguments) {
  const Contents& scene = contents_of(arguments->geometryUserPtr);
  PacketHits hits(arguments);
  // Embree offers a patch to rays that pass it by, too, if another ray enters its box.
  int may_hit[max_lanes];
  const auto& [opening, closing] = scene.patch_boxes;
  const Box& box = opening[arguments->primID];
  find_rays_through(closing.empty() ? box : hull(box, closing[arguments->primID]),
                    hits.packet.rays(), hits.packet.far_distance(), may_hit);
  alignas(32) float distances[patch_size];
  for (unsigned i = 0; i < hits.packet.lanes; ++i) {
    if ((may_hit[i] & arguments->valid[i]) == 0) continue;
    const float nearest = patch_crossings(scene, arguments->primID, hits.packet, i, distances);
    if (nearest > hits.packet.far_distance()[i]) continue;
    for (unsigned k = 0; k < patch_size; ++k)
      if (distances[k] < infinity)
        hits.offer(scene.shapes, i, arguments->primID * unsigned{patch_size} + k, distances[k]);
  }
}

void occlude_by_triangles(const RTCOccludedFunctionNArguments* arguments) {
  const Contents& scene = contents_of(arguments->geometryUserPtr);
  const Shapes& shapes = scene.shapes;
  const PacketFields packet{reinterpret_cast<float*>(arguments->ray), arguments->N};
  float* reach = packet.far_distance();
  if (shapes.all_present && shapes.closing_triangles.empty())
    return occlude_by_patch(scene.patches[arguments->primID], packet.rays(), arguments->valid,
                            packet.lanes, reach);
  alignas(32) float distances[patch_size];
  for (unsigned i = 0; i < packet.lanes; ++i) {
    if (arguments->valid[i] == 0) continue;
    patch_crossings(scene, arguments->primID, packet, i, distances);
    for (std::size_t k = 0; k < patch_size; ++k)
      if (distances[k] < reach[i] &&
          is_there(shapes, shapes.cones.size() + arguments->primID * patch_size + k, packet, i))
        reach[i] = -infinity;
  }
}

void copy_rays(const RayPacket& rays, RTCRay8& out, std::array<int, packet_size>& valid) {
  std::memcpy(out.org_x, rays.origin_x, sizeof rays.origin_x);
  std::memcpy(out.org_y, rays.origin_y, sizeof rays.origin_y);
  std::memcpy(out.org_z, rays.origin_z, sizeof rays.origin_z);
  std::memcpy(out.dir_x, rays.direction_x, sizeof rays.direction_x);
  std::memcpy(out.dir_y, rays.direction_y, sizeof rays.direction_y);
  std::memcpy(out.dir_z, rays.direction_z, sizeof rays.direction_z);
  std::memcpy(out.tfar, rays.reach, sizeof rays.reach);
  std::memcpy(out.time, rays.time, sizeof rays.time);
  std::memcpy(out.id, rays.present, sizeof rays.present);
  for (int i = 0; i < packet_size; ++i) {
    out.tnear[i] = 0.0f;
    out.mask[i] = ~0u;
    out.flags[i] = 0;
    valid[static_cast<std::size_t>(i)] = i < rays.count ? -1 : 0;
  }
}

RTCRay single_ray(const RayPacket& rays, int i) {
  RTCRay ray;
  ray.org_x = rays.origin_x[i];
  ray.org_y = rays.origin_y[i];
  ray.org_z = rays.origin_z[i];
  ray.tnear = 0.0f;
  ray.dir_x = rays.direction_x[i];
  ray.dir_y = rays.direction_y[i];
  ray.dir_z = rays.direction_z[i];
  ray.time = rays.time[i];
  ray.tfar = rays.reach[i];
  ray.mask = ~0u;
  ray.id = rays.present[i];
  ray.flags = 0;
  return ray;
}

void throw_on_error(RTCDevice device, const char* what) {
  if (rtcGetDeviceError(device) != RTC_ERROR_NONE)
    throw Error(std::string("Embree cannot ") + what);
}

}  // namespace

EmbreeDevice::EmbreeDevice(const std::string& instruction_set) : instruction_set_(instruction_set) {
  if (instruction_set_.empty()) instruction_set_ = machine_has("avx2") ? "avx2" : "sse4.2";
  if (!machine_has(instruction_set_))
    throw Error("this machine has no " + instruction_set_ +
                " instructions, which Embree was set to use");
  device_ = rtcNewDevice(("isa=" + instruction_set_).c_str());
  if (device_ == nullptr) throw Error("Embree cannot start with isa=" + instruction_set_);
}

EmbreeDevice::~EmbreeDevice() { rtcReleaseDevice(device_); }

std::string EmbreeDevice::description() const {
  const auto version = [this](RTCDeviceProperty part) {
    return std::to_string(rtcGetDeviceProperty(device_, part));
  };
  return "Embree " + version(RTC_DEVICE_PROPERTY_VERSION_MAJOR) + "." +
         version(RTC_DEVICE_PROPERTY_VERSION_MINOR) + "." +
         version(RTC_DEVICE_PROPERTY_VERSION_PATCH) + ", " + instruction_set_;
}

void RayPacket::push(const Vec3& origin, const Vec3& direction, float distance, float when,
                     std::uint32_t figures) {
  origin_x[count] = origin.x();
  origin_y[count] = origin.y();
  origin_z[count] = origin.z();
  direction_x[count] = direction.x();
  direction_y[count] = direction.y();
  direction_z[count] = direction.z();
  reach[count] = distance;
  time[count] = when;
  present[count] = figures;
  ++count;
}

EmbreeScene::Contents::Contents(Shapes traced)
    : shapes(std::move(traced)),
      cone_boxes{boxes_of(shapes.cones, 1), boxes_of(shapes.closing_cones, 1)},
      patch_boxes{boxes_of(shapes.triangles, patch_size),
                  boxes_of(shapes.closing_triangles, patch_size)} {
  std::vector<PatchCorners> corners = corners_of(shapes.triangles);
  if (shapes.closing_triangles.empty()) {
    for (const PatchCorners& patch : corners) patches.push_back(prepared_patch(patch));
  } else {
    opening_patches = std::move(corners);
    closing_patches = corners_of(shapes.closing_triangles);
  }
}

EmbreeScene::EmbreeScene(const EmbreeDevice& device, Shapes shapes)
    : contents_(std::make_unique<Contents>(std::move(shapes))), scene_(rtcNewScene(device.get())) {
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  const auto attach = [&](const std::array<std::vector<Box>, 2>& boxes, RTCBoundsFunction bounds,
                          RTCIntersectFunctionN hit, RTCOccludedFunctionN blocked) {
    RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes[0].size()));
    rtcSetGeometryTimeStepCount(geometry, boxes[1].empty() ? 1 : 2);
    rtcSetGeometryUserData(geometry, contents_.get());
    rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, hit);
    rtcSetGeometryOccludedFunction(geometry, blocked);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
  };
  // In the order of their numbers.
  attach(contents_->cone_boxes, bounds_of<&Contents::cone_boxes>, intersect_cone, occlude_by_cone);
  attach(contents_->patch_boxes, bounds_of<&Contents::patch_boxes>, intersect_triangles,
         occlude_by_triangles);
  rtcCommitScene(scene_);
  throw_on_error(device.get(), "build a scene");
}

const Shapes& EmbreeScene::shapes() const { return contents_->shapes; }

EmbreeScene::~EmbreeScene() { rtcReleaseScene(scene_); }

Hits EmbreeScene::intersect(const RayPacket& rays) const {
  Hits hits;
  RTCRayHit8 packet;
  alignas(32) std::array<int, packet_size> valid;
  copy_rays(rays, packet.ray, valid);
  std::fill_n(packet.hit.geomID, packet_size, RTC_INVALID_GEOMETRY_ID);
  std::fill_n(packet.hit.primID, packet_size, RTC_INVALID_GEOMETRY_ID);
  embree::intersect8(valid.data(), scene_, &packet, true);
  for (int i = 0; i < packet_size; ++i) {
    hits.distance[i] = packet.ray.tfar[i];
    const unsigned geometry = packet.hit.geomID[i];
    hits.shape[i] = geometry == RTC_INVALID_GEOMETRY_ID ? -1
                    : geometry == 0
                        ? static_cast<int>(packet.hit.primID[i])
                        : static_cast<int>(contents_->shapes.cones.size() + packet.hit.primID[i]);
  }
  return hits;
}

std::uint32_t EmbreeScene::occluded_together(const RayPacket& rays) const {
  RTCRay8 packet;
  alignas(32) std::array<int, packet_size> valid;
  copy_rays(rays, packet, valid);
  embree::occluded8(valid.data(), scene_, &packet, false);
  std::uint32_t blocked = 0;
  for (int i = 0; i < rays.count; ++i)
    if (packet.tfar[i] < 0.0f) blocked |= 1u << i;
  return blocked;
}

std::uint32_t EmbreeScene::occluded_singly(const RayPacket& rays) const {
  std::uint32_t blocked = 0;
  for (int i = 0; i < rays.count; ++i) {
    RTCRay ray = single_ray(rays, i);
    embree::occluded1(scene_, &ray);
    if (ray.tfar < 0.0f) blocked |= 1u << i;
  }
  return blocked;
}

}  // namespace mien::render
