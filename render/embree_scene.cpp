#include "render/embree_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "render/embree_api.h"
#include "render/error.h"

namespace mien::render {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

bool machine_has(const std::string& instruction_set) {
  if (instruction_set == "sse2") return __builtin_cpu_supports("sse2");
  if (instruction_set == "sse4.2") return __builtin_cpu_supports("sse4.2");
  if (instruction_set == "avx") return __builtin_cpu_supports("avx");
  if (instruction_set == "avx2") return __builtin_cpu_supports("avx2");
  if (instruction_set == "avx512") return __builtin_cpu_supports("avx512f");
  throw Error("unknown instruction set \"" + instruction_set +
              "\"; Embree knows sse2, sse4.2, avx, avx2 and avx512");
}

void bounds_of(const RTCBoundsFunctionArguments* arguments) {
  const RoundCone& cone =
      static_cast<const RoundCone*>(arguments->geometryUserPtr)[arguments->primID];
  const Eigen::Array3f a = cone.a.array(), b = cone.b().array();
  const Eigen::Array3f lower = (a - cone.radius_a).min(b - cone.radius_b);
  const Eigen::Array3f upper = (a + cone.radius_a).max(b + cone.radius_b);
  // Wider than any rounding, in Embree or in the intersection, so that no box hides a hit.
  const float padding =
      1e-4f * std::max(1.0f, std::max(lower.abs().maxCoeff(), upper.abs().maxCoeff()));
  RTCBounds& bounds = *arguments->bounds_o;
  bounds.lower_x = lower.x() - padding;
  bounds.lower_y = lower.y() - padding;
  bounds.lower_z = lower.z() - padding;
  bounds.upper_x = upper.x() + padding;
  bounds.upper_y = upper.y() + padding;
  bounds.upper_z = upper.z() + padding;
}

// Embree's ray packets of N rays are arrays of N values, field by field.
struct PacketFields {
  float* fields;
  unsigned lanes;

  float* operator[](unsigned field) const { return fields + field * lanes; }
  RayLanes rays() const {
    return {(*this)[0], (*this)[1], (*this)[2], (*this)[4], (*this)[5], (*this)[6]};
  }
  const float* near_distance() const { return (*this)[3]; }
  float* far_distance() const { return (*this)[8]; }
};

struct Distances {
  float lane[max_lanes];
};

// First crossing of the surface beyond the near distance; infinity when there is none.
Distances crossings(const RoundCone& cone, const PacketFields& packet) {
  float enter[max_lanes], leave[max_lanes];
  intersect_lines(cone, packet.rays(), packet.lanes, enter, leave);
  Distances distances;
  const float* from = packet.near_distance();
  for (unsigned i = 0; i < packet.lanes; ++i) {
    distances.lane[i] = enter[i] > leave[i]  ? infinity
                        : enter[i] > from[i] ? enter[i]
                        : leave[i] > from[i] ? leave[i]
                                             : infinity;
  }
  return distances;
}

void intersect_cone(const RTCIntersectFunctionNArguments* arguments) {
  const unsigned lanes = arguments->N;
  const PacketFields packet{reinterpret_cast<float*>(RTCRayHitN_RayN(arguments->rayhit, lanes)),
                            lanes};
  RTCHitN* hit = RTCRayHitN_HitN(arguments->rayhit, lanes);
  const RoundCone& cone =
      static_cast<const RoundCone*>(arguments->geometryUserPtr)[arguments->primID];
  const Distances crossing = crossings(cone, packet);
  float* reach = packet.far_distance();
  for (unsigned i = 0; i < lanes; ++i) {
    if (arguments->valid[i] == 0) continue;
    const bool nearer = crossing.lane[i] < reach[i];
    const bool tie = crossing.lane[i] == reach[i] &&
                     RTCHitN_geomID(hit, lanes, i) != RTC_INVALID_GEOMETRY_ID &&
                     arguments->primID < RTCHitN_primID(hit, lanes, i);
    if (!nearer && !tie) continue;
    reach[i] = crossing.lane[i];
    RTCHitN_primID(hit, lanes, i) = arguments->primID;
    RTCHitN_geomID(hit, lanes, i) = arguments->geomID;
  }
}

void occlude_by_cone(const RTCOccludedFunctionNArguments* arguments) {
  const unsigned lanes = arguments->N;
  const PacketFields packet{reinterpret_cast<float*>(arguments->ray), lanes};
  const RoundCone& cone =
      static_cast<const RoundCone*>(arguments->geometryUserPtr)[arguments->primID];
  const Distances crossing = crossings(cone, packet);
  float* reach = packet.far_distance();
  for (unsigned i = 0; i < lanes; ++i) {
    if (arguments->valid[i] != 0 && crossing.lane[i] < reach[i]) reach[i] = -infinity;
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
  for (int i = 0; i < packet_size; ++i) {
    out.tnear[i] = 0.0f;
    out.time[i] = 0.0f;
    out.mask[i] = ~0u;
    out.id[i] = 0;
    out.flags[i] = 0;
    valid[static_cast<std::size_t>(i)] = i < rays.count ? -1 : 0;
  }
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
                " instructions, which Embree is pinned to");
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

void RayPacket::push(const Vec3& origin, const Vec3& direction, float distance) {
  origin_x[count] = origin.x();
  origin_y[count] = origin.y();
  origin_z[count] = origin.z();
  direction_x[count] = direction.x();
  direction_y[count] = direction.y();
  direction_z[count] = direction.z();
  reach[count] = distance;
  ++count;
}

EmbreeScene::EmbreeScene(const EmbreeDevice& device, std::vector<RoundCone> cones)
    : cones_(std::move(cones)), scene_(rtcNewScene(device.get())) {
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(cones_.size()));
  rtcSetGeometryUserData(geometry, cones_.data());
  rtcSetGeometryBoundsFunction(geometry, bounds_of, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect_cone);
  rtcSetGeometryOccludedFunction(geometry, occlude_by_cone);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene_);
  throw_on_error(device.get(), "build a scene");
}

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
    hits.cone[i] = packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID
                       ? -1
                       : static_cast<int>(packet.hit.primID[i]);
  }
  return hits;
}

std::uint32_t EmbreeScene::occluded(const RayPacket& rays) const {
  RTCRay8 packet;
  alignas(32) std::array<int, packet_size> valid;
  copy_rays(rays, packet, valid);
  embree::occluded8(valid.data(), scene_, &packet, false);
  std::uint32_t blocked = 0;
  for (int i = 0; i < rays.count; ++i)
    if (packet.tfar[i] < 0.0f) blocked |= 1u << i;
  return blocked;
}

}  // namespace mien::render
