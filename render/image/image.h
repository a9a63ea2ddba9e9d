#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mien::render {

/// An RGB picture: rows from top to bottom, three channels per pixel, no padding.
template <class Channel>
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Channel> channels;

  Image() = default;
  Image(int w, int h)
      : width(w),
        height(h),
        channels(3 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

  /// The three channels of a pixel.
  Channel* at(int x, int y) { return channels.data() + offset(x, y); }
  const Channel* at(int x, int y) const { return channels.data() + offset(x, y); }

  bool operator==(const Image&) const = default;

 private:
  std::size_t offset(int x, int y) const {
    return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(x));
  }
};

using Image8 = Image<std::uint8_t>;    ///< sRGB, 0 … 255
using Image16 = Image<std::uint16_t>;  ///< sRGB, 0 … 65535

}  // namespace mien::render
