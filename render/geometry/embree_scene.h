#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "render/geometry/shapes.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace mien::render {

/// An Embree device pinned to an instruction set.
class EmbreeDevice {
 public:
  /// "sse2", "sse4.2", "avx", "avx2" or "avx512"; empty: avx2, or sse4.2 on a machine without AVX2.
  /// Throws Error for any other name, when the machine lacks the instruction set, and when Embree
  /// cannot start.
  explicit EmbreeDevice(const std::string& instruction_set);
  ~EmbreeDevice();
  EmbreeDevice(const EmbreeDevice&) = delete;
  EmbreeDevice& operator=(const EmbreeDevice&) = delete;

  RTCDeviceTy* get() const { return device_; }
  std::string description() const;  ///< "Embree 3.13.5, avx2"

 private:
  std::string instruction_set_;
  RTCDeviceTy* device_ = nullptr;
};

inline constexpr int packet_size = 8;

/// Up to eight rays in a packet. Directions have unit length.
struct RayPacket {
  alignas(32) float origin_x[packet_size] = {};
  alignas(32) float origin_y[packet_size] = {};
  alignas(32) float origin_z[packet_size] = {};
  alignas(32) float direction_x[packet_size] = {};
  alignas(32) float direction_y[packet_size] = {};
  alignas(32) float direction_z[packet_size] = {};
  alignas(32) float reach[packet_size] = {};  ///< hits beyond this distance are ignored, metres
  alignas(32) float time[packet_size] = {};   ///< 0 when the shutter opens … 1 when it closes
  /// Bit f: the ray can hit figure f; semi-transparent figures are present for a random part of the
  /// rays. Ignored if all figures are opaque (Shapes::all_present).
  alignas(32) std::uint32_t present[packet_size] = {};
  int count = 0;

  void push(const Vec3& origin, const Vec3& direction, float distance, float when = 0.0f,
            std::uint32_t figures = ~0u);
  Vec3 origin(int i) const { return {origin_x[i], origin_y[i], origin_z[i]}; }
  Vec3 direction(int i) const { return {direction_x[i], direction_y[i], direction_z[i]}; }
};

/// The nearest hit of each ray of a packet.
struct Hits {
  float distance[packet_size];
  int shape[packet_size];  ///< index of the shape (Shapes); −1: none
};

/// Shapes in an Embree bounding volume hierarchy. Embree proposes candidates by padded bounding
/// boxes, our own intersection tests decide, and of two equally near hits the shape with the lower
/// index wins, so that hits do not depend on Embree's version or instruction set. Embree's
/// primitives are round cones and patches of up to eight triangles.
class EmbreeScene {
 public:
  struct Contents;  // what Embree's callbacks see

  EmbreeScene(const EmbreeDevice& device, Shapes shapes);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  const Shapes& shapes() const;

  /// Returns the nearest hit of each ray. Optimised for coherent rays, such as neighbouring primary
  /// rays.
  Hits intersect(const RayPacket& rays) const;

  /// Returns a bit mask: bit i is set when a shape occludes ray i within its reach. Triangles are
  /// searched for each ray by itself: shadow rays diverge, and a packet would visit the boxes of
  /// all its rays. Round cones are faster tested against eight rays at a time.
  std::uint32_t occluded(const RayPacket& rays) const {
    return shapes().triangles.empty() ? occluded_together(rays) : occluded_singly(rays);
  }

 private:
  std::uint32_t occluded_together(const RayPacket& rays) const;
  std::uint32_t occluded_singly(const RayPacket& rays) const;

  std::unique_ptr<Contents> contents_;
  RTCSceneTy* scene_ = nullptr;
};

}  // namespace mien::render
