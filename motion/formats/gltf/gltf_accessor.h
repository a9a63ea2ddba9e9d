#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "motion/formats/gltf/gltf_library.h"

namespace mien::motion {

/// Number of elements of an accessor. Throws mien::Error if the accessor does not exist; `use`
/// states its purpose in error messages: "keys".
size_t accessor_count(const GltfFile& file, int accessor, std::string_view use);

/// The numbers of an accessor with `components` numbers per element (1, 2, 3, 4 or 16): floats, or
/// integers of 8 or 16 bits. Normalised integers are returned as −1…1 or 0…1, all other numbers
/// unchanged; sparse values are applied. Throws mien::Error for any other type, for bytes outside
/// the buffer and for numbers that are not finite.
std::vector<double> accessor_numbers(const GltfFile& file, int accessor, size_t components,
                                     std::string_view use);

/// The integers of an accessor with `components` numbers per element (1 or 4), such as indices of
/// vertices or joints. Throws mien::Error for any other type and for bytes outside the buffer.
std::vector<int> accessor_indices(const GltfFile& file, int accessor, size_t components,
                                  std::string_view use);

/// The bytes of a buffer view. Throws mien::Error if it does not exist or extends beyond its
/// buffer.
std::span<const unsigned char> buffer_view_bytes(const GltfFile& file, int view,
                                                 std::string_view use);

}  // namespace mien::motion
