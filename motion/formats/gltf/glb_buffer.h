#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace mien::motion {

/// Element type of an accessor.
enum class GlbElement { scalar, vec2, vec3, vec4, mat4 };

/// GPU buffer target of an accessor.
enum class GlbUse { none, vertices, indices };

/// The binary chunk of a GLB file (glTF 2.0) under construction, with its buffer views and
/// accessors.
struct GlbBuffer {
  std::string bytes;
  nlohmann::ordered_json views = nlohmann::ordered_json::array();
  nlohmann::ordered_json accessors = nlohmann::ordered_json::array();
};

/// Adds numbers to the buffer with a buffer view and an accessor of their own. Returns the index of
/// the accessor.
std::size_t add(GlbBuffer& buffer, const std::vector<float>& numbers, GlbElement element,
                GlbUse use = GlbUse::none);
std::size_t add(GlbBuffer& buffer, const std::vector<std::uint16_t>& numbers, GlbElement element,
                GlbUse use = GlbUse::none);
std::size_t add(GlbBuffer& buffer, const std::vector<std::uint32_t>& numbers, GlbElement element,
                GlbUse use = GlbUse::none);

/// As `add`, with the minimum and maximum of each component, which glTF requires for keyframe times
/// and vertex positions. There must be at least one element.
std::size_t add_bounded(GlbBuffer& buffer, const std::vector<float>& numbers, GlbElement element,
                        GlbUse use = GlbUse::none);

/// Adds an accessor of `count` elements that are 0 but for those at the ascending `indices`, whose
/// numbers are given, with the minimum and maximum of each component. There must be at least one.
std::size_t add_sparse(GlbBuffer& buffer, std::size_t count,
                       const std::vector<std::uint32_t>& indices, const std::vector<float>& numbers,
                       GlbElement element);

/// Adds a file, such as an image. Returns the index of its buffer view.
std::size_t add_file(GlbBuffer& buffer, std::string_view file);

/// The bytes of a GLB file with the given document, to which the accessors, buffer views and buffer
/// are added. Invalid UTF-8 in names is replaced.
std::string glb_of(nlohmann::ordered_json document, const GlbBuffer& buffer);

}  // namespace mien::motion
