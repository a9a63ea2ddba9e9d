#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "render/compare/pixel_map.h"
#include "render/image/image.h"

// The formulas of the paper a second time: in two dimensions, in double precision, matrices as the
// authors print them.
namespace mien::render::test::paper {

using Triple = std::array<double, 3>;

inline const double to_xyz[3][3] = {
    {10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
    {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
    {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};
inline const double to_rgb[3][3] = {{3.241003275, -1.537398934, -0.498615861},
                                    {-0.969224334, 1.875930071, 0.041554224},
                                    {0.055639423, -0.204011202, 1.057148933}};
inline const Triple white = {0.950428545, 1.0, 1.088900371};

inline Triple times(const double (&m)[3][3], const Triple& v) {
  Triple out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) out[i] += m[i][j] * v[j];
  return out;
}

inline double linear(int code) {
  const double v = code / 255.0;
  return v > 0.04045 ? std::pow((v + 0.055) / 1.055, 2.4) : v / 12.92;
}

inline Triple ycxcz(const Triple& rgb) {
  const Triple xyz = times(to_xyz, rgb);
  const double x = xyz[0] / white[0], y = xyz[1], z = xyz[2] / white[2];
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

inline Triple rgb_of(const Triple& c) {
  const double y = (c[0] + 16.0) / 116.0;
  Triple rgb = times(to_rgb, {(y + c[1] / 500.0) * white[0], y, (y - c[2] / 200.0) * white[2]});
  for (double& v : rgb) v = std::clamp(v, 0.0, 1.0);
  return rgb;
}

inline Triple hunt_lab(const Triple& rgb) {
  const Triple xyz = times(to_xyz, rgb);
  Triple f{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double t = xyz[i] / white[i], delta = 6.0 / 29.0;
    f[i] = t > delta * delta * delta ? std::cbrt(t) : t / (3.0 * delta * delta) + 4.0 / 29.0;
  }
  const double l = 116.0 * f[1] - 16.0;
  return {l, 0.01 * l * 500.0 * (f[0] - f[1]), 0.01 * l * 200.0 * (f[1] - f[2])};
}

inline double hyab(const Triple& p, const Triple& q) {
  return std::abs(p[0] - q[0]) + std::hypot(p[1] - q[1], p[2] - q[2]);
}

inline double color_error(const Triple& p, const Triple& q) {
  const double largest = std::pow(hyab(hunt_lab({0.0, 1.0, 0.0}), hunt_lab({0.0, 0.0, 1.0})), 0.7);
  const double e = std::pow(hyab(p, q), 0.7), knee = 0.4 * largest;
  return e < knee ? 0.95 / knee * e : 0.95 + 0.05 * (e - knee) / (largest - knee);
}

/// A filter of (2 r + 1)² weights and what it gives at a place of a picture of numbers.
struct Square {
  int r;
  std::vector<double> weights;

  Square(int reach, const std::function<double(int, int)>& weight) : r(reach) {
    for (int y = -r; y <= r; ++y)
      for (int x = -r; x <= r; ++x) weights.push_back(weight(x, y));
  }
  Square balanced() const {
    Square other = *this;
    double up = 0.0, down = 0.0;
    for (const double w : weights) (w > 0.0 ? up : down) += std::abs(w);
    for (double& w : other.weights) w /= w > 0.0 ? up : std::max(down, 1e-300);
    return other;
  }
  double at(const std::function<double(int, int)>& value, int x, int y) const {
    double sum = 0.0;
    std::size_t i = 0;
    for (int dy = -r; dy <= r; ++dy)
      for (int dx = -r; dx <= r; ++dx) sum += weights[i++] * value(x + dx, y + dy);
    return sum;
  }
};

inline Square sensitivity(double a1, double b1, double a2, double b2, double ppd) {
  const int reach =
      static_cast<int>(std::ceil(3.0 * std::sqrt(0.04 / 2.0) / std::numbers::pi * ppd));
  return Square(reach,
                [=](int x, int y) {
                  const double z = (x * x + y * y) / (ppd * ppd), pi = std::numbers::pi;
                  return a1 * std::sqrt(pi / b1) * std::exp(-pi * pi * z / b1) +
                         a2 * std::sqrt(pi / b2) * std::exp(-pi * pi * z / b2);
                })
      .balanced();
}

inline PixelMap error(const Image8& a, const Image8& b, double ppd) {
  const std::array<Square, 3> seen = {sensitivity(1.0, 0.0047, 0.0, 1.0, ppd),
                                      sensitivity(1.0, 0.0053, 0.0, 1.0, ppd),
                                      sensitivity(34.1, 0.04, 13.5, 0.025, ppd)};
  const double sd = 0.5 * 0.082 * ppd;
  const int reach = static_cast<int>(std::ceil(3.0 * sd));
  const auto gauss = [=](int x, int y) { return std::exp(-(x * x + y * y) / (2.0 * sd * sd)); };
  const Square edge = Square(reach, [=](int x, int y) { return -x * gauss(x, y); }).balanced();
  const Square point = Square(reach, [=](int x, int y) {
                         return (x * x / (sd * sd) - 1.0) * gauss(x, y);
                       }).balanced();
  const auto channel = [&](const Image8& image, std::size_t c) {
    return [&image, c](int x, int y) {
      const std::uint8_t* p =
          image.at(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1));
      return ycxcz({linear(p[0]), linear(p[1]), linear(p[2])})[c];
    };
  };
  const auto lab = [&](const Image8& image, int x, int y) {
    Triple c{};
    for (std::size_t i = 0; i < 3; ++i) c[i] = seen[i].at(channel(image, i), x, y);
    return hunt_lab(rgb_of(c));
  };
  const auto feature = [&](const Image8& image, const Square& detector, int x, int y) {
    const auto value = [&](int i, int j) { return (channel(image, 0)(i, j) + 16.0) / 116.0; };
    // Turned by a quarter for the other axis.
    const auto turned = [&](int i, int j) { return value(x + (j - y), y + (i - x)); };
    return std::hypot(detector.at(value, x, y), detector.at(turned, x, y));
  };
  PixelMap map(a.width, a.height);
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const double edges = std::abs(feature(a, edge, x, y) - feature(b, edge, x, y));
      const double points = std::abs(feature(a, point, x, y) - feature(b, point, x, y));
      const double f = std::sqrt(std::max(edges, points) / std::numbers::sqrt2);
      map.row(y)[x] =
          static_cast<float>(std::pow(color_error(lab(a, x, y), lab(b, x, y)), 1.0 - f));
    }
  }
  return map;
}

}  // namespace mien::render::test::paper
