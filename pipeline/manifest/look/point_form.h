#pragma once

#include <cstddef>

#include <nlohmann/json.hpp>

#include "motion/math/geometry.h"
#include "pipeline/base/reading/value_codecs.h"
#include "render/math/vector.h"

namespace mien::pipeline {

/// Assigns a colour from "#rrggbb" or [r, g, b] (linear). Other values, which the schema has
/// already reported, leave `target` unchanged.
void assign(const nlohmann::json* value, render::Color& target);

/// [x, y, z]
template <>
struct ValueCodec<motion::Vec3> {
  static void read(const DocumentValue& given, motion::Vec3& point) {
    if (!given.value.is_array() || given.value.size() != 3) return;
    for (int axis = 0; axis < 3; ++axis)
      assign(&given.value[static_cast<std::size_t>(axis)], point[axis]);
  }
  static OrderedJson write(const motion::Vec3& point, const WritingOptions&) {
    return {point.x(), point.y(), point.z()};
  }
};

/// "#rrggbb", or [r, g, b] in linear light
template <>
struct ValueCodec<render::Color> {
  static void read(const DocumentValue& given, render::Color& colour) {
    assign(&given.value, colour);
  }
  static OrderedJson write(const render::Color& colour, const WritingOptions&) {
    return {colour[0], colour[1], colour[2]};
  }
};

}  // namespace mien::pipeline
