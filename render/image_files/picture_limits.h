#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace mien::render {

/// Largest number of values (pixels times channels) of a picture that can be read: 8192 x 8192 with
/// alpha, 1 GiB as 32-bit floats. The header of a small file can claim any size.
inline constexpr std::uint64_t max_picture_values = std::uint64_t{1} << 28;

/// Returns why a picture of the size stated in its file's header cannot be read, as text to follow
/// the file's name; empty if it can be read. Check this before allocating memory for the picture.
std::string picture_read_error(std::int64_t width, std::int64_t height, std::size_t channels);

/// Throws Error if picture_read_error is not empty. `name` is the file's name.
void require_readable_size(const std::string& name, std::int64_t width, std::int64_t height,
                           std::size_t channels);

}  // namespace mien::render
