#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace mien::render {

/// Most values of a picture that is read, pixels times channels: 8192 x 8192 with alpha, which take
/// 1 GiB as they are worked with. The head of a small file can name any size.
inline constexpr std::uint64_t most_picture_values = std::uint64_t{1} << 28;

/// What forbids to read a picture that has the size which its file names, in words that follow the
/// file's name; empty when nothing does. To be asked before memory is taken for it.
std::string picture_hindrance(std::int64_t width, std::int64_t height, std::size_t channels);

/// Throws Error for such a picture. `name`: of the file.
void require_readable_size(const std::string& name, std::int64_t width, std::int64_t height,
                           std::size_t channels);

}  // namespace mien::render
