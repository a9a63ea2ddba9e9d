#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include "render/compare/picture_difference.h"
#include "render/compare/picture_size.h"

namespace mien::render {
namespace {

template <class Value>
OIIO::ImageBuf buffer_of(const Image<Value>& image, OIIO::TypeDesc kind) {
  // It takes what it only reads as something that it may write.
  return OIIO::ImageBuf(OIIO::ImageSpec(image.width, image.height, 3, kind),
                        const_cast<Value*>(image.channels.data()));
}

template <class Value>
LibraryDifference compared(const Image<Value>& a, const Image<Value>& b, OIIO::TypeDesc kind,
                           double limit) {
  expect_one_size(a, b);
  const OIIO::ImageBuf of_a = buffer_of(a, kind), of_b = buffer_of(b, kind);
  const auto threshold = static_cast<float>(limit);
  const OIIO::ImageBufAlgo::CompareResults found =
      OIIO::ImageBufAlgo::compare(of_a, of_b, threshold, threshold, OIIO::ROI(), 1);
  return {.mean = found.meanerror,
          .rms = found.rms_error,
          .psnr_db = found.PSNR,
          .largest = found.maxerror,
          .x = found.maxx,
          .y = found.maxy,
          .channel = found.maxc,
          .failing_pixels = static_cast<std::int64_t>(found.nfail)};
}

}  // namespace

LibraryDifference library_difference(const Image8& a, const Image8& b, double limit) {
  return compared(a, b, OIIO::TypeDesc::UINT8, limit);
}

LibraryDifference library_difference(const Film& a, const Film& b, double limit) {
  return compared(a, b, OIIO::TypeDesc::FLOAT, limit);
}

}  // namespace mien::render
