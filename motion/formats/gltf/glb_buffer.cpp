#include "motion/formats/gltf/glb_buffer.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

namespace mien::motion {

namespace {

using Json = nlohmann::ordered_json;

struct ElementName {
  const char* name;
  std::size_t components;
};

ElementName name_of(GlbElement element) {
  constexpr std::array<ElementName, 5> names = {
      {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}}};
  return names[static_cast<std::size_t>(element)];
}

/// glTF's numbers for them.
template <typename Number>
int component_type() {
  constexpr int unsigned_short = 5123, unsigned_int = 5125, float32 = 5126;
  if constexpr (std::is_same_v<Number, std::uint16_t>) return unsigned_short;
  if constexpr (std::is_same_v<Number, std::uint32_t>) return unsigned_int;
  return float32;
}

std::size_t add_view(GlbBuffer& buffer, std::string_view bytes, GlbUse use) {
  constexpr int vertices = 34962, indices = 34963;
  Json view = {{"buffer", 0}, {"byteOffset", buffer.bytes.size()}, {"byteLength", bytes.size()}};
  if (use != GlbUse::none) view["target"] = use == GlbUse::vertices ? vertices : indices;
  buffer.views.push_back(std::move(view));
  buffer.bytes.append(bytes);
  buffer.bytes.resize((buffer.bytes.size() + 3) / 4 * 4, '\0');
  return buffer.views.size() - 1;
}

template <typename Number>
std::string_view bytes_of(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

template <typename Number>
std::size_t add_numbers(GlbBuffer& buffer, const std::vector<Number>& numbers, GlbElement element,
                        GlbUse use) {
  const auto [name, components] = name_of(element);
  const std::size_t view = add_view(buffer, bytes_of(numbers), use);
  buffer.accessors.push_back({{"bufferView", view},
                              {"componentType", component_type<Number>()},
                              {"count", numbers.size() / components},
                              {"type", name}});
  return buffer.accessors.size() - 1;
}

/// The minimum and maximum of each component, also of elements that are 0 if there are any.
void add_bounds(Json& accessor, const std::vector<float>& numbers, GlbElement element,
                bool has_zeros) {
  const std::size_t components = name_of(element).components;
  Json least = Json::array(), most = Json::array();
  for (std::size_t c = 0; c < components; ++c) {
    float low = has_zeros ? 0.0f : numbers[c], high = low;
    for (std::size_t i = c; i < numbers.size(); i += components) {
      low = std::min(low, numbers[i]);
      high = std::max(high, numbers[i]);
    }
    least.push_back(low);
    most.push_back(high);
  }
  accessor["min"] = std::move(least);
  accessor["max"] = std::move(most);
}

void append_word(std::string& bytes, std::size_t word) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xFF);
}

void append_chunk(std::string& bytes, std::string_view type, const std::string& chunk,
                  char padding) {
  const std::size_t padded = (chunk.size() + 3) / 4 * 4;
  append_word(bytes, padded);
  bytes.append(type).append(chunk).append(padded - chunk.size(), padding);
}

}  // namespace

std::size_t add(GlbBuffer& buffer, const std::vector<float>& numbers, GlbElement element,
                GlbUse use) {
  return add_numbers(buffer, numbers, element, use);
}

std::size_t add(GlbBuffer& buffer, const std::vector<std::uint16_t>& numbers, GlbElement element,
                GlbUse use) {
  return add_numbers(buffer, numbers, element, use);
}

std::size_t add(GlbBuffer& buffer, const std::vector<std::uint32_t>& numbers, GlbElement element,
                GlbUse use) {
  return add_numbers(buffer, numbers, element, use);
}

std::size_t add_bounded(GlbBuffer& buffer, const std::vector<float>& numbers, GlbElement element,
                        GlbUse use) {
  const std::size_t accessor = add(buffer, numbers, element, use);
  add_bounds(buffer.accessors[accessor], numbers, element, false);
  return accessor;
}

std::size_t add_sparse(GlbBuffer& buffer, std::size_t count,
                       const std::vector<std::uint32_t>& indices, const std::vector<float>& numbers,
                       GlbElement element) {
  Json accessor = {{"componentType", component_type<float>()},
                   {"count", count},
                   {"type", name_of(element).name}};
  add_bounds(accessor, numbers, element, indices.size() < count);
  accessor["sparse"] = {
      {"count", indices.size()},
      {"indices",
       {{"bufferView", add_view(buffer, bytes_of(indices), GlbUse::none)},
        {"componentType", component_type<std::uint32_t>()}}},
      {"values", {{"bufferView", add_view(buffer, bytes_of(numbers), GlbUse::none)}}}};
  buffer.accessors.push_back(std::move(accessor));
  return buffer.accessors.size() - 1;
}

std::size_t add_file(GlbBuffer& buffer, std::string_view file) {
  return add_view(buffer, file, GlbUse::none);
}

std::string glb_of(nlohmann::ordered_json document, const GlbBuffer& buffer) {
  document["accessors"] = buffer.accessors;
  document["bufferViews"] = buffer.views;
  document["buffers"] = Json::array({{{"byteLength", buffer.bytes.size()}}});
  std::string chunks;
  append_chunk(chunks, "JSON", document.dump(-1, ' ', false, Json::error_handler_t::replace), ' ');
  append_chunk(chunks, std::string_view("BIN\0", 4), buffer.bytes, '\0');
  std::string file = "glTF";
  append_word(file, 2);
  append_word(file, 12 + chunks.size());
  return file + chunks;
}

}  // namespace mien::motion
