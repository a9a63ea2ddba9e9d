#pragma once

#include <array>

namespace mien::render {

/// A separable Blackman–Harris reconstruction filter (Harris 1978, four terms), applied by
/// importance sampling: samples are distributed with the filter's density and have equal weights
/// (Ernst et al. 2006), so that each contributes to one pixel only.
class Filter {
 public:
  /// `width` is the full width in pixels, more than 0.
  explicit Filter(float width);

  /// Returns the offset from the pixel's centre, in pixels, for a random number in [0, 1).
  float offset(float u) const {
    const float position = u * intervals;
    const auto index = static_cast<std::size_t>(position);
    const float part = position - static_cast<float>(index);
    return offsets_[index] + part * (offsets_[index + 1] - offsets_[index]);
  }

  float half_width() const { return offsets_[intervals]; }

 private:
  static constexpr int intervals = 1024;
  // Offsets in pixels that divide the filter's area into equal parts.
  std::array<float, intervals + 1> offsets_;
};

}  // namespace mien::render
