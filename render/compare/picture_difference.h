#pragma once

#include <cstdint>
#include <string>

#include "render/error.h"
#include "render/image/image.h"
#include "render/image/window.h"

namespace mien::render {

/// Throws Error when two pictures differ in size, stating both sizes, or have no pixels.
template <class Picture>
void require_same_size(const Picture& a, const Picture& b) {
  const auto size_text = [](const Picture& picture) {
    return std::to_string(picture.width) + " x " + std::to_string(picture.height);
  };
  if (a.width != b.width || a.height != b.height)
    throw Error("the pictures differ in size: " + size_text(a) + " and " + size_text(b) +
                " pixels");
  if (a.width < 1 || a.height < 1) throw Error("the pictures have no pixels");
}

/// The difference of two pictures over all channels. Differences are fractions of full scale.
struct PictureDifference {
  double largest = 0.0;  ///< largest absolute difference of a channel
  int x = 0;             ///< position of the first pixel with this difference, in row-major order
  int y = 0;
  int channel = 0;
  double mean = 0.0;                  ///< mean absolute difference over all channels
  double rms = 0.0;                   ///< root-mean-square difference over all channels
  double psnr_db = 0.0;               ///< for a peak value of 1; infinite for equal pictures
  std::int64_t differing_pixels = 0;  ///< number of pixels that differ in any channel
  /// Number of pixels with a channel that differs by more than the limit.
  std::int64_t pixels_over_limit = 0;
  double differing_share = 0.0;  ///< fraction of all pixels
  double over_limit_share = 0.0;
  Window changed;  ///< bounding box of the differing pixels; empty if none differ
};

/// Compares two pictures; `limit` is a fraction of full scale. Throws Error as require_same_size.
PictureDifference picture_difference(const Image8& a, const Image8& b, double limit = 0.0);

/// The result of OpenImageIO's ImageBufAlgo::compare: an independent second measurement. Throws
/// Error as require_same_size.
struct LibraryDifference {
  double mean = 0.0;
  double rms = 0.0;
  double psnr_db = 0.0;
  double largest = 0.0;
  int x = 0;
  int y = 0;
  int channel = 0;
  /// Number of pixels with a channel that differs by more than the limit.
  std::int64_t failing_pixels = 0;
};
LibraryDifference library_difference(const Image8& a, const Image8& b, double limit = 0.0);

/// A rectangle of pixels; (x, y) is its upper left corner.
struct PicturePart {
  int x = 0, y = 0, width = 0, height = 0;
};

/// Returns the rectangle within `part` in which the results of a filter with a radius of `reach`
/// pixels can differ between the pictures: the bounding box of the pixels that differ in `part` or
/// within `reach` of it, grown by `reach` and clipped to `part`. Its height is 0 if there are none.
/// Both pictures must have the same size.
PicturePart changed_part(const Image8& a, const Image8& b, const PicturePart& part, int reach);

}  // namespace mien::render
