#include "motion/formats/fbx/fbx_layer.h"

#include <string>

#include "motion/formats/fbx/fbx_values.h"

namespace mien::motion {

namespace {

/// How the values of a layer belong to the parts of a mesh.
enum class Mapping { none, by_corner, by_vertex, by_polygon, all_same };

Mapping mapping_of(const FbxDocument& document, std::uint32_t layer) {
  const std::uint32_t node = find_child(document, layer, "MappingInformationType");
  const std::string_view name = node == 0 ? std::string_view() : text_of(document, node, 0);
  if (name == "ByPolygonVertex") return Mapping::by_corner;
  if (name == "ByVertice" || name == "ByVertex" || name == "ByControlPoint") {
    return Mapping::by_vertex;
  }
  if (name == "ByPolygon") return Mapping::by_polygon;
  return name == "AllSame" ? Mapping::all_same : Mapping::none;
}

/// The index of a layer's value at a corner; −1 if the layer does not say.
std::int64_t layer_index(Mapping mapping, const std::vector<std::int64_t>& indices,
                         const FbxCorners& corners, std::size_t corner) {
  const std::size_t at =
      mapping == Mapping::by_corner    ? corner
      : mapping == Mapping::by_vertex  ? static_cast<std::size_t>(corners.vertices[corner])
      : mapping == Mapping::by_polygon ? static_cast<std::size_t>(corners.polygons[corner])
                                       : 0;
  if (indices.empty()) return static_cast<std::int64_t>(at);
  return at < indices.size() ? indices[at] : -1;
}

std::vector<std::int64_t> layer_indices(const FbxDocument& document, std::uint32_t layer,
                                        std::string_view name) {
  const std::uint32_t node = find_child(document, layer, name);
  return node == 0 ? std::vector<std::int64_t>() : integers_of(document, node);
}

}  // namespace

std::vector<float> layer_values(const FbxDocument& document, std::uint32_t layer,
                                const FbxCorners& corners, const FbxLayerKind& kind) {
  const Mapping mapping = mapping_of(document, layer);
  const std::uint32_t node = find_child(document, layer, kind.values);
  if (mapping == Mapping::none || node == 0) return {};
  const std::vector<float> numbers = floats_of(document, node);
  const std::vector<std::int64_t> indices = layer_indices(document, layer, kind.indices);
  std::vector<float> values(kind.width * corners.vertices.size(), 0.0f);
  for (std::size_t c = 0; c < corners.vertices.size(); ++c) {
    const std::int64_t index = layer_index(mapping, indices, corners, c);
    // Corners without a value are stored as −1.
    if (index < 0) continue;
    if (static_cast<std::size_t>(index) >= numbers.size() / kind.width) {
      refuse_fbx(document, layer,
                 "a value of the layer " + std::string(kind.values) + " does not exist");
    }
    const std::size_t from = kind.width * static_cast<std::size_t>(index);
    for (std::size_t i = 0; i < kind.width; ++i) values[kind.width * c + i] = numbers[from + i];
  }
  return values;
}

std::vector<std::int64_t> material_indices(const FbxDocument& document, std::uint32_t layer) {
  if (mapping_of(document, layer) != Mapping::by_polygon) return {};
  return layer_indices(document, layer, "Materials");
}

}  // namespace mien::motion
