#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

namespace mien::render {

/// A point of the unit square, both coordinates in [0, 1).
struct Point2 {
  float u;
  float v;
};

/// A 32-bit hash of two words.
constexpr std::uint32_t mixed(std::uint32_t a, std::uint32_t b) {
  std::uint32_t x = a ^ (b * 0x9e3779b9u + 0x85ebca6bu);
  x = (x ^ (x >> 16)) * 0x21f0aaadu;
  x = (x ^ (x >> 15)) * 0x735a2d97u;
  return x ^ (x >> 15);
}

constexpr std::uint32_t reversed_bits(std::uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0xff00ff00u) >> 8) | ((x & 0x00ff00ffu) << 8);
  x = ((x & 0xf0f0f0f0u) >> 4) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x & 0xccccccccu) >> 2) | ((x & 0x33333333u) << 2);
  return ((x & 0xaaaaaaaau) >> 1) | ((x & 0x55555555u) << 1);
}

/// Returns point `index` of the two-dimensional Sobol sequence, as 32-bit fractions. The first
/// dimension is the van der Corput sequence; for the second, the index is first multiplied by the
/// Pascal matrix modulo 2, here in five steps (Ahmed 2024).
constexpr std::array<std::uint32_t, 2> sobol(std::uint32_t index) {
  std::uint32_t v = index;
  v ^= v >> 16;
  v ^= (v & 0xff00ff00u) >> 8;
  v ^= (v & 0xf0f0f0f0u) >> 4;
  v ^= (v & 0xccccccccu) >> 2;
  v ^= (v & 0xaaaaaaaau) >> 1;
  return {reversed_bits(index), reversed_bits(v)};
}

/// Owen's nested uniform scrambling of a 32-bit fraction given with reversed bits: a hash each bit
/// of which depends only on the seed, on the same bit of `x` and on lower bits (Laine & Karras
/// 2011, constants of Vegdahl 2021).
constexpr std::uint32_t scrambled_reversed(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

/// The top 24 bits as a float in [0, 1).
constexpr float unit_float(std::uint32_t fraction) {
  return static_cast<float>(fraction >> 8) * 0x1p-24f;
}

/// Returns point `index` of an Owen-scrambled, shuffled Sobol sequence. Each seed gives an
/// independent sequence, so further pairs of dimensions are padded with other seeds (Burley 2020).
/// Every aligned block of 2^k indices is a (0, k, 2)-net.
constexpr Point2 sample_point(std::uint32_t index, std::uint32_t seed) {
  const std::uint32_t shuffled =
      reversed_bits(scrambled_reversed(reversed_bits(index), mixed(seed, 0)));
  const std::array<std::uint32_t, 2> point = sobol(shuffled);
  return {unit_float(reversed_bits(scrambled_reversed(reversed_bits(point[0]), mixed(seed, 1)))),
          unit_float(reversed_bits(scrambled_reversed(reversed_bits(point[1]), mixed(seed, 2))))};
}

/// The use of a pair of random numbers. That of light i is FirstLight + i, that of figure i is
/// FirstFigure + i.
enum class Dimension : std::uint32_t {
  PixelPosition,
  FigureSky,
  FloorSky,
  FloorSkyChoice,
  CornerSky,
  Lens,
  Time,                   ///< first number only
  FirstLight,             ///< one per light
  FirstFigure = 1u << 16  ///< one per figure, first number only: whether the figure is present
};

/// Spreads bits 0 … 15 to the even positions (Morton code).
constexpr std::uint32_t spread_bits(std::uint32_t x) {
  x &= 0xffffu;
  x = (x | (x << 8)) & 0x00ff00ffu;
  x = (x | (x << 4)) & 0x0f0f0f0fu;
  x = (x | (x << 2)) & 0x33333333u;
  return (x | (x << 1)) & 0x55555555u;
}

/// The random numbers of a pixel: a pure function of the seed, pixel, dimension and index.
class PixelSampler {
 public:
  PixelSampler() = default;

  /// Returns the sampler of a pixel with `samples` samples. All pixels share one sequence, of which
  /// each uses one block, in the order of the Morton curve, so that errors of neighbours tend to
  /// cancel (Ahmed & Wonka 2020): single pixels are as noisy as with independent sequences, but
  /// areas are less noisy.
  static PixelSampler for_picture(std::uint64_t seed, int x, int y, int samples) {
    PixelSampler sampler(seed, 0, 0);
    sampler.samples_ = static_cast<std::uint32_t>(samples);
    return sampler.for_pixel(x, y);
  }

  /// Returns the sampler of another pixel of the same picture.
  PixelSampler for_pixel(int x, int y) const {
    PixelSampler sampler = *this;
    sampler.place_ = spread_bits(static_cast<std::uint32_t>(x)) |
                     (spread_bits(static_cast<std::uint32_t>(y)) << 1);
    return sampler;
  }

  /// Makes a sampler that is independent of its neighbours, for example for a pixel or a grid
  /// corner.
  PixelSampler(std::uint64_t seed, int x, int y)
      : seed_(mixed(
            mixed(mixed(static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)),
                  static_cast<std::uint32_t>(x)),
            static_cast<std::uint32_t>(y))) {}

  /// Returns the seed of a pair of dimensions for sample_point; `which` is the index of the light
  /// or figure.
  std::uint32_t seed(Dimension dimension, int which = 0) const {
    return mixed(seed_, static_cast<std::uint32_t>(dimension) + static_cast<std::uint32_t>(which));
  }

  /// Returns the index, for sample_point, of the pixel's point number `point`; each sample has
  /// `times` points.
  std::uint32_t index(int point, int times = 1) const {
    return place_ * std::bit_ceil(static_cast<std::uint32_t>(times) * samples_) +
           static_cast<std::uint32_t>(point);
  }

  Point2 point(Dimension dimension, int index) const { return point(dimension, 0, index); }
  Point2 point(Dimension dimension, int which, int index) const {
    return sample_point(this->index(index), seed(dimension, which));
  }

  /// A random number for the pixel as a whole.
  float choice(Dimension dimension) const { return sample_point(place_, seed(dimension)).u; }

 private:
  std::uint32_t seed_ = 0;
  std::uint32_t place_ = 0;  // index of the pixel on the Morton curve
  std::uint32_t samples_ = 1;
};

/// Stochastic transparency: returns the figures that are present for a sample, one bit per figure.
inline std::uint32_t present_figures(const PixelSampler& sampler, std::span<const float> opacities,
                                     int index) {
  std::uint32_t present = ~0u;
  for (std::size_t f = 0; f < opacities.size(); ++f) {
    const bool there =
        opacities[f] >= 1.0f ||
        sampler.point(Dimension::FirstFigure, static_cast<int>(f), index).u < opacities[f];
    if (!there) present &= ~(1u << f);
  }
  return present;
}

}  // namespace mien::render
