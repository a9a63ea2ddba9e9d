#pragma once

#include <array>

#include "render/math/powers.h"

namespace mien::render {

// The colours of ꟻLIP (Andersson et al. 2020, section 4.1): all inline, for loops of them.

/// Linear light with Rec.709 primaries, 0 … 1 in what a display shows.
struct LinearColor {
  float r = 0.0f, g = 0.0f, b = 0.0f;
};

/// YCxCz (Monga et al.), linear in light, without the factors and the constant that undo themselves
/// on the way back: its Y is 116 y − 16, its Cx 500 cx, its Cz 200 cz.
struct OpponentColor {
  float y = 0.0f;   ///< Y/Yn: luminance, white is 1
  float cx = 0.0f;  ///< X/Xn − Y/Yn
  float cz = 0.0f;  ///< Y/Yn − Z/Zn
};

/// CIELAB of the white of the display; `a` and `b` times 0.01 L once Hunt's effect is in them:
/// colours look less colourful in the dark.
struct LabColor {
  float l = 0.0f, a = 0.0f, b = 0.0f;
};

/// Rows of a matrix from linear light to X/Xn, Y/Yn, Z/Zn, or back.
using ColorMatrix = std::array<std::array<float, 3>, 3>;

/// Matrix for the primaries of IEC 61966-2-1 and a white of chromaticity (0.31271, 0.32902), CIE's
/// D65, as in the authors' own program. White becomes (1, 1, 1).
const ColorMatrix& white_relative_xyz();
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

/// Clamps a colour to the cube of colours that a display can show.
inline LinearColor within_cube(const LinearColor& c) {
  const auto unit = [](float v) { return v < 0.0f ? 0.0f : (v > 1.0f ? 1.0f : v); };
  return {unit(c.r), unit(c.g), unit(c.b)};
}

/// The cube root with a linear toe of CIELAB (CIE 15, equation 8.6).
inline float lab_curve(float t) {
  constexpr float knee = 216.0f / 24389.0f;  // (6/29)³
  const float root = cube_root(t < 0.0f ? 0.0f : t);
  return t > knee ? root : t * (841.0f / 108.0f) + 4.0f / 29.0f;
}

/// CIELAB of linear light, with Hunt's effect.
inline LabColor hunt_lab_from_linear(const ColorMatrix& m, const LinearColor& c) {
  const OpponentColor o = opponent_from_linear(m, c);
  const float fx = lab_curve(o.y + o.cx), fy = lab_curve(o.y), fz = lab_curve(o.y - o.cz);
  const float l = 116.0f * fy - 16.0f;
  return {l, 0.01f * l * (500.0f * (fx - fy)), 0.01f * l * (200.0f * (fy - fz))};
}

/// HyAB (Abasi et al. 2020): city blocks between lightness and the rest, straight within the rest.
inline float hyab(const LabColor& p, const LabColor& q) {
  const float dl = p.l - q.l, da = p.a - q.a, db = p.b - q.b;
  return std::abs(dl) + std::sqrt(da * da + db * db);
}

inline constexpr float color_exponent = 0.7f;  ///< q_c

/// The largest distance between displayable colours, of green and blue, to the power of q_c.
float largest_color_power();

/// Distances to the power of q_c, as 0 … 1: straight up to 0.95 at 0.4 of the largest, and straight
/// from there on to 1.
inline float redistributed(float power_of_distance, float largest) {
  constexpr float pc = 0.4f, pt = 0.95f;
  const float knee = pc * largest;
  const float above = pt + (power_of_distance - knee) / (largest - knee) * (1.0f - pt);
  return power_of_distance < knee ? pt / knee * power_of_distance : above;
}

}  // namespace mien::render
