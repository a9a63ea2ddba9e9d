#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "motion/formats/fbx/fbx_document.h"

namespace mien::motion {

/// How the corners of a mesh, where its polygons meet its vertices, are numbered.
struct FbxCorners {
  std::vector<int> vertices;  ///< of each corner
  std::vector<int> polygons;  ///< of each corner
};

/// Names of the nodes that hold the values of a layer, and how many numbers a value has.
struct FbxLayerKind {
  std::string_view values;
  std::string_view indices;
  std::size_t width = 1;
};

inline constexpr FbxLayerKind uv_layer = {"UV", "UVIndex", 2};
inline constexpr FbxLayerKind normal_layer = {"Normals", "NormalsIndex", 3};

/// The values of a layer at each corner, `width` numbers after one another; zeros where the layer
/// does not say. Empty if its way of mapping values to corners, vertices or polygons is unknown.
/// Throws mien::Error if a value does not exist.
std::vector<float> layer_values(const FbxDocument& document, std::uint32_t layer,
                                const FbxCorners& corners, const FbxLayerKind& kind);

/// The indices of a layer of materials at each polygon; empty if one holds for all.
std::vector<std::int64_t> material_indices(const FbxDocument& document, std::uint32_t layer);

}  // namespace mien::motion
