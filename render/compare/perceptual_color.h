#pragma once

#include <array>

#include "render/math/powers.h"

namespace mien::render {

// Colour spaces and colour distance of ꟻLIP (Andersson et al. 2020, section 4.1), inline for use in
// inner loops.

/// A linear colour with Rec.709 primaries; channels of displayable colours are 0 … 1.
struct LinearColor {
  float r = 0.0f, g = 0.0f, b = 0.0f;
};

/// A colour in the linear opponent space YCxCz (Monga et al.), without its scale factors and
/// offset, which cancel in the inverse transform: Y = 116 y − 16, Cx = 500 cx, Cz = 200 cz.
struct OpponentColor {
  float y = 0.0f;   ///< Y/Yn: relative luminance, 1 for white
  float cx = 0.0f;  ///< X/Xn − Y/Yn
  float cz = 0.0f;  ///< Y/Yn − Z/Zn
};

/// A CIELAB colour relative to the display's white. With the Hunt adjustment, `a` and `b` are
/// multiplied by 0.01 L, because colours appear less colourful at low luminance.
struct LabColor {
  float l = 0.0f, a = 0.0f, b = 0.0f;
};

/// The rows of a matrix that converts linear RGB to X/Xn, Y/Yn, Z/Zn or back.
using ColorMatrix = std::array<std::array<float, 3>, 3>;

/// Returns the matrix from linear RGB to white-relative XYZ for the primaries of IEC 61966-2-1
/// (sRGB) and the white D65 at chromaticity (0.31271, 0.32902), as in the authors' implementation.
/// White becomes (1, 1, 1).
const ColorMatrix& white_relative_xyz();
/// Returns the inverse of that matrix.
const ColorMatrix& linear_from_white_relative_xyz();

inline OpponentColor opponent_from_linear(const ColorMatrix& m, const LinearColor& c) {
  const float x = m[0][0] * c.r + m[0][1] * c.g + m[0][2] * c.b;
  const float y = m[1][0] * c.r + m[1][1] * c.g + m[1][2] * c.b;
  const float z = m[2][0] * c.r + m[2][1] * c.g + m[2][2] * c.b;
  return {y, x - y, y - z};
}

inline LinearColor linear_from_opponent(const ColorMatrix& m, const OpponentColor& c) {
  const float x = c.y + c.cx, z = c.y - c.cz;
  return {m[0][0] * x + m[0][1] * c.y + m[0][2] * z, m[1][0] * x + m[1][1] * c.y + m[1][2] * z,
          m[2][0] * x + m[2][1] * c.y + m[2][2] * z};
}

/// Clamps each channel to 0 … 1, the range that a display can show.
inline LinearColor within_cube(const LinearColor& c) {
  const auto unit = [](float v) { return v < 0.0f ? 0.0f : (v > 1.0f ? 1.0f : v); };
  return {unit(c.r), unit(c.g), unit(c.b)};
}

/// The cube root of CIELAB, with its linear segment near zero (CIE 15, equation 8.6).
inline float lab_curve(float t) {
  constexpr float knee = 216.0f / 24389.0f;  // (6/29)³
  const float root = cube_root(t < 0.0f ? 0.0f : t);
  return t > knee ? root : t * (841.0f / 108.0f) + 4.0f / 29.0f;
}

/// Converts a linear colour to CIELAB with the Hunt adjustment.
inline LabColor hunt_lab_from_linear(const ColorMatrix& m, const LinearColor& c) {
  const OpponentColor o = opponent_from_linear(m, c);
  const float fx = lab_curve(o.y + o.cx), fy = lab_curve(o.y), fz = lab_curve(o.y - o.cz);
  const float l = 116.0f * fy - 16.0f;
  return {l, 0.01f * l * (500.0f * (fx - fy)), 0.01f * l * (200.0f * (fy - fz))};
}

/// HyAB distance (Abasi et al. 2020): the absolute difference of lightness plus the Euclidean
/// distance in the a–b plane.
inline float hyab(const LabColor& p, const LabColor& q) {
  const float dl = p.l - q.l, da = p.a - q.a, db = p.b - q.b;
  return std::abs(dl) + std::sqrt(da * da + db * db);
}

inline constexpr float color_exponent = 0.7f;  ///< exponent of colour distances, q_c in the paper

/// Returns the largest HyAB distance between displayable colours, that of green and blue, raised to
/// the power q_c.
float largest_color_power();

/// Maps a colour distance, already raised to the power q_c, to 0 … 1. The map is piecewise linear:
/// up to 0.95 at 0.4 of `largest` (largest_color_power), then up to 1 at `largest`.
inline float redistributed(float power_of_distance, float largest) {
  constexpr float pc = 0.4f, pt = 0.95f;
  const float knee = pc * largest;
  const float above = pt + (power_of_distance - knee) / (largest - knee) * (1.0f - pt);
  return power_of_distance < knee ? pt / knee * power_of_distance : above;
}

}  // namespace mien::render
