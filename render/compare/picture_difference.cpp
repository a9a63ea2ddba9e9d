#include "render/compare/picture_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

#include "render/compare/picture_size.h"

namespace mien::render {
namespace {

template <class Value>
double full_scale() {
  if constexpr (std::is_floating_point_v<Value>) return 1.0;
  return std::numeric_limits<Value>::max();
}

template <class Value>
double distance(Value a, Value b) {
  if (a == b) return 0.0;
  const double apart = std::abs(static_cast<double>(a) - static_cast<double>(b));
  if (!std::isnan(apart)) return apart / full_scale<Value>();
  const bool neither = std::isnan(static_cast<double>(a)) && std::isnan(static_cast<double>(b));
  return neither ? 0.0 : std::numeric_limits<double>::infinity();
}

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

template <class Value>
PictureDifference difference_of(int width, int height, int channels, const std::vector<Value>& a,
                                const std::vector<Value>& b, double limit) {
  PictureDifference found;
  double sum = 0.0, squares = 0.0;
  std::size_t at = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double most = 0.0;
      for (int c = 0; c < channels; ++c, ++at) {
        const double apart = distance(a[at], b[at]);
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
  const double pixels = static_cast<double>(width) * height;
  found.mean = sum / (pixels * channels);
  found.rms = std::sqrt(squares / (pixels * channels));
  found.psnr_db = -20.0 * std::log10(found.rms);
  found.differing_share = static_cast<double>(found.differing_pixels) / pixels;
  found.over_limit_share = static_cast<double>(found.pixels_over_limit) / pixels;
  return found;
}

template <class Value>
PictureDifference image_difference(const Image<Value>& a, const Image<Value>& b, double limit) {
  expect_one_size(a, b);
  return difference_of(a.width, a.height, 3, a.channels, b.channels, limit);
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

PictureDifference picture_difference(const Image8& a, const Image8& b, double limit) {
  return image_difference(a, b, limit);
}

PictureDifference picture_difference(const Image16& a, const Image16& b, double limit) {
  return image_difference(a, b, limit);
}

PictureDifference picture_difference(const Film& a, const Film& b, double limit) {
  return image_difference(a, b, limit);
}

PictureDifference picture_difference(const Channels& a, const Channels& b, double limit) {
  expect_one_size(a, b);
  if (a.names != b.names)
    throw Error("the pictures have other channels: " + listed(a.names) + " and " + listed(b.names));
  return difference_of(a.width, a.height, static_cast<int>(a.names.size()), a.values, b.values,
                       limit);
}

PictureDifference picture_difference(const std::filesystem::path& a, const std::filesystem::path& b,
                                     double limit) {
  const Channels of_a = read_channels(a), of_b = read_channels(b);
  try {
    return picture_difference(of_a, of_b, limit);
  } catch (const Error& error) {
    throw Error(a.string() + " and " + b.string() + ": " + error.what());
  }
}

}  // namespace mien::render
