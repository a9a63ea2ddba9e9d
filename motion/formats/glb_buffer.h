#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace mien::motion {

/// How many numbers make one element of an accessor.
enum class GlbElement { scalar, vec2, vec3, vec4, mat4 };

/// What the graphics card keeps an accessor's numbers as.
enum class GlbUse { none, vertices, indices };

/// The binary part of a GLB file (glTF 2.0) that is being written, and what its JSON says of it.
struct GlbBuffer {
  std::string bytes;
  nlohmann::ordered_json views = nlohmann::ordered_json::array();
  nlohmann::ordered_json accessors = nlohmann::ordered_json::array();
};

/// Adds the numbers with a view and an accessor of their own; returns the accessor's index.
std::size_t add(GlbBuffer& buffer, const std::vector<float>& numbers, GlbElement element,
                GlbUse use = GlbUse::none);
std::size_t add(GlbBuffer& buffer, const std::vector<std::uint16_t>& numbers, GlbElement element,
                GlbUse use = GlbUse::none);
std::size_t add(GlbBuffer& buffer, const std::vector<std::uint32_t>& numbers, GlbElement element,
                GlbUse use = GlbUse::none);

/// As `add`, and states the least and the most of each component: glTF asks for them of key times
/// and positions. There is at least one element.
std::size_t add_bounded(GlbBuffer& buffer, const std::vector<float>& numbers, GlbElement element,
                        GlbUse use = GlbUse::none);

/// Adds a file, such as a picture; returns its view's index.
std::size_t add_file(GlbBuffer& buffer, std::string_view file);

/// The GLB file of a document, which gets its version and what there is to say of the buffer.
/// Names in it may hold bytes that are no UTF-8.
std::string glb_of(nlohmann::ordered_json document, const GlbBuffer& buffer);

}  // namespace mien::motion
