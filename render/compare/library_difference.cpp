#include "render/compare/picture_difference.h"
#include "render/compare/picture_size.h"
#include "render/image_files/image_files.h"

namespace mien::render {

LibraryDifference library_difference(const Image8& a, const Image8& b, double limit) {
  expect_one_size(a, b);
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
