#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "motion/formats/gltf_library.h"

namespace mien::motion {

/// Number of elements of an accessor. Throws mien::Error when there is no such accessor; `use` is
/// its purpose for error messages: "key times".
size_t accessor_count(const GltfFile& file, int accessor, std::string_view use);

/// The numbers of an accessor with `components` (1, 2, 3, 4, 16) in each element: floats and
/// plain integers as they are, normalised integers as −1…1 or 0…1, sparse values put in. Throws
/// mien::Error for every other type, for bytes outside the buffer and for numbers that are not
/// finite.
std::vector<double> accessor_numbers(const GltfFile& file, int accessor, size_t components,
                                     std::string_view use);

/// The whole numbers of an accessor with `components` (1, 4) in each element: indices of vertices
/// or joints. Throws mien::Error for every other type and for bytes outside the buffer.
std::vector<int> accessor_indices(const GltfFile& file, int accessor, size_t components,
                                  std::string_view use);

/// The bytes of a buffer view. Throws mien::Error when there is none or it reaches beyond its
/// buffer.
std::span<const unsigned char> buffer_view_bytes(const GltfFile& file, int view,
                                                 std::string_view use);

}  // namespace mien::motion
