#include "render/compare/picture_difference.h"
#include "render/compare/picture_size.h"
#include "render/image_files/image_files.h"

namespace mien::render {
namespace {

template <class Value>
LibraryDifference compared(const Image<Value>& a, const Image<Value>& b, ChannelKind kind,
                           double limit) {
  expect_one_size(a, b);
  const ImageComparison found = image_files().compare({a.width, a.height, kind, a.channels.data()},
                                                      {b.width, b.height, kind, b.channels.data()},
                                                      static_cast<float>(limit));
  return {.mean = found.mean,
          .rms = found.rms,
          .psnr_db = found.psnr_db,
          .largest = found.largest,
          .x = found.x,
          .y = found.y,
          .channel = found.channel,
          .failing_pixels = found.failing};
}

}  // namespace

LibraryDifference library_difference(const Image8& a, const Image8& b, double limit) {
  return compared(a, b, ChannelKind::byte, limit);
}

LibraryDifference library_difference(const Film& a, const Film& b, double limit) {
  return compared(a, b, ChannelKind::single, limit);
}

}  // namespace mien::render
