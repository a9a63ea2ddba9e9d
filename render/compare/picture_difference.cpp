#include "render/compare/picture_difference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

#include "render/compare/picture_size.h"
#include "render/image_files/image_files.h"

namespace mien::render {

namespace {

/// Grows a window so that it holds a pixel.
void include(Window& window, int x, int y) {
  if (window.width == 0) {
    window = {x, y, 1, 1};
    return;
  }
  const int right = std::max(window.x + window.width, x + 1);
  const int bottom = std::max(window.y + window.height, y + 1);
  window.x = std::min(window.x, x);
  window.y = std::min(window.y, y);
  window.width = right - window.x;
  window.height = bottom - window.y;
}

}  // namespace

PictureDifference picture_difference(const Image8& a, const Image8& b, double limit) {
  require_same_size(a, b);
  PictureDifference found;
  double sum = 0.0, squares = 0.0;
  std::size_t at = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      double most = 0.0;
      for (int c = 0; c < 3; ++c, ++at) {
        const double apart = std::abs(a.channels[at] - b.channels[at]) / 255.0;
        sum += apart;
        squares += apart * apart;
        most = std::max(most, apart);
        if (!(apart > found.largest)) continue;
        found.largest = apart;
        found.x = x;
        found.y = y;
        found.channel = c;
      }
      if (most == 0.0) continue;
      ++found.differing_pixels;
      if (most > limit) ++found.pixels_over_limit;
      include(found.changed, x, y);
    }
  }
  const double pixels = static_cast<double>(a.width) * a.height;
  found.mean = sum / (pixels * 3);
  found.rms = std::sqrt(squares / (pixels * 3));
  found.psnr_db = -20.0 * std::log10(found.rms);
  found.differing_share = static_cast<double>(found.differing_pixels) / pixels;
  found.over_limit_share = static_cast<double>(found.pixels_over_limit) / pixels;
  return found;
}

LibraryDifference library_difference(const Image8& a, const Image8& b, double limit) {
  require_same_size(a, b);
  const ImageComparison found = image_files().compare(
      {a.width, a.height, ChannelKind::byte, a.channels.data()},
      {b.width, b.height, ChannelKind::byte, b.channels.data()}, static_cast<float>(limit));
  return {.mean = found.mean,
          .rms = found.rms,
          .psnr_db = found.psnr_db,
          .largest = found.largest,
          .x = found.x,
          .y = found.y,
          .channel = found.channel,
          .failing_pixels = found.failing};
}

}  // namespace mien::render
