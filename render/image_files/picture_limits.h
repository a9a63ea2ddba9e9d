#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace mien::render {

/// Largest number of values (pixels times channels) of a picture that is read: 8192 x 8192 with
/// alpha, 1 GiB in memory. The header of a small file can claim any size.
inline constexpr std::uint64_t max_picture_values = std::uint64_t{1} << 28;

/// Why a picture of the size that its file's header states cannot be read, as words that follow the
/// file's name; empty if it can. Check this before allocating memory for it.
std::string picture_read_error(std::int64_t width, std::int64_t height, std::size_t channels);

/// Throws Error if there is a picture_read_error. `name`: the file's.
void require_readable_size(const std::string& name, std::int64_t width, std::int64_t height,
                           std::size_t channels);

}  // namespace mien::render
